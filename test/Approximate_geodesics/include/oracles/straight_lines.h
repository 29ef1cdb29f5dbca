// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_STRAIGHT_LINES_H
#define APPROXIMATE_GEODESICS_TEST_STRAIGHT_LINES_H

#include "meshes/test_soup.h"

#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesics_test {

inline double distance_in_space(const Point& p, const Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// The length of the straight pieces from each point to the next one.
inline double length_of(const std::vector<Point>& points)
{
  double result = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    result += distance_in_space(points[i - 1], points[i]);
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_STRAIGHT_LINES_H
