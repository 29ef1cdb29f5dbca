// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// What sums of lengths may be wrong by, as a part of them.
constexpr double rounding_of_distances = 1e-12;

// The smallest distance that a search may have found as `distance`, with this bound between
// vertices, and from sources that are so far from the nearest of them.
inline double
smallest_distance(const double distance, const double epsilon, const double cost_to_corner = 0)
{
  if(std::isinf(epsilon))
    return std::isinf(distance) ? distance : 0;
  const double detour = cost_to_corner > 0 ? (2 + epsilon) * cost_to_corner : 0;
  return (std::max)(distance - detour, 0.) / (1 + epsilon) * (1 - rounding_of_distances);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H
