// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OFF_ERROR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OFF_ERROR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Mesh_files/Text_lines.h>

#include <cstddef>
#include <ios>
#include <istream>
#include <optional>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

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

/*
 * The start of an OFF file.
 */
struct Off_header
{
  explicit Off_header(Text_lines& line)
  {
    if(!line.next() || line.words.front().find("OFF") == std::string::npos)
    {
      error = "it does not begin with OFF";
      return;
    }
    line.words.erase(line.words.begin());
    is_binary = !line.words.empty() && line.words.front() == "BINARY";
    if(is_binary)
      return;
    if(line.words.empty() && !line.next())
    {
      error = "it ends after OFF";
      return;
    }
    const std::optional<std::size_t> vertices = to_count(line.words.front());
    const std::optional<std::size_t> faces =
        line.words.size() < 2 ? std::nullopt : to_count(line.words[1]);
    if(!vertices || !faces)
      error = line.name() + "the numbers of vertices and faces are expected here";
    number_of_vertices = vertices.value_or(0);
    number_of_faces = faces.value_or(0);
  }

  std::string error;
  bool is_binary = false; // without numbers then
  std::size_t number_of_vertices = 0, number_of_faces = 0;
};

// Whether an OFF file announces no more elements than it has bytes. CGAL's reader allocates all of
// them at once.
inline bool is_long_enough_for_off(std::istream& in)
{
  Text_lines line(in);
  const Off_header header(line);
  in.clear();
  in.seekg(0, std::ios::end);
  return header.number_of_vertices + header.number_of_faces <= static_cast<std::size_t>(in.tellg());
}

// Returns why an OFF file cannot be read, or an empty string if the reason is unknown.
inline std::string error_in_off(std::istream& in)
{
  Text_lines line(in);
  const Off_header header(line);
  if(!header.error.empty() || header.is_binary)
    return header.error;
  const auto end = [](const std::size_t i, const std::size_t size, const std::string& of) {
    return "it ends after " + std::to_string(i) + " of " + std::to_string(size) + ' ' + of;
  };
  for(std::size_t i = 0; i < header.number_of_vertices; ++i)
    if(!line.next())
      return end(i, header.number_of_vertices, "vertices");
    else if(!has_coordinates(line.words, 0))
      return line.name() + "vertex " + std::to_string(i) +
             " does not have three finite coordinates";
  for(std::size_t i = 0; i < header.number_of_faces; ++i)
  {
    if(!line.next())
      return end(i, header.number_of_faces, "faces");
    const std::string error = error_in_off_face(line, i, header.number_of_vertices);
    if(!error.empty())
      return error;
  }
  return "";
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OFF_ERROR_H
