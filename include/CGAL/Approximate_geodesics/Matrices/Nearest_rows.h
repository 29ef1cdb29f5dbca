// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_NEAREST_ROWS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_NEAREST_ROWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/Sparse_rows.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/nearest_columns.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * The smallest distances of each row, in memory: the distances to the nearest targets, including
 * the source itself if it is a target. They ascend in each row; ties are broken by column. A row
 * has fewer entries if the search reaches fewer columns.
 *
 * If all targets are vertices, the search for a row ends as soon as its entries are known.
 *
 * \tparam T the type of distances, `double` or `float`
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double>
class Nearest_rows : public Sparse_rows<T>
{
public:
  /// constructs a sink for up to `number` entries per row. \pre `number > 0`
  explicit Nearest_rows(const std::size_t number)
    : m_number(internal::checked_number_of_nearest(number))
  {
  }

  /// \name Row Sink
  /// @{

  using typename Sparse_rows<T>::Block;

  /// returns the maximum number of entries per row.
  std::size_t number_of_nearest() const { return m_number; }

  /// appends a row to a block.
  void collect(Block& block, const std::size_t row, const Distance_row& distances) const
  {
    block.append(row, internal::nearest_columns(distances, m_number), distances);
  }

  /// @}

private:
  std::size_t m_number;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_NEAREST_ROWS_H
