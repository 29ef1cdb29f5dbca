// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_PAIRING_HEAP_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_PAIRING_HEAP_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/internal/Boost_heap_queue.h>

#include <boost/heap/pairing_heap.hpp>

#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {

namespace internal {

using Boost_pairing_heap_queue =
    Boost_heap_queue<boost::heap::pairing_heap<Queue_entry, boost::heap::compare<Has_larger_key>>>;

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A priority queue on a pairing heap \cgalCite{fsst-phnfs-86}, from the library Boost.Heap: simpler
 * than a Fibonacci heap, and often faster. Keys are lowered in place.
 *
 * `push()` takes constant time if it enters a node, and amortized time \cgalBigO{\log m}, as Boost
 * states, if it lowers a key; `extract_min()` takes amortized time \cgalBigO{\log m} for `m`
 * entries. Memory is \cgalBigO{n} for `n` nodes.
 *
 * Objects can be moved, but not copied.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
class Pairing_heap_queue
#ifndef DOXYGEN_RUNNING
  : public internal::Boost_pairing_heap_queue
#endif
{
public:
  /// makes an empty queue for a graph with `number_of_nodes` nodes.
  explicit Pairing_heap_queue(const std::size_t number_of_nodes = 0,
                              const Arc_lengths& arcs = Arc_lengths())
    : internal::Boost_pairing_heap_queue(number_of_nodes, arcs)
  {
  }
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_PAIRING_HEAP_QUEUE_H
