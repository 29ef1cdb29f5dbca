// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_INDEXED_HEAP_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_INDEXED_HEAP_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queues/Queue_entry.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * An implicit 4-ary heap with at most one entry per node, which supports decreasing keys. The array
 * of entry positions is allocated at the first push. Unlike `boost::d_ary_heap_indirect`, it lists
 * its entries, and clear() takes time in proportion to their number.
 */
class Indexed_heap
{
public:
  using Node = std::uint32_t;
  using Entry = Queue_entry;

  explicit Indexed_heap(const std::size_t number_of_nodes) : m_number_of_nodes(number_of_nodes) {}

  bool is_empty() const { return m_entries.empty(); }
  std::size_t size() const { return m_entries.size(); }

  // The entry with the smallest key.
  const Entry& top() const { return m_entries.front(); }

  // All entries, in heap order.
  const std::vector<Entry>& entries() const { return m_entries; }

  // The number of comparisons since the last call of `clear()`.
  std::size_t comparisons() const { return m_comparisons; }

  // Inserts a node, or decreases its key. Returns whether the node is new.
  bool push(const Entry& e)
  {
    if(e.node >= m_position.size())
      m_position.resize((std::max)(m_number_of_nodes, std::size_t(e.node) + 1), ABSENT);
    const Position position = m_position[e.node];
    if(position == ABSENT)
    {
      m_entries.push_back(e);
      move_up(m_entries.size() - 1, e);
      return true;
    }
    if(e.key < m_entries[position].key)
      move_up(position, e);
    return false;
  }

  // Removes the entry with the smallest key.
  void pop()
  {
    CGAL_precondition(!is_empty());
    m_position[top().node] = ABSENT;
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(!is_empty())
      move_down(last);
  }

  void clear()
  {
    for(const Entry& e : m_entries)
      m_position[e.node] = ABSENT;
    m_entries.clear();
    m_comparisons = 0;
  }

  std::size_t memory() const
  {
    return m_entries.capacity() * sizeof(Entry) + m_position.capacity() * sizeof(Position);
  }

private:
  using Position = std::uint32_t; // entries do not outnumber nodes

  static constexpr Position ABSENT = (std::numeric_limits<Position>::max)();
  static constexpr std::size_t ARITY = 4;

  void place(const std::size_t position, const Entry& e)
  {
    m_entries[position] = e;
    m_position[e.node] = static_cast<Position>(position);
  }

  // Sifts `e` up from a position.
  void move_up(std::size_t position, const Entry& e)
  {
    while(position > 0)
    {
      const std::size_t parent = (position - 1) / ARITY;
      ++m_comparisons;
      if(!(e.key < m_entries[parent].key))
        break;
      place(position, m_entries[parent]);
      position = parent;
    }
    place(position, e);
  }

  // Sifts `e` down from the top.
  void move_down(const Entry& e)
  {
    std::size_t position = 0;
    for(;;)
    {
      const std::size_t first = ARITY * position + 1;
      if(first >= size())
        break;
      const std::size_t child = smallest(first, (std::min)(first + ARITY, size()));
      ++m_comparisons;
      if(!(m_entries[child].key < e.key))
        break;
      place(position, m_entries[child]);
      position = child;
    }
    place(position, e);
  }

  std::size_t smallest(const std::size_t first, const std::size_t beyond)
  {
    std::size_t result = first;
    for(std::size_t i = first + 1; i < beyond; ++i)
      result = m_entries[i].key < m_entries[result].key ? i : result;
    m_comparisons += beyond - first - 1;
    return result;
  }

  std::size_t m_number_of_nodes;
  std::vector<Entry> m_entries;
  std::vector<Position> m_position; // by node; empty until the first push
  std::size_t m_comparisons = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_INTERNAL_INDEXED_HEAP_H
