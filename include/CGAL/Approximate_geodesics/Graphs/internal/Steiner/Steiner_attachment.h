// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ATTACHMENT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ATTACHMENT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The straight lines between a point of the surface and the nodes of a Steiner graph in the same
 * face, and other points there. `Costs` is `Weighted_costs` or `Gauge_costs`: costs are those of
 * leaving the point, or of arriving there if these costs are those of the opposite directions.
 */
template <typename Costs>
class Steiner_attachment
{
  using Index = Intrinsic_triangulation::Index;
  using Node = Steiner_nodes::Node;

public:
  Steiner_attachment(const Intrinsic_triangulation& triangulation,
                     const Steiner_nodes& nodes,
                     const Costs& costs,
                     const Intrinsic_point& point)
    : m_triangulation(triangulation),
      m_nodes(nodes),
      m_points(nodes.points()),
      m_costs(costs),
      m_point(point)
  {
  }

  // Calls `f(node, cost)` for the lines to nodes. If the point is a vertex, these are all nodes
  // that stand for it.
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
      if(m_costs.is_open(h))
        expand_across_face(h, f);
    });
    if(m_point.is_on_edge())
    {
      expand_along_edge(m_point.halfedge, m_point.t, f);
      expand_along_edge(m_triangulation.opposite(m_point.halfedge), 1 - m_point.t, f);
    }
  }

  // Calls `f(i, cost)` for each line to one of `points`. There may be several to the same point.
  template <typename F>
  void for_each_point(const Points_by_face& points, F f) const
  {
    m_point.for_each_face(m_triangulation, [&](const Index h) {
      points.for_each_in_face(h, [&](const std::size_t i) { for_each_line(h, points[i], i, f); });
    });
  }

  // A line in a face crosses no edge.
  template <typename End, typename F>
  double for_each_crossing(const End& /* end */, const double cost, F /* f */) const
  {
    return cost;
  }

private:
  template <typename End, typename F>
  static void offer(const End end, const double cost, F& f)
  {
    if(cost < std::numeric_limits<double>::infinity())
      f(end, cost);
  }

  // To the corners of the face to the left of `h`, and to the nodes on those of its sides that the
  // point is not on.
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
          for_each_node_on_edge(side, [&](const Node node, const double part) {
            offer(node, m_costs.across(h, start + part * (end - start) - position), f);
          });
      }
    });
  }

  // From the point at the part `t` of the way along `h` to all nodes of the edge, or of its left
  // side.
  template <typename F>
  void expand_along_edge(const Index h, const double t, F& f) const
  {
    const double length = m_triangulation.length(h);
    const double to_source = m_costs.along(h, false) * length;
    const double to_target = m_costs.along(h, true) * length;
    const auto offer_at = [&](const Node node, const double part) {
      offer(node, part < t ? to_source * (t - part) : to_target * (part - t), f);
    };
    offer_at(m_nodes.at_source(m_triangulation, h), 0);
    offer_at(m_nodes.at_target(m_triangulation, h), 1);
    for_each_node_on_edge(h, offer_at);
  }

  // Calls `f(node, part)` for the points of the edge of `h`, or of its left side, with their parts
  // of the way along `h`.
  template <typename F>
  void for_each_node_on_edge(const Index h, F f) const
  {
    const Index e = m_points.edge(h);
    for(Index p = m_points.first_point(e); p < m_points.beyond_point(e); ++p)
      f(m_nodes.node_of_point(p),
        m_points.is_first(h) ? m_points.part_before(e, p) : m_points.part_behind(e, p));
  }

  // Along an edge, and across the face to the left of `h`.
  template <typename F>
  void for_each_line(const Index h, const Intrinsic_point& end, const std::size_t i, F& f) const
  {
    if(m_point.is_same(end, m_triangulation))
    {
      f(i, 0.);
      return;
    }
    if(m_point.is_on_edge() && end.is_on_edge())
      for(const Index side : {m_point.halfedge, m_triangulation.opposite(m_point.halfedge)})
        line_along_edge(side, end, i, f);
    if(m_costs.is_open(h))
      for_each_face_point(m_triangulation, m_point, h, [&](const Face_point& p) {
        for_each_face_point(m_triangulation, end, h,
                            [&](const Face_point& q) { offer(i, m_costs.between(h, p, q), f); });
      });
  }

  // On the left side of `side`, which the point is on, if the other point is, too.
  template <typename F>
  void
  line_along_edge(const Index side, const Intrinsic_point& end, const std::size_t i, F& f) const
  {
    const Index h = m_point.halfedge, opposite = m_triangulation.opposite(h);
    if(end.halfedge != h && end.halfedge != opposite)
      return;
    const double way = (end.halfedge == h ? end.t : 1 - end.t) - m_point.t; // along `h`
    offer(i,
          m_costs.along(side, (way > 0) == (side == h)) *
              (std::abs(way) * m_triangulation.length(h)),
          f);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
  const Costs m_costs;
  const Intrinsic_point m_point;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ATTACHMENT_H
