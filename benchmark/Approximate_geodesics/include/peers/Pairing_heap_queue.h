// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_PAIRING_HEAP_QUEUE_H
#define BENCHMARK_PAIRING_HEAP_QUEUE_H

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>

#include <boost/heap/pairing_heap.hpp>

namespace CGAL::Approximate_geodesics {

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
using Pairing_heap_queue = internal::Queue_of_heap<boost::heap::pairing_heap>;

} // namespace CGAL::Approximate_geodesics

#endif // BENCHMARK_PAIRING_HEAP_QUEUE_H
