// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The straight lines from a point across the faces around, as far as a discrete geodesic graph
 * follows those from a vertex: to vertices, and to other points. As there, they are enough for
 * paths that are at most 1 + epsilon times as long as the shortest ones.
 */
class Cones_of_point
{
public:
  Cones_of_point(const Intrinsic_triangulation& triangulation,
                 const Cone_rules& rules,
                 const Intrinsic_point& point)
    : m_triangulation(triangulation),
      m_point(point),
      m_unfolding{triangulation},
      m_expansion(triangulation, m_unfolding, rules),
      m_rules(rules),
      m_lines(triangulation, point)
  {
  }

  Cones_of_point(const Cones_of_point&) = delete; // it refers to a member
  Cones_of_point& operator=(const Cones_of_point&) = delete;

  // The rules by which cones end.
  const Cone_rules& rules() const { return m_rules; }

  // Calls `f(v, length)` for the lines to vertices.
  template <typename F>
  void for_each_node(F f) const
  {
    for_each_node(Leave_out_nothing(), f);
  }

  // The same for those through windows that `visitor` does not prune.
  template <typename Visitor, typename F>
  void for_each_node(const Visitor& visitor, F f) const
  {
    m_lines.for_each_node(f);
    if(!m_point.is_vertex())
      for_each_view([&](const View& view) { for_each_node_in_view(view, visitor, f); });
  }

  // The same for those in a view.
  template <typename Visitor, typename F>
  void for_each_node_in_view(const View& view, const Visitor& visitor, F& f) const
  {
    m_expansion.expand_through(
        view, [&](const Straight_arc& arc) { f(arc.target, arc.length); }, visitor);
  }

  // Calls `f(view)` for the sides through which lines leave the faces that contain the point.
  template <typename F>
  void for_each_view(F f) const
  {
    m_point.for_each_face(m_triangulation, [&](const Index h) { for_each_view_out_of_face(h, f); });
  }

  // Calls `f(i, length)` for the lines to given points, or `f(i, length, t)` if `for_each_foot()`
  // and `for_each_position()` tell where the nearest points are.
  template <typename Points, typename F>
  void for_each_point(const Points& points, F f) const
  {
    if(points.is_empty() || m_point.is_vertex())
      return;
    m_lines.for_each_point(points, f);
    Window_tree tree;
    const auto report = [&](const std::size_t i, const Straight_arc& line, const auto... t) {
      f(i, line.length, t...);
    };
    for_each_view([&](const View& view) {
      expand_to_points(view, points, tree, Leave_out_nothing(), report);
    });
  }

  // Calls `f(h, t)` for the edges that the line of the given length to a vertex or a point crosses.
  // Returns its length.
  template <typename End, typename F>
  double for_each_crossing(const End& vertex_or_point, const double length, F f) const
  {
    const Intrinsic_point end = point_at(vertex_or_point);
    Line_search search{length};
    consider_lines_in_faces(end, search);
    find_line(end, Within_reach<Leave_out_nothing>{{}, search.reach()}, search);
    if(!search.is_found()) // rounding has ended cones too early
      Cones_of_point(m_triangulation, m_rules.farther(1. / 64), m_point)
          .find_line(end, Leave_out_nothing_in_doubt(), search);
    if(length > 0 && !(search.smallest_difference < infinity))
      reject("a line from a curve cannot be traced: faces along it are degenerate");
    return trace(search, f);
  }

  // Considers the lines to a point that cross no edge.
  void consider_lines_in_faces(const Intrinsic_point& end, Line_search& search) const
  {
    m_lines.for_each_line_to(end, [&](const double l) { search.consider({0, l, {0, 0}, 0, 0}); });
  }

  // Considers the lines to a point through windows that `visitor` does not prune.
  template <typename Visitor>
  void find_line(const Intrinsic_point& end, const Visitor& visitor, Line_search& search) const
  {
    for_each_view([&](const View& view) { find_line_in_view(end, view, visitor, search); });
  }

  // Calls `f(h, t)` for the edges that the line found crosses. Returns its length.
  template <typename F>
  double trace(const Line_search& search, F f) const
  {
    if(search.found.trail != 0)
      search.for_each_crossing(m_triangulation, view(search.found.start).window, f);
    return search.found.length;
  }

protected:
  // Considers the lines to a point through the windows of a view.
  template <typename Visitor>
  void find_line_in_view(const Intrinsic_point& end,
                         const View& view,
                         const Visitor& visitor,
                         Line_search& search) const
  {
    const auto consider = [&](const Straight_arc& arc) {
      if(arc.target == end.vertex)
        search.consider(arc);
    };
    if(end.is_vertex())
      m_expansion.expand_through(view, consider, Remembering<Visitor>{visitor, search.tree});
    else
      expand_to_points(view, Points_by_face(m_triangulation, {end}), search.tree, visitor,
                       [&](std::size_t, const Straight_arc& line) { search.consider(line); });
  }

  // Calls `f(view)` for the sides through which lines leave the face to the left of `h`.
  template <typename F>
  void for_each_view_out_of_face(const Index h, F f) const
  {
    for(const Index side : m_triangulation.halfedges_of_face(h))
      if(!m_triangulation.is_border(m_triangulation.opposite(side)) &&
         !m_point.is_on_edge_of(side, m_triangulation))
        if(const View v = view(side); v.window.left_distance > 0 && v.window.right_distance > 0)
          f(v);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Intrinsic_point m_point;

private:
  // Looks for points in the faces that cones cross.
  template <typename Visitor, typename Points, typename Report>
  struct Finding_points : Remembering<Visitor>
  {
    static constexpr bool wants_faces = true;

    void on_face(const Cone& cone, const Plane_vector apex) const
    {
      const Window& w = cone.window;
      for_each_position(
          triangulation, points, w.halfedge, {w.left_position, w.right_position, apex},
          [&](const std::size_t i, const Plane_vector position, const auto... t) {
            if(is_seen(position, cone))
              report(i, Straight_arc{0, length(position), position, start, w.trail}, t...);
          });
    }

    static bool is_seen(const Plane_vector position, const Cone& cone)
    {
      const double rounding = (std::max)(1e-14, Visitor::slack) * length(position);
      return cross(cone.right.direction, position) >= -rounding &&
             cross(position, cone.left.direction) >= -rounding;
    }

    const Intrinsic_triangulation& triangulation;
    const Points& points;
    const Report& report;
    Index start;
  };

  template <typename Visitor, typename Points, typename Report>
  void expand_to_points(const View& view,
                        const Points& points,
                        Window_tree& tree,
                        const Visitor& visitor,
                        const Report& report) const
  {
    m_expansion.expand_through(
        view, [](const Straight_arc&) {},
        Finding_points<Visitor, Points, Report>{
            {visitor, tree}, m_triangulation, points, report, view.start});
  }

  // The view out of the face to the left of `side`, from the point at the origin.
  View view(const Index side) const
  {
    const Face_layout layout(m_triangulation, side);
    const bool has_needles = m_triangulation.thin_faces().has_extreme_needles();
    Plane_vector left{}, right{}, edge = layout.edge(1, 0);
    for_each_face_point(m_triangulation, m_point, side, [&](const Face_point& p) {
      const Plane_vector position = layout.position(p);
      left = has_needles ? layout.vector_to_corner(1, p) : layout.corner(1) - position;
      right = has_needles ? layout.vector_to_corner(0, p) : layout.corner(0) - position;
    });
    if(!(cross(right, left) > 0)) // the face has no area, and the point may be between its corners
    {
      constexpr double rounding = 1e-9; // closer to a corner, it would decide this
      const bool is_between = dot(right, left) < 0 && (std::min)(length(right), length(left)) >
                                                          rounding * length(left - right);
      const double sign = is_between ? -1 : 1;
      left = {sign * length(left), 0};
      right = {length(right), 0};
      edge = right - left;
    }
    return {{m_triangulation.opposite(side), layout.vertex(1), layout.vertex(0), left, right,
             length(left), length(right), edge, 0},
            side};
  }

  const Unfolding_on_demand m_unfolding;
  const Cone_expansion<Unfolding_on_demand> m_expansion;
  const Cone_rules m_rules;
  const Lines_in_faces m_lines;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H
