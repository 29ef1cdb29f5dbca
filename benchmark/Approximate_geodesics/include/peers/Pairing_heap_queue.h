// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_PAIRING_HEAP_QUEUE_H
#define BENCHMARK_PAIRING_HEAP_QUEUE_H

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Heap_queues.h>

#include <boost/heap/pairing_heap.hpp>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

namespace internal {

using Boost_pairing_heap_queue =
    Boost_heap_queue<boost::heap::pairing_heap<Queue_entry, boost::heap::compare<Has_larger_key>>>;

} // namespace internal

/*
 * A priority queue based on the pairing heap (Fredman et al. 1986) of Boost.Heap: simpler than a
 * Fibonacci heap, and often faster. Keys are decreased in place.
 *
 * `push()` takes constant time to insert a node, and amortized time O(log m), according to Boost,
 * to decrease a key; `extract_min()` takes amortized time O(log m) for `m` entries. Memory is O(n)
 * for `n` nodes.
 *
 * The class is movable, but not copyable.
 */
class Pairing_heap_queue : public internal::Boost_pairing_heap_queue
{
public:
  // Constructs an empty queue for a graph with `number_of_nodes` nodes.
  explicit Pairing_heap_queue(const std::size_t number_of_nodes = 0,
                              const Arc_lengths& arcs = Arc_lengths())
    : internal::Boost_pairing_heap_queue(number_of_nodes, arcs)
  {
  }
};

} // namespace CGAL::Approximate_geodesics

#endif // BENCHMARK_PAIRING_HEAP_QUEUE_H
