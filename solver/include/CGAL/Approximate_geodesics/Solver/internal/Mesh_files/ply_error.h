// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_PLY_ERROR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_PLY_ERROR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/IO/PLY.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <istream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The header of a PLY file.
 */
struct Ply_header
{
  explicit Ply_header(std::istream& in)
  {
    std::string text;
    for(std::string first; std::getline(in, text) && first != "end_header";)
    {
      std::istringstream words(text);
      std::string element, type;
      words >> first >> element;
      if(first == "element")
        words >> number_of[element];
      while(words >> type)
        lists_corners = lists_corners || type == "vertex_indices" || type == "vertex_index";
      begins = begins || first == "ply";
      ends = first == "end_header";
    }
  }

  bool begins = false;
  bool ends = false;
  bool lists_corners = false;
  std::map<std::string, std::size_t> number_of; // by element
};

// Returns why a PLY file cannot be read, or an empty string if the reason is unknown. After a
// failure, CGAL's reader keeps the elements before the error, which locates it.
inline std::string error_in_ply(std::istream& in)
{
  Ply_header header(in);
  if(!header.begins)
    return "it does not begin with ply";
  if(!header.ends)
    return "its header does not end";
  if(!header.lists_corners)
    return "its faces have no list vertex_indices";
  in.clear();
  in.seekg(0);
  std::vector<Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  IO::read_PLY(in, points, faces, parameters::verbose(false));
  in.clear();
  const std::string reason =
      in.peek() == std::istream::traits_type::eof() ? "it ends in " : "invalid number in ";
  if(points.size() < header.number_of["vertex"])
    return reason + "vertex " + std::to_string(points.size()) + " of " +
           std::to_string(header.number_of["vertex"]);
  if(faces.size() < header.number_of["face"])
    return reason + "face " + std::to_string(faces.size()) + " of " +
           std::to_string(header.number_of["face"]);
  return "";
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_PLY_ERROR_H
