// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_STL_ERROR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_STL_ERROR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

// Returns why an STL file cannot be read.
inline std::string error_in_stl(std::istream& in)
{
  std::string word;
  if(in >> word && word == "solid")
  {
    std::size_t number_of_faces = 0;
    while(in >> word)
      number_of_faces += word == "endfacet" ? 1 : 0;
    return "face " + std::to_string(number_of_faces) + " or its end is missing or malformed";
  }
  constexpr std::streamoff header = 80, size_of_face = 50;
  std::uint32_t announced = 0;
  in.clear();
  in.seekg(header);
  in.read(reinterpret_cast<char*>(&announced), sizeof(announced));
  const std::streamoff begin = in.tellg();
  in.seekg(0, std::ios::end);
  return "it ends after " + std::to_string((in.tellg() - begin) / size_of_face) + " of " +
         std::to_string(boost::endian::little_to_native(announced)) + " faces";
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_STL_ERROR_H
