// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_BUFFERED_INPUT_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_BUFFERED_INPUT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <ios>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

inline bool is_blank(const char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/*
 * Reads a stream in large pieces, and hands out lines, words or bytes of it. What is handed out is
 * valid until the next call.
 */
class Buffered_input
{
public:
  // The stream is referred to, not copied.
  explicit Buffered_input(std::istream& in) : m_in(in), m_buffer(std::size_t(1) << 18) {}

  // Reads the next line, without its end. Returns whether there is one.
  bool next_line(std::string_view& line)
  {
    std::size_t size = 0;
    const char* end = nullptr;
    do
    {
      end = static_cast<const char*>(std::memchr(begin() + size, '\n', m_size - size));
      size = m_size;
    } while(end == nullptr && refill());
    if(end == nullptr && m_size == 0)
      return false;
    const std::size_t length = end == nullptr ? m_size : static_cast<std::size_t>(end - begin());
    line = std::string_view(begin(), length);
    skip(length + (end == nullptr ? 0 : 1));
    return true;
  }

  // Reads the next word. Returns whether there is one.
  bool next_word(std::string_view& word)
  {
    std::size_t size = 0;
    for(;; skip(1))
      if(m_size == 0 && !refill())
        return false;
      else if(!is_blank(*begin()))
        break;
    while(size < m_size || refill())
      if(is_blank(begin()[size]))
        break;
      else
        ++size;
    word = std::string_view(begin(), size);
    skip(size);
    return true;
  }

  // Returns the next bytes, or null if there are fewer.
  const char* next_bytes(const std::size_t number)
  {
    while(m_size < number)
      if(!refill())
        return nullptr;
    const char* const result = begin();
    skip(number);
    return result;
  }

private:
  const char* begin() const { return m_buffer.data() + m_begin; }

  void skip(const std::size_t number)
  {
    m_begin += number;
    m_size -= number;
  }

  // Reads more behind what has not been handed out. Returns whether there was more.
  bool refill()
  {
    std::memmove(m_buffer.data(), begin(), m_size);
    m_begin = 0;
    if(m_size == m_buffer.size())
      m_buffer.resize(2 * m_buffer.size());
    m_in.read(m_buffer.data() + m_size, static_cast<std::streamsize>(m_buffer.size() - m_size));
    m_size += static_cast<std::size_t>(m_in.gcount());
    return m_in.gcount() > 0;
  }

  std::istream& m_in;
  std::vector<char> m_buffer;
  std::size_t m_begin = 0, m_size = 0; // of what has not been handed out
};

// Takes the first word off a line. It is empty if there is none.
inline std::string_view take_word(std::string_view& line)
{
  std::size_t begin = 0;
  while(begin < line.size() && is_blank(line[begin]))
    ++begin;
  std::size_t end = begin;
  while(end < line.size() && !is_blank(line[end]))
    ++end;
  const std::string_view result = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return result;
}

// Reads a number that is a whole word. Returns whether it is one.
template <typename T>
bool to_number(const std::string_view word, T& number)
{
#ifndef __cpp_lib_to_chars // floating-point numbers are missing
  if constexpr(std::is_floating_point_v<T>)
  {
    const std::string text(word);
    char* end = nullptr;
    number = static_cast<T>(std::is_same_v<T, float> ? std::strtof(text.c_str(), &end)
                                                     : std::strtod(text.c_str(), &end));
    return !text.empty() && *end == '\0';
  }
  else
#endif
  {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
  }
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_BUFFERED_INPUT_H
