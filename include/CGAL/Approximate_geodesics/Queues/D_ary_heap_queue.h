// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_D_ARY_HEAP_QUEUE_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_D_ARY_HEAP_QUEUE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/internal/Boost_heap_queue.h>

#include <boost/heap/d_ary_heap.hpp>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

namespace internal {

template <unsigned D>
using Boost_d_ary_heap_queue =
    Boost_heap_queue<boost::heap::d_ary_heap<Queue_entry,
                                             boost::heap::arity<D>,
                                             boost::heap::mutable_<true>,
                                             boost::heap::compare<Has_larger_key>>>;

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A priority queue based on the implicit `D`-ary heap of Boost.Heap. Keys are decreased in place.
 *
 * `push()` takes time \cgalBigO{\log_D m}, `extract_min()` takes \cgalBigO{D \log_D m} for `m`
 * entries. Memory is \cgalBigO{n} for `n` nodes.
 *
 * The class is movable, but not copyable.
 *
 * \tparam D the number of children, at least 2
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
template <unsigned D = 4>
class D_ary_heap_queue
#ifndef DOXYGEN_RUNNING
  : public internal::Boost_d_ary_heap_queue<D>
#endif
{
public:
  /// constructs an empty queue for a graph with `number_of_nodes` nodes.
  explicit D_ary_heap_queue(const std::size_t number_of_nodes = 0,
                            const Arc_lengths& arcs = Arc_lengths())
    : internal::Boost_d_ary_heap_queue<D>(number_of_nodes, arcs)
  {
  }
};

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * A priority queue based on an implicit binary heap.
 *
 * \cgalModels{GeodesicPriorityQueue}
 */
using Binary_heap_queue = D_ary_heap_queue<2>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_D_ARY_HEAP_QUEUE_H
