// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_STATISTICS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_STATISTICS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * What a run of `Propagation` did, if it was asked to count.
 */
struct Propagation_statistics
{
  /// the number of nodes whose distance was found.
  std::size_t settled_nodes = 0;
  /// the number of entries taken out of the queue and expanded or found stale.
  std::size_t pops = 0;
  /// the number of pops of a node that had been lowered since it was entered, which cost nothing.
  std::size_t stale_pops = 0;
  /// the number of arcs looked at.
  std::size_t relaxations = 0;
  /// the number of arcs that lowered the distance of their target.
  std::size_t improvements = 0;
  /// the number of comparisons inside the queue: of keys, and of the ends of buckets, one for each
  /// bucket that was looked into. It is 0 if the queue does not count them.
  std::size_t queue_comparisons = 0;

  /// returns the number of pops that expanded a node for the second time or later.
  std::size_t repeated_pops() const { return pops - stale_pops - settled_nodes; }

  /// returns the number of edges looked at: both arcs of an edge count as one.
  std::size_t edges() const { return relaxations / 2; }

  /// returns the number of comparisons, as Schwartz, de Rezende and Pedrini count them
  /// \cgalCite{srp-fasgp-15}: one for each entry that came out of the queue (for each vertex, if
  /// none comes out twice), one for each edge, and those inside the queue. It says nothing if the
  /// queue does not count them.
  std::size_t comparisons() const { return pops + edges() + queue_comparisons; }

  /// returns what that number is at least, `E + V`.
  std::size_t fewest_comparisons() const { return settled_nodes + edges(); }

  /// returns the bound that a Fibonacci heap is given, \f$E + V \log_2 V\f$.
  double heap_comparisons() const
  {
    const double v = static_cast<double>(settled_nodes);
    return static_cast<double>(edges()) + (v > 0 ? v * std::log2(v) : 0);
  }
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_STATISTICS_H
