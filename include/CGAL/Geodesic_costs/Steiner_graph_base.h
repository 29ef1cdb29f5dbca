// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_STEINER_GRAPH_BASE_H
#define CGAL_GEODESIC_COSTS_STEINER_GRAPH_BASE_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>
#include <CGAL/Geodesic_costs/internal/Free_ways.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Free_lengths.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_groups.h>
#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Geodesic_costs/internal/continued_runs.h>
#include <CGAL/Geodesic_costs/internal/free_ends.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

namespace internal {

/*
 * The arcs of a Steiner graph, which are computed from its nodes on the fly. `Costs` is
 * `Weighted_costs` or `Gauge_costs`: it determines the costs of arcs, and which arcs across a face
 * are enumerated.
 */
template <typename Costs>
class Steiner_arcs : Steiner_view
{
public:
  explicit Steiner_arcs(const Costs& costs) : Steiner_view(costs), m_costs(costs) {}

  // Calls `f(target, cost)` for the arcs that start from `node` and may be part of a cheapest path
  // that arrives there as `labels` says.
  template <typename Labels, typename F>
  void for_each(const Node node, const Labels& labels, F& f) const
  {
    if(m_nodes.is_point(node))
      expand_point(node, labels, f);
    else if(m_nodes.is_sector(node))
      expand_sector(node, f);
    else if(!m_nodes.is_divided(node))
      expand_vertex(node, f);
    else if(labels.predecessor(node) == null_index) // a path may start there, but not go through
      m_nodes.for_each_sector(node, [&](const Node sector) { f(sector, 0.); });
  }

  // Returns a summary of the costs of arcs along edges, as if points divided every edge into equal
  // parts.
  Arc_lengths along_edges() const
  {
    Arc_length_summary result;
    m_points.for_each_first_halfedge([&](const Index h, const Index e) {
      for(int i = 0; i < (Costs::are_symmetric ? 1 : 2); ++i)
      {
        const double cost_per_length = m_costs.along(h, i == 0);
        if(cost_per_length == infinity)
          continue;
        const double cost = cost_per_length * m_triangulation.length(h);
        const std::size_t number = m_points.number_of_points(e) + std::size_t(1);
        result.add(cost / double(number), cost, cost, number);
      }
    });
    return result.result();
  }

private:
  // ----- arcs from vertices

  template <typename F>
  void expand_sector(const Node node, F& f) const
  {
    const Index sector = m_nodes.sector(node);
    const Node v = m_nodes.sectors().vertex(sector);
    f(v, 0.);
    Index h = m_nodes.sectors().first_halfedge(sector);
    do
    {
      expand_corner(v, h, f);
      h = m_triangulation.counterclockwise(v, h);
    } while(!m_triangulation.is_border(h) && !m_triangulation.is_barrier(h));
    // the side of a barrier that belongs to the sector
    expand_edge(m_triangulation.opposite(h), false, f);
    for_each_joined_sector(m_triangulation, m_nodes, node, [&](const Node next) { f(next, 0.); });
  }

  template <typename F>
  void expand_vertex(const Node v, F& f) const
  {
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = m_triangulation.first_halfedge(v); h < beyond; ++h)
    {
      expand_corner(v, h, f);
      if(m_triangulation.is_barrier(h)) // with arcs on both sides
        expand_edge(m_triangulation.opposite(h), false, f);
    }
  }

  // Enumerates the arcs from the source `v` of `h` along it and across the face to its left.
  template <typename F>
  void expand_corner(const Node v, const Index h, F& f) const
  {
    expand_edge(h, true, f);
    if(m_triangulation.is_open(h))
      m_costs.expand_corner(v, h, f);
  }

  // Enumerates the arc along the edge of `h`, or along its left side, from its source or target.
  template <typename F>
  void expand_edge(const Index h, const bool starts_at_source, F& f) const
  {
    const double cost = m_costs.along(h, starts_at_source);
    if(cost == infinity)
      return;
    const Index e = m_points.edge(h);
    const Index first = m_points.first_point(e), beyond = m_points.beyond_point(e);
    const double length = m_triangulation.length(h);
    if(first == beyond)
      f(starts_at_source ? m_nodes.at_target(m_triangulation, h)
                         : m_nodes.at_source(m_triangulation, h),
        cost * length);
    else if(starts_at_source == m_points.is_first(h))
      f(m_nodes.node_of_point(first), cost * (length * m_points.part_before(e, first)));
    else
      f(m_nodes.node_of_point(beyond - 1), cost * (length * m_points.part_behind(e, beyond - 1)));
  }

  // ----- arcs from points on edges

  // A path that arrives along the edge continues into both faces, any other path only into the face
  // that it does not come from.
  template <typename Labels, typename F>
  void expand_point(const Node node, const Labels& labels, F& f) const
  {
    const Index p = m_nodes.point(node), h = m_points.halfedge(p);
    const Index opposite = m_triangulation.opposite(h);
    const bool has_right =
        m_points.edge(opposite) == m_points.edge(h) && m_triangulation.is_open(opposite);
    const Viewpoint left = viewpoint(p, h);
    if(left.cost_to_source < infinity)
      f(left.toward_source, left.cost_to_source);
    if(left.cost_to_target < infinity)
      f(left.toward_target, left.cost_to_target);

    const Node origin = labels.predecessor(node);
    const Node twin = m_triangulation.is_lifted(h)
                          ? m_nodes.node_of_point(m_points.twin(m_triangulation, h, p))
                          : null_index;
    if(twin != null_index)
      f(twin, 0.);
    if(origin == twin || origin == left.toward_source || origin == left.toward_target ||
       origin == null_index)
    {
      if(m_triangulation.is_open(h))
        m_costs.expand_face(left, m_triangulation.halfedges_of_face(h), labels, f);
      if(has_right)
        m_costs.expand_face(left.reversed(opposite), m_triangulation.halfedges_of_face(opposite),
                            labels, f);
    }
    else
      expand_crossed_edge(left, has_right, origin, labels, f);
  }

  // Enumerates the arcs from a viewpoint on an edge, one of whose faces the path has crossed from
  // `origin`.
  template <typename Labels, typename F>
  void expand_crossed_edge(const Viewpoint& left,
                           const bool has_right,
                           const Node origin,
                           const Labels& labels,
                           F& f) const
  {
    const Face left_face = m_triangulation.halfedges_of_face(left.halfedge);
    const bool has_left = m_triangulation.is_open(left.halfedge);
    if(!has_right)
      return m_costs.expand_back(left, left_face, origin, labels, f);
    const Face right_face =
        m_triangulation.halfedges_of_face(m_triangulation.opposite(left.halfedge));
    const Viewpoint right = left.reversed(right_face[0]);
    const bool comes_from_right = is_opposite(origin, right_face);
    if(has_left && comes_from_right)
      m_costs.expand_face(left, left_face, labels, f);
    else if(has_left)
      m_costs.expand_back(left, left_face, origin, labels, f);
    // two faces can have several edges in common
    if(comes_from_right && !(has_left && is_opposite(origin, left_face)))
      m_costs.expand_back(right, right_face, origin, labels, f);
    else
      m_costs.expand_face(right, right_face, labels, f);
  }

  // Returns the viewpoint of `p`, on the edge whose first halfedge is `h`.
  Viewpoint viewpoint(const Index p, const Index h) const
  {
    const Index e = m_points.edge(h);
    const double length = m_triangulation.length(h), there = m_costs.along(h, true);
    const double back = Costs::are_symmetric ? there : m_costs.along(h, false);
    const double from_source = length * m_points.part_before(e, p);
    const double from_target = length * m_points.part_behind(e, p);
    const bool is_first = p == m_points.first_point(e), is_last = p + 1 == m_points.beyond_point(e);
    const Node node = m_nodes.node_of_point(p);
    return {h,
            node,
            from_source,
            from_target,
            is_first ? m_nodes.at_source(m_triangulation, h) : node - 1,
            is_last ? m_nodes.at_target(m_triangulation, h) : node + 1,
            back * (is_first ? from_source : length * m_points.part_between(e, p - 1)),
            there * (is_last ? from_target : length * m_points.part_between(e, p))};
  }

  // Returns whether a node is on the second or third edge of a face, or at their common vertex.
  bool is_opposite(const Node node, const Face& face) const
  {
    if(!m_nodes.is_point(node))
      return node == m_nodes.at_corner(m_triangulation.target(face[1]), face[2]);
    const Index e = m_points.edge(m_points.halfedge(m_nodes.point(node)));
    return e == m_points.edge(face[1]) || e == m_points.edge(face[2]);
  }

  const Costs m_costs;
};

/*
 * The straight lines between a point of the surface and the nodes of a Steiner graph in the same
 * face, and other points there. Costs are those of leaving the point, or of arriving at it if
 * `Costs` are those of the opposite directions.
 */
template <typename Costs>
class Steiner_attachment : Steiner_view, public Lines_of_point<Costs>
{
  using Lines = Lines_of_point<Costs>;
  using Lines::m_costs;
  using Lines::m_point;

public:
  Steiner_attachment(const Costs& costs, const Intrinsic_point& point)
    : Steiner_view(costs), Lines(Steiner_view::m_triangulation, costs, point)
  {
  }

  // Calls `f(node, cost)` for the lines to nodes. If the point is a vertex, these are its own
  // nodes.
  template <typename F>
  void for_each_node(F f) const
  {
    if(m_point.is_vertex())
    {
      f(m_point.vertex, 0.);
      if(m_nodes.is_divided(m_point.vertex))
        m_nodes.for_each_sector(m_point.vertex, [&](const Node sector) { f(sector, 0.); });
      return;
    }
    m_point.for_each_face(m_triangulation, [&](const Index h) {
      if(m_triangulation.is_open(h))
        expand_across_face(h, f);
    });
    if(m_point.is_on_edge())
    {
      expand_along_edge(m_point.halfedge, m_point.t, f);
      expand_along_edge(m_triangulation.opposite(m_point.halfedge), 1 - m_point.t, f);
    }
  }

  // Calls `f(node, part)` for the node at the source of a side of a face, and for those inside the
  // side, which are at a part of the way to its target.
  template <typename F>
  void for_each_node_on_side(const Index side, F f) const
  {
    f(m_nodes.at_corner(m_triangulation.source(side), side), 0.);
    m_nodes.for_each_node_on_edge(side, f);
  }

  // The cost of a line in the face to the left of `h`, whose source is the origin.
  double cost_across(const Index h, const Plane_vector line) const
  {
    return m_costs.across(h, line);
  }

private:
  // Enumerates the lines to the corners of the face to the left of `h`, and to the nodes on those
  // of its sides that the point is not on.
  template <typename F>
  void expand_across_face(const Index h, F& f) const
  {
    const auto corner = m_costs.corners(h);
    const auto halfedges = m_triangulation.halfedges_of_face(h);
    for_each_face_point(m_triangulation, m_point, h, [&](const Face_point& p) {
      const Plane_vector position = p.seen_from(m_triangulation, h).position(corner);
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Index side = halfedges[i];
        const Plane_vector start = corner[i], end = corner[(i + 1) % 3];
        offer(m_nodes.at_corner(m_triangulation.source(side), side),
              m_costs.across(h, start - position), f);
        if(!m_point.is_on_edge_of(side, m_triangulation))
          m_nodes.for_each_node_on_edge(side, [&](const Node node, const double part) {
            offer(node, m_costs.across(h, start + part * (end - start) - position), f);
          });
      }
    });
  }

  // Enumerates the lines from the point at the part `t` of `h` to all nodes of the edge, or of its
  // left side.
  template <typename F>
  void expand_along_edge(const Index h, const double t, F& f) const
  {
    const double length = m_triangulation.length(h);
    const auto offer_at = [&](const Node node, const double part) {
      const double cost = m_costs.along(h, part >= t);
      if(cost < infinity)
        f(node, cost * length * std::abs(part - t));
    };
    offer_at(m_nodes.at_source(m_triangulation, h), 0);
    offer_at(m_nodes.at_target(m_triangulation, h), 1);
    m_nodes.for_each_node_on_edge(h, offer_at);
  }

  using Steiner_view::m_triangulation;
};

} // namespace internal

/*!
 * \ingroup PkgGeodesicCostsGraphs
 *
 * The common base class of `Steiner_graph` and `Directional_graph`: the nodes of a mesh with
 * Steiner points, and their arcs. The nodes at the border of a face are a group, see
 * `GeodesicGraph`.
 *
 * \tparam Placement a model of `SteinerPointPlacement`
 * \tparam Costs determines the costs of arcs: by the weights of faces, or by their gauges
 */
template <typename Placement, typename Costs>
class Steiner_graph_base : public internal::Steiner_groups
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
  /// if it lies on an edge, or that in the opposite direction, whichever is larger, for the corner
  /// where this is least; `0` for vertices. Paths between points \f$p\f$ and \f$q\f$ cost at most
  /// \f$(1 + \varepsilon)\,d(p,q) + (2 + \varepsilon)(c_p + c_q)\f$, where \f$d\f$ is the cost of
  /// the cheapest path on the surface, \f$\varepsilon\f$ is `epsilon()`, and \f$c\f$ is this cost.
  /// It is in units of the graph, see `unit()`, and infinity for points that no path leaves or
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

  /// returns by how much, relatively, distances there can be larger than those back: `0`, or
  /// infinity in a `Directional_graph`.
  static constexpr double asymmetry()
  {
    return Costs::are_symmetric ? 0 : std::numeric_limits<double>::infinity();
  }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_nodes.size(); }

  /// returns the number of points on edges. On barriers, those of both sides count.
  std::size_t number_of_points() const { return m_nodes.points().number_of_points(); }

  /// returns the unit of costs, in the unit of the mesh times that of the costs per unit of length.
  double unit() const { return m_triangulation.unit() * Costs::unit(m_triangulation); }

  /// returns a summary of the costs of the arcs along edges, as if points divided every edge into
  /// equal parts. It is updated whenever many weights have changed.
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

  /// returns whether there may be arcs that cost nothing though they have a length.
  bool has_free_arcs() const { return m_may_have_free_arcs; }

  /// calls `f(target, length)` for the arcs from `node` that cost nothing. `starts` tells whether
  /// paths start with the node.
  template <typename F>
  void for_each_free_arc(const Node node, const bool starts, F f) const
  {
    using Lengths = internal::Free_lengths<Costs>;
    const bool is_vertex = !m_nodes.is_point(node) && !m_nodes.is_sector(node);
    if(starts || !is_vertex || !m_nodes.is_divided(node)) // no path leads through such a vertex
      internal::Steiner_arcs<Lengths>(Lengths(costs(m_is_backward)))
          .for_each(node, typename Lengths::No_labels(), f);
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

  /// \cond SKIP_IN_MANUAL
  // Attaches a point by those of these lines that cost nothing, with their lengths as costs.
  internal::Steiner_attachment<internal::Free_lengths<Costs>>
  attach_free(const Intrinsic_point& point, const bool is_target) const
  {
    return {internal::Free_lengths<Costs>(costs(is_target != m_is_backward)), point};
  }
  /// \endcond

  /// prefetches the data from which the arcs of `node` are computed.
  void prefetch(const Node node) const { m_nodes.prefetch(m_triangulation, node); }

  /// returns the number of bytes that the graph takes, its triangulation included.
  std::size_t memory() const
  {
    return internal::memory_of(m_triangulation, m_placement, m_edges, m_nodes, m_changes);
  }

  /// returns whether the triangulation is valid.
  bool is_valid() const { return m_triangulation.is_valid(); }

  /// @}

  /// \cond SKIP_IN_MANUAL
protected:
  Steiner_graph_base(Intrinsic_triangulation triangulation,
                     Placement placement,
                     const std::size_t maximum_number_of_points,
                     const bool is_backward = false)
    : Steiner_groups(std::move(triangulation)),
      m_placement(std::move(placement)),
      m_edges(m_triangulation),
      m_is_backward(is_backward)
  {
    m_nodes = internal::Steiner_nodes(m_triangulation, m_placement, maximum_number_of_points);
    summarize_arcs();
  }

  void summarize_arcs()
  {
    m_arc_lengths = arcs().along_edges();
    m_may_have_free_arcs = Costs::are_some_free(m_triangulation);
    m_number_of_changes = m_changes.number();
  }

  Placement m_placement;
  typename Costs::Edges m_edges;
  Arc_lengths m_arc_lengths;
  std::size_t m_number_of_changes = 0; // before arcs were summarized
  bool m_is_backward;                  // whether distances are those to the sources of a search

private:
  Costs costs(const bool is_backward) const
  {
    return {m_triangulation, m_nodes, m_edges, is_backward};
  }

  internal::Steiner_arcs<Costs> arcs() const
  {
    return internal::Steiner_arcs<Costs>(costs(m_is_backward));
  }
  /// \endcond
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_COSTS_STEINER_GRAPH_BASE_H
