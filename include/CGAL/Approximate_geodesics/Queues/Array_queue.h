// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_ARRAY_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_ARRAY_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Queue_entry.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A priority queue that keeps its entries in an unordered array, and searches all of them for the
 * smallest key. This is the queue of Dijkstra's original algorithm \cgalCite{d-ntpcg-59}, provided
 * for comparison.
 *
 * `push()` takes constant time and decreases keys in place; `extract_min()` takes time \cgalBigO{m}
 * for `m` entries. Memory is \cgalBigO{n} for `n` nodes.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
class Array_queue
#ifndef DOXYGEN_RUNNING
  : public internal::Ordered_queue_base
#endif
{
public:
  /// constructs an empty queue for a graph with `number_of_nodes` nodes.
  explicit Array_queue(const std::size_t number_of_nodes = 0, const Arc_lengths& = Arc_lengths())
    : m_position(number_of_nodes, absent)
  {
  }

  /// returns whether the queue is empty.
  bool is_empty() const { return m_entries.empty(); }

  /// inserts `node` with `key`, or decreases its key.
  /// \pre The node exists, and `key` is not smaller than the last extracted key.
  void push(const Node node, const Key key)
  {
    CGAL_precondition(node < m_position.size() && !is_final(key));
    Node& position = m_position[node];
    if(position != absent)
    {
      m_entries[position].key = (std::min)(m_entries[position].key, key);
      return;
    }
    m_entries.push_back({key, node});
    position = static_cast<Node>(m_entries.size() - 1);
  }

  /// removes and returns the entry with the smallest key. \pre `!is_empty()`
  Batch extract_min()
  {
    CGAL_precondition(!is_empty());
    const auto smallest =
        std::min_element(m_entries.begin(), m_entries.end(),
                         [](const Entry& a, const Entry& b) { return a.key < b.key; });
    const Entry result = *smallest;
    *smallest = m_entries.back();
    m_position[smallest->node] = static_cast<Node>(smallest - m_entries.begin());
    m_position[result.node] = absent;
    m_entries.pop_back();
    return hand_out(result);
  }

  /// calls `f(node)` for the nodes of all entries.
  template <typename F>
  void for_each_node(F f) const
  {
    for(const Entry& e : m_entries)
      f(e.node);
  }

  /// removes all entries.
  void clear()
  {
    for(const Entry& e : m_entries)
      m_position[e.node] = absent;
    m_entries.clear();
    restart();
  }

  /// returns the size of the queue in bytes.
  std::size_t memory() const
  {
    return m_entries.capacity() * sizeof(Entry) + m_position.capacity() * sizeof(Node);
  }

private:
  static constexpr Node absent = (std::numeric_limits<Node>::max)();

  std::vector<Entry> m_entries;
  std::vector<Node> m_position; // of the entry, by node
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_ARRAY_QUEUE_H
