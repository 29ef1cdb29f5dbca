// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_COMPRESSED_ROWS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_COMPRESSED_ROWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Sparse_block.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

/*
 * A sparse matrix in compressed sparse row format.
 */
template <typename T>
struct Compressed_rows
{
  using Column = Distance_row::Column;

  std::vector<std::size_t> starts{0}; // of the entries by row, and the end
  std::unique_ptr<Column[]> columns;
  std::unique_ptr<T[]> distances;

  Compressed_rows() = default;

  // Concatenates blocks, whose rows may be in any order. Each block is freed after it was copied,
  // which limits peak memory.
  Compressed_rows(const std::size_t number_of_rows, std::vector<Sparse_block<T>>& blocks)
    : starts(number_of_rows + 1, 0)
  {
    for(const Sparse_block<T>& block : blocks)
      for(std::size_t i = 0; i < block.rows.size(); ++i)
        starts[block.rows[i] + 1] = block.numbers_of_entries[i];
    allocate();
    for(Sparse_block<T>& block : blocks)
      take(std::exchange(block, Sparse_block<T>()));
  }

  // Replaces each distance and its transpose by the smaller of the two. The result has an entry if
  // either exists.
  // \pre Columns ascend, and the matrix is square.
  void make_symmetric()
  {
    const Compressed_rows other = transposed();
    Compressed_rows result;
    result.starts.assign(starts.size(), 0);
    for_each_of_both(other, [&](const std::size_t row, Column, T) { ++result.starts[row + 1]; });
    result.allocate();
    std::size_t i = 0;
    for_each_of_both(other, [&](std::size_t, const Column column, const T distance) {
      result.columns[i] = column;
      result.distances[i++] = distance;
    });
    *this = std::move(result);
  }

private:
  // \pre Each start except the first one is the number of entries of the previous row.
  void allocate()
  {
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    columns.reset(new Column[starts.back()]);
    distances.reset(new T[starts.back()]);
  }

  void take(const Sparse_block<T>& block)
  {
    std::size_t from = 0;
    for(std::size_t i = 0; i < block.rows.size(); ++i)
    {
      const std::size_t start = starts[block.rows[i]], number = block.numbers_of_entries[i];
      std::copy_n(block.columns.data() + from, number, columns.get() + start);
      std::copy_n(block.distances.data() + from, number, distances.get() + start);
      from += number;
    }
  }

  Compressed_rows transposed() const
  {
    const std::size_t number_of_rows = starts.size() - 1;
    Compressed_rows result;
    result.starts.assign(starts.size(), 0);
    for(std::size_t i = 0; i < starts.back(); ++i)
      ++result.starts[columns[i] + 1];
    result.allocate();
    std::vector<std::size_t> next = result.starts;
    for(std::size_t row = 0; row < number_of_rows; ++row)
      for(std::size_t i = starts[row]; i < starts[row + 1]; ++i)
      {
        const std::size_t to = next[columns[i]]++;
        result.columns[to] = static_cast<Column>(row);
        result.distances[to] = distances[i];
      }
    return result;
  }

  // Calls `f(row, column, distance)` for the union of the entries of both matrices, with the
  // smaller distance.
  template <typename F>
  void for_each_of_both(const Compressed_rows& other, F f) const
  {
    for(std::size_t row = 0; row + 1 < starts.size(); ++row)
    {
      std::size_t i = starts[row], j = other.starts[row];
      while(i < starts[row + 1] || j < other.starts[row + 1])
      {
        const bool has_i = i < starts[row + 1], has_j = j < other.starts[row + 1];
        const bool takes_i = has_i && !(has_j && other.columns[j] < columns[i]);
        const bool takes_j = has_j && !(has_i && columns[i] < other.columns[j]);
        const Column column = takes_i ? columns[i] : other.columns[j];
        const T distance = takes_i && takes_j ? (std::min)(distances[i], other.distances[j])
                           : takes_i          ? distances[i]
                                              : other.distances[j];
        f(row, column, distance);
        i += takes_i;
        j += takes_j;
      }
    }
  }
};

} // namespace internal

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_COMPRESSED_ROWS_H
