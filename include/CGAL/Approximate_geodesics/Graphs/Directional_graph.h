// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_DIRECTIONAL_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_DIRECTIONAL_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Directional_points.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Gauge_costs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_arcs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_attachment.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
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
 * The graph for costs that depend on the direction, which `directional_cost()` gives to a
 * triangulation. Its nodes are those of a `Steiner_graph`: vertices and points on edges. An arc
 * across a face costs what the gauge of the face says of the vector from one end to the other, and
 * one along an edge the smaller of what both faces say. There are no arcs where that is infinite,
 * nor across barriers, along which paths may run.
 *
 * Going there and coming back are two questions. Distances are from the sources; with the named
 * parameter `direction_to_source(true)` they are to the sources. `leads_to_sources()` tells. So
 * that both can be asked without reading a mesh twice, `reversed()` is a copy that answers the
 * other one.
 *
 * A straight line across a face stands for zigzags where these are cheaper: their costs are what it
 * costs, and zigzags within the face come as close to it as one likes.
 *
 * Arcs are not stored: the graph takes 60 bytes per vertex in addition to the triangulation, which
 * has the gauges, and 8 per point, or 4 if points divide edges into equal parts. They are not all
 * looked at either, as in a `Steiner_graph`.
 *
 * An object of this class never changes after its construction, and may be used by several threads.
 *
 * \tparam Placement a model of `SteinerPointPlacement`: `Directional_points` guarantees a bound,
 *         `Fixed_number_of_points` and `Points_at_interval` are simpler and do not.
 *
 * \cgalModels{SurfaceGraph}
 */
template <typename Placement = Directional_points>
class Directional_graph
{
public:
  /// the number of a node; those of the vertices come first.
  using Node = Intrinsic_triangulation::Index;

  /// \name Creation
  /// @{

  /*!
   * builds the graph of `triangulation`.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \param triangulation the triangulation
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": that of the
   *           placement, and those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{direction_to_source}
   *     \cgalParamDescription{whether distances are those to the sources of a search, and not from
   *                           them}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`false`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{maximum_number_of_points}
   *     \cgalParamDescription{so many points may be needed on all edges together}
   *     \cgalParamType{an integer type}
   *     \cgalParamDefault{1000 per edge on average, but at least \f$10^6\f$ and at most
   *                       \f$10^8\f$}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if the triangulation has no directional costs, if there are
   *         points, and a face breaks the triangle inequality, or as the placement does.
   * \throws std::length_error if more than `maximum_number_of_points` points would be needed: the
   *         message tells how many, and on which edge most of them; or if there would be more nodes
   *         than 32-bit numbers can tell apart.
   *
   * Run time and memory are \cgalBigO{n} for `n` nodes.
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Directional_graph(Intrinsic_triangulation triangulation,
                             const NamedParameters& np = parameters::default_values())
    : Directional_graph(std::move(triangulation),
                        Placement(np),
                        parameters::choose_parameter(
                            parameters::get_parameter(np, internal_np::direction_to_source), false),
                        internal::maximum_number_of_points(np))
  {
  }

  /// builds the graph likewise, with a placement that was made before; `0` stands for the default
  /// of `maximum_number_of_points`.
  Directional_graph(Intrinsic_triangulation triangulation,
                    Placement placement,
                    const bool direction_to_source = false,
                    const std::size_t maximum_number_of_points = 0)
    : m_triangulation(checked(std::move(triangulation))),
      m_placement(std::move(placement)),
      m_edges(m_triangulation),
      m_leads_to_sources(direction_to_source)
  {
    m_nodes = internal::Steiner_nodes(m_triangulation, m_placement, maximum_number_of_points);
    m_arc_lengths = arcs().along_edges();
  }

  /// returns a copy for the other question.
  Directional_graph reversed() const
  {
    Directional_graph result = *this;
    result.m_leads_to_sources = !m_leads_to_sources;
    return result;
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the triangulation that the graph was built on.
  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  /// returns the placement of the points.
  const Placement& placement() const { return m_placement; }

  /// returns whether distances are those to the sources of a search, and not from them.
  bool leads_to_sources() const { return m_leads_to_sources; }

  /// returns the bound that the placement guarantees: paths between vertices cost at most `1 +
  /// epsilon()` times as much as the cheapest ones on the surface. It is infinity if there is none.
  double epsilon() const { return m_placement.epsilon(m_triangulation); }

  /// returns what the straight line from `point` to a corner of its face costs, or that from there
  /// to `point`, whichever is more, for the corner where this is least; `0` for vertices. Paths
  /// between points \f$p\f$ and \f$q\f$ cost at most \f$(1 + \varepsilon)\,d(p,q) + (2 +
  /// \varepsilon)(c_p + c_q)\f$, where \f$d\f$ is the cost of the cheapest path on the surface,
  /// \f$\varepsilon\f$ is `epsilon()`, and \f$c\f$ is this cost. It is in units of the graph, see
  /// `unit()`, and infinity for points that no path leaves, or that none gets to.
  double cost_to_corner(const Intrinsic_point& point) const
  {
    double result = std::numeric_limits<double>::infinity();
    attach(point).for_each_node([&](const Node corner, const double cost) {
      if(!m_nodes.is_point(corner))
        attach_target(point).for_each_node([&](const Node node, const double cost_back) {
          if(node == corner)
            result = (std::min)(result, (std::max)(cost, cost_back));
        });
    });
    return result;
  }

  /// returns how much too high costs may be, relatively, as they were asked for in some directions
  /// only; this is part of the bound. For cost functions that are not convex, costs are exact in
  /// the sense that they are those of zigzags in directions that were asked for.
  double sampling_error() const { return m_triangulation.gauges().sampling_error(); }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_nodes.size(); }

  /// returns the number of points on edges. On barriers, those of both sides count.
  std::size_t number_of_points() const { return m_nodes.points().number_of_points(); }

  /// returns the unit of costs, in the unit of the mesh times that of the costs per unit of length.
  double unit() const { return m_triangulation.unit() * m_triangulation.gauges().unit(); }

  /// returns a summary of the costs of the arcs along edges, as if points divided every edge into
  /// equal parts.
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

  /// attaches a point that a search starts from by straight lines to the nodes on the sides of its
  /// face, or of both faces if it lies on an edge.
  internal::Steiner_attachment<internal::Gauge_costs> attach(const Intrinsic_point& point) const
  {
    return {m_triangulation, m_nodes, costs(m_leads_to_sources), point};
  }

  /// attaches a point that a search arrives at.
  internal::Steiner_attachment<internal::Gauge_costs>
  attach_target(const Intrinsic_point& point) const
  {
    return {m_triangulation, m_nodes, costs(!m_leads_to_sources), point};
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

private:
  static Intrinsic_triangulation checked(Intrinsic_triangulation triangulation)
  {
    if(!triangulation.has_directional_costs())
      internal::reject(
          "the triangulation of a Directional_graph has no costs; they are given to its "
          "constructor, as face_weight_map(directional_cost(f))");
    return triangulation;
  }

  internal::Gauge_costs costs(const bool is_backward) const
  {
    return {m_triangulation, m_nodes, m_edges, is_backward};
  }

  internal::Steiner_arcs<internal::Gauge_costs> arcs() const
  {
    return {m_triangulation, m_nodes, costs(m_leads_to_sources)};
  }

  Intrinsic_triangulation m_triangulation;
  Placement m_placement;
  internal::Edge_costs m_edges;
  internal::Steiner_nodes m_nodes;
  Arc_lengths m_arc_lengths;
  bool m_leads_to_sources = false;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_DIRECTIONAL_GRAPH_H
