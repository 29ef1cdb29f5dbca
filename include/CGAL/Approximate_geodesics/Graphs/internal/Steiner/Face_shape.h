// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_FACE_SHAPE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_FACE_SHAPE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Gauges/Face_gauges.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

// Shape parameters of faces, vertex stars and gauges, which the placement of points depends on.

/*
 * The face to the left of a halfedge, and its corner at the source of the halfedge.
 */
class Face_shape
{
public:
  using Index = Intrinsic_triangulation::Index;

  // \pre `h` is not a border halfedge.
  Face_shape(const Intrinsic_triangulation& triangulation, const Index h)
    : m_first(triangulation.length(h)),
      m_opposite(triangulation.length(triangulation.next(h))),
      m_second(triangulation.length(triangulation.next(triangulation.next(h)))),
      m_area(area_of_triangle(m_first, m_opposite, m_second))
  {
    if(const auto face = thin_face(triangulation, h, m_first, m_opposite, m_second))
      m_area = face->doubled_area / 2;
  }

  // Returns the sine of the angle at the corner, or 1 if it is obtuse: the distance of a point of
  // one of the two edges there from the other edge, relative to its distance from the corner.
  double sine_of_corner() const { return sine(m_first, m_second, m_opposite); }

  // Returns the same for the corner at the target of the halfedge.
  double sine_of_next_corner() const { return sine(m_first, m_opposite, m_second); }

  // Returns the distance from the corner to the opposite edge.
  double distance_to_opposite_edge() const
  {
    if(is_obtuse(m_opposite, m_first, m_second))
      return m_first;
    if(is_obtuse(m_opposite, m_second, m_first))
      return m_second;
    return m_opposite > 0 ? 2 * (m_area / m_opposite) : (std::min)(m_first, m_second);
  }

private:
  // Returns whether the angle between the sides `a` and `b` is obtuse.
  static bool is_obtuse(const double a, const double b, const double opposite)
  {
    return opposite * opposite >= a * a + b * b;
  }

  double sine(const double a, const double b, const double opposite) const
  {
    if(!(a > 0 && b > 0) || is_obtuse(a, b, opposite))
      return 1;
    return 2 * (m_area / a) / b;
  }

  double m_first, m_opposite, m_second; // lengths
  double m_area;
};

/*
 * The union of the faces around a vertex.
 */
class Star
{
public:
  using Index = Intrinsic_triangulation::Index;

  // the smallest radius that is returned, relative to the longest edge at the vertex
  static constexpr double SMALLEST_RADIUS = 1e-9;

  Star(const Intrinsic_triangulation& triangulation, const Index v)
  {
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    {
      m_longest_edge = (std::max)(m_longest_edge, triangulation.length(h));
      if(!triangulation.is_border(h))
        add_face(h, Face_shape(triangulation, h).distance_to_opposite_edge(),
                 std::isinf(triangulation.weight(h)));
    }
  }

  // Returns the distance from the vertex to the border of the star; infinity if there is no face.
  double radius() const { return (std::max)(m_radius, SMALLEST_RADIUS * m_longest_edge); }

  // Returns whether the radius is smaller than `radius()` because of a face that paths may enter.
  bool is_degenerate() const { return m_radius_of_open < SMALLEST_RADIUS * m_longest_edge; }

  // Returns the halfedge from the vertex whose face determines the radius; it is not forbidden.
  Index narrowest_face() const { return m_narrowest; }

private:
  void add_face(const Index h, const double distance, const bool is_forbidden)
  {
    m_radius = (std::min)(m_radius, distance);
    if(is_forbidden || distance >= m_radius_of_open)
      return;
    m_radius_of_open = distance;
    m_narrowest = h;
  }

  double m_radius = std::numeric_limits<double>::infinity();
  double m_radius_of_open = std::numeric_limits<double>::infinity(); // of faces not forbidden
  double m_longest_edge = 0;
  Index m_narrowest = Intrinsic_triangulation::null_index;
};

// Returns whether all faces around a vertex have the same weight, so that paths near it are
// straight. Forbidden faces do not count.
inline bool are_weights_uniform(const Intrinsic_triangulation& triangulation,
                                const Intrinsic_triangulation::Index v)
{
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  if(triangulation.has_weights())
    for(auto h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      if(const double weight = triangulation.weight(h); !std::isinf(weight))
      {
        smallest = (std::min)(smallest, weight);
        largest = (std::max)(largest, weight);
      }
  return largest == 0 || smallest == largest;
}

/*
 * The properties of a gauge that the error of a path across its face depends on.
 */
class Gauge_shape
{
public:
  using Index = Face_gauges::Index;
  using Sector = Face_gauges::Sector;

  Gauge_shape(const Face_gauges& gauges, const Index face)
    : m_first(gauges.first_sector(face)), m_beyond(gauges.beyond_sector(face))
  {
    for(const Sector* s = m_first; s != m_beyond; ++s)
    {
      m_is_finite = m_is_finite && s->is_finite();
      if(!s->is_finite())
        continue;
      for(const Plane_vector d : {s->direction, next(s)->direction})
        m_smallest = (std::min)(m_smallest, (std::max)(dot(s->functional, d), 0.));
      m_largest = (std::max)(m_largest, length(s->functional));
    }
  }

  bool is_forbidden() const { return m_first == m_beyond; }
  bool is_free() const { return !is_forbidden() && m_is_finite && m_largest == 0; }

  // Returns whether no direction is free or forbidden, or all are.
  bool is_bounded() const { return is_forbidden() || is_free() || (m_is_finite && m_smallest > 0); }

  // Returns the cost of the cheapest direction, per unit of length.
  double smallest() const { return m_smallest; }

  // Returns a number Q such that for all vectors c, the gauge F(d + c) exceeds a linear function of
  // c, which depends on d only, by at most
  //   F(d) (r + Q |c|^2 / (2 |d|^2)).
  // Sectors where F is zero or infinite are left out.
  // \pre The face is neither free nor forbidden.
  //
  // From sector s to sector t, F(d + c) exceeds the functional of s by (t - s)(d + c), and the
  // largest Q for that is |t - s|^2 / (2 F(d) (r F(d) - (t - s) d)), for |d| = 1. Both factors
  // below are smallest at one of the ends of s.
  double curvature(const double r) const
  {
    double result = 0;
    for(const Sector* s = m_first; s != m_beyond; ++s)
      if(s->is_finite())
        result = (std::max)(result, curvature(*s, next(s)->direction, r));
    return result;
  }

private:
  const Sector* next(const Sector* const s) const { return s + 1 == m_beyond ? m_first : s + 1; }

  double curvature(const Sector& s, const Plane_vector end, const double r) const
  {
    const double at_start = dot(s.functional, s.direction), at_end = dot(s.functional, end);
    const double smallest = (std::min)(at_start, at_end);
    if(!(smallest > 0))
      return 0;
    double result = 0;
    for(const Sector* t = m_first; t != m_beyond; ++t)
    {
      const Plane_vector step = t->functional - s.functional;
      const double gap = (std::min)((std::max)(-dot(step, s.direction), 0.) + r * at_start,
                                    (std::max)(-dot(step, end), 0.) + r * at_end);
      const double q = dot(step, step) / (2 * smallest * gap);
      result = q > result ? q : result; // false for NaN
    }
    return result;
  }

  const Sector* m_first;
  const Sector* m_beyond;
  double m_smallest = std::numeric_limits<double>::infinity();
  double m_largest = 0;
  bool m_is_finite = true;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_FACE_SHAPE_H
