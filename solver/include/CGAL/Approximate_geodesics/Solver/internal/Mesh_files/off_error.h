// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OFF_ERROR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OFF_ERROR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Mesh_files/Text_lines.h>

#include <cstddef>
#include <istream>
#include <optional>
#include <string>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Returns the error in a face line, or an empty string.
inline std::string error_in_off_face(const Text_lines& line,
                                     const std::size_t face,
                                     const std::size_t number_of_vertices)
{
  const std::string name = "face " + std::to_string(face);
  const std::optional<std::size_t> size = to_count(line.words.front());
  if(!size)
    return line.name() + name + " has \"" + line.words.front() +
           "\" instead of its number of vertices";
  for(std::size_t i = 1; i <= *size; ++i)
  {
    if(i >= line.words.size())
      return line.name() + name + " has " + std::to_string(i - 1) + " of its " +
             std::to_string(*size) + " vertices";
    const std::optional<std::size_t> vertex = to_count(line.words[i]);
    if(!vertex || *vertex >= number_of_vertices)
      return line.name() + text_of_wrong_corner(face, line.words[i], number_of_vertices);
  }
  return "";
}

// Returns why an OFF file cannot be read, or an empty string if the reason is unknown.
inline std::string error_in_off(std::istream& in)
{
  Text_lines line(in);
  if(!line.next() || line.words.front().find("OFF") == std::string::npos)
    return "it does not begin with OFF";
  line.words.erase(line.words.begin());
  if(!line.words.empty() && line.words.front() == "BINARY")
    return "";
  if(line.words.empty() && !line.next())
    return "it ends after OFF";
  const std::optional<std::size_t> vertices = to_count(line.words.front());
  const std::optional<std::size_t> faces =
      line.words.size() < 2 ? std::nullopt : to_count(line.words[1]);
  if(!vertices || !faces)
    return line.name() + "the numbers of vertices and faces are expected here";

  const auto end = [](const std::size_t i, const std::size_t size, const std::string& of) {
    return "it ends after " + std::to_string(i) + " of " + std::to_string(size) + ' ' + of;
  };
  for(std::size_t i = 0; i < *vertices; ++i)
    if(!line.next())
      return end(i, *vertices, "vertices");
    else if(!has_coordinates(line.words, 0))
      return line.name() + "vertex " + std::to_string(i) +
             " does not have three finite coordinates";
  for(std::size_t i = 0; i < *faces; ++i)
  {
    if(!line.next())
      return end(i, *faces, "faces");
    const std::string error = error_in_off_face(line, i, *vertices);
    if(!error.empty())
      return error;
  }
  return "";
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OFF_ERROR_H
