// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_LINES_OF_SIGHT_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_LINES_OF_SIGHT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/trace_arc.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Names a vertex by its index in the triangulation. On a part of a mesh, this is not its index in
// the mesh, and the search has to be repeated on the whole mesh.
struct Untraceable_line : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

// A straight line, and the halfedges that it crosses.
struct Sight_line
{
  double length = 0;
  Plane_vector end = {0, 0};
  Sight start = {}; // through the first halfedge
  std::vector<Index> halfedges = {};
};

// Looks for a line.
struct Sight_search : Sought_line<Sight_line>
{
  Sight_search(const double line_length, const double rounding_of_length)
    : Sought_line{line_length, rounding_of_length, {}}
  {
  }

  bool is_found(const double tolerance = 1e-12) const { return Sought_line::is_found(tolerance); }

  // Calls `f(h, t)` for the halfedges of the line found, at the part `t` of the way from source to
  // target. Returns its length.
  template <typename F>
  double for_each_crossing(const Face_steps& steps, F f) const
  {
    Plane_vector left = found.start.left, edge = found.start.edge;
    const auto edge_ahead = [&](const std::size_t i) {
      if(i > 0)
      {
        const Face_step& step = steps[found.halfedges[i - 1]];
        const bool goes_right = found.halfedges[i] == step.right;
        if(goes_right)
          left = left + step.left_side(edge);
        edge = goes_right ? step.right_edge(edge) : step.left_side(edge);
      }
      return std::make_pair(left, left + edge);
    };
    for_each_crossed_edge(found.halfedges, found.end, edge_ahead, f);
    return found.length;
  }
};

// Considers the lines to a given point, for a search. Sights are followed depth first, so the
// halfedges on the way of a sight are the first `depth` of the recorded ones.
template <typename Bound>
struct Tracing_visitor : Sight_visitor_base
{
  static constexpr bool wants_sights = true;
  static constexpr bool wants_faces = true;

  double bound(const Index v) const { return bounds(v); }

  void on_sight(const Sight& sight)
  {
    halfedges.resize(sight.depth);
    halfedges.push_back(sight.halfedge);
  }

  void on_vertex(const Index v,
                 const Sight_path& path,
                 const Sight& /* sight */,
                 const Plane_vector apex,
                 const Plane_vector /* left_edge */)
  {
    if(v == end.vertex)
      consider(path.length, apex);
  }

  void on_face(const Sight& sight, const Plane_vector apex)
  {
    if(!end.is_vertex())
      for_each_position(triangulation, end, sight.halfedge, {sight.left, sight.right, apex},
                        [&](const Plane_vector position) {
                          const Sight_path path = sight.path_to(position, length(position));
                          if(path.length < infinity)
                            consider(path.length, position);
                        });
  }

  void consider(const double length, const Plane_vector position)
  {
    search.consider(length, [&] { return Sight_line{length, position, first, halfedges}; });
  }

  const Intrinsic_triangulation& triangulation;
  const Bound& bounds;
  const Intrinsic_point& end;
  Sight_search& search;
  Sight first;
  std::vector<Index> halfedges;
};

/*
 * The straight lines from a point that is not a vertex. Without labels, they are those in its
 * faces; those across other faces are found with the help of upper bounds, as those from vertices.
 */
class Lines_of_sight : public Lines_in_faces
{
public:
  using Lines_in_faces::for_each_crossing;

  Lines_of_sight(const Intrinsic_triangulation& triangulation,
                 const Sight_tables& tables,
                 const Intrinsic_point& point)
    : Lines_in_faces(triangulation, point), m_tables(tables)
  {
  }

  /*
   * Calls `on_node(v, length, arrival)` for lines to vertices, and `on_point(i, length)` for lines
   * to `points`, or `on_point(i, length, t)` if `for_each_foot()` and `for_each_position()` tell
   * where the nearest points are: for those of use to paths that start with the label `label` here,
   * and that are no longer than `bound(v)` at each vertex `v` that they could be reached over.
   */
  template <typename Bound, typename Points, typename OnNode, typename OnPoint>
  void for_each_line(const double label,
                     const Bound& bound,
                     const Points& points,
                     OnNode on_node,
                     OnPoint on_point) const
  {
    for_each_corner(on_node);
    Lines_in_faces::for_each_point(points, on_point);
    Visitor<Bound, Points, OnNode, OnPoint> visitor{{},     triangulation(), bound,
                                                    points, on_node,         on_point};
    Sight_expansion<decltype(visitor)> expansion(m_tables, label, visitor);
    for_each_sight([&](const Sight& sight, const Index left_end, const Index right_end) {
      expansion.look(sight, left_end, right_end);
    });
  }

  /*
   * Calls `f(h, t)` for the edges that the line to `end` crosses whose length is the given one, up
   * to `rounding`. Returns its length; throws if there is none. The point may be a vertex here.
   * Paths start with the label `label`, and none is longer than `bound(v, slack)` at `v`. The slack
   * is relative to the labels that the bound is computed from: labels are rounded, and those of
   * vertices next to the line may exclude it. Nearly always, the smallest slack is enough. `length`
   * is a difference of labels, which may be rounded as well.
   */
  template <typename Bound, typename F>
  double for_each_crossing(const double label,
                           const Bound& bound,
                           const Intrinsic_point& end,
                           const double length,
                           const double rounding,
                           F f) const
  {
    Sight_search line(length, rounding);
    const auto is_found_roughly = [&] {
      constexpr double rough = 1e-9;
      return line.is_found(rough) || line.smallest_difference <= rough * label;
    };
    consider_lines_in_faces(end, line);
    const auto look = [&](const double slack) {
      look_for(
          end, label, [&](const Index v) { return bound(v, slack); },
          [&](const auto& on_sight) { for_each_sight(on_sight); }, line);
    };
    if(!line.is_found())
      look(1e-6);
    for(const double slack : {1e-3, 1., 1e3})
      if(!is_found_roughly())
        look(slack);
    if(!is_found_roughly())
    {
      // an end of the line, or a vertex close to it
      const Intrinsic_point& p = end.is_vertex() ? end : point();
      const Index v = p.is_vertex() ? p.vertex : triangulation().source(p.halfedge);
      throw Untraceable_line(name_of_package() + "the line from or to vertex " +
                             std::to_string(triangulation().index(v)) +
                             " cannot be traced: faces along it are nearly degenerate");
    }
    return line.for_each_crossing(m_tables.steps, f);
  }

  /*
   * Calls `f(h, t)` for the edges that the line from this point crosses, in the opposite order,
   * from the vertex where it arrives. Its length is known, up to `rounding`, and its direction
   * approximately; few vertices are so close to it that both sides of them have to be searched.
   * Returns its length, or a negative number if it is not found: the direction is too inaccurate at
   * edges of length zero, and in faces that are nearly degenerate.
   */
  template <typename F>
  double for_each_crossing_back(const Index vertex,
                                const Arrival& arrival,
                                const double length,
                                const double rounding,
                                F f) const
  {
    Sight_search line(length, rounding);
    if(!point().is_vertex())
      consider_lines_in_faces(Intrinsic_point::at_vertex(vertex), line);
    for(double angle = 4 * Arrival::ROUNDING; angle < 1 && !line.is_found(); angle *= 1000)
      look_back(vertex, arrival, angle, line);
    return line.is_found() ? line.for_each_crossing(m_tables.steps, f) : -1;
  }

  // Calls `f(sight, left_end, right_end)` for the sights through the sides of the faces that
  // contain the point, but those at the border and those that contain it, too.
  template <typename F>
  void for_each_sight(F f) const
  {
    if(point().is_vertex())
      return Vertex_sights(triangulation(), m_tables)
          .for_each(
              point().vertex, Arrival(), [](Index) {}, f);
    for_each_side(
        [&](const Index side, const Face_point&, const Plane_vector start, const Plane_vector end) {
          const Index outside = triangulation().opposite(side);
          if(triangulation().is_border(outside) || point().is_on_edge_of(side, triangulation()))
            return;
          const Sight sight = this->sight(outside, end, start);
          if(sight.left_distance > 0 && sight.right_distance > 0)
            f(sight, triangulation().source(outside), triangulation().target(outside));
        });
  }

  // Calls `f(side, p, start, end)` for the sides of these faces, laid out around the point, and
  // the point as one of the face. Positions are sums of edges, as differences would have no
  // direction where the point is close to a corner.
  template <typename F>
  void for_each_side(F f) const
  {
    point().for_each_face(triangulation(), [&](const Index h) {
      for(const Index side : triangulation().halfedges_of_face(h))
      {
        const Face_layout layout(triangulation(), side);
        for_each_face_point(triangulation(), point(), side, [&](const Face_point& p) {
          f(side, p, layout.vector_to_corner(0, p), layout.vector_to_corner(1, p));
        });
      }
    });
  }

  // Reports the corners of the faces that contain the point. A corner at the same position has no
  // arrival, like a source.
  template <typename OnNode>
  void for_each_corner(OnNode& on_node) const
  {
    for_each_side([&](const Index side, const Face_point& p, const Plane_vector start,
                      const Plane_vector end) {
      const Index opposite = triangulation().next(side); // opposite to the source of `side`
      // computed in the same way as the upper bound
      const double to_corner = distance(triangulation(), p, Face_point::at_source(side));
      on_node(triangulation().source(side), to_corner,
              to_corner > 0 ? Arrival::across(opposite, start, start - end) : Arrival());
    });
  }

private:
  // Considers the lines to `end` through the sights that `for_each_sight` reports.
  template <typename Bound, typename ForEachSight>
  void look_for(const Intrinsic_point& end,
                const double label,
                const Bound& bound,
                ForEachSight for_each_sight,
                Sight_search& line) const
  {
    Tracing_visitor<Bound> visitor{{}, triangulation(), bound, end, line, {}, {}};
    Sight_expansion<Tracing_visitor<Bound>> expansion(m_tables, label, visitor);
    for_each_sight([&](const Sight& sight, const Index left_end, const Index right_end) {
      visitor.first = sight;
      expansion.look(sight, left_end, right_end);
    });
  }

  void look_back(const Index vertex,
                 const Arrival& arrival,
                 const double angle,
                 Sight_search& line) const
  {
    constexpr double slack = 1e-6;
    const double length = line.length * (1 + slack) + line.rounding;
    const auto consider_edge = [&](const Index h) {
      if(triangulation().target(h) == point().vertex)
        consider(triangulation().length(h), line);
    };
    look_for(
        point(), 0, [=](Index) { return length; }, // no part of a line is longer than the whole
        [&](const auto& on_sight) {
          Vertex_sights(triangulation(), m_tables)
              .for_each_back(vertex, arrival, angle, consider_edge, on_sight);
        },
        line);
  }

  // A line that crosses no edge.
  static void consider(const double length, Sight_search& line)
  {
    line.consider(length, [&] { return Sight_line{length}; });
  }

  // The lines to `end` that cross no edge.
  void consider_lines_in_faces(const Intrinsic_point& end, Sight_search& line) const
  {
    const auto consider = [&](const double length) { Lines_of_sight::consider(length, line); };
    const auto consider_corner = [&](const Index v, const double length, const Arrival&) {
      if(v == end.vertex)
        consider(length);
    };
    if(!point().is_vertex() && end.is_vertex())
      for_each_corner(consider_corner);
    for_each_line_to(end, consider); // differs by rounding
  }

  template <typename Bound, typename Points, typename OnNode, typename OnPoint>
  struct Visitor : Sight_visitor_base
  {
    static constexpr bool wants_faces = true;

    double bound(const Index v) const { return bounds(v); }

    void on_vertex(const Index v,
                   const Sight_path& path,
                   const Sight& sight,
                   const Plane_vector apex,
                   const Plane_vector left_edge)
    {
      on_node(v, path.length, sight.arrival(path, apex, left_edge));
    }

    void on_face(const Sight& sight, const Plane_vector apex)
    {
      for_each_position(triangulation, points, sight.halfedge, {sight.left, sight.right, apex},
                        [&](const std::size_t i, const Plane_vector position, const auto... t) {
                          const Sight_path path = sight.path_to(position, length(position));
                          if(path.length < infinity)
                            on_point(i, path.length, t...);
                        });
    }

    const Intrinsic_triangulation& triangulation;
    const Bound& bounds;
    const Points& points;
    OnNode& on_node;
    OnPoint& on_point;
  };

protected:
  static Sight sight(const Index halfedge, Plane_vector left, Plane_vector right)
  {
    if(!(cross(right, left) > 0)) // the face has no area, and the point may be between its corners
    {
      const double sign = dot(right, left) < 0 ? -1 : 1;
      left = {sign * length(left), 0};
      right = {length(right), 0};
    }
    return {halfedge, null_index, 0, 0, left, right, right - left, length(left), length(right)};
  }

  const Sight_tables& m_tables;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_LINES_OF_SIGHT_H
