#ifndef COMMAND_LINE_VERTEX_NUMBERS_H
#define COMMAND_LINE_VERTEX_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <numeric>
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

inline std::string name_of_line(const std::size_t number)
{
  return "line " + std::to_string(number);
}

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
  const std::size_t result = to_number(text.substr(prefix.size()));
  if(result == 0)
    throw std::invalid_argument("no vertex is chosen");
  return result;
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

// `number` of `size` vertices, all of them different, and the same with every standard library.
inline std::vector<std::uint64_t>
random_vertices(const std::size_t size, const std::size_t number, std::mt19937_64& random)
{
  check_number_of_vertices(number, size);
  std::vector<std::uint64_t> result(size);
  std::iota(result.begin(), result.end(), std::uint64_t(0));
  for(std::size_t i = 0; i < number; ++i)
    std::swap(result[i], result[i + random() % (size - i)]);
  result.resize(number);
  return result;
}

#endif // COMMAND_LINE_VERTEX_NUMBERS_H
