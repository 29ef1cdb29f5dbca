// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_TEXT_LINES_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_TEXT_LINES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <istream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Splits a text into lines of words. It skips blank lines, and comments that begin with #.
 */
class Text_lines
{
public:
  // The stream is referred to, not copied.
  explicit Text_lines(std::istream& in) : m_in(in) {}

  // Reads the next line. Returns whether there is one.
  bool next()
  {
    words.clear();
    for(std::string text; words.empty() && std::getline(m_in, text); ++m_number)
    {
      std::istringstream stream(text.substr(0, text.find('#')));
      for(std::string word; stream >> word;)
        words.push_back(word);
    }
    return !words.empty();
  }

  // The prefix of messages about the current line.
  std::string name() const { return "line " + std::to_string(m_number) + ": "; }

  std::vector<std::string> words;

private:
  std::istream& m_in;
  std::size_t m_number = 0; // counted from 1
};

inline bool is_finite_number(const std::string& word)
{
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return !word.empty() && *end == '\0' && std::isfinite(value);
}

inline std::optional<std::size_t> to_count(const std::string& word)
{
  if(word.empty() || word.size() > 18 || word.find_first_not_of("0123456789") != word.npos)
    return std::nullopt;
  return std::stoull(word);
}

// Whether three numbers begin at a word.
inline bool has_coordinates(const std::vector<std::string>& words, const std::size_t first)
{
  for(std::size_t i = first; i < first + 3; ++i)
    if(i >= words.size() || !is_finite_number(words[i]))
      return false;
  return true;
}

inline std::string text_of_wrong_corner(const std::size_t face,
                                        const std::string& vertex,
                                        const std::size_t number_of_vertices)
{
  return "face " + std::to_string(face) + " has vertex " + vertex +
         "; the vertices are numbered from 0, and there are " + std::to_string(number_of_vertices);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MESH_FILES_TEXT_LINES_H
