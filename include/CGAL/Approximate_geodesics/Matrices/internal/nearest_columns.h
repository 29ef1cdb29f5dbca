// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_NEAREST_COLUMNS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_NEAREST_COLUMNS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

inline std::size_t checked_number_of_nearest(const std::size_t number)
{
  if(number == 0)
    reject("the number of nearest columns is 0; it must be at least 1");
  return number;
}

// Returns the `number` nearest columns, sorted by distance, then by column.
inline std::vector<Distance_row::Column> nearest_columns(const Distance_row& row,
                                                         const std::size_t number)
{
  using Entry = std::pair<double, Distance_row::Column>;
  std::vector<Entry> entries;
  entries.reserve(row.reached().size());
  for(const auto column : row.reached())
    entries.emplace_back(row[column], column);
  if(number < entries.size())
  {
    const auto end = entries.begin() + static_cast<std::ptrdiff_t>(number);
    std::nth_element(entries.begin(), end, entries.end());
    entries.erase(end, entries.end());
  }
  std::sort(entries.begin(), entries.end());
  std::vector<Distance_row::Column> result;
  result.reserve(entries.size());
  for(const Entry& entry : entries)
    result.push_back(entry.second);
  return result;
}

} // namespace internal

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_NEAREST_COLUMNS_H
