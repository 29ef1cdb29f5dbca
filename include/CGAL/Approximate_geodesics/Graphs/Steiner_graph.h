// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_STEINER_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_STEINER_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_arcs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_attachment.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Weighted_costs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/graph_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsGraphs
 *
 * The graph of the vertices of a mesh and of points on its edges, so-called Steiner points. Two
 * nodes at the border of the same face are joined by a straight arc across the face, and
 * neighbors on an edge by an arc along it.
 *
 * It is the graph for faces with weights. An arc across a face costs its length times the weight of
 * the face, and one along an edge its length times the smaller weight of the two faces. There are
 * no arcs across faces of infinite weight, nor across barriers, along which paths may run. Without
 * weights and barriers, it is still the graph for paths across a few large faces.
 *
 * The placement says where points are, and so which error is made: `Geometric_points` guarantees a
 * bound, `Fixed_number_of_points` and `Points_at_interval` are simpler and do not.
 *
 * Arcs are not stored: the graph takes 36 bytes per vertex, in addition to the triangulation, and 8
 * per point, or 4 if points divide edges into equal parts. They are not all looked at either. A
 * path that comes across a face is not continued into the same face again, and where edges have
 * many points, a point looks only at those of the opposite edges that neither of its two neighbors
 * reaches on a shorter path.
 *
 * Nodes are the vertices, the points, and one more for every sector of those vertices whose
 * surroundings are divided by barriers into several sectors: no path leads through such a vertex
 * from one sector into another.
 *
 * An object of this class never changes after its construction, unless its weights are exchanged,
 * and may be used by several threads.
 *
 * \tparam Placement a model of `SteinerPointPlacement`
 *
 * \cgalModels{SurfaceGraph}
 */
template <typename Placement = Geometric_points>
class Steiner_graph
{
public:
  /// the number of a node; those of the vertices come first.
  using Node = Intrinsic_triangulation::Index;

  /// \name Creation
  /// @{

  /// the graph of an empty mesh.
  Steiner_graph() : Steiner_graph(Intrinsic_triangulation()) {}

  /*!
   * builds the graph of `triangulation`, its weights and its barriers.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": that of the
   *           placement, and the one listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{maximum_number_of_points}
   *     \cgalParamDescription{so many points may be needed on all edges together}
   *     \cgalParamType{an integer type}
   *     \cgalParamDefault{1000 per edge on average, but at least \f$10^6\f$ and at most
   *                       \f$10^8\f$}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if there are points, and a face breaks the triangle inequality,
   *         or as the placement does.
   * \throws std::length_error if more than `maximum_number_of_points` points would be needed: the
   *         message tells how many, and on which edge most of them; if there would be more nodes
   *         than 32-bit numbers can tell apart, or as the placement does.
   *
   * Run time and memory are \cgalBigO{n} for `n` nodes. If points are refused, they are not made.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Steiner_graph(Intrinsic_triangulation triangulation,
                         const NamedParameters& np = parameters::default_values())
    : Steiner_graph(std::move(triangulation), Placement(np), internal::maximum_number_of_points(np))
  {
    static_assert(!internal::is_given<NamedParameters, internal_np::direction_to_source_t>,
                  "direction_to_source: distances there and back are the same in this graph; use "
                  "Directional_graph");
    if constexpr(internal::is_given<NamedParameters, internal_np::face_weight_t>)
      if(!m_triangulation.has_weights() && m_triangulation.number_of_halfedges() > 0)
        internal::reject("face_weight_map was given to Steiner_graph; it is for the constructor of "
                         "Intrinsic_triangulation");
  }

  /// builds the graph likewise, with a placement that was made before; `0` stands for the default
  /// of `maximum_number_of_points`.
  Steiner_graph(Intrinsic_triangulation triangulation,
                Placement placement,
                const std::size_t maximum_number_of_points = 0)
    : m_triangulation(std::move(triangulation)), m_placement(std::move(placement))
  {
    internal::reject_directional_costs(m_triangulation, "Steiner_graph");
    m_nodes = internal::Steiner_nodes(m_triangulation, m_placement, maximum_number_of_points);
    m_arc_lengths = arcs().along_edges();
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the triangulation that the graph was built on.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  /// returns the placement of the points.
  const Placement& placement() const { return m_placement; }

  /// returns the bound that the placement guarantees with the present weights: paths between
  /// vertices cost at most `1 + epsilon()` times as much as the cheapest ones on the surface. It is
  /// infinity if there is none. For paths between other points, see `cost_to_corner()`. Run time is
  /// \cgalBigO{n}.
  double epsilon() const { return m_placement.epsilon(m_triangulation); }

  /// returns what the straight line from `point` to the nearest corner of its face costs, or of
  /// both faces if it lies on an edge; `0` for vertices. Paths between points \f$p\f$ and \f$q\f$
  /// cost at most \f$(1 + \varepsilon)\,d(p,q) + (2 + \varepsilon)(c_p + c_q)\f$, where \f$d\f$
  /// is the cost of the cheapest path on the surface, \f$\varepsilon\f$ is `epsilon()`, and
  /// \f$c\f$ is this cost. It is in units of the graph, see `unit()`, and infinity for points that
  /// no path leaves.
  double cost_to_corner(const Intrinsic_point& point) const
  {
    double result = std::numeric_limits<double>::infinity();
    attach(point).for_each_node([&](const Node node, const double cost) {
      if(!m_nodes.is_point(node))
        result = (std::min)(result, cost);
    });
    return result;
  }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_nodes.size(); }

  /// returns the number of points on edges. On barriers, those of both sides count.
  std::size_t number_of_points() const { return m_nodes.points().number_of_points(); }

  /// returns the unit of costs, in the unit of the mesh times that of the weights.
  double unit() const { return m_triangulation.unit() * m_triangulation.weight_unit(); }

  /// returns a summary of the costs of the arcs along edges, which are the shortest ones, as if
  /// points divided every edge into equal parts.
  const Arc_lengths& arc_lengths() const { return m_arc_lengths; }

  /// returns an upper bound of the number of arcs that start from a node.
  std::size_t maximum_degree() const { return m_nodes.maximum_degree(); }

  /// returns where a node is, which may be one of the vertices.
  Intrinsic_point position(const Node node) const { return m_nodes.position(node); }

  /// calls `f(target, cost)` for the arcs that start from `node` and may be part of a cheapest path
  /// that arrives there as `labels` says.
  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    arcs().for_each(node, labels, f);
  }

  /// returns `length`, as no arc crosses an edge between its ends.
  template <typename F>
  double for_each_crossing(Node /* source */, Node /* target */, const double length, F) const
  {
    return length;
  }

  /// attaches a point of the surface by straight lines to the nodes on the sides of its face, or of
  /// both faces if it lies on an edge. A vertex is attached to what stands for it: to more than one
  /// node, if barriers divide its faces.
  internal::Steiner_attachment<internal::Weighted_costs> attach(const Intrinsic_point& point) const
  {
    return {m_triangulation, m_nodes, costs(), point};
  }

  /// prefetches the data from which the arcs of `node` are computed.
  void prefetch(const Node node) const { m_nodes.prefetch(m_triangulation, node); }

  /// returns the number of bytes that the graph takes, its triangulation included.
  std::size_t memory() const
  {
    return m_triangulation.memory() + m_placement.memory() + m_nodes.memory();
  }

  /// returns whether the triangulation is valid.
  bool is_valid() const { return m_triangulation.is_valid(); }

  /// @}

  /// \name Modification
  /// @{

  /*!
   * exchanges the weights for what `read_face_weights()` returns; the points stay where they are.
   * If weights around a vertex become different that were all the same when the graph was built, or
   * thin faces are not forbidden any more, the bound gets worse, unless `Geometric_points` was told
   * to expect different weights: `epsilon()` tells.
   *
   * \warning No other thread may use the graph meanwhile, and existing workspaces for it become
   * invalid.
   *
   * Run time is \cgalBigO{n} for `n` vertices and points.
   */
  void set_weights(Face_weights weights)
  {
    m_triangulation.set_weights(std::move(weights));
    m_arc_lengths = arcs().along_edges();
  }

  /// @}

private:
  internal::Weighted_costs costs() const { return {m_triangulation, m_nodes}; }

  internal::Steiner_arcs<internal::Weighted_costs> arcs() const
  {
    return {m_triangulation, m_nodes, costs()};
  }

  Intrinsic_triangulation m_triangulation;
  Placement m_placement;
  internal::Steiner_nodes m_nodes;
  Arc_lengths m_arc_lengths;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_STEINER_GRAPH_H
