#ifndef COMMAND_LINE_LISTED_VERTICES_H
#define COMMAND_LINE_LISTED_VERTICES_H

#include "lines_of_file.h"
#include "vertex_numbers.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

struct Listed_vertex
{
  std::size_t index;
  std::string line; // of a file, for errors
};

// Vertices that a text file lists, by their indices; the rest of a line after # is a comment.
inline std::vector<Listed_vertex> listed_vertices(const std::string& file)
{
  std::vector<Listed_vertex> result;
  for_each_line(file, [&](const std::vector<std::string>& words, const std::string& line) {
    for(const std::string& word : words)
      result.push_back({to_vertex_index(word), line});
  });
  if(result.empty())
    throw std::invalid_argument("the file lists no vertex");
  return result;
}

// The same, if all are vertices of a mesh.
inline std::vector<std::size_t> checked_indices(const std::vector<Listed_vertex>& listed,
                                                const std::size_t number_of_vertices)
{
  std::vector<std::size_t> result;
  for(const Listed_vertex& vertex : listed)
  {
    const auto check = [&] { check_vertex_index(vertex.index, number_of_vertices); };
    if(vertex.line.empty())
      check();
    else
      name_in_errors(vertex.line, check);
    result.push_back(vertex.index);
  }
  return result;
}

#endif // COMMAND_LINE_LISTED_VERTICES_H
