// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_RADIUS_ROWS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_RADIUS_ROWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/Sparse_rows.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * The distances up to `maximum_distance`, in memory. Columns ascend in each row.
 *
 * \tparam T the type of distances, `double` or `float`
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double>
class Radius_rows : public Sparse_rows<T>
{
  using Base = Sparse_rows<T>;

public:
  /// \name Row Sink
  /// @{

  using typename Base::Block;

  /// symmetric matrices are supported.
  static constexpr bool can_be_symmetric = true;

  /// removes all rows.
  void start(const Distance_matrix_plan& plan)
  {
    Base::start(plan);
    m_is_symmetric = plan.is_symmetric();
  }

  /// appends a row to a block.
  void collect(Block& block, const std::size_t row, const Distance_row& distances) const
  {
    block.append(row, distances.reached(), distances);
  }

  /// concatenates all blocks.
  bool finish(const bool is_done) { return Base::finish(is_done, m_is_symmetric); }

  /// @}

private:
  bool m_is_symmetric = false;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_RADIUS_ROWS_H
