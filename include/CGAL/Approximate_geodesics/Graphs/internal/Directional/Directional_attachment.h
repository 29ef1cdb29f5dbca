// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_DIRECTIONAL_ATTACHMENT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_DIRECTIONAL_ATTACHMENT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Directional/Travel_costs.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Corner_nodes.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Points_by_face.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The straight lines between a point of the surface and the nodes in the same face, and to other
 * points there, where costs depend on the direction. Costs are those of leaving the point; those of
 * arriving there are those of leaving it with the traveler reversed.
 */
class Directional_attachment
{
  using Index = Intrinsic_triangulation::Index;
  using Node = Steiner_nodes::Node;

public:
  Directional_attachment(const Intrinsic_triangulation& triangulation,
                         const Steiner_nodes& nodes,
                         const Travel_costs& costs,
                         const Intrinsic_point& point)
    : m_triangulation(triangulation),
      m_nodes(nodes),
      m_points(nodes.points()),
      m_corners(triangulation, nodes),
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
      if(m_corners.is_divided(m_point.vertex))
        m_corners.for_each_sector(m_point.vertex, [&](const Node sector) { f(sector, 0.); });
      return;
    }
    m_point.for_each_face(m_triangulation, [&](const Index h) { expand_across_face(h, f); });
    if(m_point.is_on_edge())
    {
      const Index opposite = m_triangulation.opposite(m_point.halfedge);
      expand_along_edge(m_point.halfedge, m_point.t, f);
      expand_along_edge(opposite, 1 - m_point.t, f);
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
  // The corners of the face to the left of `h` in its frame, from the source of `h` on.
  std::array<Plane_vector, 3> corners(const Index h) const
  {
    const auto halfedges = m_triangulation.halfedges_of_face(h);
    const auto way = [&](const Index g) {
      return m_triangulation.length(g) * m_triangulation.gauges().side(g);
    };
    return {Plane_vector{0, 0}, way(halfedges[0]), -1 * way(halfedges[2])};
  }

  // Calls `f(position)` for where a point is among these corners.
  template <typename F>
  void for_each_position(const Index h,
                         const std::array<Plane_vector, 3>& corners,
                         const Intrinsic_point& p,
                         F f) const
  {
    for_each_face_point(m_triangulation, p, h, [&](const Face_point& q) {
      f(q.seen_from(m_triangulation, h).position(corners));
    });
  }

  // To the corners of the face to the left of `h`, and to the nodes on those of its sides that the
  // point is not on.
  template <typename F>
  void expand_across_face(const Index h, F& f) const
  {
    const auto corner = corners(h);
    const auto halfedges = m_triangulation.halfedges_of_face(h);
    for_each_position(h, corner, m_point, [&](const Plane_vector position) {
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Index side = halfedges[i];
        const Plane_vector start = corner[i], end = corner[(i + 1) % 3];
        f(m_corners.at_corner(m_triangulation.source(side), side),
          m_costs.across(h, start - position));
        if(!m_point.is_on_edge_of(side, m_triangulation))
          for_each_node_on_edge(side, [&](const Node node, const double part) {
            f(node, m_costs.across(h, start + part * (end - start) - position));
          });
      }
    });
  }

  // From the point at the part `t` of the way along `h` to all nodes of the edge, or of its left
  // side.
  template <typename F>
  void expand_along_edge(const Index h, const double t, F& f) const
  {
    f(m_corners.at_source(h), cost_along(h, t, 0));
    f(m_corners.at_target(h), cost_along(h, t, 1));
    for_each_node_on_edge(
        h, [&](const Node node, const double part) { f(node, cost_along(h, t, part)); });
  }

  double cost_along(const Index h, const double from, const double to) const
  {
    if(from == to)
      return 0;
    const double length = m_triangulation.length(h);
    return to > from ? m_costs.along(h) * ((to - from) * length)
                     : m_costs.against(h) * ((from - to) * length);
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
      for(const Index g : {m_point.halfedge, m_triangulation.opposite(m_point.halfedge)})
        if(end.halfedge == g)
          f(i, cost_along(g, g == m_point.halfedge ? m_point.t : 1 - m_point.t, end.t));
    const auto corner = corners(h);
    for_each_position(h, corner, m_point, [&](const Plane_vector p) {
      for_each_position(h, corner, end,
                        [&](const Plane_vector q) { f(i, m_costs.across(h, q - p)); });
    });
  }

  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
  const Corner_nodes m_corners;
  const Travel_costs m_costs;
  const Intrinsic_point m_point;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_DIRECTIONAL_DIRECTIONAL_ATTACHMENT_H
