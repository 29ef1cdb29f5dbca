// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_STEINER_GRAPH_BASE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_STEINER_GRAPH_BASE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_arcs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsGraphs
 *
 * The common base class of `Steiner_graph` and `Directional_graph`: the nodes of a mesh with
 * Steiner points, and their arcs.
 *
 * \tparam Placement a model of `SteinerPointPlacement`
 * \tparam Costs determines the costs of arcs: by the weights of faces, or by their gauges
 */
template <typename Placement, typename Costs>
class Steiner_graph_base
{
public:
  /// the number of a node; those of the vertices come first.
  using Node = Intrinsic_triangulation::Index;

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

  /// returns the cost of the straight line from `point` to a corner of its face, or of both faces
  /// if it lies on an edge, or the cost of the way back, whichever is larger, for the corner where
  /// this is least; `0` for vertices. Paths between points \f$p\f$ and \f$q\f$ cost at most \f$(1 +
  /// \varepsilon)\,d(p,q) + (2 + \varepsilon)(c_p + c_q)\f$, where \f$d\f$ is the cost of the
  /// cheapest path on the surface, \f$\varepsilon\f$ is `epsilon()`, and \f$c\f$ is this cost. It
  /// is in units of the graph, see `unit()`, and infinity for points that no path leaves or
  /// reaches.
  double cost_to_corner(const Intrinsic_point& point) const
  {
    std::vector<std::pair<Node, double>> corners;
    attach(point).for_each_node([&](const Node node, const double cost) {
      if(!m_nodes.is_point(node))
        corners.emplace_back(node, cost);
    });
    double result = std::numeric_limits<double>::infinity();
    attach_target(point).for_each_node([&](const Node node, const double cost_back) {
      for(const auto& corner : corners)
        if(corner.first == node)
          result = (std::min)(result, (std::max)(corner.second, cost_back));
    });
    return result;
  }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_nodes.size(); }

  /// returns the number of points on edges. On barriers, those of both sides count.
  std::size_t number_of_points() const { return m_nodes.points().number_of_points(); }

  /// returns the unit of costs, in the unit of the mesh times that of the costs per unit of length.
  double unit() const { return m_triangulation.unit() * Costs::unit(m_triangulation); }

  /// returns a summary of the costs of the arcs along edges, as if
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

  /// returns `cost`, as no arc crosses an edge between its ends.
  template <typename F>
  double for_each_crossing(Node /* source */, Node /* target */, const double cost, F) const
  {
    return cost;
  }

  /// attaches a point where searches start by straight lines to the nodes on the sides of its face,
  /// or of both faces if it lies on an edge. A vertex is attached to its own node, and to those of
  /// its sectors if barriers divide its faces.
  internal::Steiner_attachment<Costs> attach(const Intrinsic_point& point) const
  {
    return {costs(m_is_backward), point};
  }

  /// attaches a point where searches arrive.
  internal::Steiner_attachment<Costs> attach_target(const Intrinsic_point& point) const
  {
    return {costs(!m_is_backward), point};
  }

  /// prefetches the data from which the arcs of `node` are computed.
  void prefetch(const Node node) const { m_nodes.prefetch(m_triangulation, node); }

  /// returns the number of bytes that the graph takes, its triangulation included.
  std::size_t memory() const
  {
    return m_triangulation.memory() + m_placement.memory() + m_edges.memory() + m_nodes.memory();
  }

  /// returns whether the triangulation is valid.
  bool is_valid() const { return m_triangulation.is_valid(); }

  /// @}

#ifndef DOXYGEN_RUNNING
protected:
  Steiner_graph_base(Intrinsic_triangulation triangulation,
                     Placement placement,
                     const std::size_t maximum_number_of_points,
                     const bool is_backward = false)
    : m_triangulation(std::move(triangulation)),
      m_placement(std::move(placement)),
      m_edges(m_triangulation),
      m_is_backward(is_backward)
  {
    m_nodes = internal::Steiner_nodes(m_triangulation, m_placement, maximum_number_of_points);
    summarize_arcs();
  }

  void summarize_arcs() { m_arc_lengths = arcs().along_edges(); }

  Intrinsic_triangulation m_triangulation;
  Placement m_placement;
  typename Costs::Edges m_edges;
  internal::Steiner_nodes m_nodes;
  Arc_lengths m_arc_lengths;
  bool m_is_backward; // whether distances are those to the sources of a search

private:
  Costs costs(const bool is_backward) const
  {
    return {m_triangulation, m_nodes, m_edges, is_backward};
  }

  internal::Steiner_arcs<Costs> arcs() const
  {
    return internal::Steiner_arcs<Costs>(costs(m_is_backward));
  }
#endif
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_STEINER_GRAPH_BASE_H
