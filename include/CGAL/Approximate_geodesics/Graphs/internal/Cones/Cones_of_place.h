// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_PLACE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_PLACE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_plane.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Points_by_face.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>
#include <CGAL/Approximate_geodesics/Surface/internal/lines_in_faces.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The straight lines from a place that is not a vertex, across the faces around, as far as a
 * discrete geodesic graph follows those from a vertex: to vertices, and to other such places. For
 * the same reason as there, they are enough for paths that are at most 1 + epsilon times as long as
 * the shortest ones.
 */
class Cones_of_place
{
  using Index = Intrinsic_triangulation::Index;

public:
  Cones_of_place(const Intrinsic_triangulation& triangulation,
                 const double epsilon,
                 const Intrinsic_point& place)
    : m_triangulation(triangulation),
      m_unfolding(triangulation),
      m_expansion(triangulation, m_unfolding, epsilon),
      m_epsilon(epsilon),
      m_place(place)
  {
  }

  Cones_of_place(const Cones_of_place&) = delete; // it refers to a member
  Cones_of_place& operator=(const Cones_of_place&) = delete;

  // Calls `f(v, length)` for the lines to vertices.
  template <typename F>
  void for_each_arc(F f) const
  {
    for_each_line_to_corner(m_triangulation, m_place, f);
    if(!m_place.is_vertex())
      for_each_window([&](const Window& window, const Index start) {
        m_expansion.expand_through(
            window, start, [&](const Straight_arc& arc) { f(arc.target, arc.length); },
            Leave_out_nothing());
      });
  }

  // Calls `f(i, length)` for the lines to given places.
  template <typename F>
  void for_each_line(const Points_by_face& places, F f) const
  {
    if(places.is_empty() || m_place.is_vertex())
      return;
    for_each_line_in_face(m_triangulation, m_place, places, f);
    Window_tree tree;
    expand_to_places<Leave_out_nothing>(
        places, tree, [&](const std::size_t i, const Straight_arc& line) { f(i, line.length); });
  }

  // Calls `f(h, t)` for the edges that the line of the given length to the vertex `v` crosses.
  // Returns its length.
  template <typename F>
  double trace_arc(const Index v, const double length, F f) const
  {
    Line_search search{length};
    for_each_line_to_corner(m_triangulation, m_place, [&](const Index corner, const double l) {
      if(corner == v)
        search.consider({corner, l, {0, 0}, 0, 0});
    });
    find_arc<Leave_out_nothing>(v, search);
    if(!search.is_found())
      farther().find_arc<Leave_out_nothing_in_doubt>(v, search);
    return trace(search, f);
  }

  // The same for the line to `end`, which is not a vertex.
  template <typename F>
  double trace_line(const Intrinsic_point& end, const double length, F f) const
  {
    const Points_by_face places(m_triangulation, {end});
    Line_search search{length};
    const auto consider = [&](std::size_t, const Straight_arc& line) { search.consider(line); };
    for_each_line_in_face(m_triangulation, m_place, places, [&](std::size_t, const double l) {
      search.consider({0, l, {0, 0}, 0, 0});
    });
    expand_to_places<Leave_out_nothing>(places, search.tree, consider);
    if(!search.is_found())
      farther().expand_to_places<Leave_out_nothing_in_doubt>(places, search.tree, consider);
    return trace(search, f);
  }

private:
  // For lines that are not found again, as cones have ended before by rounding only.
  Cones_of_place farther() const { return {m_triangulation, m_epsilon / 64, m_place}; }

  template <typename Filter>
  void find_arc(const Index v, Line_search& search) const
  {
    const auto consider = [&](const Straight_arc& arc) {
      if(arc.target == v)
        search.consider(arc);
    };
    if(!m_place.is_vertex())
      for_each_window([&](const Window& window, const Index start) {
        m_expansion.expand_through(window, start, consider,
                                   Remembering<Filter>{Filter(), search.tree});
      });
  }

  // Looks for places in the faces that it is told of, and remembers windows.
  template <typename Filter, typename Report>
  struct Finding_places : Filter
  {
    static constexpr bool wants_faces = true;

    void on_face(const Cone& cone, const Plane_vector apex) const
    {
      const Window& w = cone.window;
      places.for_each_in_face(triangulation, w.halfedge, [&](const std::size_t i) {
        for_each_face_point(triangulation, places[i], w.halfedge, [&](const Face_point& point) {
          const Face_point p = point.seen_from(triangulation, w.halfedge);
          const Plane_vector position =
              p.weight[0] * w.left_position + p.weight[1] * w.right_position + p.weight[2] * apex;
          if(is_seen(position, cone))
            report(i, Straight_arc{0, length(position), position, start, w.way});
        });
      });
    }

    static bool is_seen(const Plane_vector position, const Cone& cone)
    {
      const double rounding = (std::max)(1e-14, Filter::slack) * length(position);
      return cross(cone.right.direction, position) >= -rounding &&
             cross(position, cone.left.direction) >= -rounding;
    }

    std::uint32_t way_through(const Index halfedge, const std::uint32_t way) const
    {
      return tree.add(halfedge, way);
    }

    const Intrinsic_triangulation& triangulation;
    const Points_by_face& places;
    Window_tree& tree;
    const Report& report;
    Index start;
  };

  template <typename Filter, typename Report>
  void expand_to_places(const Points_by_face& places, Window_tree& tree, const Report& report) const
  {
    for_each_window([&](const Window& window, const Index start) {
      m_expansion.expand_through(
          window, start, [](const Straight_arc&) {},
          Finding_places<Filter, Report>{{}, m_triangulation, places, tree, report, start});
    });
  }

  // Calls `f(window, start)` for the sides of the faces around that one can look out of. `start` is
  // the halfedge inside.
  template <typename F>
  void for_each_window(F f) const
  {
    for_each_face(m_triangulation, m_place, [&](const Index h) {
      for(const Index side : halfedges_of_face(m_triangulation, h))
        if(!m_triangulation.is_border(m_triangulation.opposite(side)) && !is_on(side))
        {
          const Window w = window(side);
          if(w.left_distance > 0 && w.right_distance > 0)
            f(w, side);
        }
    });
  }

  bool is_on(const Index side) const
  {
    return m_place.is_on_edge() &&
           (side == m_place.halfedge || m_triangulation.opposite(side) == m_place.halfedge);
  }

  // The view out of the face to the left of `side`, from the place at the origin.
  Window window(const Index side) const
  {
    const Face_plane plane(m_triangulation, side);
    Plane_vector position{0, 0};
    plane.for_each_position(m_place, [&](const Plane_vector p) { position = p; });
    Plane_vector left = plane.corner(1) - position, right = plane.corner(0) - position;
    if(!(cross(right, left) > 0)) // the face has no area, and the place may be between its corners
    {
      const double sign = is_between(right, left) ? -1 : 1;
      left = {sign * length(left), 0};
      right = {length(right), 0};
    }
    return {m_triangulation.opposite(side),
            plane.vertex(1),
            plane.vertex(0),
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
    const std::vector<Index> halfedges = search.tree.halfedges(search.found.way);
    if(!halfedges.empty())
    {
      const Window first = window(search.found.start);
      for_each_crossing(m_triangulation, halfedges, first.left_position, first.right_position,
                        search.found.position, f);
    }
    return search.found.length;
  }

  const Intrinsic_triangulation& m_triangulation;
  const Unfolding_on_demand m_unfolding;
  const Cone_expansion<Unfolding_on_demand> m_expansion;
  const double m_epsilon;
  const Intrinsic_point m_place;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONES_OF_PLACE_H
