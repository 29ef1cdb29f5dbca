// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_STRAIGHT_WALK_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_STRAIGHT_WALK_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Geodesic_constructions/internal/Tangent_frames.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The point of the face to the left of `h` with the given weights, of which at most one is zero up
// to rounding.
inline Intrinsic_point point_in_face(const Intrinsic_triangulation& triangulation,
                                     const Index h,
                                     const std::array<double, 3>& weight)
{
  constexpr double rounding = 1e-14;
  if(weight[2] < rounding)
    return Intrinsic_point::on_edge(h, weight[1]);
  const Index second = triangulation.next(h);
  if(weight[0] < rounding)
    return Intrinsic_point::on_edge(second, weight[2]);
  if(weight[1] < rounding)
    return Intrinsic_point::on_edge(triangulation.next(second), weight[0]);
  return Intrinsic_point::in_face(h, weight[1], weight[2]);
}

/*
 * A walk straight ahead (Polthier and Schmies, Straightest geodesics on polyhedral surfaces):
 * straight across faces and edges, and through vertices as `Fan::straight_on()` says. Lengths are
 * in units of the triangulation.
 *
 * A walk that passes very close to a vertex goes through it. So a line crosses an edge of length
 * zero only at its ends; there, it goes on as if the edge were very short.
 */
class Straight_walk
{
public:
  // Walks from a point, in a direction that is an angle in its frame, until the length is used up,
  // or the border is met, or as many faces have been visited.
  Straight_walk(const Intrinsic_triangulation& triangulation,
                const Intrinsic_point& start,
                const double angle,
                const double length,
                const std::size_t largest_number_of_faces)
    : m_triangulation(triangulation),
      m_frames(triangulation),
      m_points{start},
      m_length(length),
      m_angle(angle)
  {
    set_out(start, m_frames.direction(start, angle));
    while(rest() > 0 && m_is_on_way && m_number_of_faces < largest_number_of_faces)
    {
      check_for_interruption_at(m_number_of_faces++);
      if(m_triangulation.is_border(m_at.halfedge))
        follow_edge();
      else
        cross_face();
    }
  }

  const std::vector<Intrinsic_point>& points() const { return m_points; }

  // The length walked.
  double length() const { return m_walked; }

  // The direction at the end, as an angle in its frame.
  double angle() const { return m_angle; }

  // Whether the walk has met the border and could not go on.
  bool meets_border() const { return rest() > 0 && !m_is_on_way; }

private:
  static constexpr double NEAR_VERTEX = 1e-12; // in lengths of the edge
  static constexpr double ROUNDING = 1e-14;

  // ----- where the walk goes on

  void set_out(const Intrinsic_point& p, const std::optional<Direction>& direction)
  {
    m_is_on_way = direction.has_value();
    if(!m_is_on_way)
      return;
    m_at = p.is_vertex() ? Face_point::at_source(direction->halfedge) : Face_point::in_face(p);
    if(m_at.halfedge != direction->halfedge)
      m_at = m_at.seen_from_opposite(direction->halfedge);
    m_way = {std::cos(direction->angle), std::sin(direction->angle)};
  }

  // Goes on from a vertex, at an angle on the surface.
  void set_out_from_vertex(const Fan& fan, const Index v, const double angle)
  {
    const Intrinsic_point p = Intrinsic_point::at_vertex(v);
    append(p);
    m_angle = fan.scale() * angle;
    set_out(p, m_frames.direction_at_vertex(fan, v, angle));
  }

  Fan fan_of(const Index v)
  {
    m_number_of_faces += m_triangulation.degree(v);
    return m_frames.fan(v);
  }

  // `back` is the direction that the walk comes from.
  void arrive_at_vertex(const Index v, const Direction& back)
  {
    const Fan fan = fan_of(v);
    const double angle = m_frames.angle_from_axis(fan, v, back.halfedge) + back.angle;
    const std::optional<double> ahead = fan.straight_on(angle);
    set_out_from_vertex(fan, v, ahead.value_or(angle + straight_angle));
    m_is_on_way = m_is_on_way && ahead.has_value();
  }

  void arrive_at_corner(const Face_layout& face, const std::size_t i, const Plane_vector way)
  {
    const Plane_vector right = face.edge(i, (i + 1) % 3), left = face.edge(i, (i + 2) % 3);
    const double from_x_axis = internal::length(right) > 0
                                   ? angle_of(right)
                                   : angle_of(left) - m_frames.corner(face.halfedge(i));
    arrive_at_vertex(face.vertex(i), m_frames.direction_in_corner(
                                         face.halfedge(i), angle_of(-1. * way) - from_x_axis));
  }

  // `way` is the direction where `h`, which is crossed from the left, is the x axis.
  void arrive_at_edge(const Index h, const double t, const Plane_vector way)
  {
    append(Intrinsic_point::on_edge(h, t));
    m_angle = angle_of(way);
    m_at = Face_point::on_edge(m_triangulation.opposite(h), 1 - t);
    m_way = {-way.x, (std::max)(0., -way.y)};
    m_is_on_way = !m_triangulation.is_border(m_at.halfedge);
  }

  void append(const Intrinsic_point& p)
  {
    if(!p.is_same(m_points.back(), m_triangulation))
      m_points.push_back(p);
  }

  double rest() const { return m_length - m_walked; }

  // Returns how far the walk comes on a straight line of this length, as a part of it.
  double advance(const double distance)
  {
    const double before = rest();
    m_walked += distance;
    if(rest() > ROUNDING * m_length)
      return 1;
    m_walked = m_length;
    return before < distance * (1 - ROUNDING) ? before / distance : 1;
  }

  // ----- one face

  // From a vertex along a halfedge that has no face to its left.
  void follow_edge()
  {
    const Index h = m_at.halfedge;
    const double part = advance(m_triangulation.length(h));
    if(part == 1)
      return arrive_at_vertex(m_triangulation.target(h), {m_triangulation.opposite(h), 0});
    m_angle = 0;
    append(Intrinsic_point::on_edge(h, part));
  }

  void cross_face()
  {
    const Face_layout face(m_triangulation, m_at.halfedge);
    if(m_at.is_vertex() && pass_edge_of_length_zero(face))
      return;
    const Plane_vector way = turned_left(m_way, unit(face.edge(0, 1)));
    const std::array<Plane_vector, 3> corners{face.vector_to_corner(0, m_at),
                                              face.vector_to_corner(1, m_at),
                                              face.vector_to_corner(2, m_at)};
    const std::size_t side = side_ahead(corners, way), next = (side + 1) % 3;
    const Plane_vector edge = face.edge(side, next);
    const double t =
        part_of_side(corners[side], corners[next], way, NEAR_VERTEX * internal::length(edge));
    const double part = advance(
        internal::length(t < 0.5 ? corners[side] + t * edge : corners[next] - (1 - t) * edge));
    if(part < 1)
      end_in_face(face, side, t, part);
    else if(t == 0 || t == 1)
      arrive_at_corner(face, t == 0 ? side : next, way);
    else
      arrive_at_edge(face.halfedge(side), t, turned_right(way, unit(edge)));
  }

  // The side with one end to the right of the way, and the other one to the left.
  std::size_t side_ahead(const std::array<Plane_vector, 3>& corners, const Plane_vector way) const
  {
    if(m_at.is_vertex())
      return 1;
    if(m_at.is_on_edge())
      return cross(way, corners[2]) > 0 ? 1 : 2;
    std::array<double, 3> inside{};
    for(std::size_t i = 0; i < 3; ++i)
      inside[i] = (std::min)(cross(corners[i], way), cross(way, corners[(i + 1) % 3]));
    return static_cast<std::size_t>(std::max_element(inside.begin(), inside.end()) -
                                    inside.begin());
  }

  // Whether the way passes a corner so closely that it goes through. It need not pass close to the
  // start of the way, where rounding decides what is ahead.
  static bool passes(const Plane_vector corner, const Plane_vector way, const double tolerance)
  {
    constexpr double ahead = 1e-6; // an angle
    const double offset = std::abs(cross(corner, way));
    return offset <= tolerance && offset <= ahead * dot(corner, way);
  }

  // Where the way crosses the line from `right` to `left`: 0 or 1 if it goes through an end, also
  // where it is almost parallel to an edge of that, and crosses this far from the end.
  static double part_of_side(const Plane_vector right,
                             const Plane_vector left,
                             const Plane_vector way,
                             const double tolerance)
  {
    const double r = (std::max)(0., cross(right, way)), l = (std::max)(0., cross(way, left));
    const bool is_right = passes(right, way, tolerance), is_left = passes(left, way, tolerance);
    if(is_right != is_left)
      return is_left ? 1 : 0;
    if(!is_right && r + l > 0)
      return (std::clamp)(r / (r + l), ROUNDING * ROUNDING, 1 - ROUNDING);
    const double to_right = dot(right, way), to_left = dot(left, way);
    return to_left >= 0 && (to_right < 0 || to_left < to_right) ? 1 : 0; // the nearer end ahead
  }

  // Ends at a part of the way to a point of a side.
  void
  end_in_face(const Face_layout& face, const std::size_t side, const double t, const double part)
  {
    std::array<double, 3> weight = m_at.weight, end{0, 0, 0};
    end[side] = 1 - t;
    end[(side + 1) % 3] = t;
    for(std::size_t i = 0; i < 3; ++i)
      weight[i] += part * (end[i] - weight[i]);
    for(std::size_t i = 0; i < 3; ++i)
      if(weight[i] > 1 - NEAR_VERTEX)
        return arrive_at_corner(face, i, turned_left(m_way, unit(face.edge(0, 1))));
    const Index h = m_at.halfedge;
    const Intrinsic_point p = point_in_face(m_triangulation, h, weight);
    append(p);
    m_angle = m_frames.angle(p, {h, angle_of(m_way)});
  }

  // From one end to the other, if the edge is a side of the face ahead that has the vertex.
  bool pass_edge_of_length_zero(const Face_layout& face)
  {
    const Index opposite_side = face.halfedge(1);
    const double angle = angle_of(m_way);
    if(!(internal::length(face.edge(0, 1)) > 0)) // the way is parallel to the opposite side
    {
      const Fan fan = fan_of(face.vertex(1));
      set_out_from_vertex(fan, face.vertex(1),
                          m_frames.angle_from_axis(fan, face.vertex(1), opposite_side) + angle -
                              m_frames.corner(face.halfedge(0)));
      return true;
    }
    if(internal::length(face.edge(0, 2)) > 0)
      return false;
    const Fan fan = fan_of(face.vertex(2));
    set_out_from_vertex(
        fan, face.vertex(2),
        m_frames.angle_from_axis(fan, face.vertex(2), m_triangulation.opposite(opposite_side)) +
            angle);
    return true;
  }

  static Plane_vector unit(const Plane_vector v)
  {
    const double l = internal::length(v);
    return l > 0 ? 1 / l * v : Plane_vector{1, 0};
  }

  const Intrinsic_triangulation& m_triangulation;
  const Tangent_frames m_frames;
  std::vector<Intrinsic_point> m_points;
  const double m_length;
  double m_walked = 0;
  double m_angle;
  bool m_is_on_way = true;
  std::size_t m_number_of_faces = 0;
  Face_point m_at{};        // in the face ahead, to the left of a halfedge, ...
  Plane_vector m_way{1, 0}; // ... which is the x axis of the direction
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_STRAIGHT_WALK_H
