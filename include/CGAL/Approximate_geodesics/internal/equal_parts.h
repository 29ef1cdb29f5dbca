// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_EQUAL_PARTS_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_EQUAL_PARTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Writes the positions of so many points that divide an edge into equal parts; for positions, see
// `Points_on_edges`.
inline void divide_into_equal_parts(float* positions, const std::size_t number_of_points)
{
  const double number_of_parts = double(number_of_points) + 1;
  for(std::size_t i = 0; i < number_of_points; ++i)
  {
    const double from_first = double(i + 1), from_second = double(number_of_points - i);
    positions[i] = static_cast<float>(from_first <= from_second ? from_first / number_of_parts
                                                                : -from_second / number_of_parts);
  }
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_EQUAL_PARTS_H
