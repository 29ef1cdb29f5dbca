// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_VISITOR_BASE_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_VISITOR_BASE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * The progress of the computation of a distance matrix.
 */
struct Distance_matrix_progress
{
  /// the number of rows of the matrix.
  std::size_t number_of_rows;

  /// the number of completed rows, including those of earlier runs and other processes.
  std::size_t number_done;

  /// the number of completed rows per second since the start of this run.
  double rows_per_second;

  /// the estimated number of seconds until completion, at the rate of this run.
  double seconds_left;
};

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * A visitor that does nothing. Derived classes only define the functions that they need. The
 * functions are not virtual: those of the derived class hide them.
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

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_VISITOR_BASE_H
