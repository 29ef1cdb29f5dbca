// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_SLOPE_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_SLOPE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

// Returns the gain in height per unit of horizontal length; infinity for a vertical direction.
template <typename Vector_3>
double slope(const Vector_3& direction)
{
  const double x = CGAL::to_double(direction.x()), y = CGAL::to_double(direction.y());
  const double z = CGAL::to_double(direction.z()), run = std::sqrt(x * x + y * y);
  return run > 0 ? z / run : std::copysign(std::numeric_limits<double>::infinity(), z);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_SLOPE_H
