// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_VISITOR_BASE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_VISITOR_BASE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * How far the computation of a distance matrix is.
 */
struct Distance_matrix_progress
{
  /// the number of rows of the matrix.
  std::size_t number_of_rows;

  /// the number of those that are done, by an earlier run or another process included.
  std::size_t number_done;

  /// the rows done per second since this run has started.
  double rows_per_second;

  /// the seconds until all rows are done, if the rest takes as long as those of this run.
  double seconds_left;
};

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * A visitor that does nothing. A class derived from it has to define only the functions that it
 * needs; these hide those below, which are not virtual.
 *
 * \cgalModels{DistanceMatrixVisitor}
 */
struct Distance_matrix_visitor_base
{
  /// does nothing.
  void on_progress(const Distance_matrix_progress& /* progress */) {}

  /// returns `true`.
  bool go_further() { return true; }
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_VISITOR_BASE_H
