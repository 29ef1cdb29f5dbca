// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_COST_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_COST_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * A directional cost: one of the predefined cost functions with its parameters and arrays. Unlike
 * arbitrary functions, it can be saved by a `Solver`.
 *
 * The constructor of `Solver` checks parameters and arrays.
 */
struct Solver_cost
{
  /// the cost functions.
  enum Model : std::uint8_t
  {
    HIKING_TIME,    ///< `Hiking_time`
    WALKING_ENERGY, ///< `Walking_energy`
    DRIFT_TIME,     ///< `Drift_time`
    ONE_WAY,        ///< `One_way`
    TENSOR_COST     ///< `Tensor_cost`
  };

  /// returns `Hiking_time`, with a factor for speeds.
  static Solver_cost hiking_time(const double factor = 1) { return {HIKING_TIME, {factor}, {}}; }

  /// returns `Walking_energy`.
  static Solver_cost walking_energy() { return {WALKING_ENERGY, {}, {}}; }

  /// returns `Drift_time`, with the velocities of the drift, three numbers per face, and the speed
  /// of the boat.
  static Solver_cost drift_time(std::vector<double> velocities, const double speed)
  {
    return {DRIFT_TIME, {speed}, std::move(velocities)};
  }

  /// returns `One_way`, with the directions of the faces, three numbers each, the cost in
  /// admissible directions, and the smallest cosine of the angle to an admissible direction.
  static Solver_cost
  one_way(std::vector<double> ways, const double cost = 1, const double smallest_cosine = 0)
  {
    return {ONE_WAY, {cost, smallest_cosine}, std::move(ways)};
  }

  /// returns `Tensor_cost`, with six numbers per face: the entries xx, xy, xz, yy, yz and zz.
  static Solver_cost tensor_cost(std::vector<double> tensors)
  {
    return {TENSOR_COST, {}, std::move(tensors)};
  }

  Model model;                    ///< the cost function
  std::vector<double> parameters; ///< the numerical arguments of its constructor
  std::vector<double> of_faces;   ///< three or six numbers per face, or none
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_COST_H
