// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_VERTEX_FAN_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_VERTEX_FAN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Circulation around a vertex.

namespace CGAL::Approximate_geodesics::internal {

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

  // whether it is below pi, and not just by rounding errors
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

// The sum of the corners counterclockwise from one halfedge to another one that starts from the
// same vertex, and all the way round if they are the same. Infinity if there is a border, or an
// edge between them that cannot be crossed.
inline double angle_of_fan(const Intrinsic_triangulation& triangulation,
                           const Intrinsic_triangulation::Index first,
                           const Intrinsic_triangulation::Index last)
{
  const auto v = triangulation.source(first);
  Angle_sum result;
  auto h = first;
  do
  {
    if(triangulation.is_border(h) || (h != first && !triangulation.is_crossable(h)))
      return std::numeric_limits<double>::infinity();
    result.add(corner_angle(triangulation, h));
    h = triangulation.counterclockwise(v, h);
  } while(h != last);
  return result.value();
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_VERTEX_FAN_H
