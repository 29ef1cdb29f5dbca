// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_EDGE_LENGTHS_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_EDGE_LENGTHS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <array>
#include <cmath>

// Lengths that neither overflow nor underflow on the way: see the remark on units at
// `Intrinsic_triangulation`.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

using Point = std::array<double, 3>;

// A power of two, and its inverse, that brings `extent` near 2^200 without rounding: products of
// four lengths still fit a double, and lengths may be smaller than the extent by more than 1e300.
class Scale
{
public:
  explicit Scale(const double extent)
    : m_exponent(extent > 0 ? (std::max)(std::ilogb(extent) - 200, SMALLEST_EXPONENT) : 0),
      m_half_way(std::ldexp(1., -(m_exponent / 2))),
      m_rest(std::ldexp(1., -(m_exponent - m_exponent / 2)))
  {
  }

  double unit() const { return std::ldexp(1., m_exponent); }

  // in two steps, as one factor could overflow
  double reduce(const double x) const { return x * m_half_way * m_rest; }

private:
  static constexpr int SMALLEST_EXPONENT = -1074; // of a double

  int m_exponent;
  double m_half_way;
  double m_rest;
};

inline double distance(const Point& p, const Point& q)
{
  const double dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2];
  const double squared = dx * dx + dy * dy + dz * dz;

  constexpr double smallest_accurate = 1e-280; // below, a square may have lost bits to underflow
  if(squared > smallest_accurate)
    return std::sqrt(squared);

  const double largest = (std::max)({std::abs(dx), std::abs(dy), std::abs(dz)});
  if(largest == 0)
    return 0;
  const Scale scale(largest);
  const double x = scale.reduce(dx), y = scale.reduce(dy), z = scale.reduce(dz);
  return std::sqrt(x * x + y * y + z * z) * scale.unit();
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_EDGE_LENGTHS_H
