// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_STATISTICS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_STATISTICS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * The figures of a run of `Propagation`, if statistics were enabled.
 */
struct Propagation_statistics
{
  /// the number of nodes that were settled.
  std::size_t settled_nodes = 0;
  /// the number of entries extracted from the queue, and either expanded or skipped as stale.
  std::size_t pops = 0;
  /// the number of stale entries among them, which cost next to nothing.
  std::size_t stale_pops = 0;
  /// the number of arcs looked at.
  std::size_t relaxations = 0;
  /// the number of arcs that lowered the distance of their target.
  std::size_t improvements = 0;
  /// the number of comparisons inside the queue: of keys, and one for each bucket visited. It is 0
  /// if the queue does not count them.
  std::size_t queue_comparisons = 0;

  /// returns the number of pops that expanded a node for the second time or later.
  std::size_t repeated_pops() const { return pops - stale_pops - settled_nodes; }

  /// returns the number of edges looked at: both arcs of an edge count as one.
  std::size_t edges() const { return relaxations / 2; }

  /// returns the number of comparisons, as Schwartz, de Rezende and Pedrini count them
  /// \cgalCite{srp-fasgp-15}: one for each entry extracted from the queue, one for each edge, and
  /// those inside the queue. It is meaningless if the queue does not count them.
  std::size_t comparisons() const { return pops + edges() + queue_comparisons; }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_STATISTICS_H
