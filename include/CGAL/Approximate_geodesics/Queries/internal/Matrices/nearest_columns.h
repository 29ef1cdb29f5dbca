// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_NEAREST_COLUMNS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_NEAREST_COLUMNS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Queries/Matrices/Distance_row.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

inline std::size_t checked_number_of_nearest(const std::size_t number)
{
  if(number == 0)
    reject("the number of nearest columns is 0; it must be at least 1");
  return number;
}

// The columns that are nearest, and so many of them, by distance and by number.
inline std::vector<Distance_row::Column> nearest_columns(const Distance_row& row,
                                                         const std::size_t number)
{
  using Column = Distance_row::Column;
  std::vector<Column> result = row.reached();
  const auto end = result.begin() + static_cast<std::ptrdiff_t>((std::min)(number, result.size()));
  std::partial_sort(result.begin(), end, result.end(), [&](const Column a, const Column b) {
    return std::make_pair(row[a], a) < std::make_pair(row[b], b);
  });
  result.erase(end, result.end());
  return result;
}

} // namespace internal

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_NEAREST_COLUMNS_H
