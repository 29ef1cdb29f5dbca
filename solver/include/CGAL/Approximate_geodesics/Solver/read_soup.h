// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/mesh_file_error.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <cerrno>
#include <cstddef>
#include <fstream>
#include <ios>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * reads a polygon soup in the format of the file name extension: OFF, OBJ, PLY, STL or GOCAD (ts).
 * It wraps `CGAL::IO::read_polygon_soup()`, and adds the reason of a failure.
 *
 * \throws std::invalid_argument if reading fails, or a face has a vertex that does not exist. The
 *         message names the line, the vertex or the face, if it is known, or says why the file
 *         cannot be opened.
 */
template <typename Point>
void read_soup(const std::string& file,
               std::vector<Point>& points,
               std::vector<std::vector<std::size_t>>& faces)
{
  const auto fail = [&](const std::string& reason) {
    throw std::invalid_argument("cannot read a mesh from " + file + ": " + reason);
  };
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  const bool is_at_end = in.peek() == std::ifstream::traits_type::eof();
  if(in.fail())
    fail(errno != 0 ? std::generic_category().message(errno) : "it cannot be opened");
  if(is_at_end)
    fail("it is empty");
  bool is_read = false;
  const std::string ending = internal::ending_of(file);
  if(internal::is_long_enough(in, ending))
    internal::fits_memory(
        [&] { is_read = IO::read_polygon_soup(file, points, faces, parameters::verbose(false)); });
  if(!is_read)
  {
    std::string reason = "a number in it exceeds the memory";
    in.clear();
    in.seekg(0);
    internal::fits_memory([&] { reason = internal::error_in_mesh_file(in, ending); });
    fail(reason);
  }
  for(std::size_t f = 0; f < faces.size(); ++f)
    for(const std::size_t v : faces[f])
      if(v >= points.size())
        fail(internal::text_of_wrong_corner(f, std::to_string(static_cast<std::ptrdiff_t>(v)),
                                            points.size()));
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H
