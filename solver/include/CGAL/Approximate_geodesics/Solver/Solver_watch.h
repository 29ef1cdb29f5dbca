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

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * What a `Solver` calls while it is at work, about 30 times a second, and always in the thread that
 * called it. Both functions can be left empty.
 */
struct Solver_watch
{
  /// returns whether to go on. If not, the call of the solver ends with `Solver_interrupted`.
  std::function<bool()> go_further;

  /// receives how many pieces of work are done, and how many there are: vertices of a search or of
  /// a graph with a bound that is built, rows of a matrix, or points of a sample. It is not called
  /// if there are none.
  std::function<void(std::size_t, std::size_t)> on_progress;
};

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * What a `Solver` throws if a watch has ended a call. The solver is as it was before.
 */
struct Solver_interrupted : std::runtime_error
{
  /// says that the call was ended.
  Solver_interrupted() : std::runtime_error("Approximate_geodesics: the run was interrupted") {}
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_WATCH_H
