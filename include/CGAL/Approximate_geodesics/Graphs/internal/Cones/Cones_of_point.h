// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation.h>

#include <algorithm>
#include <cmath>
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
      m_unfolding{triangulation},
      m_expansion(triangulation, m_unfolding, rules),
      m_rules(rules),
      m_point(point),
      m_lines(triangulation, point)
  {
  }

  Cones_of_point(const Cones_of_point&) = delete; // it refers to a member
  Cones_of_point& operator=(const Cones_of_point&) = delete;

  // Calls `f(v, length)` for the lines to vertices.
  template <typename F>
  void for_each_node(F f) const
  {
    m_lines.for_each_node(f);
    if(!m_point.is_vertex())
      for_each_view([&](const View& view) {
        m_expansion.expand_through(
            view, [&](const Straight_arc& arc) { f(arc.target, arc.length); }, Leave_out_nothing());
      });
  }

  // Calls `f(i, length)` for the lines to given points.
  template <typename F>
  void for_each_point(const Points_by_face& points, F f) const
  {
    if(points.is_empty() || m_point.is_vertex())
      return;
    m_lines.for_each_point(points, f);
    Window_tree tree;
    const auto report = [&](const std::size_t i, const Straight_arc& line) { f(i, line.length); };
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
    return trace(search, f);
  }

  // Considers the lines to a point that cross no edge.
  void consider_lines_in_faces(const Intrinsic_point& end, Line_search& search) const
  {
    const auto consider = [&](const double l) { search.consider({0, l, {0, 0}, 0, 0}); };
    if(m_point.is_vertex())
      consider(shortest_segment(m_triangulation, m_point, end).length);
    else if(end.is_vertex())
      m_lines.for_each_node([&](const Index corner, const double l) {
        if(corner == end.vertex)
          consider(l);
      });
    else
      m_lines.for_each_point(Points_by_face(m_triangulation, {end}),
                             [&](std::size_t, const double l) { consider(l); });
  }

  // Considers the lines to a point through windows that `visitor` does not prune.
  template <typename Visitor>
  void find_line(const Intrinsic_point& end, const Visitor& visitor, Line_search& search) const
  {
    for_each_view([&](const View& view) { find_line(end, view, visitor, search); });
  }

  // Considers those in the given direction, up to a small angle, that are no longer than `reach`.
  void find_line(const Intrinsic_point& end,
                 const Direction_in_mesh& direction,
                 const double tolerance,
                 const double reach,
                 Line_search& search) const
  {
    const Intrinsic_triangulation& t = m_triangulation;
    const auto look = [&](const Index h, const double angle) {
      for_each_view_out_of_face(h, [&](const View& view) {
        const Plane_vector ray =
            turned_left(unit_vector(h, view.start), {std::cos(angle), std::sin(angle)});
        find_line(end, view, Along_line{{}, ray, reach, tolerance}, search);
      });
    };
    if(!m_point.is_vertex())
      return look(direction.halfedge, direction.angle);
    Index h = direction.halfedge;
    double angle = direction.angle;
    for(Index n = t.degree(m_point.vertex); n > 0 && !t.is_border(h) && angle >= -tolerance; --n)
    {
      const double corner = angle_of(corner_angle(t, h));
      if(angle <= corner + tolerance)
        look(h, angle);
      angle -= corner;
      h = t.counterclockwise(m_point.vertex, h);
    }
  }

  // Considers the line of an arc from `source`, the point, that was found in another triangulation.
  void find_arc(const Retriangulation& other,
                const Index source,
                const Straight_arc& arc,
                const Intrinsic_point& end,
                Line_search& search) const
  {
    std::optional<Direction_in_mesh> direction = other.direction(source, arc.start);
    if(!direction)
      return;
    direction->angle += angle_of(arc.position);
    for(double tolerance = 1e-11; tolerance < 1e-3 && !search.is_found(); tolerance *= 100)
      find_line(end, *direction, tolerance, arc.length, search);
  }

  // Calls `f(h, t)` for the edges that the line found crosses. Returns its length.
  template <typename F>
  double trace(const Line_search& search, F f) const
  {
    if(search.found.trail != 0)
      search.for_each_crossing(m_triangulation, view(search.found.start).window, f);
    return search.found.length;
  }

private:
  // Windows that a line with this direction and length may go through.
  struct Along_line : Leave_out_nothing_in_doubt
  {
    bool prune(const Window& w) const
    {
      const Plane_vector edge = w.left_position - w.right_position;
      return cross(direction, w.left_position) < -tolerance * length(w.left_position) ||
             cross(w.right_position, direction) < -tolerance * length(w.right_position) ||
             cross(w.right_position, edge) > 1.01 * reach * cross(direction, edge);
    }

    Plane_vector direction; // of length 1
    double reach;
    double tolerance;
  };

  template <typename Visitor>
  void find_line(const Intrinsic_point& end,
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

  // Looks for points in the faces that cones cross.
  template <typename Visitor, typename Report>
  struct Finding_points : Remembering<Visitor>
  {
    static constexpr bool wants_faces = true;

    void on_face(const Cone& cone, const Plane_vector apex) const
    {
      const Window& w = cone.window;
      points.for_each_in_face(w.halfedge, [&](const std::size_t i) {
        for_each_face_point(triangulation, points[i], w.halfedge, [&](const Face_point& point) {
          const Plane_vector position = point.seen_from(triangulation, w.halfedge)
                                            .position({w.left_position, w.right_position, apex});
          if(is_seen(position, cone))
            report(i, Straight_arc{0, length(position), position, start, w.trail});
        });
      });
    }

    static bool is_seen(const Plane_vector position, const Cone& cone)
    {
      const double rounding = (std::max)(1e-14, Visitor::slack) * length(position);
      return cross(cone.right.direction, position) >= -rounding &&
             cross(position, cone.left.direction) >= -rounding;
    }

    const Intrinsic_triangulation& triangulation;
    const Points_by_face& points;
    const Report& report;
    Index start;
  };

  template <typename Visitor, typename Report>
  void expand_to_points(const View& view,
                        const Points_by_face& points,
                        Window_tree& tree,
                        const Visitor& visitor,
                        const Report& report) const
  {
    m_expansion.expand_through(
        view, [](const Straight_arc&) {},
        Finding_points<Visitor, Report>{
            {visitor, tree}, m_triangulation, points, report, view.start});
  }

  // Calls `f(view)` for the sides through which lines leave the faces that contain the point.
  template <typename F>
  void for_each_view(F f) const
  {
    m_point.for_each_face(m_triangulation, [&](const Index h) { for_each_view_out_of_face(h, f); });
  }

  template <typename F>
  void for_each_view_out_of_face(const Index h, F f) const
  {
    for(const Index side : m_triangulation.halfedges_of_face(h))
      if(!m_triangulation.is_border(m_triangulation.opposite(side)) &&
         !m_point.is_on_edge_of(side, m_triangulation))
        if(const View v = view(side); v.window.left_distance > 0 && v.window.right_distance > 0)
          f(v);
  }

  // The direction of `h` as it is laid out for the view through `side`, a halfedge of the same
  // face.
  Plane_vector unit_vector(const Index h, const Index side) const
  {
    const Face_layout layout(m_triangulation, side);
    std::size_t i = 0;
    while(i < 2 && layout.halfedge(i) != h)
      ++i;
    const Plane_vector edge = layout.edge(i, (i + 1) % 3);
    return 1 / length(edge) * edge;
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

  const Intrinsic_triangulation& m_triangulation;
  const Unfolding_on_demand m_unfolding;
  const Cone_expansion<Unfolding_on_demand> m_expansion;
  const Cone_rules m_rules;
  const Intrinsic_point m_point;
  const Lines_in_faces m_lines;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H
