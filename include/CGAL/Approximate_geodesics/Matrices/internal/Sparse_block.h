// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_SPARSE_BLOCK_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_SPARSE_BLOCK_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

/*
 * The entries of a block of rows of a sparse matrix, row by row.
 */
template <typename T>
struct Sparse_block
{
  using Column = Distance_row::Column;

  std::vector<std::size_t> rows;
  std::vector<std::uint32_t> numbers_of_entries; // by row
  std::vector<Column> columns;
  std::vector<T> distances;

  void append(const std::size_t row,
              const std::vector<Column>& columns_of_row,
              const Distance_row& distances_of_row)
  {
    rows.push_back(row);
    numbers_of_entries.push_back(static_cast<std::uint32_t>(columns_of_row.size()));
    columns.insert(columns.end(), columns_of_row.begin(), columns_of_row.end());
    for(const Column column : columns_of_row)
      distances.push_back(static_cast<T>(distances_of_row[column]));
  }

  void clear()
  {
    rows.clear();
    numbers_of_entries.clear();
    columns.clear();
    distances.clear();
  }
};

} // namespace internal

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_SPARSE_BLOCK_H
