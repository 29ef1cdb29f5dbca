// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_TYPES_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_TYPES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
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
  /// the length of a line from the source to the node that costs nothing, in the unit of
  /// `GeodesicGraph::for_each_free_arc()`. Of equal seeds, paths start from one with the smallest.
  double free_length = 0;
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

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * The figures of a run of `Propagation`, if statistics were enabled.
 */
struct Propagation_statistics
{
  /// the number of nodes that were settled, also by the earlier runs that this one continues.
  std::size_t settled_nodes = 0;
  /// the number of entries extracted from the queue, and either expanded or skipped as stale.
  std::size_t pops = 0;
  /// the number of stale entries among them, which cost very little.
  std::size_t stale_pops = 0;
  /// the number of scanned arcs.
  std::size_t relaxations = 0;
  /// the number of arcs that lowered the distance of their target.
  std::size_t improvements = 0;
  /// the number of comparisons inside the queue: of keys, and one for each bucket visited. It is 0
  /// if the queue does not count them.
  std::size_t queue_comparisons = 0;

  /// returns the number of pops that expanded a node for the second time or later, as far as they
  /// outnumber the nodes that earlier runs have settled.
  std::size_t repeated_pops() const
  {
    return pops - stale_pops - (std::min)(pops - stale_pops, settled_nodes);
  }

  /// returns the number of scanned edges: both arcs of an edge count as one.
  std::size_t edges() const { return relaxations / 2; }

  /// returns the number of comparisons, as Schwartz, de Rezende and Pedrini count them
  /// \cgalCite{srp-fasgp-15}: one for each entry extracted from the queue, one for each edge, and
  /// those inside the queue. It is meaningless if the queue does not count them.
  std::size_t comparisons() const { return pops + edges() + queue_comparisons; }
};

namespace internal {

inline void check_initial_distance(const double distance, const std::size_t number_of_source)
{
  if(!(distance >= 0) || std::isinf(distance))
    reject("the initial distance of source " + std::to_string(number_of_source) + " is " +
           text_of(distance) + "; it must be a finite number that is not negative");
}

// Rejects invalid seeds and stop rules for a graph of this size and unit.
inline void check_input(const std::vector<Seed>& seeds,
                        const Stop_rule& stop,
                        const std::size_t number_of_nodes,
                        const double unit)
{
  const auto check_node = [&](const std::size_t node, const char* const role) {
    if(node >= number_of_nodes)
      reject(std::string(role) + " node " + std::to_string(node) + " does not exist: there are " +
             std::to_string(number_of_nodes) + " nodes");
  };
  for(const Seed& seed : seeds)
  {
    check_node(seed.node, "source");
    const double distance = seed.distance / unit; // overflows if the mesh is tiny
    if(!(distance >= 0) || std::isinf(distance))
      reject("the distance that source node " + std::to_string(seed.node) + " starts with is " +
             text_of(seed.distance) +
             "; it must be a finite number that is not negative, and not too large beside the "
             "lengths of the mesh");
  }
  for(const std::size_t target : stop.targets)
    check_node(target, "target");
  for(const std::vector<Last_arc>& arcs : stop.points)
    for(const Last_arc& arc : arcs)
      check_node(arc.node, "target");
  if(!(stop.maximum_distance >= 0))
    reject("the maximum distance is " + text_of(stop.maximum_distance) +
           "; it must be a number that is not negative");
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A visitor that does nothing. A class derived from it has to define only the functions that it
 * needs; these hide those below, which are not virtual.
 *
 * \cgalModels{GeodesicVisitor}
 */
struct Geodesic_visitor_base
{
  /// does nothing.
  template <typename Vertex>
  void on_settled(const Vertex& /* vertex */, double /* distance */)
  {
  }

  /// does nothing.
  void on_progress(std::size_t /* number_of_settled_nodes */, std::size_t /* number_of_nodes */) {}

  /// returns `true`.
  bool go_further() { return true; }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_PROPAGATION_TYPES_H
