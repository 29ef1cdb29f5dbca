// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_READ_SOUP_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Mesh_files/obj_error.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Mesh_files/off_error.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Mesh_files/ply_error.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Mesh_files/stl_error.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <cctype>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <ios>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

// Calls `f()`. Returns whether the numbers in a damaged file let it come to its end.
template <typename F>
bool fits_memory(F f)
{
  try
  {
    f();
    return true;
  }
  catch(const std::bad_alloc&)
  {
  }
  catch(const std::length_error&)
  {
  }
  return false;
}

inline std::string ending_of(const std::string& file)
{
  const std::size_t dot = file.find_last_of("./");
  std::string result = dot == std::string::npos || file[dot] == '/' ? "" : file.substr(dot + 1);
  for(char& c : result)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Returns why CGAL could not read a file. CGAL itself reports no reason.
inline std::string error_in_mesh_file(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::string ending = ending_of(file);
  std::string result;
  if(ending == "off")
    result = error_in_off(in);
  else if(ending == "obj")
    result = error_in_obj(in);
  else if(ending == "ply")
    result = error_in_ply(in);
  else if(ending == "stl")
    result = error_in_stl(in);
  else if(ending != "ts")
    return "its file name extension must be .off, .obj, .ply, .stl or .ts";
  return result.empty() ? "CGAL cannot read it, for an unknown reason" : result;
}

} // namespace internal

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
  if(internal::ending_of(file) != "off" || internal::is_long_enough_for_off(in))
    internal::fits_memory(
        [&] { is_read = IO::read_polygon_soup(file, points, faces, parameters::verbose(false)); });
  if(!is_read)
  {
    std::string reason = "a number in it exceeds the memory";
    internal::fits_memory([&] { reason = internal::error_in_mesh_file(file); });
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
