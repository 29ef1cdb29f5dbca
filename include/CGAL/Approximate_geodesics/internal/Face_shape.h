// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_FACE_SHAPE_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_FACE_SHAPE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/internal/Unfolding.h>

#include <algorithm>
#include <limits>

// What geometric progressions of points are made to measure for.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

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
    if(is_obtuse(a, b, opposite))
      return 1;
    return 2 * (m_area / a) / b; // neither side is 0, as the angle would be called obtuse
  }

  double m_first, m_opposite, m_second; // lengths
  double m_area;
};

// The distance from `v` to the border of the union of its faces; infinity if it has none.
inline double radius_of_star(const Intrinsic_triangulation& triangulation,
                             const Intrinsic_triangulation::Index v)
{
  double result = std::numeric_limits<double>::infinity();
  for(auto h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    if(!triangulation.is_border(h))
      result = (std::min)(result, Face_shape(triangulation, h).distance_to_opposite_edge());
  return result;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_FACE_SHAPE_H
