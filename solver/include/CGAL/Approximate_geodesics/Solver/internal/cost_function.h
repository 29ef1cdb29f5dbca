// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_COST_FUNCTION_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_COST_FUNCTION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/cost_functions.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_cost.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

// A type-erased cost function of a face index and a direction.
using Cost_function = std::function<double(std::size_t, const Simple_cartesian<double>::Vector_3&)>;

// A property map of face vectors, three numbers each.
struct Face_vectors
{
  const double* numbers;

  friend Simple_cartesian<double>::Vector_3 get(const Face_vectors& map, const std::size_t face)
  {
    const double* const v = map.numbers + 3 * face;
    return {v[0], v[1], v[2]};
  }
};

// A property map of face tensors, six numbers each.
struct Face_tensors
{
  const double* numbers;

  friend std::array<double, 6> get(const Face_tensors& map, const std::size_t face)
  {
    std::array<double, 6> result;
    std::copy_n(map.numbers + 6 * face, 6, result.begin());
    return result;
  }
};

inline void check_numbers_of_faces(const Solver_cost& cost, const std::size_t number_of_faces)
{
  const std::size_t per_face =
      cost.model == Solver_cost::TENSOR_COST                                        ? 6
      : cost.model == Solver_cost::DRIFT_TIME || cost.model == Solver_cost::ONE_WAY ? 3
                                                                                    : 0;
  if(cost.of_faces.size() != per_face * number_of_faces)
    reject("the costs have " + std::to_string(cost.of_faces.size()) + " numbers for " +
           std::to_string(number_of_faces) + " faces; there must be " + std::to_string(per_face) +
           " per face");
  for(std::size_t i = 0; i < cost.of_faces.size(); ++i)
    if(!std::isfinite(cost.of_faces[i]))
      reject("face " + std::to_string(i / per_face) + " has the number " +
             text_of(cost.of_faces[i]) + " in its cost; numbers must be finite");
}

inline Cost_function ready_function(const Solver_cost& cost)
{
  const double* const numbers = cost.of_faces.data();
  const auto parameter = [&](const std::size_t i) {
    if(i >= cost.parameters.size())
      reject("the costs have " + std::to_string(cost.parameters.size()) +
             " parameters, too few for their model");
    return cost.parameters[i];
  };
  switch(cost.model)
  {
  case Solver_cost::HIKING_TIME:
    return Hiking_time(parameter(0));
  case Solver_cost::WALKING_ENERGY:
    return Walking_energy();
  case Solver_cost::DRIFT_TIME:
    return Drift_time<Face_vectors>({numbers}, parameter(0));
  case Solver_cost::ONE_WAY:
    return One_way<Face_vectors>({numbers}, parameter(0), parameter(1));
  case Solver_cost::TENSOR_COST:
    return Tensor_cost<Face_tensors>({numbers});
  }
  reject("unknown cost model " + std::to_string(int(cost.model)));
}

// Returns an interruptible function, which refers to `cost`.
inline Cost_function cost_function(const Solver_cost& cost, const std::size_t number_of_faces)
{
  check_numbers_of_faces(cost, number_of_faces);
  const auto calls = std::make_shared<std::size_t>(0);
  return [calls, f = ready_function(cost)](const std::size_t face, const auto& direction) {
    constexpr std::size_t calls_between_looks = 1024;
    if(++*calls % calls_between_looks == 0)
      check_for_interruption();
    return f(face, direction);
  };
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_COST_FUNCTION_H
