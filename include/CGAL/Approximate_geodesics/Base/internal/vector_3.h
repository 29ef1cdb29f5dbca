// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_VECTOR_3_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_VECTOR_3_H

#include <CGAL/license/Approximate_geodesics.h>

#include <array>
#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

// A vector or a point in space.
using Space_vector = std::array<double, 3>;

inline Space_vector difference(const Space_vector& a, const Space_vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// a + t b
inline Space_vector linear_combination(const Space_vector& a, const double t, const Space_vector& b)
{
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

inline double dot(const Space_vector& a, const Space_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double distance(const Space_vector& a, const Space_vector& b)
{
  const Space_vector way = difference(a, b);
  return std::sqrt(dot(way, way));
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_VECTOR_3_H
