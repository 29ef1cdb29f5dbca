// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ATTACHMENT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ATTACHMENT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Corner_nodes.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Points_on_edges.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_layout.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The straight lines from a point of the surface to the nodes of a Steiner graph in the same face,
 * and to other points there.
 */
class Steiner_attachment : public Lines_in_faces
{
  using Node = Steiner_nodes::Node;

public:
  Steiner_attachment(const Intrinsic_triangulation& triangulation,
                     const Steiner_nodes& nodes,
                     const Intrinsic_point& point)
    : Lines_in_faces(triangulation, point),
      m_nodes(nodes),
      m_points(nodes.points()),
      m_corners(triangulation, nodes)
  {
  }

  // Calls `f(node, cost)` for the lines to nodes. If the point is a vertex, these are all nodes
  // that stand for it.
  template <typename F>
  void for_each_node(F f) const
  {
    const Intrinsic_point& p = point();
    if(p.is_vertex())
    {
      f(p.vertex, 0.);
      if(m_corners.is_divided(p.vertex))
        m_corners.for_each_sector(p.vertex, [&](const Node sector) { f(sector, 0.); });
      return;
    }
    p.for_each_face(triangulation(), [&](const Index h) { expand_across_face(h, f); });
    if(p.is_on_edge())
      for(const Index h : {p.halfedge, triangulation().opposite(p.halfedge)})
        expand_along_edge(h == p.halfedge ? p.t : 1 - p.t, h, f);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // To the corners of the face to the left of `h`, and to the nodes on those of its sides that the
  // point is not on.
  template <typename F>
  void expand_across_face(const Index h, F& f) const
  {
    const double weight = triangulation().weight(h);
    if(!(weight < infinity))
      return;
    const Face_layout layout(triangulation(), h);
    layout.for_each_position(point(), [&](const Plane_vector position) {
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Index side = layout.halfedge(i);
        const Plane_vector start = layout.corner(i), end = layout.corner((i + 1) % 3);
        f(m_corners.at_corner(layout.vertex(i), side), weight * length(start - position));
        if(!point().is_on_edge_of(side, triangulation()))
          for_each_node_on_edge(side, [&](const Node node, const double part) {
            f(node, weight * length(start + part * (end - start) - position));
          });
      }
    });
  }

  // From the point at the part `t` of the way along `h` to all nodes of the edge, or of its left
  // side.
  template <typename F>
  void expand_along_edge(const double t, const Index h, F& f) const
  {
    const double weight = triangulation().weight_of_edge(h);
    if(weight == infinity)
      return;
    const double cost = weight * triangulation().length(h);
    f(m_corners.at_source(h), cost * t);
    f(m_corners.at_target(h), cost * (1 - t));
    for_each_node_on_edge(
        h, [&](const Node node, const double part) { f(node, cost * std::abs(part - t)); });
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

  const Steiner_nodes& m_nodes;
  const Points_on_edges& m_points;
  const Corner_nodes m_corners;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_ATTACHMENT_H
