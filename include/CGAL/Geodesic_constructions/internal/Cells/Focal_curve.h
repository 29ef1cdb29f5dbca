// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FOCAL_CURVE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FOCAL_CURVE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

// The inverse of a number, also of zero: a signed infinity.
inline double inverse(const double x) { return x != 0 ? 1 / x : std::copysign(infinity, x); }

// Whether `v` is to the left of `u`: never both ways, and not for equal vectors. The sign of
// `cross(u, v)` has neither property where the compiler contracts it to a fused operation.
inline bool is_before(const Plane_vector u, const Plane_vector v) { return u.x * v.y > u.y * v.x; }

// Unit vectors between two, counterclockwise, by less than a half turn.
struct Direction_range
{
  Plane_vector begin, end;

  bool contains(const Plane_vector u) const { return is_before(begin, u) && is_before(u, end); }

  bool is_empty() const { return !is_before(begin, end); } // or NaN

  Plane_vector middle() const
  {
    const Plane_vector sum = begin + end;
    return inverse(length(sum)) * sum;
  }
};

/*
 * A curve around the origin, given by 1 / r for a direction: `constant + dot(linear, u)` for a unit
 * vector `u`. It is a conic with a focus at the origin, or a straight line. All curves that bound
 * what a tip is nearest to have this form: borders of faces, rays from other tips, and hyperbolas.
 * Two of them meet where a trigonometric polynomial of degree one vanishes.
 */
struct Focal_curve
{
  double constant = 0;
  Plane_vector linear = {0, 0};

  // The line through `p` in direction `d`.
  static Focal_curve line(const Plane_vector p, const Plane_vector d)
  {
    const double factor = inverse(cross(d, p));
    return {0, {-factor * d.y, factor * d.x}};
  }

  // The points whose distance from `focus` is larger by `difference` than that from the origin.
  // \pre The difference is smaller than the distance of the focus, in absolute value.
  static Focal_curve hyperbola(const Plane_vector focus, const double difference)
  {
    const double distance = length(focus);
    const double factor = 2 * inverse((distance - difference) * (distance + difference));
    return {factor * difference, factor * focus};
  }

  double at(const Plane_vector u) const { return constant + dot(linear, u); }

  // Whether it is positive in the middle of a range.
  bool is_positive_within(const Direction_range& range) const
  {
    const Plane_vector sum = range.begin + range.end;
    return constant * length(sum) + dot(linear, sum) > 0;
  }

  Plane_vector point(const Plane_vector u) const { return inverse(at(u)) * u; }

  friend Focal_curve operator-(const Focal_curve& a, const Focal_curve& b)
  {
    return {a.constant - b.constant, a.linear - b.linear};
  }

  // Calls `f(u)` for the directions in a range where the function vanishes.
  template <typename F>
  void for_each_root(const Direction_range& range, F f) const
  {
    const double at_begin = at(range.begin), at_end = at(range.end);
    if(at_begin * at_end > 0 && !range.contains(at_begin > 0 ? -1. * linear : linear))
      return; // it is largest or smallest at the ends
    const double squared = dot(linear, linear), rest = squared - constant * constant;
    if(!(rest > 0))
      return;
    const double along = -constant / squared, across = std::sqrt(rest) / squared;
    for(const double sign : {-1., 1.})
    {
      const Plane_vector u{along * linear.x - sign * across * linear.y,
                           along * linear.y + sign * across * linear.x};
      if(range.contains(u))
        f(u);
    }
  }

  // The largest value in a range.
  double maximum(const Direction_range& range) const
  {
    if(range.contains(linear))
      return constant + length(linear);
    return (std::max)(at(range.begin), at(range.end));
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_FOCAL_CURVE_H
