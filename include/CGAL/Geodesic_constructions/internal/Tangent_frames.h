// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_TANGENT_FRAMES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_TANGENT_FRAMES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL::Approximate_geodesics::internal {

// A direction in the face to the left of a halfedge: the angle from the halfedge counterclockwise.
struct Direction
{
  Index halfedge = null_index;
  double angle = 0;
};

// The faces around a vertex, counterclockwise from the axis.
struct Fan
{
  static constexpr double ROUNDING = 1e-10; // of directions at the border

  Index axis = null_index; // the first halfedge; null_index if the vertex is isolated
  double angle = 0;        // the sum of the angles of the faces
  int number_of_borders = 0;

  // Angles in the frame of the vertex are angles on the surface times this number.
  double scale() const
  {
    const double full = 2 * straight_angle;
    return angle > (number_of_borders > 0 ? full : 0) ? full / angle : 1;
  }

  /*
   * The direction, as an angle on the surface, in which a straight line goes on that comes from the
   * direction `back`: inside, the angles on both sides are the same. At the border, the larger one
   * is pi, if that is possible: so lines go on along a straight border.
   */
  std::optional<double> straight_on(const double back) const
  {
    if(number_of_borders == 0)
      return back + angle / 2;
    const double left = angle - back; // to the border
    if(number_of_borders > 1 || !((std::max)(left, back) >= straight_angle - ROUNDING))
      return std::nullopt;
    return left >= back ? (std::min)(back + straight_angle, angle)
                        : (std::max)(back - straight_angle, 0.);
  }
};

/*
 * The frames at points of the surface that `Tangent_vector` describes: for a vertex, angles from
 * an axis, which are scaled; for other points, angles from their halfedge.
 */
class Tangent_frames
{
public:
  explicit Tangent_frames(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  Fan fan(const Index v) const
  {
    const Index first = m_triangulation.first_halfedge(v);
    Fan result;
    for(Index h = first; h < m_triangulation.beyond_halfedge(v); ++h)
      if(!m_triangulation.is_border(h))
        result.angle += corner(h);
      else if(result.number_of_borders++ == 0)
        result.axis = m_triangulation.counterclockwise(v, h);
    if(result.number_of_borders == 0 && m_triangulation.degree(v) > 0)
      result.axis = first;
    return result;
  }

  // The angle on the surface from the axis to a halfedge that starts at the vertex.
  double angle_from_axis(const Fan& fan, const Index v, const Index halfedge) const
  {
    double result = 0;
    for(Index h = fan.axis; h != halfedge; h = m_triangulation.counterclockwise(v, h))
      result += m_triangulation.is_border(h) ? 0 : corner(h);
    return result;
  }

  // The angle in the frame of `p` of a direction: from a vertex; or, at another point, in a face
  // that contains it.
  double angle(const Intrinsic_point& p, const Direction& direction) const
  {
    if(p.is_vertex())
    {
      const Fan f = fan(p.vertex);
      return f.scale() * (angle_from_axis(f, p.vertex, direction.halfedge) + direction.angle);
    }
    if(p.halfedge == direction.halfedge)
      return direction.angle;
    if(!m_triangulation.is_border(p.halfedge))
      for(const Index h : m_triangulation.halfedges_of_face(p.halfedge))
        if(h == direction.halfedge)
          return angle_between(p.halfedge, h) + direction.angle;
    return straight_angle + direction.angle +
           angle_between(m_triangulation.opposite(p.halfedge), direction.halfedge);
  }

  // The inverse of that; none if the direction points out of the surface. It is along a border
  // halfedge of a vertex if there is no face to its left.
  std::optional<Direction> direction(const Intrinsic_point& p, const double angle) const
  {
    if(p.is_vertex())
    {
      const Fan f = fan(p.vertex);
      return direction_at_vertex(f, p.vertex, angle / f.scale());
    }
    const double rest = std::remainder(angle, 2 * straight_angle);
    const bool is_along = p.is_on_edge() && (std::abs(rest) < Fan::ROUNDING ||
                                             std::abs(rest) > straight_angle - Fan::ROUNDING);
    const Index opposite = m_triangulation.opposite(p.halfedge);
    const bool has_left = !m_triangulation.is_border(p.halfedge),
               has_right = !m_triangulation.is_border(opposite);
    if(p.is_in_face() || (has_left && (rest >= 0 || (is_along && !has_right))))
      return Direction{p.halfedge, is_along && rest < 0 ? snapped(rest) : rest};
    if(has_right && (rest <= 0 || is_along))
      return Direction{opposite, rest > 0 ? snapped(rest - straight_angle) : rest + straight_angle};
    return std::nullopt;
  }

  // Likewise for an angle on the surface, from the axis of a vertex.
  std::optional<Direction>
  direction_at_vertex(const Fan& fan, const Index v, const double angle) const
  {
    if(fan.axis == null_index)
      return std::nullopt;
    const double full = fan.number_of_borders > 0 ? 2 * straight_angle / fan.scale() : fan.angle;
    double rest = full > 0 ? angle - full * std::floor(angle / full) : 0;
    if(fan.number_of_borders > 0 && rest > full - Fan::ROUNDING && full > fan.angle)
      rest = 0;
    Index h = fan.axis;
    for(Index n = m_triangulation.degree(v); n > 0; --n)
    {
      if(!m_triangulation.is_border(h))
      {
        const double c = corner(h);
        if(rest <= c)
          return Direction{h, rest};
        rest -= c;
      }
      else if(n == 1 && rest <= Fan::ROUNDING)
        return Direction{h, 0};
      h = m_triangulation.counterclockwise(v, h);
    }
    if(fan.number_of_borders > 0)
      return std::nullopt;
    return Direction{fan.axis, 0}; // rounding
  }

  // Of an angle that points out of the surface at a border vertex: from the halfedge where the gap
  // between the faces begins.
  std::optional<Direction> direction_beyond_border(const Index v, const double angle) const
  {
    const Fan f = fan(v);
    const double full = 2 * straight_angle, on_surface = angle / f.scale();
    for(Index h = m_triangulation.first_halfedge(v); h < m_triangulation.beyond_halfedge(v); ++h)
      if(m_triangulation.is_border(h) && m_triangulation.counterclockwise(v, h) == f.axis)
        return Direction{h, on_surface - full * std::floor(on_surface / full) - f.angle};
    return std::nullopt;
  }

  // The angle of the face to the left of a halfedge, at its source.
  double corner(const Index h) const { return angle_of(corner_angle(m_triangulation, h)); }

  // The angle from a halfedge to another one of the same face.
  double angle_between(const Index from, const Index to) const
  {
    double result = 0;
    for(Index h = from; h != to; h = m_triangulation.next(h))
      result += straight_angle - corner(m_triangulation.next(h));
    return result;
  }

  // The direction at a corner of a face, whose angle may be wrong by rounding, or by full turns.
  Direction direction_in_corner(const Index h, const double angle) const
  {
    const double c = corner(h), rest = std::remainder(angle, 2 * straight_angle);
    const bool is_beyond = rest > c || rest < -straight_angle / 2;
    return {h, is_beyond ? c : (std::max)(0., rest)};
  }

  // The angle in the frame of `p` of the straight line to `q`; none if no face and no edge contains
  // both.
  std::optional<double> angle_toward(const Intrinsic_point& p, const Intrinsic_point& q) const
  {
    const Segment segment = shortest_segment(m_triangulation, p, q);
    if(!(segment.length < infinity))
      return std::nullopt;
    const Index h = segment.from.halfedge;
    if(m_triangulation.is_border(h)) // between vertices
      return angle(p, {h, 0});
    const Face_layout face(m_triangulation, h);
    const Face_point to = segment.to.seen_from(m_triangulation, h);
    Plane_vector way{0, 0};
    for(std::size_t i = 0; i < 3; ++i)
      way = way + to.weight[i] * face.vector_to_corner(i, segment.from);
    return angle_in_face(p, segment.from, face, way);
  }

  // The angle in the frame of `p` of a way into a face that contains `p`. The face is laid out from
  // the halfedge of `in_face`, which is the same point.
  double angle_in_face(const Intrinsic_point& p,
                       const Face_point& in_face,
                       const Face_layout& face,
                       const Plane_vector way) const
  {
    Index h = in_face.halfedge;
    const double from_halfedge = angle_of(way) - angle_of(face.edge(0, 1));
    if(!p.is_vertex())
      return angle(p, {h, from_halfedge});
    for(std::size_t i = 0; in_face.weight[i] != 1; ++i)
      h = m_triangulation.next(h);
    return angle(p, direction_in_corner(h, from_halfedge - angle_between(in_face.halfedge, h)));
  }

  // How much the angle of a vector grows by parallel transport from `p` to `q`, in their frames;
  // none if no face and no edge contains both. At vertices, angles to the path are kept after they
  // have been scaled, so that straight walks stay parallel to themselves.
  std::optional<double> turn(const Intrinsic_point& p, const Intrinsic_point& q) const
  {
    if(p.is_same(q, m_triangulation))
      return p.halfedge == q.halfedge ? 0 : straight_angle; // from one side of an edge
    if(p.is_vertex() || q.is_vertex())
    {
      const std::optional<double> there = angle_toward(p, q), back = angle_toward(q, p);
      return there ? std::optional(*back + straight_angle - *there) : std::nullopt;
    }
    const Segment segment = shortest_segment(m_triangulation, p, q);
    if(!(segment.length < infinity))
      return std::nullopt;
    const Direction any{segment.from.halfedge, 0};
    return angle(q, any) - angle(p, any);
  }

private:
  // An angle next to 0 or pi becomes that.
  static double snapped(const double angle)
  {
    return std::abs(angle) < straight_angle / 2 ? 0 : straight_angle;
  }

  const Intrinsic_triangulation& m_triangulation;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_TANGENT_FRAMES_H
