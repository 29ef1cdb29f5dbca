#ifndef COMMAND_LINE_VERTEX_NUMBERS_H
#define COMMAND_LINE_VERTEX_NUMBERS_H

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

inline std::size_t to_number(const std::string& text)
{
  if(text.empty() || text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos)
    throw std::invalid_argument("\"" + text + "\" is not a number of vertices, nor a vertex index");
  return std::stoull(text);
}

// The number of vertices that is asked for, such as 5 in `random:5`, if `kind` is `random`.
inline std::optional<std::size_t> number_after(const std::string& kind, const std::string& text)
{
  const std::string prefix = kind + ':';
  if(text.compare(0, prefix.size(), prefix) != 0)
    return std::nullopt;
  return to_number(text.substr(prefix.size()));
}

inline void check_vertex_index(const std::size_t index, const std::size_t number_of_vertices)
{
  if(index >= number_of_vertices)
    throw std::invalid_argument("there is no vertex " + std::to_string(index) + ": the mesh has " +
                                std::to_string(number_of_vertices) + " vertices");
}

#endif // COMMAND_LINE_VERTEX_NUMBERS_H
