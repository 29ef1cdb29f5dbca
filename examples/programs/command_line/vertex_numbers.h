#ifndef COMMAND_LINE_VERTEX_NUMBERS_H
#define COMMAND_LINE_VERTEX_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Returns `f()`; if that refuses its input, says which it is.
template <typename F>
auto name_in_errors(const std::string& name, F f)
{
  try
  {
    return f();
  }
  catch(const std::invalid_argument& e)
  {
    throw std::invalid_argument(name + ": " + e.what());
  }
}

inline bool is_whole_number(const std::string& text)
{
  return !text.empty() && text.size() <= 18 &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

// `alternatives` are named in errors.
inline std::size_t to_vertex_index(const std::string& text, const std::string& alternatives = "")
{
  if(!is_whole_number(text))
    throw std::invalid_argument('"' + text + "\" is not the index of a vertex" + alternatives);
  return std::stoull(text);
}

inline std::optional<std::string> text_after(const std::string& kind, const std::string& text)
{
  const std::string prefix = kind + ':';
  if(text.compare(0, prefix.size(), prefix) != 0)
    return std::nullopt;
  return text.substr(prefix.size());
}

// The number of vertices that is asked for, such as 5 in `random:5`, if `kind` is `random`.
inline std::optional<std::size_t> number_after(const std::string& kind, const std::string& text)
{
  const std::optional<std::string> number = text_after(kind, text);
  if(!number)
    return std::nullopt;
  if(!is_whole_number(*number) || std::stoull(*number) == 0)
    throw std::invalid_argument("a number of vertices from 1 on must follow, as in " + kind + ":5");
  return std::stoull(*number);
}

inline void check_vertex_index(const std::size_t index, const std::size_t number_of_vertices)
{
  if(index >= number_of_vertices)
    throw std::invalid_argument("there is no vertex " + std::to_string(index) + ": the mesh has " +
                                std::to_string(number_of_vertices) + " vertices");
}

inline void check_number_of_vertices(const std::size_t wanted, const std::size_t number_of_vertices)
{
  if(wanted > number_of_vertices)
    throw std::invalid_argument("the mesh has " + std::to_string(number_of_vertices) + " vertices");
}

// `number` of the vertices, all of them different, and the same with every standard library.
inline std::vector<std::uint64_t> random_vertices(std::vector<std::uint64_t> vertices,
                                                  const std::size_t number,
                                                  std::mt19937_64& random)
{
  const std::size_t size = vertices.size();
  check_number_of_vertices(number, size);
  for(std::size_t i = 0; i < number; ++i)
    std::swap(vertices[i], vertices[i + random() % (size - i)]);
  vertices.resize(number);
  return vertices;
}

#endif // COMMAND_LINE_VERTEX_NUMBERS_H
