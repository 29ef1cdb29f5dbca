// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_SPARSE_ROWS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_SPARSE_ROWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Compressed_rows.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Sparse_block.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * A sparse distance matrix in memory, in compressed sparse row format: the common base of
 * `Radius_rows` and `Nearest_rows`. An entry takes `4 + sizeof(T)` bytes.
 *
 * \tparam T the type of distances, `double` or `float`
 */
template <typename T>
class Sparse_rows
{
  static_assert(std::is_floating_point_v<T>, "distances are floating-point numbers");

public:
  /// the number of a column.
  using Column = Distance_row::Column;

  /// returns the number of rows; `0` if the computation was not completed.
  std::size_t number_of_rows() const { return m_rows.starts.size() - 1; }

  /// returns the number of columns.
  std::size_t number_of_columns() const { return m_number_of_columns; }

  /// returns the number of entries.
  std::size_t number_of_entries() const { return m_rows.starts.back(); }

  /// returns the columns of the entries of a row. \pre The row exists.
  Iterator_range<const Column*> columns(const std::size_t row) const
  {
    return part(m_rows.columns.get(), row);
  }

  /// returns the distances of the entries of a row, in the same order. \pre The row exists.
  Iterator_range<const T*> distances(const std::size_t row) const
  {
    return part(m_rows.distances.get(), row);
  }

  /// \name Row Sink
  /// @{

  /// the entries of a block of rows.
  using Block = internal::Sparse_block<T>;

  /// removes all rows.
  void start(const Distance_matrix_plan& plan)
  {
    m_rows = internal::Compressed_rows<T>();
    m_number_of_columns = plan.number_of_columns();
    m_rows_to_come = plan.number_of_rows();
    m_blocks.assign(plan.number_of_blocks(), Block());
  }

  /// stores a block.
  void add(const std::size_t number, Block& block)
  {
    m_blocks[number] = block; // copies without spare capacity
    block.clear();
  }

  /// concatenates all blocks.
  bool finish(const bool is_done) { return finish(is_done, false); }

  /// @}

protected:
  /// constructs a matrix without rows.
  Sparse_rows() = default;

  /// concatenates all blocks and, if `is_symmetric`, replaces each distance and its transpose by
  /// the smaller of the two. If an exception is thrown, there are no rows.
  bool finish(const bool is_done, const bool is_symmetric)
  {
    if(is_done)
    {
      internal::Compressed_rows<T> rows(m_rows_to_come, m_blocks);
      if(is_symmetric)
        rows.make_symmetric();
      m_rows = std::move(rows);
    }
    m_blocks.clear();
    return is_done;
  }

private:
  template <typename V>
  Iterator_range<const V*> part(const V* const values, const std::size_t row) const
  {
    CGAL_precondition(row < number_of_rows());
    return {values + m_rows.starts[row], values + m_rows.starts[row + 1]};
  }

  internal::Compressed_rows<T> m_rows;
  std::size_t m_number_of_columns = 0;
  std::size_t m_rows_to_come = 0;
  std::vector<Block> m_blocks; // until they are concatenated
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_SPARSE_ROWS_H
