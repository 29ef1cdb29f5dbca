// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_FIBONACCI_HEAP_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_FIBONACCI_HEAP_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/internal/Boost_heap_queue.h>

#include <boost/heap/fibonacci_heap.hpp>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

namespace internal {

using Boost_fibonacci_heap_queue = Boost_heap_queue<
    boost::heap::fibonacci_heap<Queue_entry, boost::heap::compare<Has_larger_key>>>;

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A priority queue based on the Fibonacci heap \cgalCite{ft-fhtui-87} of Boost.Heap. It has the
 * best asymptotic bounds of all practical heaps, but large constants. Keys are decreased in place.
 *
 * `push()` takes amortized constant time, `extract_min()` amortized time \cgalBigO{\log m} for `m`
 * entries. Memory is \cgalBigO{n} for `n` nodes.
 *
 * The class is movable, but not copyable.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
class Fibonacci_heap_queue
#ifndef DOXYGEN_RUNNING
  : public internal::Boost_fibonacci_heap_queue
#endif
{
public:
  /// constructs an empty queue for a graph with `number_of_nodes` nodes.
  explicit Fibonacci_heap_queue(const std::size_t number_of_nodes = 0,
                                const Arc_lengths& arcs = Arc_lengths())
    : internal::Boost_fibonacci_heap_queue(number_of_nodes, arcs)
  {
  }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_FIBONACCI_HEAP_QUEUE_H
