// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The arcs of a Steiner graph, which are computed from its nodes when they are asked for. What they
 * cost, and which of those across a face matter, `Costs` knows: `Weighted_costs` or `Gauge_costs`.
 */
template <typename Costs>
class Steiner_arcs
{
  using Index = Intrinsic_triangulation::Index;
  using Node = Index;
  using Face = Viewpoint::Face;

public:
  Steiner_arcs(const Intrinsic_triangulation& triangulation,
               const Steiner_nodes& nodes,
               const Costs& costs)
    : m_triangulation(triangulation), m_nodes(nodes), m_points(nodes.points()), m_costs(costs)
  {
  }

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
    else if(labels.predecessor(node) == null_node) // a path may start there, but not go through
      m_nodes.for_each_sector(node, [&](const Node sector) { f(sector, 0.); });
  }

  // A summary of the costs of arcs along edges, as if points divided every edge into equal parts.
  Arc_lengths along_edges() const
  {
    Arc_length_summary result;
    m_points.for_each_first_halfedge([&](const Index h, const Index e) {
      for(int i = 0; i < (Costs::are_symmetric ? 1 : 2); ++i)
      {
        const double cost = m_costs.along(h, i == 0) * m_triangulation.length(h);
        const std::size_t number = m_points.number_of_points(e) + std::size_t(1);
        if(cost < infinity) // nor a forbidden edge of length zero
          result.add(cost / double(number), cost, cost, number);
      }
    });
    return result.result();
  }

private:
  static constexpr Node null_node = Intrinsic_triangulation::null_index;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

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
    // of a barrier, the side that faces the sector
    expand_edge(m_triangulation.opposite(h), false, f);
  }

  template <typename F>
  void expand_vertex(const Node v, F& f) const
  {
    const Index beyond = m_triangulation.beyond_halfedge(v);
    for(Index h = m_triangulation.first_halfedge(v); h < beyond; ++h)
    {
      expand_corner(v, h, f);
      if(m_triangulation.is_barrier(h)) // both sides of which start here
        expand_edge(m_triangulation.opposite(h), false, f);
    }
  }

  // The arcs from the source `v` of `h` along it and across the face to its left.
  template <typename F>
  void expand_corner(const Node v, const Index h, F& f) const
  {
    expand_edge(h, true, f);
    if(m_costs.is_open(h))
      m_costs.expand_corner(v, h, f);
  }

  // The arc along the edge of `h`, or along its left side, from its source or target.
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

  // A path that comes along the edge goes on into both faces, any other one only into the face that
  // it does not come from.
  template <typename Labels, typename F>
  void expand_point(const Node node, const Labels& labels, F& f) const
  {
    const Index p = m_nodes.point(node), h = m_points.halfedge(p);
    const Index opposite = m_triangulation.opposite(h);
    const bool has_right = m_points.edge(opposite) == m_points.edge(h) && m_costs.is_open(opposite);
    const Viewpoint left = viewpoint(p, h);
    if(left.cost_to_source < infinity)
      f(left.toward_source, left.cost_to_source);
    if(left.cost_to_target < infinity)
      f(left.toward_target, left.cost_to_target);

    const Node origin = labels.predecessor(node);
    if(origin == left.toward_source || origin == left.toward_target || origin == null_node)
    {
      if(m_costs.is_open(h))
        m_costs.expand_face(left, m_triangulation.halfedges_of_face(h), labels, f);
      if(has_right)
        m_costs.expand_face(left.reversed(opposite), m_triangulation.halfedges_of_face(opposite),
                            labels, f);
    }
    else if(has_right)
      expand_crossed_edge(left, origin, labels, f);
  }

  // The arcs from a viewpoint between two faces, one of which the path has crossed from `origin`
  // on.
  template <typename Labels, typename F>
  void
  expand_crossed_edge(const Viewpoint& left, const Node origin, const Labels& labels, F& f) const
  {
    const Face right_face =
        m_triangulation.halfedges_of_face(m_triangulation.opposite(left.halfedge));
    const bool comes_from_right = is_opposite(origin, right_face);
    if(comes_from_right && m_costs.is_open(left.halfedge))
    {
      const Face left_face = m_triangulation.halfedges_of_face(left.halfedge);
      m_costs.expand_face(left, left_face, labels, f);
      if(is_opposite(origin, left_face)) // two faces can have several edges in common
        m_costs.expand_face(left.reversed(right_face[0]), right_face, labels, f);
    }
    else if(!comes_from_right)
      m_costs.expand_face(left.reversed(right_face[0]), right_face, labels, f);
  }

  // The point `p`, whose edge has `h` as its first halfedge.
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

  // Whether a node is on one of the two edges of a face that are not the first, or where these
  // meet.
  bool is_opposite(const Node node, const Face& face) const
  {
    if(!m_nodes.is_point(node))
      return node == m_nodes.at_corner(m_triangulation.target(face[1]), face[2]);
    const Index e = m_points.edge(m_points.halfedge(m_nodes.point(node)));
    return e == m_points.edge(face[1]) || e == m_points.edge(face[2]);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
  const Costs m_costs;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ARCS_H
