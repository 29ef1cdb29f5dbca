// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OBJ_ERROR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OBJ_ERROR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/internal/Mesh_files/Text_lines.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <istream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Whether CGAL's reader accepts a keyword.
inline bool can_be_in_obj(const std::string& word)
{
  std::istringstream in("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + word + "\n");
  std::vector<Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  return IO::read_OBJ(in, points, faces);
}

// Returns the error in a face line, or an empty string. Vertex numbers start from 1; negative ones
// count from the end.
inline std::string error_in_obj_face(const Text_lines& line,
                                     const std::size_t face,
                                     const std::size_t number_of_vertices)
{
  const std::string name = "face " + std::to_string(face);
  for(std::size_t i = 1; i < line.words.size(); ++i)
  {
    const std::string vertex = line.words[i].substr(0, line.words[i].find('/'));
    const std::optional<std::size_t> index = to_count(vertex.substr(vertex[0] == '-' ? 1 : 0));
    if(!index || *index == 0 || *index > number_of_vertices)
      return line.name() + name + " has vertex " + vertex +
             "; the vertices are numbered from 1, and there are " +
             std::to_string(number_of_vertices);
  }
  return line.words.size() < 4 ? line.name() + name + " has fewer than three vertices" : "";
}

// Returns why an OBJ file cannot be read, or an empty string if the reason is unknown.
inline std::string error_in_obj(std::istream& in)
{
  std::size_t number_of_vertices = 0, number_of_faces = 0;
  std::set<std::string> known{"v", "f"};
  for(Text_lines line(in); line.next();)
  {
    const std::string& first = line.words.front();
    if(first == "v" && !has_coordinates(line.words, 1))
      return line.name() + "vertex " + std::to_string(number_of_vertices) +
             " does not have three finite coordinates";
    if(known.insert(first).second && !can_be_in_obj(first))
      return line.name() + '"' + first + "\" is an unknown keyword";
    number_of_vertices += first == "v" ? 1 : 0;
  }
  in.clear();
  in.seekg(0);
  for(Text_lines line(in); line.next();)
    if(line.words.front() == "f")
    {
      const std::string error = error_in_obj_face(line, number_of_faces++, number_of_vertices);
      if(!error.empty())
        return error;
    }
  return number_of_faces == 0 ? "it has no faces" : "";
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_OBJ_ERROR_H
