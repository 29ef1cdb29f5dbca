// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_FACE_SHAPE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_FACE_SHAPE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Apex_position.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Gauges/Face_gauges.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

// Shape parameters of faces and vertex stars, which the placement of points depends on.

/*
 * The face to the left of a halfedge, as seen from the source of that.
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

  // How far the points of an edge that starts at the corner are from the face's other two edges, in
  // proportion to their distance from the corner, as long as that end of the edge is the one that
  // matters: the sine of the angle there, or 1 if it is obtuse.
  double sine_of_corner() const { return sine(m_first, m_second, m_opposite); }

  // ... at the other end of the halfedge
  double sine_of_next_corner() const { return sine(m_first, m_opposite, m_second); }

  // the distance from the corner to the opposite edge
  double distance_to_opposite_edge() const
  {
    if(is_obtuse(m_opposite, m_first, m_second))
      return m_first;
    if(is_obtuse(m_opposite, m_second, m_first))
      return m_second;
    return m_opposite > 0 ? 2 * (m_area / m_opposite) : (std::min)(m_first, m_second);
  }

private:
  // whether the angle between the sides `a` and `b` is
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

  // stars are taken to have at least this radius, in lengths of the longest edge in them
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

  // the distance from the vertex to the border of the star; infinity if there is no face
  double radius() const { return (std::max)(m_radius, SMALLEST_RADIUS * m_longest_edge); }

  // whether the radius is smaller than it is taken for, because of a face that paths may enter
  bool is_degenerate() const { return m_radius_of_open < SMALLEST_RADIUS * m_longest_edge; }

  // the halfedge that starts from the vertex, with the face to its left that makes it so small
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

/*
 * Whether the weights of the faces around a vertex differ. Forbidden faces do not count.
 */
class Weight_spread
{
public:
  using Index = Intrinsic_triangulation::Index;

  Weight_spread(const Intrinsic_triangulation& triangulation, const Index v)
  {
    if(triangulation.has_weights())
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
        add(triangulation.weight(h));
  }

  // whether paths near the vertex are straight
  bool are_uniform() const { return m_largest == 0 || (!m_has_free && m_smallest == m_largest); }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void add(const double weight)
  {
    if(weight == infinity)
      return;
    m_largest = (std::max)(m_largest, weight);
    if(weight > 0)
      m_smallest = (std::min)(m_smallest, weight);
    else
      m_has_free = true;
  }

  double m_smallest = infinity; // of those that are not zero
  double m_largest = 0;
  bool m_has_free = false;
};

/*
 * What the error of a path across a face depends on, where the face has a gauge.
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

  // whether no direction is free, and none is forbidden, unless all are
  bool is_bounded() const { return is_forbidden() || is_free() || (m_is_finite && m_smallest > 0); }

  // the cost of the cheapest direction, per unit of length
  double smallest() const { return m_smallest; }

  // A number Q such that a change `c` of a vector `d` adds at most
  //   F(d) (r + Q |c|^2 / (2 |d|^2))
  // to what a linear function of `c`, which depends on `d` only, says of the gauge F. \pre The face
  // is neither free nor forbidden. Sectors where F is zero or infinite are left out.
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
      result = q > result ? q : result; // not if it is not a number
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
