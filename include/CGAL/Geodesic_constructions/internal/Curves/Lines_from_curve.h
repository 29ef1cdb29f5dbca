// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_LINES_FROM_CURVE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_LINES_FROM_CURVE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Lines_of_sight.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Strip_expansion.h>

#include <boost/container/static_vector.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Whether a run finds lines from its labels by sights, as that of a saddle vertex graph does.
template <typename Run>
constexpr bool follows_sights =
    is_valid<const Run&, const Sight_tables&>([](auto& run) -> decltype(run.tables()) {}) &&
    is_valid<const Run&, double>([](auto& run) -> decltype(run.bound(0)) {});

// Where the angle between two segments of a curve is no larger than pi, up to rounding, no shortest
// path to the curve ends at their common point, unless it also ends at a right angle.
constexpr bool is_wider_than_straight(const double angle) { return angle > straight_angle + 1e-11; }

/*
 * The shortest paths that end at a vertex of a curve, which is a vertex of the mesh: those that
 * make at least a right angle with the curve's segments before and after it.
 */
class Sectors_at_vertex
{
  using Boundary = Bend_sectors::Boundary;

public:
  Sectors_at_vertex(const Intrinsic_triangulation& triangulation,
                    const Sight_tables& tables,
                    const Index v)
    : m_triangulation(triangulation), m_tables(tables), m_vertex(v)
  {
  }

  // Calls `on_edge(h)` and `on_sight(sight, left_end, right_end)` as `Vertex_sights` does, for the
  // paths on the left of a curve that comes from `before` and goes on to `after`.
  template <typename OnEdge, typename OnSight>
  void for_each_left(const Intrinsic_point& before,
                     const Intrinsic_point& after,
                     OnEdge on_edge,
                     OnSight on_sight) const
  {
    const Boundary start = direction_to(after), end = direction_to(before);
    const Vertex_sights sights(m_triangulation, m_tables);
    const double angle = angle_between(start, end);
    if(!is_wider_than_straight(angle))
      return;
    const Boundary right = quarter_turn_left(start), left = quarter_turn_right(end);
    if(angle < infinity)
      return sights.open_sector(m_vertex, right, left, on_edge, on_sight);
    if(right.exists())
      sights.open_sector(m_vertex, right, {}, on_edge, on_sight);
    if(left.exists())
      sights.open_sector(m_vertex, {sights.first_after_border(m_vertex), {1, 0}}, left, on_edge,
                         on_sight);
  }

private:
  bool has_face(const Index h) const { return m_tables.steps[h].has_face(); }
  Plane_vector corner(const Index h) const { return unit_corner(m_tables.steps[h]); }

  Boundary direction_to(const Intrinsic_point& p) const
  {
    const Segment line = shortest_segment(m_triangulation, Intrinsic_point::at_vertex(m_vertex), p);
    const Index h = line.from.halfedge;
    if(m_triangulation.is_border(h))
      return {h, {1, 0}};
    const Plane_vector way =
        line.to.seen_from(m_triangulation, h).position(m_triangulation, {0, 0}, {1, 0});
    const double l = length(way);
    return {h, l > 0 && way.y > 0 ? 1 / l * way : Plane_vector{way.x < 0 ? -1. : 1., 0}};
  }

  // Counterclockwise; infinity if there is a border between.
  double angle_between(const Boundary& start, const Boundary& end) const
  {
    if(start.halfedge == end.halfedge && cross(start.direction, end.direction) > 0)
      return angle_of(end.direction) - angle_of(start.direction);
    double result = angle_of(end.direction) - angle_of(start.direction);
    Index h = start.halfedge;
    do
    {
      if(!has_face(h))
        return infinity;
      result += angle_of(corner(h));
      h = m_triangulation.counterclockwise(m_vertex, h);
    } while(h != end.halfedge);
    return result;
  }

  // Does not exist beyond a border.
  Boundary quarter_turn_left(const Boundary& b) const
  {
    Index h = b.halfedge;
    Plane_vector direction = turned_left(b.direction, {0, 1});
    for(Index n = m_triangulation.degree(m_vertex); n > 0 && has_face(h); --n)
    {
      if(!(cross(corner(h), direction) > 0))
        return {h, direction};
      direction = turned_right(direction, corner(h));
      h = m_triangulation.counterclockwise(m_vertex, h);
    }
    return {};
  }

  Boundary quarter_turn_right(const Boundary& b) const
  {
    Index h = b.halfedge;
    Plane_vector direction = turned_right(b.direction, {0, 1});
    for(Index n = m_triangulation.degree(m_vertex); n > 0 && direction.y < 0; --n)
    {
      h = m_triangulation.clockwise(m_vertex, h);
      if(!has_face(h))
        return {};
      direction = turned_left(direction, corner(h));
    }
    return {h, direction};
  }

  const Intrinsic_triangulation& m_triangulation;
  const Sight_tables& m_tables;
  const Index m_vertex;
};

/*
 * The same for a point on an edge or in a face.
 */
class Sectors_at_point : public Lines_of_sight
{
public:
  Sectors_at_point(const Intrinsic_triangulation& triangulation,
                   const Sight_tables& tables,
                   const Intrinsic_point& point)
    : Lines_of_sight(triangulation, tables, point)
  {
    point.for_each_face(triangulation, [&](const Index h) {
      Plane_vector x_axis{1, 0};
      const Face_layout layout(triangulation, h);
      if(point.is_on_edge())
        x_axis = (h == point.halfedge ? 1 : -1) / layout_length(layout) * layout.edge(0, 1);
      m_faces.push_back({h, layout, x_axis});
    });
  }

  using Lines_of_sight::for_each_corner;

  template <typename OnSight>
  void
  for_each_left(const Intrinsic_point& before, const Intrinsic_point& after, OnSight on_sight) const
  {
    const Plane_vector start = direction_to(after), end = direction_to(before);
    double angle = angle_of(turned_right(end, start));
    if(!(angle > 0))
      angle += 2 * straight_angle;
    if(!is_wider_than_straight(angle))
      return;
    const Sector sector{turned_left(start, {0, 1}), turned_right(end, {0, 1})};
    for(const Face& face : m_faces)
      for(std::size_t i = 0; i < 3; ++i)
        look_through(face, i, sector, on_sight);
  }

private:
  struct Face
  {
    Index halfedge;
    Face_layout layout;
    Plane_vector x_axis; // turned so that the edge of the point is on the x axis

    Plane_vector vector_to_corner(const std::size_t i, const Face_point& p) const
    {
      return turned_right(layout.vector_to_corner(i, p), x_axis);
    }
  };

  // Of an angle of at most pi.
  struct Sector
  {
    Plane_vector right, left;

    bool contains(const Plane_vector d) const
    {
      return cross(right, d) >= 0 && cross(d, left) >= 0;
    }
  };

  static double layout_length(const Face_layout& layout)
  {
    const double l = length(layout.edge(0, 1));
    return l > 0 ? l : 1;
  }

  Plane_vector direction_to(const Intrinsic_point& end) const
  {
    Plane_vector result{0, 0};
    double smallest = infinity;
    for(const Face& face : m_faces)
      for_each_face_point(triangulation(), point(), face.halfedge, [&](const Face_point& p) {
        for_each_face_point(triangulation(), end, face.halfedge, [&](const Face_point& q) {
          const Face_point from = p.seen_from(triangulation(), face.halfedge),
                           to = q.seen_from(triangulation(), face.halfedge);
          std::size_t c = 0;
          const auto step = steps_between(from, to, c);
          const std::size_t second = (c + 1) % 3, third = (c + 2) % 3;
          const Plane_vector way =
              step[second] * face.layout.edge(c, second) + step[third] * face.layout.edge(c, third);
          if(const double l = length(way); l > 0 && l < smallest)
          {
            smallest = l;
            result = 1 / l * turned_right(way, face.x_axis);
          }
        });
      });
    return result;
  }

  template <typename OnSight>
  void look_through(const Face& face,
                    const std::size_t i,
                    const Sector& sector,
                    const OnSight& on_sight) const
  {
    const Index side = face.layout.halfedge(i), outside = triangulation().opposite(side);
    if(triangulation().is_border(outside) || point().is_on_edge_of(side, triangulation()))
      return;
    for_each_face_point(triangulation(), point(), side, [&](const Face_point& p) {
      const Plane_vector right = face.vector_to_corner(i, p),
                         left = face.vector_to_corner((i + 1) % 3, p);
      Sight sight = this->sight(outside, left, right);
      if(!(sight.left_distance > 0 && sight.right_distance > 0))
        return;
      const bool has_angle = cross(right, left) > 0;
      if(has_angle && !narrow(sight, left, right, sector))
        return;
      on_sight(sight, triangulation().source(outside), triangulation().target(outside));
    });
  }

  // Returns whether anything is left.
  static bool
  narrow(Sight& sight, const Plane_vector left, const Plane_vector right, const Sector& sector)
  {
    const Sector whole{right, left};
    const bool has_right = sector.contains(right), has_left = sector.contains(left);
    if(!has_right && !whole.contains(sector.right))
      return false;
    if(!has_left && !whole.contains(sector.left))
      return false;
    if(!has_right)
      sight.right_ray = Sight_ray::boundary(sector.right, sight.right_distance);
    if(!has_left)
      sight.left_ray = Sight_ray::boundary(sector.left, sight.left_distance);
    return true;
  }

  boost::container::static_vector<Face, 2> m_faces;
};

/*
 * The straight lines from a polyline where a search starts: from its segments at right angles, and
 * from its vertices.
 */
class Lines_from_curve
{
public:
  Lines_from_curve(const Intrinsic_triangulation& triangulation, const Sight_tables& tables)
    : m_triangulation(triangulation), m_tables(tables)
  {
  }

  // Calls `f(v, length, arrival, foot)` for the lines from a curve to vertices, for paths that
  // start with the label `label` and are no longer than `bound(v)`.
  template <typename Bound, typename F>
  void
  for_each_line(const Intrinsic_curve& curve, const double label, const Bound& bound, F f) const
  {
    for(const std::vector<Intrinsic_point>& polyline : curve.polylines)
      for_each_line(polyline, label, bound, f);
    for(const Index h : curve.faces)
      for(const Index side : m_triangulation.halfedges_of_face(h))
        f(m_triangulation.target(side), 0., Arrival::on_curve(side),
          Intrinsic_point::at_vertex(m_triangulation.target(side)));
  }

  // Calls `f(v, length, arrival, foot)` for the lines from a polyline to vertices, for paths that
  // start with the label `label` and are no longer than `bound(v)`.
  template <typename Bound, typename F>
  void for_each_line(const std::vector<Intrinsic_point>& polyline,
                     const double label,
                     const Bound& bound,
                     F f) const
  {
    const std::vector<Intrinsic_point> points = without_repetitions(polyline);
    if(points.size() == 1)
      return look_around(points[0], label, bound, f);
    const std::size_t last = points.size() - 1;
    const bool is_closed = points[0].is_same(points[last], m_triangulation);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      check_for_interruption();
      if(i < last)
        look_beside(points[i], points[i + 1], label, bound, f);
      if(i == last && is_closed)
        return;
      const Intrinsic_point* const before = i > 0       ? &points[i - 1]
                                            : is_closed ? &points[last - 1]
                                                        : nullptr;
      const Intrinsic_point* const after = i < last ? &points[i + 1] : nullptr;
      look_from(points[i], before, after, label, bound, f);
    }
  }

private:
  template <typename Bound, typename F>
  struct Sight_visitor : Sight_visitor_base
  {
    double bound(const Index v) const { return bounds(v); }

    void on_vertex(const Index v,
                   const Sight_path& path,
                   const Sight& sight,
                   const Plane_vector apex,
                   const Plane_vector left_edge)
    {
      f(v, path.length, sight.arrival(path, apex, left_edge), start);
    }

    const Bound& bounds;
    F& f;
    const Intrinsic_point& start;
  };

  template <typename Bound, typename F>
  struct Strip_visitor
  {
    double bound(const Index v) const { return bounds(v); }

    bool ends(const Strip& /* strip */) const { return false; }

    void on_vertex(const Index v,
                   const double length,
                   const double x,
                   const Strip& strip,
                   const Plane_vector apex,
                   const Plane_vector left_edge)
    {
      f(v, length, arrival(x, strip, apex, left_edge), segment.point(triangulation, x / width));
    }

    // As `Sight::arrival()`.
    Arrival arrival(const double x,
                    const Strip& strip,
                    const Plane_vector apex,
                    const Plane_vector left_edge) const
    {
      constexpr double smallest_part = 1e-9;
      const Plane_vector way{apex.x - x, apex.y};
      const double shortest =
          smallest_part * (std::max)({internal::length(strip.left), internal::length(strip.right),
                                      internal::length(apex)});
      if(!(std::abs(cross(strip.edge, left_edge)) > shortest * internal::length(strip.edge) &&
           internal::length(way) > shortest))
        return Arrival::in_unknown_direction(strip.halfedge);
      return Arrival::across(strip.halfedge, way, left_edge);
    }

    const Intrinsic_triangulation& triangulation;
    const Bound& bounds;
    F& f;
    const Curve_segment& segment;
    double width;
  };

  std::vector<Intrinsic_point> without_repetitions(const std::vector<Intrinsic_point>& points) const
  {
    std::vector<Intrinsic_point> result;
    for(const Intrinsic_point& p : points)
      if(result.empty() || !p.is_same(result.back(), m_triangulation))
        result.push_back(p);
    return result;
  }

  // From a single point.
  template <typename Bound, typename F>
  void look_around(const Intrinsic_point& p, const double label, const Bound& bound, F& f) const
  {
    if(p.is_vertex())
      return f(p.vertex, 0., Arrival(), p);
    const Lines_of_sight lines(m_triangulation, m_tables, p);
    const auto on_corner = [&](const Index v, const double length, const Arrival& arrival) {
      f(v, length, arrival, p);
    };
    lines.for_each_corner(on_corner);
    Sight_visitor<Bound, F> visitor{{}, bound, f, p};
    Sight_expansion<Sight_visitor<Bound, F>> expansion(m_tables, label, visitor);
    lines.for_each_sight([&](const Sight& sight, const Index left_end, const Index right_end) {
      expansion.look(sight, left_end, right_end);
    });
  }

  // From a segment, on both sides.
  template <typename Bound, typename F>
  void look_beside(const Intrinsic_point& p,
                   const Intrinsic_point& q,
                   const double label,
                   const Bound& bound,
                   F& f) const
  {
    for_each_segment(m_triangulation, p, q, [&](const Curve_segment& segment) {
      report_corners(segment, f);
      for(const Curve_segment& s : {segment, Curve_segment{segment.to, segment.from}})
      {
        const Segment_layout layout(m_triangulation, s);
        Strip_visitor<Bound, F> visitor{m_triangulation, bound, f, s, layout.length()};
        if(layout.length() > 0)
          Strip_expansion<Face_steps, Strip_visitor<Bound, F>>(m_triangulation, m_tables.steps,
                                                               label, visitor)
              .look(layout, is_along_halfedge(s.from, s.to));
      }
    });
  }

  // The lines to the corners of the face of a segment.
  template <typename F>
  void report_corners(const Curve_segment& segment, F& f) const
  {
    const Segment_layout layout(m_triangulation, segment);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Index side = layout.halfedge(i), v = layout.vertex(i);
      const double t = layout.nearest_part(layout.corner(i));
      const Intrinsic_point foot = segment.point(m_triangulation, t);
      const double length =
          distance(m_triangulation, segment.face_point(t), Face_point::at_source(side));
      const Plane_vector way = layout.corner(i) - Plane_vector{t * layout.length(), 0};
      const auto arrival = [&] {
        if(length > 0)
          return Arrival::across(m_triangulation.next(side), way, layout.edge((i + 1) % 3, i));
        const bool is_vertex_of_curve = foot.vertex == v; // whose lines `look_from()` finds
        return is_vertex_of_curve && has_accurate_angles(m_triangulation, foot)
                   ? Arrival::on_curve(side)
                   : Arrival();
      }();
      f(v, length, arrival, foot);
    }
  }

  // From a vertex of the curve. It is an end of the curve if there is none before or after it.
  template <typename Bound, typename F>
  void look_from(const Intrinsic_point& p,
                 const Intrinsic_point* const before,
                 const Intrinsic_point* const after,
                 const double label,
                 const Bound& bound,
                 F& f) const
  {
    if(!has_accurate_angles(m_triangulation, p))
      return look_around(p, label, bound, f);
    Sight_visitor<Bound, F> visitor{{}, bound, f, p};
    Sight_expansion<Sight_visitor<Bound, F>> expansion(m_tables, label, visitor);
    const auto on_sight = [&](const Sight& sight, const Index left_end, const Index right_end) {
      expansion.look(sight, left_end, right_end);
    };
    const auto look = [&](const auto& look_left) {
      look_left(before ? *before : *after, after ? *after : *before);
      if(before && after)
        look_left(*after, *before);
    };
    if(p.is_vertex())
    {
      const Sectors_at_vertex sectors(m_triangulation, m_tables, p.vertex);
      const auto on_edge = [&](const Index h) {
        f(m_triangulation.target(h), m_triangulation.length(h), Arrival::along(h), p);
      };
      return look([&](const Intrinsic_point& from, const Intrinsic_point& to) {
        sectors.for_each_left(from, to, on_edge, on_sight);
      });
    }
    const Sectors_at_point sectors(m_triangulation, m_tables, p);
    const auto on_corner = [&](const Index v, const double length, const Arrival& arrival) {
      f(v, length, arrival, p);
    };
    sectors.for_each_corner(on_corner);
    look([&](const Intrinsic_point& from, const Intrinsic_point& to) {
      sectors.for_each_left(from, to, on_sight);
    });
  }

  const Intrinsic_triangulation& m_triangulation;
  const Sight_tables& m_tables;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_LINES_FROM_CURVE_H
