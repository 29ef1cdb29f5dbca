// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_PLANE_VECTOR_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_PLANE_VECTOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

struct Plane_vector
{
  double x, y;

  friend Plane_vector operator+(const Plane_vector a, const Plane_vector b)
  {
    return {a.x + b.x, a.y + b.y};
  }
  friend Plane_vector operator-(const Plane_vector a, const Plane_vector b)
  {
    return {a.x - b.x, a.y - b.y};
  }
  friend Plane_vector operator*(const double factor, const Plane_vector a)
  {
    return {factor * a.x, factor * a.y};
  }
};

inline double dot(const Plane_vector a, const Plane_vector b) { return a.x * b.x + a.y * b.y; }

// positive if `b` is to the left of `a`
inline double cross(const Plane_vector a, const Plane_vector b) { return a.x * b.y - a.y * b.x; }

inline double length(const Plane_vector a) { return std::sqrt(dot(a, a)); }

// `a` divided by its length; zero if it has none
inline Plane_vector direction_of(const Plane_vector a)
{
  const double l = length(a);
  return l > 0 ? 1 / l * a : Plane_vector{0, 0};
}

// from the x axis, between -pi and pi
inline double angle_of(const Plane_vector a) { return std::atan2(a.y, a.x); }

// `a` turned by the angle from the x axis to the unit vector `r`
inline Plane_vector turned_left(const Plane_vector a, const Plane_vector r)
{
  return {a.x * r.x - a.y * r.y, a.x * r.y + a.y * r.x};
}

// `a` turned by that angle in the opposite direction
inline Plane_vector turned_right(const Plane_vector a, const Plane_vector r)
{
  return turned_left(a, {r.x, -r.y});
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_PLANE_VECTOR_H
