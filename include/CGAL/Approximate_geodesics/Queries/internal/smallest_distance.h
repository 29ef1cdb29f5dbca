// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

// A bound on the relative rounding error of sums of lengths.
constexpr double rounding_of_distances = 1e-12;

// Returns a lower bound on the exact distance if a search with the error bound `epsilon` has found
// `distance`. `cost_to_corner` is the largest cost from a source to the nearest vertex.
inline double
smallest_distance(const double distance, const double epsilon, const double cost_to_corner = 0)
{
  if(std::isinf(epsilon))
    return std::isinf(distance) ? distance : 0;
  const double detour = cost_to_corner > 0 ? (2 + epsilon) * cost_to_corner : 0;
  return (std::max)(distance - detour, 0.) / (1 + epsilon) * (1 - rounding_of_distances);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H
