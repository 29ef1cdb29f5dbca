// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_HYPERBOLA_BRANCH_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_HYPERBOLA_BRANCH_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The points whose distance from a focus is larger by a difference than that from the origin:
 * focus / 2 + x e + y f with x = -(difference / 2) cosh s and y = b sinh s, where e is the
 * direction of the focus, at distance d, f is e turned by a right angle, and
 * 4 b^2 = d^2 - difference^2. A straight line if the difference is zero.
 */
class Hyperbola_branch
{
public:
  // \pre The difference is smaller than the distance of the focus, in absolute value.
  Hyperbola_branch(const Plane_vector focus, const double difference)
    : m_center(0.5 * focus), m_difference(difference)
  {
    const double distance = length(focus);
    m_axis = 1 / distance * focus;
    m_semiaxis = std::sqrt((distance - difference) * (distance + difference)) / 2;
  }

  // Calls `f(point)` for points between two others, such that the arc is at most `chord_error` away
  // from the polyline. The arc between the parameters s and t is at most
  // |difference| sinh^2((t - s) / 4) away from its chord, as it is farthest next to the vertex of
  // the branch.
  template <typename F>
  void for_each_between(const Plane_vector p,
                        const Plane_vector q,
                        const double chord_error,
                        const F& f) const
  {
    const double begin = parameter(p), end = parameter(q);
    const double parts =
        std::sqrt(std::abs(m_difference) / chord_error) * std::sinh(std::abs(end - begin) / 4);
    const double n = std::ceil((std::min)(MOST_PARTS, parts));
    for(double i = 1; i < n; ++i)
      f(point(begin + i / n * (end - begin)));
  }

  // The area between an arc and its chord; positive if the arc is farther from the origin.
  double area_beside_chord(const Plane_vector p, const Plane_vector q) const
  {
    const double s = std::abs(parameter(q) - parameter(p));
    return m_difference * m_semiaxis / 4 * sinh_minus(s);
  }

private:
  static constexpr double MOST_PARTS = 1000; // of an arc in a face

  double parameter(const Plane_vector p) const { return std::asinh(cross(m_axis, p) / m_semiaxis); }

  Plane_vector point(const double s) const
  {
    const Plane_vector p{-m_difference / 2 * std::cosh(s), m_semiaxis * std::sinh(s)};
    return m_center + turned_left(p, m_axis);
  }

  // sinh s - s
  static double sinh_minus(const double s)
  {
    constexpr double limit = 0.1;
    if(s > limit)
      return std::sinh(s) - s;
    const double x = s * s;
    return s * x / 6 * (1 + x / 20 * (1 + x / 42 * (1 + x / 72 * (1 + x / 110))));
  }

  Plane_vector m_center, m_axis;
  double m_difference, m_semiaxis;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CELLS_HYPERBOLA_BRANCH_H
