// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CORNER_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CORNER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Thin_faces.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

// Looks for the face to the left of `h`, whose sides have these lengths, among the thin ones. Not
// inlined: most meshes have no thin faces, and a call keeps loops fast.
BOOST_NOINLINE inline std::optional<Thin_face>
find_thin_face(const Intrinsic_triangulation& triangulation,
               const Intrinsic_triangulation::Index h,
               const double a,
               const double b,
               const double c)
{
  if(!Thin_faces::is_thin(a, b, c))
    return std::nullopt;
  return triangulation.thin_faces().find(triangulation.halfedges_of_face(h));
}

// The shape of the face to the left of `h`, whose sides have lengths `a`, `b`, and `c`, in any
// order, if it is a thin one. Its corners are the source and the target of `h`, and the third
// vertex.
inline std::optional<Thin_face> thin_face(const Intrinsic_triangulation& triangulation,
                                          const Intrinsic_triangulation::Index h,
                                          const double a,
                                          const double b,
                                          const double c)
{
  if(triangulation.thin_faces().is_empty())
    return std::nullopt;
  return find_thin_face(triangulation, h, a, b, c);
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
                                   const Intrinsic_triangulation::Index h,
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
inline Apex_position apex_position(const Intrinsic_triangulation& triangulation,
                                   const Intrinsic_triangulation::Index source,
                                   const Intrinsic_triangulation::Index h)
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

  // The squared distance of points at the distances `x` and `y` from the corner.
  double squared_distance(const double x, const double y) const
  {
    return (x - y) * (x - y) + (x * m_opening) * y;
  }

  double distance(const double x, const double y) const
  {
    return std::sqrt(squared_distance(x, y));
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
                             const Intrinsic_triangulation::Index h,
                             const double a,
                             const double b,
                             const double c)
{
  if(const std::optional<Thin_face> face = thin_face(triangulation, h, a, b, c))
    return Corner(*face, a, b);
  return Corner(a, b, c);
}

// The angle between two sides of a triangle, as a unit vector. At an edge of length zero it is a
// right angle, so that a line through the edge goes straight on.
inline Plane_vector angle_between(const double a, const double b, const double opposite)
{
  if(!(a > 0 && b > 0))
    return {0, 1};
  return {1 - Corner(a, b, opposite).opening() / 2, 2 * (area_of_triangle(a, b, opposite) / a) / b};
}

// The same as `corner_of_face()`, as a unit vector.
inline Plane_vector corner_angle(const Intrinsic_triangulation& triangulation,
                                 const Intrinsic_triangulation::Index h,
                                 const double a,
                                 const double b,
                                 const double opposite)
{
  if(const std::optional<Thin_face> face = thin_face(triangulation, h, a, b, opposite))
    return {face->at_corner[0] / a / b, face->doubled_area / a / b};
  return angle_between(a, b, opposite);
}

inline Plane_vector corner_angle(const Intrinsic_triangulation& triangulation,
                                 const Intrinsic_triangulation::Index h)
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
                     const Intrinsic_triangulation::Index first,
                     const Intrinsic_triangulation::Index last,
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
inline double angle_of_fan(const Intrinsic_triangulation& triangulation,
                           const Intrinsic_triangulation::Index first,
                           const Intrinsic_triangulation::Index last)
{
  Angle_sum sum;
  const bool is_open = for_each_corner(triangulation, first, last, [&](const auto h) {
    sum.add(corner_angle(triangulation, h));
    return true;
  });
  return is_open ? sum.value() : std::numeric_limits<double>::infinity();
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CORNER_H
