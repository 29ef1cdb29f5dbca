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

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * A distance matrix in memory, of which only some entries are kept, as compressed sparse rows. An
 * entry takes `4 + sizeof(T)` bytes: what `Radius_rows` and `Nearest_rows` have in common.
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

  /// returns the number of rows; `0` if they were not completed.
  std::size_t number_of_rows() const { return m_rows.starts.size() - 1; }

  /// returns the number of columns.
  std::size_t number_of_columns() const { return m_number_of_columns; }

  /// returns the number of entries.
  std::size_t number_of_entries() const { return m_rows.starts.back(); }

  /// returns the columns of a row's entries. \pre The row exists.
  Iterator_range<const Column*> columns(const std::size_t row) const
  {
    return part(m_rows.columns.get(), row);
  }

  /// returns the distances of a row's entries, in the same order. \pre The row exists.
  Iterator_range<const T*> distances(const std::size_t row) const
  {
    return part(m_rows.distances.get(), row);
  }

  /// \name What a Sink Does
  /// @{

  /// the entries of some rows.
  using Block = internal::Sparse_block<T>;

  /// forgets all rows.
  void start(const Distance_matrix_plan& plan)
  {
    m_rows = internal::Compressed_rows<T>();
    m_number_of_columns = plan.number_of_columns();
    m_rows_to_come = plan.number_of_rows();
    m_blocks.assign(plan.number_of_blocks(), Block());
  }

  /// keeps a block.
  void add(const std::size_t number, Block& block)
  {
    m_blocks[number] = block; // without the room that it has to grow
    block.clear();
  }

  /// puts all blocks together.
  bool finish(const bool is_done) { return finish(is_done, false); }

  /// @}

protected:
  /// no rows.
  Sparse_rows() = default;

  /// puts all blocks together, and replaces each distance by the smaller one of both directions if
  /// that is wanted. There are no rows if that fails.
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
  std::vector<Block> m_blocks; // until they are put together
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_SPARSE_ROWS_H
