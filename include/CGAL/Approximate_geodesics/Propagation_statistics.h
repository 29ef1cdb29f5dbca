// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PROPAGATION_STATISTICS_H
#define CGAL_APPROXIMATE_GEODESICS_PROPAGATION_STATISTICS_H

#include <CGAL/license/Approximate_geodesics.h>

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

  /// returns the number of pops that expanded a node for the second time or later.
  std::size_t repeated_pops() const { return pops - stale_pops - settled_nodes; }
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PROPAGATION_STATISTICS_H
