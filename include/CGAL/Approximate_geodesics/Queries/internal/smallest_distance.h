// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H

#include <CGAL/license/Approximate_geodesics.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// What sums of lengths may be wrong by, as a part of them.
constexpr double rounding_of_distances = 1e-12;

// The smallest distance that a search with this bound may have found as `distance`.
inline double smallest_distance(const double distance, const double epsilon)
{
  return distance / (1 + epsilon) * (1 - rounding_of_distances);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SMALLEST_DISTANCE_H
