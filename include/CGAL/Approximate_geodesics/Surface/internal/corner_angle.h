// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CORNER_ANGLE_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CORNER_ANGLE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// `a` turned by the angle from the x axis to the unit vector `r`
inline Plane_vector turned_left(const Plane_vector a, const Plane_vector r)
{
  return {a.x * r.x - a.y * r.y, a.x * r.y + a.y * r.x};
}

// ... and the other way
inline Plane_vector turned_right(const Plane_vector a, const Plane_vector r)
{
  return turned_left(a, {r.x, -r.y});
}

// The unit vector at the angle between two sides of a triangle. At an edge of length zero the angle
// is taken to be right, so that a line through the edge goes straight on.
inline Plane_vector angle_between(const double a, const double b, const double opposite)
{
  if(!(a > 0 && b > 0))
    return {0, 1};
  return {1 - Corner(a, b, opposite).opening() / 2, 2 * (area_of_triangle(a, b, opposite) / a) / b};
}

// The angle at the source of `h` in the face to its left.
inline Plane_vector corner_angle(const Intrinsic_triangulation& triangulation,
                                 const Intrinsic_triangulation::Index h)
{
  const auto g = triangulation.next(h);
  return angle_between(triangulation.length(h), triangulation.length(triangulation.next(g)),
                       triangulation.length(g));
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CORNER_ANGLE_H
