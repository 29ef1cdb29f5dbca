// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_GRID_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_GRID_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Array_costs.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/Grid_vector.h>
#include <CGAL/Iterator_range.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

using Slope_function = std::function<double(double)>;

// Samples of a function of the slope, at multiples of a step, from the steepest descent on. It is
// only called for these slopes.
class Sampled_slopes
{
public:
  explicit Sampled_slopes(const std::vector<double>& costs) : m_costs(costs)
  {
    if(costs.size() != NUMBER)
      reject("there are " + std::to_string(costs.size()) + " costs by slope; there must be " +
             std::to_string(NUMBER));
  }

  double operator()(const double slope) const
  {
    return m_costs[static_cast<std::size_t>(std::lround(slope * PER_UNIT) +
                                            static_cast<long>(NUMBER / 2))];
  }

private:
  static constexpr double PER_UNIT = Grid_solver_options::SLOPES_PER_UNIT;
  static constexpr std::size_t NUMBER = Grid_solver_options::NUMBER_OF_SLOPES;

  std::vector<double> m_costs;
};

// Returns the cost by slope; none if the model is of cell and direction.
inline Slope_function slope_function(const Grid_solver_options& options)
{
  if(!options.slope_costs.empty())
    return Sampled_slopes(options.slope_costs);
  if(!options.cost)
    return {};
  const Solver_cost& cost = *options.cost;
  switch(cost.model)
  {
  case Solver_cost::HIKING_TIME:
    return Hiking_time(parameter_of(cost, 0));
  case Solver_cost::WALKING_ENERGY:
    return Walking_energy();
  case Solver_cost::NAISMITH_TIME:
    return Naismith_time(parameter_of(cost, 0), parameter_of(cost, 1));
  default:
    return {};
  }
}

// Returns a function of cell and direction, which owns its numbers.
inline auto cell_function(const Grid_shape& shape, const Solver_cost& cost)
{
  if(cost.model == Solver_cost::SAMPLED_COST)
    reject("costs that are sampled in faces are not for grids");
  check_numbers_of_faces(cost, shape.number_of_cells(), "cell");
  const auto owned = std::make_shared<Solver_cost>(cost);
  return [owned, shape, f = ready_function(*owned)](const Grid_cell& cell, const Grid_vector& d) {
    return f(shape.index(cell), Face_vector(d.x(), d.y(), d.z()));
  };
}

template <typename FrictionRange>
Grid_graph make_grid_graph(const Grid_shape& shape,
                           const FrictionRange& friction,
                           const Grid_solver_options& options)
{
  const Slope_function by_slope = slope_function(options);
  const bool has_costs = by_slope || options.cost;
  if(options.epsilon && (has_costs || options.heights != nullptr))
    reject("epsilon is given, and there is no bound with heights or costs; only with friction");
  if(options.epsilon)
    return Grid_graph(shape, friction, parameters::epsilon(*options.epsilon));
  if(options.heights == nullptr)
  {
    if(!(options.max_slope == infinity))
      reject("max_slope is given, and there are no heights");
    if(by_slope)
      reject("the costs depend on the slope, and there are no heights");
    if(!has_costs)
      return Grid_graph(shape, friction);
    return Grid_graph(shape, friction,
                      parameters::face_weight_map(Approximate_geodesics::directional_cost(
                          cell_function(shape, *options.cost))));
  }
  const auto heights =
      parameters::heights(
          CGAL::make_range(options.heights, options.heights + shape.number_of_cells()))
          .max_slope(options.max_slope);
  if(by_slope)
    return Grid_graph(shape, friction,
                      heights.face_weight_map(Approximate_geodesics::directional_cost(by_slope)));
  if(has_costs)
    return Grid_graph(shape, friction,
                      heights.face_weight_map(Approximate_geodesics::directional_cost(
                          cell_function(shape, *options.cost))));
  return Grid_graph(shape, friction, heights);
}

inline Grid_graph make_grid_graph(const Grid_shape& shape, const Grid_solver_options& options)
{
  if(options.friction == nullptr)
    return make_grid_graph(shape, 1, options);
  const std::size_t number = shape.number_of_cells();
  return make_grid_graph(shape, CGAL::make_range(options.friction, options.friction + number),
                         options);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_MAKE_GRID_GRAPH_H
