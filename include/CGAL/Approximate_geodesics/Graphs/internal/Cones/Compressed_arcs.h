// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_COMPRESSED_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_COMPRESSED_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/prefetch.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/stored_arcs.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The arcs of a graph, one node after the other, in 6 bytes each.
 *
 * A search gets them from memory for the most part, so bytes are time. A row is made up of words
 * of 32 bits: the smallest target, the lengths, and the differences of the targets from the
 * smallest one, 16 bits each. In the few rows where these do not fit, there are whole targets
 * instead, which WIDE says at the start.
 */
class Compressed_arcs
{
  using Word = std::uint32_t;

public:
  using Node = Intrinsic_triangulation::Index;

  // Lengths are in units of `unit`, a power of two.
  explicit Compressed_arcs(const double unit = 1) : m_first(1, 0), m_unit(unit) {}

  std::size_t number_of_rows() const { return m_first.size() - 1; }
  std::size_t number_of_arcs() const { return m_summary.number_of_arcs(); }
  std::size_t maximum_degree() const { return m_maximum_degree; }
  double unit() const { return m_unit; }

  Arc_lengths arc_lengths() const { return m_summary.result(m_unit); }

  void reserve(const std::size_t number_of_rows) { m_first.reserve(number_of_rows + 1); }

  // Makes room for all rows of these.
  void reserve(const std::vector<Compressed_arcs>& parts)
  {
    std::size_t number_of_rows = 0, number_of_words = 0;
    for(const Compressed_arcs& part : parts)
    {
      number_of_rows += part.number_of_rows();
      number_of_words += part.m_words.size();
    }
    reserve(number_of_rows);
    m_words.reserve(number_of_words);
  }

  // Appends the arcs of the next node, which are sorted by targets, all different.
  void append_row(const std::vector<Stored_arc>& arcs)
  {
    if(!arcs.empty())
      append_words(arcs);
    m_first.push_back(m_words.size());
    m_maximum_degree = (std::max)(m_maximum_degree, arcs.size());
    for(const Stored_arc& arc : arcs)
      m_summary.add(static_cast<double>(arc.length));
  }

  // Appends the rows of the nodes that follow, in the same unit.
  void append(const Compressed_arcs& other)
  {
    CGAL_precondition(other.m_unit == m_unit);
    const std::size_t shift = m_words.size();
    m_words.insert(m_words.end(), other.m_words.begin(), other.m_words.end());
    for(std::size_t i = 1; i < other.m_first.size(); ++i)
      m_first.push_back(shift + other.m_first[i]);
    m_maximum_degree = (std::max)(m_maximum_degree, other.m_maximum_degree);
    m_summary.add(other.m_summary);
  }

  // Calls `f(target, length)` for every arc of `node`.
  template <typename F>
  void for_each_arc(const Node node, F f) const
  {
    const double unit = m_unit; // `f` cannot change it
    for_each_stored_arc(node, [&](const Node target, const float length) {
      f(target, static_cast<double>(length) * unit);
    });
  }

  template <typename F>
  void for_each_stored_arc(const Node node, F f) const
  {
    const Word* const row = m_words.data() + m_first[node];
    const std::size_t size = m_first[node + 1] - m_first[node];
    if(size == 0)
      return;
    const Word base = *row;
    const char* const lengths = reinterpret_cast<const char*>(row + 1);
    if(base != WIDE)
    {
      const std::size_t degree = narrow_degree(size);
      const char* const targets = lengths + degree * sizeof(float);
      for(std::size_t i = 0; i < degree; ++i)
        f(base + read<std::uint16_t>(targets, i), read<float>(lengths, i));
    }
    else
    {
      const std::size_t degree = wide_degree(size);
      const char* const targets = lengths + degree * sizeof(float);
      for(std::size_t i = 0; i < degree; ++i)
        f(read<std::uint32_t>(targets, i), read<float>(lengths, i));
    }
  }

  std::size_t degree(const Node node) const
  {
    const std::size_t size = m_first[node + 1] - m_first[node];
    if(size == 0)
      return 0;
    return m_words[m_first[node]] != WIDE ? narrow_degree(size) : wide_degree(size);
  }

  // Prefetches six cache lines, the size of a typical row, even if there are fewer.
  void prefetch(const Node node) const
  {
    constexpr std::size_t lines = 6, words_per_cache_line = 64 / sizeof(m_words[0]);
    for(std::size_t i = 0; i < lines; ++i)
      internal::prefetch(m_words.data(), m_first[node] + i * words_per_cache_line);
  }

  void shrink_to_fit()
  {
    m_words.shrink_to_fit();
    m_first.shrink_to_fit();
  }

  std::size_t memory() const
  {
    return m_words.capacity() * sizeof(Word) + m_first.capacity() * sizeof(std::size_t);
  }

private:
  static constexpr Word WIDE = Intrinsic_triangulation::null_index;

  static std::size_t narrow_degree(const std::size_t size) { return (4 * size - 4) / 6; }
  static std::size_t wide_degree(const std::size_t size) { return (size - 1) / 2; }

  template <typename T>
  static T read(const char* const array, const std::size_t i)
  {
    T result;
    std::memcpy(&result, array + i * sizeof(T), sizeof(T));
    return result;
  }

  template <typename T>
  static void write(char*& end, const T value)
  {
    std::memcpy(end, &value, sizeof(T));
    end += sizeof(T);
  }

  void append_words(const std::vector<Stored_arc>& arcs)
  {
    constexpr Node largest_difference = (std::numeric_limits<std::uint16_t>::max)();
    const Node base = arcs.front().target;
    const bool is_wide = arcs.back().target - base > largest_difference;
    const std::size_t words_of_targets = is_wide ? arcs.size() : (arcs.size() + 1) / 2;
    const std::size_t first = m_words.size();
    m_words.resize(first + 1 + arcs.size() + words_of_targets);
    char* end = reinterpret_cast<char*>(m_words.data() + first);
    write(end, is_wide ? WIDE : base);
    for(const Stored_arc& arc : arcs)
      write(end, arc.length);
    for(const Stored_arc& arc : arcs)
      if(is_wide)
        write(end, arc.target);
      else
        write(end, static_cast<std::uint16_t>(arc.target - base));
  }

  std::vector<Word> m_words;
  std::vector<std::size_t> m_first; // per node, and one beyond
  double m_unit;
  Arc_length_summary m_summary; // in that unit
  std::size_t m_maximum_degree = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_COMPRESSED_ARCS_H
