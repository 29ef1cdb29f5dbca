// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_RULES_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_RULES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * Where a run of `Propagation` starts.
 */
struct Seed
{
  /// the node.
  std::uint32_t node;
  /// its initial distance, in the unit of the mesh: finite and not negative.
  double distance = 0;
  /// the index of its source: what `Propagation::source()` returns for the nodes nearest to this
  /// seed.
  std::size_t source = 0;
};

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * An arc from a node to a point of the surface that need not be a node.
 */
struct Last_arc
{
  /// the node.
  std::uint32_t node;
  /// the length of the arc, in the unit of the mesh: not negative.
  double length;
};

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * When a run of `Propagation` may end early.
 */
struct Stop_rule
{
  /// nodes farther than this, in the unit of the mesh, are not reached.
  double maximum_distance = std::numeric_limits<double>::infinity();
  /// if there are targets or points, the run ends as soon as the distances of all these nodes ...
  std::vector<std::uint32_t> targets = {};
  /// ... and of all these points are final. A point is given by the arcs that lead to it.
  std::vector<std::vector<Last_arc>> points = {};
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_RULES_H
