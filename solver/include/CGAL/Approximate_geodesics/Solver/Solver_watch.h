// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WATCH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WATCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>
#include <functional>
#include <stdexcept>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * The callbacks of a `Solver`, which are called about 30 times per second, always in the calling
 * thread. Both may be empty.
 */
struct Solver_watch
{
  /// returns whether to continue. Otherwise the call throws `Solver_interrupted`.
  std::function<bool()> go_further;

  /// receives the number of completed steps and their total: vertices of a search or of a graph
  /// under construction, rows of a matrix, or points of a sample. It is not called if the total is
  /// 0.
  std::function<void(std::size_t, std::size_t)> on_progress;
};

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * The exception that a `Solver` throws if a watch ends a call. The solver is unchanged.
 */
struct Solver_interrupted : std::runtime_error
{
  /// constructs the exception.
  Solver_interrupted() : std::runtime_error("Approximate_geodesics: the run was interrupted") {}
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WATCH_H
