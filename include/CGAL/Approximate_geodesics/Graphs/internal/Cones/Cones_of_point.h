// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>
#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

// Throws if no line of about the given length was found.
inline void check_is_found(const Line_search& search, const double unit)
{
  if(!search.is_found())
    reject("the graph has an arc of length " + text_of(search.length * unit) +
           " that the mesh has not; was it read from a file that was changed?");
}

/*
 * The straight lines from a point that is not a vertex, across the faces around, as far as a
 * discrete geodesic graph follows those from a vertex: to vertices, and to other such points. For
 * the same reason as there, they are enough for paths that are at most 1 + epsilon times as long as
 * the shortest ones.
 */
class Cones_of_point
{
  using Index = Intrinsic_triangulation::Index;

public:
  Cones_of_point(const Intrinsic_triangulation& triangulation,
                 const Cone_rules& rules,
                 const Intrinsic_point& point)
    : m_triangulation(triangulation),
      m_unfolding(triangulation),
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
      for_each_window([&](const Window& window, const Index start) {
        m_expansion.expand_through(
            window, start, [&](const Straight_arc& arc) { f(arc.target, arc.length); },
            Leave_out_nothing());
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
    expand_to_points(points, tree, Leave_out_nothing(),
                     [&](const std::size_t i, const Straight_arc& line) { f(i, line.length); });
  }

  // Calls `f(h, t)` for the edges that the line of the given length to the vertex `v` crosses.
  // Returns its length.
  template <typename F>
  double for_each_crossing(const Index v, const double length, F f) const
  {
    Line_search search{length};
    find_line(v, Leave_out_nothing(), search);
    if(!search.is_found())
      farther().find_arc(v, Leave_out_nothing_in_doubt(), search);
    return trace(search, f);
  }

  // The same for the line to `end`, which is not a vertex.
  template <typename F>
  double for_each_crossing(const Intrinsic_point& end, const double length, F f) const
  {
    Line_search search{length};
    find_line(end, Leave_out_nothing(), search);
    if(!search.is_found())
      farther().find_line(end, Leave_out_nothing_in_doubt(), search);
    return trace(search, f);
  }

  // The same for a line to a vertex or a point through windows that `visitor` does not prune, of a
  // length that may be wrong by `rounding`. Throws if there is none.
  template <typename End, typename Visitor, typename F>
  double trace_within(
      const End& end, const double length, const double rounding, const Visitor& visitor, F f) const
  {
    Line_search search(length, rounding);
    find_line(end, visitor, search);
    check_is_found(search, m_triangulation.unit());
    return trace(search, f);
  }

private:
  // For lines that are not found again, as cones have ended before by rounding only.
  Cones_of_point farther() const { return {m_triangulation, m_rules.farther(1. / 64), m_point}; }

  template <typename Visitor>
  void find_line(const Index v, const Visitor& visitor, Line_search& search) const
  {
    m_lines.for_each_node([&](const Index corner, const double l) {
      if(corner == v)
        search.consider({corner, l, {0, 0}, 0, 0});
    });
    find_arc(v, visitor, search);
  }

  template <typename Visitor>
  void find_line(const Intrinsic_point& end, const Visitor& visitor, Line_search& search) const
  {
    const Points_by_face points(m_triangulation, {end});
    m_lines.for_each_point(points, [&](std::size_t, const double l) {
      search.consider({0, l, {0, 0}, 0, 0});
    });
    expand_to_points(points, search.tree, visitor,
                     [&](std::size_t, const Straight_arc& line) { search.consider(line); });
  }

  template <typename Visitor>
  void find_arc(const Index v, const Visitor& visitor, Line_search& search) const
  {
    const auto consider = [&](const Straight_arc& arc) {
      if(arc.target == v)
        search.consider(arc);
    };
    if(!m_point.is_vertex())
      for_each_window([&](const Window& window, const Index start) {
        m_expansion.expand_through(window, start, consider,
                                   Remembering<Visitor>{visitor, search.tree});
      });
  }

  // Looks for points in the faces that it is told of, and records windows.
  template <typename Visitor, typename Report>
  struct Finding_points : Visitor
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

    std::uint32_t record_window(const Index halfedge, const std::uint32_t trail) const
    {
      return tree.add(halfedge, trail);
    }

    const Intrinsic_triangulation& triangulation;
    const Points_by_face& points;
    Window_tree& tree;
    const Report& report;
    Index start;
  };

  template <typename Visitor, typename Report>
  void expand_to_points(const Points_by_face& points,
                        Window_tree& tree,
                        const Visitor& visitor,
                        const Report& report) const
  {
    for_each_window([&](const Window& window, const Index start) {
      m_expansion.expand_through(
          window, start, [](const Straight_arc&) {},
          Finding_points<Visitor, Report>{visitor, m_triangulation, points, tree, report, start});
    });
  }

  // Calls `f(window, start)` for the sides of the faces around that one can look out of. `start` is
  // the halfedge inside.
  template <typename F>
  void for_each_window(F f) const
  {
    m_point.for_each_face(m_triangulation, [&](const Index h) {
      for(const Index side : m_triangulation.halfedges_of_face(h))
        if(!m_triangulation.is_border(m_triangulation.opposite(side)) &&
           !m_point.is_on_edge_of(side, m_triangulation))
        {
          const Window w = window(side);
          if(w.left_distance > 0 && w.right_distance > 0)
            f(w, side);
        }
    });
  }

  // The view out of the face to the left of `side`, from the point at the origin.
  Window window(const Index side) const
  {
    const Face_layout layout(m_triangulation, side);
    Plane_vector position{0, 0};
    layout.for_each_position(m_point, [&](const Plane_vector p) { position = p; });
    Plane_vector left = layout.corner(1) - position, right = layout.corner(0) - position;
    if(!(cross(right, left) > 0)) // the face has no area, and the point may be between its corners
    {
      const double sign = is_between(right, left) ? -1 : 1;
      left = {sign * length(left), 0};
      right = {length(right), 0};
    }
    return {m_triangulation.opposite(side),
            layout.vertex(1),
            layout.vertex(0),
            left,
            right,
            length(left),
            length(right),
            0};
  }

  // Whether two points that are in one line with the origin are on either side of it, and not so
  // close to it that this is a matter of rounding.
  static bool is_between(const Plane_vector a, const Plane_vector b)
  {
    constexpr double rounding = 1e-9;
    return dot(a, b) < 0 && (std::min)(length(a), length(b)) > rounding * length(b - a);
  }

  template <typename F>
  double trace(const Line_search& search, F f) const
  {
    if(search.found.trail != 0)
    {
      const Window first = window(search.found.start);
      search.for_each_crossing(m_triangulation, first.left_position, first.right_position, f);
    }
    return search.found.length;
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
