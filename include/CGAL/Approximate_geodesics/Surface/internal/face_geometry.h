// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_GEOMETRY_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_GEOMETRY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Areas, third vertices and corners of faces: computed from the lengths of the sides, or known more
// accurately if a face is thin.

// The area of the triangle with these sides, by Kahan's arrangement of Heron's formula, which is
// accurate for needles too (W. Kahan, Miscalculating area and angles of a needle-like triangle).
inline double area_of_triangle(const double a, const double b, const double c)
{
  const double smaller = (std::min)(a, b), larger = (std::max)(a, b);
  const double x = (std::max)(larger, c), z = (std::min)(smaller, c);
  const double y = (std::max)(smaller, (std::min)(larger, c));
  const double product = (x + (y + z)) * (z - (x - y)) * (z + (x - y)) * (x + (y - z));
  return product > 0 ? std::sqrt(product) / 4 : 0; // rounded lengths can be too long for a triangle
}

// Not inlined: few faces are thin, and a call keeps loops fast.
BOOST_NOINLINE inline std::optional<Thin_face>
find_thin_face(const Intrinsic_triangulation& triangulation, const Index h)
{
  return triangulation.thin_faces().find(triangulation.halfedges_of_face(h));
}

// The shape of the face to the left of `h`, whose sides have lengths `a`, `b`, and `c`, in any
// order, if it is a thin one. Its corners are the source and the target of `h`, and the third
// vertex.
inline std::optional<Thin_face> thin_face(const Intrinsic_triangulation& triangulation,
                                          const Index h,
                                          const double a,
                                          const double b,
                                          const double c)
{
  if(triangulation.thin_faces().is_empty() || !Thin_faces::is_thin(a, b, c))
    return std::nullopt;
  return find_thin_face(triangulation, h);
}

/*
 * The position of the third vertex of the face to the left of a halfedge, in lengths of the
 * halfedge: its distance from the source along the halfedge, its distance from the target backward,
 * and its distance to the left. The first two add up to 1; both are kept because the vertex can be
 * close to either end, or far behind both.
 *
 * In a thin face whose shape is known, the relative error of each is below 1e-12. In other faces of
 * meshes with coordinates, that holds for `across`, and for the others relative to the distance of
 * the third vertex from the respective end.
 */
struct Apex_position
{
  double along, beyond, across;
};

// `a` and `b` are the lengths of the sides at the source and at the target of `h`. The result is
// zero if the halfedge is degenerate, or nearly so.
inline Apex_position apex_position(const Intrinsic_triangulation& triangulation,
                                   const Index h,
                                   const double a,
                                   const double b)
{
  constexpr double largest = 0x1p1000; // the other sides in lengths of the halfedge
  const double base = triangulation.length(h);
  if(!(base > (a + b) / largest))
    return {0, 0, 0};
  if(const std::optional<Thin_face> face = thin_face(triangulation, h, base, a, b))
    return {face->at_corner[0] / base / base, face->at_corner[1] / base / base,
            face->doubled_area / base / base};
  // rounded sides can differ by more than the base
  const double along = 0.5 + 0.5 * ((a - b) / base) * ((a + b) / base);
  const double beyond = 0.5 - 0.5 * ((a - b) / base) * ((a + b) / base);
  return {(std::clamp)(along, -largest, largest), (std::clamp)(beyond, -largest, largest),
          2 * (area_of_triangle(base, a, b) / base) / base};
}

// \pre `h` starts from `source`, and is not a border halfedge.
inline Apex_position
apex_position(const Intrinsic_triangulation& triangulation, const Index source, const Index h)
{
  return apex_position(triangulation, h,
                       triangulation.length(triangulation.counterclockwise(source, h)),
                       triangulation.length(triangulation.next(h)));
}

/*
 * The angle at a corner of a face, for distances between points of its two sides. If x and y are
 * the distances of two points from the corner, the law of cosines is d^2 = x^2 + y^2 - 2 x y
 * cos(angle) = (x - y)^2 + x y (2 sin(angle / 2))^2. The terms of the latter form are not negative,
 * so it is accurate for needles, too.
 */
class Corner
{
public:
  // `a` and `b` are the lengths of the two sides, and `c` that of the opposite edge.
  Corner(const double a, const double b, const double c)
  {
    const double shorter = (std::min)(a, b), longer = (std::max)(a, b);
    const double difference = longer - shorter;
    if(shorter > 0) // rounded lengths can be too long or too short for a triangle
      m_opening = (std::clamp)((c + difference) / longer * (c - difference) / shorter, 0., largest);
  }

  // For a thin face whose shape is known.
  Corner(const Thin_face& face, const double a, const double b)
  {
    const double cosine = face.at_corner[0] / a / b, sine = face.doubled_area / a / b;
    m_opening = cosine > 0 ? 2 * sine * sine / (1 + cosine) : (std::min)(2 - 2 * cosine, largest);
  }

  // The distance of points at the distances `x` and `y` from the corner.
  double distance(const double x, const double y) const
  {
    return std::sqrt((x - y) * (x - y) + (x * m_opening) * y);
  }

  // the squared length of the base of a triangle with two sides of length 1 at this corner
  double opening() const { return m_opening; }

private:
  static constexpr double largest = 4; // at a straight angle

  double m_opening = 0;
};

// The corner at the source of `h` in the face to its left. `a` and `b` are the lengths of the two
// sides that meet there, in any order, and `c` is that of the opposite edge.
inline Corner corner_of_face(const Intrinsic_triangulation& triangulation,
                             const Index h,
                             const double a,
                             const double b,
                             const double c)
{
  if(const std::optional<Thin_face> face = thin_face(triangulation, h, a, b, c))
    return Corner(*face, a, b);
  return Corner(a, b, c);
}

// The angle at the same corner, as a unit vector. At an edge of length zero it is a right angle, so
// that a line through the edge goes straight on.
inline Plane_vector corner_angle(const Intrinsic_triangulation& triangulation,
                                 const Index h,
                                 const double a,
                                 const double b,
                                 const double opposite)
{
  if(const std::optional<Thin_face> face = thin_face(triangulation, h, a, b, opposite))
    return {face->at_corner[0] / a / b, face->doubled_area / a / b};
  if(!(a > 0 && b > 0))
    return {0, 1};
  return {1 - Corner(a, b, opposite).opening() / 2, 2 * (area_of_triangle(a, b, opposite) / a) / b};
}

inline Plane_vector corner_angle(const Intrinsic_triangulation& triangulation, const Index h)
{
  const auto g = triangulation.next(h);
  return corner_angle(triangulation, h, triangulation.length(h),
                      triangulation.length(triangulation.next(g)), triangulation.length(g));
}

constexpr double straight_angle = 3.14159265358979323846;

// A sum of angles from 0 to pi, given by unit vectors.
class Angle_sum
{
public:
  void add(const Plane_vector angle)
  {
    // differences of angles can be too small by a rounding error
    m_rest =
        turned_left(m_rest, angle.x > 0 ? Plane_vector{angle.x, (std::max)(0., angle.y)} : angle);
    if(m_rest.y < 0)
    {
      m_rest = -1 * m_rest;
      ++m_half_turns;
    }
  }

  // whether it is below pi by more than rounding errors
  bool is_convex() const
  {
    constexpr double rounding = 1e-10;
    return m_half_turns == 0 && (m_rest.x > 0 || m_rest.y > rounding);
  }

  double value() const { return straight_angle * m_half_turns + std::atan2(m_rest.y, m_rest.x); }

private:
  Plane_vector m_rest{1, 0};
  int m_half_turns = 0;
};

// Calls `f(h)` for the corners counterclockwise from one halfedge to another one with the same
// source, and for all corners around the vertex if both are the same. Stops and returns `false` if
// `f` does, or at a border, or at an edge between them that cannot be crossed.
template <typename F>
bool for_each_corner(const Intrinsic_triangulation& triangulation,
                     const Index first,
                     const Index last,
                     F f)
{
  const auto v = triangulation.source(first);
  auto h = first;
  do
  {
    if(triangulation.is_border(h) || (h != first && !triangulation.is_crossable(h)) || !f(h))
      return false;
    h = triangulation.counterclockwise(v, h);
  } while(h != last);
  return true;
}

// The sum of these corners, or infinity if paths cannot cross all edges between them.
inline double
angle_of_fan(const Intrinsic_triangulation& triangulation, const Index first, const Index last)
{
  Angle_sum sum;
  const bool is_open = for_each_corner(triangulation, first, last, [&](const auto h) {
    sum.add(corner_angle(triangulation, h));
    return true;
  });
  return is_open ? sum.value() : infinity;
}

/*
 * A point of the face to the left of a halfedge, in barycentric coordinates. The halfedge starts
 * from the point if it is a vertex, and contains it if it is on an edge.
 */
struct Face_point
{
  Index halfedge;
  std::array<double, 3> weight; // of its source, its target, and the third vertex

  static Face_point at_source(const Index h) { return {h, {1, 0, 0}}; }
  static Face_point on_edge(const Index h, const double t) { return {h, {1 - t, t, 0}}; }
  static Face_point in_face(const Intrinsic_point& p)
  {
    return {p.halfedge, {1 - p.t - p.s, p.t, p.s}};
  }

  bool is_vertex() const { return weight[1] == 0 && weight[2] == 0; }
  bool is_on_edge() const { return weight[2] == 0; }

  // a point of an edge as seen from the opposite halfedge
  Face_point seen_from_opposite(const Index opposite) const
  {
    return {opposite, {weight[1], weight[0], 0}};
  }

  // the same point as seen from another halfedge of the face
  Face_point seen_from(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    Face_point result = *this;
    for(int i = 0; i < 2 && result.halfedge != h; ++i)
      result = {triangulation.next(result.halfedge),
                {result.weight[1], result.weight[2], result.weight[0]}};
    CGAL_assertion(result.halfedge == h);
    return result;
  }

  // its position, given those of the corners, starting with the source of the halfedge
  Plane_vector position(const std::array<Plane_vector, 3>& corner) const
  {
    return weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2];
  }

  // its position, given that of the source of the halfedge, and the halfedge's direction
  Plane_vector position(const Intrinsic_triangulation& triangulation,
                        const Plane_vector source,
                        const Plane_vector direction) const
  {
    Plane_vector result = source + weight[1] * triangulation.length(halfedge) * direction;
    if(weight[2] > 0)
    {
      const auto third = triangulation.next(triangulation.next(halfedge));
      result = result + weight[2] * triangulation.length(third) *
                            turned_left(direction, corner_angle(triangulation, halfedge));
    }
    return result;
  }
};

/*
 * The differences of the weights of two points of a face. Their sum is zero, but a weight that was
 * computed as 1 - t - s, or is close to 1, is rounded. Between near points, the difference of the
 * largest weight is therefore computed from the two others. Sets `corner` to a corner such that the
 * differences of the two other weights have opposite signs.
 */
inline std::array<double, 3>
steps_between(const Face_point& p, const Face_point& q, std::size_t& corner)
{
  std::array<double, 3> step{};
  for(std::size_t i = 0; i < 3; ++i)
    step[i] = q.weight[i] - p.weight[i];
  constexpr double close = 1. / 1024;
  if((std::max)({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])}) < close)
  {
    std::size_t largest = 0;
    for(const std::size_t i : {std::size_t(1), std::size_t(2)})
      if(p.weight[i] + q.weight[i] > p.weight[largest] + q.weight[largest])
        largest = i;
    const std::size_t second = (largest + 1) % 3, third = (largest + 2) % 3;
    step[largest] = -(step[second] + step[third]);
    corner = step[second] * step[third] > 0 ? second : largest;
    return step;
  }
  corner = 0;
  while(corner < 2 && step[(corner + 1) % 3] * step[(corner + 2) % 3] > 0)
    ++corner;
  return step;
}

// The distance of two points of a face. It is accurate for points of an edge or of a needle, too,
// and for near points.
inline double
distance(const Intrinsic_triangulation& triangulation, const Face_point& p, const Face_point& q)
{
  const Face_point r = q.seen_from(triangulation, p.halfedge);
  if(p.is_on_edge() && r.is_on_edge()) // there may be no face to the left
    return std::abs(r.weight[1] - p.weight[1]) * triangulation.length(p.halfedge);
  std::size_t i = 0;
  const std::array<double, 3> step = steps_between(p, r, i);
  const auto halfedges = triangulation.halfedges_of_face(p.halfedge);
  const auto length = [&](const std::size_t j) { return triangulation.length(halfedges[j % 3]); };
  const double a = length(i), opposite = length(i + 1), b = length(i + 2);
  return corner_of_face(triangulation, halfedges[i], a, b, opposite)
      .distance(std::abs(step[(i + 1) % 3]) * a, std::abs(step[(i + 2) % 3]) * b);
}

// Calls `f(q)` for the point as one of the face to the left of `h`: not at all if the face does not
// contain it, and twice if it is on two sides that are the same edge.
template <typename F>
void for_each_face_point(const Intrinsic_triangulation& triangulation,
                         const Intrinsic_point& p,
                         const Index h,
                         F f)
{
  Index side = h;
  for(int i = 0; i < 3; ++i, side = triangulation.next(side))
    if(p.is_vertex())
    {
      if(triangulation.source(side) == p.vertex)
        f(Face_point::at_source(side));
    }
    else if(side == p.halfedge)
      f(Face_point::in_face(p));
    else if(p.is_on_edge() && side == triangulation.opposite(p.halfedge))
      f(Face_point::on_edge(side, 1 - p.t));
}

// Calls `f(position)` for the point in that face, if the corners from the source of `h` on are at
// these positions.
template <typename F>
void for_each_position(const Intrinsic_triangulation& triangulation,
                       const Intrinsic_point& p,
                       const Index h,
                       const std::array<Plane_vector, 3>& corners,
                       F f)
{
  for_each_face_point(triangulation, p, h, [&](const Face_point& point) {
    f(point.seen_from(triangulation, h).position(corners));
  });
}

// Calls `f(i, position)` for all points there.
template <typename F>
void for_each_position(const Intrinsic_triangulation& triangulation,
                       const Points_by_face& points,
                       const Index h,
                       const std::array<Plane_vector, 3>& corners,
                       F f)
{
  points.for_each_in_face(h, [&](const std::size_t i) {
    for_each_position(triangulation, points[i], h, corners,
                      [&](const Plane_vector position) { f(i, position); });
  });
}

// The end of a line, which is a vertex or any point.
inline Intrinsic_point point_at(const Index v) { return Intrinsic_point::at_vertex(v); }
inline Intrinsic_point point_at(const Intrinsic_point& point) { return point; }

// A straight line through a face, or along an edge.
struct Segment
{
  Face_point from, to; // seen from halfedges of the same face
  double length = infinity;
};

// The shortest edge between two vertices.
inline Segment
shortest_edge(const Intrinsic_triangulation& triangulation, const Index v, const Index w)
{
  Segment result{};
  if(v == w)
    result.length = 0;
  const Index beyond = triangulation.beyond_halfedge(v);
  for(Index h = triangulation.first_halfedge(v); h < beyond; ++h)
    if(triangulation.target(h) == w && triangulation.length(h) < result.length)
      result = {Face_point::at_source(h), {h, {0, 1, 0}}, triangulation.length(h)};
  return result;
}

// The shortest segment between two points; of infinite length if no face and no edge contains both.
inline Segment shortest_segment(const Intrinsic_triangulation& triangulation,
                                const Intrinsic_point& p,
                                const Intrinsic_point& q)
{
  if(p.is_vertex() && q.is_vertex())
    return shortest_edge(triangulation, p.vertex, q.vertex);
  if(p.is_vertex())
  {
    const Segment s = shortest_segment(triangulation, q, p);
    return {s.to, s.from, s.length};
  }
  Segment result{};
  const auto look_for_q = [&](const Face_point& from) {
    if(!triangulation.is_border(from.halfedge))
      for_each_face_point(triangulation, q, from.halfedge, [&](const Face_point& to) {
        const double length = distance(triangulation, from, to);
        if(length < result.length)
          result = {from, to, length};
      });
  };
  look_for_q(Face_point::in_face(p));
  if(p.is_on_edge())
    look_for_q(Face_point::in_face(p).seen_from_opposite(triangulation.opposite(p.halfedge)));
  return result;
}

// The sum of the straight lines from each point to the next; infinity if two of them share no face.
inline double length_of_segments(const Intrinsic_triangulation& triangulation,
                                 const std::vector<Intrinsic_point>& points)
{
  double result = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    result += shortest_segment(triangulation, points[i - 1], points[i]).length;
  return result;
}

/*
 * The face to the left of a halfedge, laid out in the plane: its corners are the source and the
 * target of the halfedge, and the third vertex, in counterclockwise order.
 */
class Face_layout
{
public:
  Face_layout(const Intrinsic_triangulation& triangulation, const Index h)
    : m_triangulation(triangulation), m_halfedges(triangulation.halfedges_of_face(h))
  {
    const std::array<double, 3> lengths{triangulation.length(m_halfedges[0]),
                                        triangulation.length(m_halfedges[1]),
                                        triangulation.length(m_halfedges[2])};
    const auto longest = std::max_element(lengths.begin(), lengths.end()); // others may be zero
    const auto base = static_cast<std::size_t>(longest - lengths.begin());
    const double c = lengths[base], a = lengths[(base + 1) % 3], b = lengths[(base + 2) % 3];
    m_corners[base] = {0, 0};
    m_corners[(base + 1) % 3] = {c, 0};
    const auto face = thin_face(triangulation, m_halfedges[base], a, b, c);
    if(face)
      m_corners[(base + 2) % 3] = {face->at_corner[0] / c, face->doubled_area / c};
    else if(c > 0)
      m_corners[(base + 2) % 3] = {0.5 * (c + (b - a) * ((b + a) / c)),
                                   2 * area_of_triangle(a, b, c) / c};
    else
      m_corners[(base + 2) % 3] = {0, 0};
    for(std::size_t i = 0; i < 3; ++i)
      m_edges[i] = m_corners[(i + 1) % 3] - m_corners[i];
    if(face) // a short edge that does not start from the origin would lose its direction
      m_edges[(base + 1) % 3] = {-face->at_corner[1] / c, face->doubled_area / c};
  }

  // The halfedge from corner `i` to the next one.
  Index halfedge(const std::size_t i) const { return m_halfedges[i]; }

  Index vertex(const std::size_t i) const
  {
    return m_triangulation.target(m_halfedges[(i + 2) % 3]);
  }

  Plane_vector corner(const std::size_t i) const { return m_corners[i]; }

  // The vector from corner `i` to corner `j`, accurate in its direction and length.
  Plane_vector edge(const std::size_t i, const std::size_t j) const
  {
    return i == j ? Plane_vector{0, 0} : j == (i + 1) % 3 ? m_edges[i] : -1. * m_edges[j];
  }

  // The direction of a halfedge of the face, of length 1; zero if the halfedge has no length.
  Plane_vector direction(const Index h) const
  {
    std::size_t i = 0;
    while(i < 2 && m_halfedges[i] != h)
      ++i;
    return direction_of(m_edges[i]);
  }

  Plane_vector position(const Face_point& point) const
  {
    return point.seen_from(m_triangulation, m_halfedges[0]).position(m_corners);
  }

  // The vector from a point of the face to corner `j`, accurate where the point is close to it.
  Plane_vector vector_to_corner(const std::size_t j, const Face_point& point) const
  {
    const auto& weight = point.seen_from(m_triangulation, m_halfedges[0]).weight;
    Plane_vector result{0, 0};
    for(std::size_t i = 0; i < 3; ++i)
      result = result + weight[i] * edge(i, j);
    return result;
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  std::array<Index, 3> m_halfedges;
  std::array<Plane_vector, 3> m_corners;
  std::array<Plane_vector, 3> m_edges; // from each corner to the next
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACE_GEOMETRY_H
