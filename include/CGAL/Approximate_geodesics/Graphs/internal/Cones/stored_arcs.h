// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// An arc as it is stored: lengths are in a unit of the rows, and rounded up.
struct Stored_arc
{
  std::uint32_t target;
  float length;
};

// The smallest `float` that is not below `x`, which is not negative. Whether it is the nearest one
// cannot be predicted, so there is no branch: the next `float` is that of the next number.
inline float round_up(const double x)
{
  static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == sizeof(std::uint32_t));
  float result = static_cast<float>(x);
  std::uint32_t bits;
  std::memcpy(&bits, &result, sizeof(bits));
  bits += static_cast<std::uint32_t>(static_cast<double>(result) < x);
  std::memcpy(&result, &bits, sizeof(bits));
  return result;
}

// The middle of the lengths that are rounded up to this one: the line of an arc is nearer to it
// than a line that is longer than its arc.
inline double before_rounding_up(const double length) { return length * (1 - 0x1p-24); }

// A unit in which arcs fit a `float`: a power of two near the longest edge.
inline double unit_of_arcs(const Intrinsic_triangulation& triangulation)
{
  const auto& lengths = triangulation.lengths();
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  return longest > 0 ? std::ldexp(1., std::ilogb(longest)) : 1;
}

// Sorts arcs by their targets, and keeps only the shortest one to each target.
inline void sort_many_arcs(std::vector<Stored_arc>& arcs)
{
  std::sort(arcs.begin(), arcs.end(), [](const Stored_arc& a, const Stored_arc& b) {
    return std::tie(a.target, a.length) < std::tie(b.target, b.length);
  });
  const auto end =
      std::unique(arcs.begin(), arcs.end(),
                  [](const Stored_arc& a, const Stored_arc& b) { return a.target == b.target; });
  arcs.erase(end, arcs.end());
}

constexpr std::size_t FEW_ARCS = 128; // a multiple of the number of lanes

// Does the same for few arcs: the position of an arc is the number of smaller targets. Counting
// them takes vector instructions and no branch, and half the time of sorting.
inline void sort_few_arcs(std::vector<Stored_arc>& arcs)
{
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  constexpr std::size_t lanes = 16;
  std::array<std::uint32_t, FEW_ARCS> targets;
  std::array<Stored_arc, FEW_ARCS> sorted;
  const std::size_t size = arcs.size(), counted = (size + lanes - 1) / lanes * lanes;
  std::fill_n(targets.begin(), counted, none);
  std::fill_n(sorted.begin(), size, Stored_arc{none, std::numeric_limits<float>::infinity()});
  std::transform(arcs.begin(), arcs.end(), targets.begin(),
                 [](const Stored_arc& arc) { return arc.target; });
  for(const Stored_arc& arc : arcs)
  {
    std::uint32_t rank = 0;
    for(std::size_t i = 0; i < counted; ++i)
      rank += static_cast<std::uint32_t>(targets[i] < arc.target);
    sorted[rank] = {arc.target, (std::min)(sorted[rank].length, arc.length)};
  }
  const auto end =
      std::copy_if(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(size), arcs.begin(),
                   [=](const Stored_arc& a) { return a.target != none; });
  arcs.erase(end, arcs.end());
}

// Replaces `arcs` by those of `node`, as they are stored: sorted, with only the shortest one to
// each target. `for_each_arc(f)` calls `f(target, length)`.
template <typename ForEachArc>
void find_stored_arcs(const Index node,
                      const double unit,
                      std::vector<Stored_arc>& arcs,
                      ForEachArc for_each_arc)
{
  arcs.clear();
  for_each_arc([&](const Index target, const double length) {
    if(target != node)
      arcs.push_back({target, round_up(length / unit)});
  });
  if(arcs.size() <= FEW_ARCS)
    sort_few_arcs(arcs);
  else
    sort_many_arcs(arcs);
}

/*
 * The arcs of consecutive nodes, in 6 bytes each.
 *
 * A search reads most of them from main memory, so their size determines its time. A row is made up
 * of words of 32 bits: the smallest target, the lengths, and the differences of the targets from
 * the smallest one, 16 bits each. In the few rows where these do not fit, targets are stored as
 * they are, after the marker WIDE. Before all rows, a word each tells where they begin.
 */
class Arc_block
{
  using Word = std::uint32_t;

public:
  static constexpr std::size_t MAXIMUM_SIZE = 1024; // a power of two

  std::size_t size() const { return m_size; }
  std::size_t maximum_degree() const { return m_maximum_degree; }
  const Arc_length_summary& summary() const { return m_summary; }

  // Removes all rows, and keeps the memory.
  void clear()
  {
    m_words.clear();
    m_size = m_maximum_degree = 0;
    m_summary = Arc_length_summary();
  }

  // Appends the arcs of the next node, which are sorted by targets, all different.
  // \pre There are less than `MAXIMUM_SIZE` rows.
  void append(const std::vector<Stored_arc>& arcs)
  {
    CGAL_precondition(m_size < MAXIMUM_SIZE);
    if(m_size == 0)
      m_words.assign(MAXIMUM_SIZE + 1, static_cast<Word>(MAXIMUM_SIZE + 1));
    if(!arcs.empty())
    {
      constexpr Index largest_difference = (std::numeric_limits<std::uint16_t>::max)();
      const Index base = arcs.front().target;
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
    if(m_words.size() > (std::numeric_limits<Word>::max)())
      throw std::length_error("Approximate_geodesics: consecutive nodes of a discrete geodesic "
                              "graph have more than 2^31 arcs");
    m_words[++m_size] = static_cast<Word>(m_words.size());
    m_maximum_degree = (std::max)(m_maximum_degree, arcs.size());
    for(const Stored_arc& arc : arcs)
      m_summary.add(static_cast<double>(arc.length));
  }

  // Calls `f(target, length)` for every arc of a row.
  template <typename F>
  void for_each_arc(const std::size_t row, F f) const
  {
    const std::size_t size = number_of_words(row);
    if(size == 0)
      return;
    const Word* const words = first_word(row);
    const Word base = *words;
    const char* const lengths = reinterpret_cast<const char*>(words + 1);
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

  std::size_t degree(const std::size_t row) const
  {
    const std::size_t size = number_of_words(row);
    if(size == 0)
      return 0;
    return *first_word(row) != WIDE ? narrow_degree(size) : wide_degree(size);
  }

  // Prefetches six cache lines, the size of a typical row, even if there are fewer.
  void prefetch(const std::size_t row) const
  {
    constexpr std::size_t lines = 6, words_per_cache_line = 64 / sizeof(Word);
    for(std::size_t i = 0; i < lines; ++i)
      internal::prefetch(m_words.data(), m_words[row] + i * words_per_cache_line);
  }

  void shrink_to_fit() { m_words.shrink_to_fit(); }

  std::size_t memory() const { return memory_of(m_words); }

private:
  static constexpr Word WIDE = null_index;

  static std::size_t narrow_degree(const std::size_t size) { return (4 * size - 4) / 6; }
  static std::size_t wide_degree(const std::size_t size) { return (size - 1) / 2; }

  const Word* first_word(const std::size_t row) const { return m_words.data() + m_words[row]; }
  std::size_t number_of_words(const std::size_t row) const
  {
    return m_words[row + 1] - m_words[row];
  }

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

  std::vector<Word> m_words; // where rows begin, where the last one ends, and the rows
  std::size_t m_size = 0;
  std::size_t m_maximum_degree = 0;
  Arc_length_summary m_summary;
};

/*
 * The arcs of a graph, in blocks of rows: threads build these independently, and none is copied.
 */
class Compressed_arcs
{
public:
  using Node = Index;

  // Lengths are in units of `unit`, a power of two.
  explicit Compressed_arcs(const double unit = 1) : m_unit(unit) {}

  // All blocks but the last one are full.
  Compressed_arcs(const double unit, std::vector<Arc_block> blocks)
    : m_blocks(std::move(blocks)), m_unit(unit)
  {
    for(const Arc_block& block : m_blocks)
      m_maximum_degree = (std::max)(m_maximum_degree, block.maximum_degree());
  }

  std::size_t number_of_rows() const
  {
    return m_blocks.empty() ? 0 : (m_blocks.size() - 1) * SIZE_OF_BLOCK + m_blocks.back().size();
  }
  std::size_t number_of_arcs() const { return summary().number_of_arcs(); }
  Arc_lengths arc_lengths() const { return summary().result(m_unit); }
  double unit() const { return m_unit; }

  // A search asks for it with every batch of nodes.
  std::size_t maximum_degree() const { return m_maximum_degree; }

  // Appends the arcs of the next node, which are sorted by targets, all different.
  void append_row(const std::vector<Stored_arc>& arcs)
  {
    if(m_blocks.empty() || m_blocks.back().size() == SIZE_OF_BLOCK)
    {
      shrink_to_fit();
      m_blocks.emplace_back();
    }
    m_blocks.back().append(arcs);
    m_maximum_degree = (std::max)(m_maximum_degree, arcs.size());
  }

  // Calls `f(target, length)` for every arc of `node`.
  template <typename F>
  void for_each_arc(const Node node, F f) const
  {
    // copies, which compilers keep in registers
    for_each_stored_arc(
        node, [f = std::move(f), unit = m_unit](const Node target, const float length) mutable {
          f(target, static_cast<double>(length) * unit);
        });
  }

  template <typename F>
  void for_each_stored_arc(const Node node, F f) const
  {
    block(node).for_each_arc(node % SIZE_OF_BLOCK, f);
  }

  std::size_t degree(const Node node) const { return block(node).degree(node % SIZE_OF_BLOCK); }

  void prefetch(const Node node) const { block(node).prefetch(node % SIZE_OF_BLOCK); }

  // Shrinks the last block; the others have no spare capacity.
  void shrink_to_fit()
  {
    if(!m_blocks.empty())
      m_blocks.back().shrink_to_fit();
  }

  std::size_t memory() const
  {
    std::size_t result = memory_of(m_blocks);
    for(const Arc_block& block : m_blocks)
      result += block.memory();
    return result;
  }

private:
  static constexpr std::size_t SIZE_OF_BLOCK = Arc_block::MAXIMUM_SIZE;

  const Arc_block& block(const Node node) const { return m_blocks[node / SIZE_OF_BLOCK]; }

  Arc_length_summary summary() const
  {
    Arc_length_summary result;
    for(const Arc_block& block : m_blocks)
      result.add(block.summary());
    return result;
  }

  std::vector<Arc_block> m_blocks;
  std::size_t m_maximum_degree = 0;
  double m_unit;
};

/*
 * The arcs of the nodes that were requested. The class is thread-safe: the arcs of a node are those
 * of the first thread that has computed them.
 */
class Arc_cache
{
public:
  using Arcs = std::vector<Stored_arc>;

  Arc_cache() = default;

  explicit Arc_cache(const std::size_t number_of_nodes) : m_arcs(number_of_nodes) {}

  Arc_cache(Arc_cache&&) = default;

  Arc_cache& operator=(Arc_cache&& other) noexcept
  {
    m_arcs.swap(other.m_arcs);
    return *this;
  }

  ~Arc_cache()
  {
    for(const auto& arcs : m_arcs)
      delete arcs.load(std::memory_order_relaxed);
  }

  // Whether arcs are kept.
  bool is_enabled() const { return !m_arcs.empty(); }

  // The arcs of `node`, computed by `find(arcs)` on first request.
  template <typename F>
  const Arcs& arcs(const std::size_t node, F find)
  {
    std::atomic<const Arcs*>& slot = m_arcs[node];
    if(const Arcs* const known = slot.load(std::memory_order_acquire))
      return *known;
    auto mine = std::make_unique<Arcs>();
    find(*mine);
    mine->shrink_to_fit();
    const Arcs* expected = nullptr;
    if(slot.compare_exchange_strong(expected, mine.get(), std::memory_order_acq_rel,
                                    std::memory_order_acquire))
      return *mine.release();
    return *expected;
  }

  std::size_t memory() const
  {
    std::size_t result = memory_of(m_arcs);
    for(const auto& kept : m_arcs)
      if(const Arcs* const arcs = kept.load(std::memory_order_acquire))
        result += sizeof(Arcs) + memory_of(*arcs);
    return result;
  }

private:
  std::vector<std::atomic<const Arcs*>> m_arcs; // null where they are not known
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H
