// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_COST_GRAPHS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_COST_GRAPHS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Directional_graph.h>
#include <CGAL/Geodesic_costs/Directional_points.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_costs/equal_parts.h>
#include <CGAL/Geodesic_costs/internal/Steiner/limit_of_points.h>

#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The graphs that named parameters select which give costs, barriers, or points on edges.
 */
template <typename NamedParameters>
class Cost_graphs
{
  static constexpr bool has_epsilon = is_given<NamedParameters, internal_np::epsilon_t>;
  static constexpr bool has_number =
      is_given<NamedParameters, internal_np::number_of_points_per_edge_t>;

public:
  // Calls `f` with the graph, and returns the result.
  template <typename F>
  static auto with_graph(Intrinsic_triangulation triangulation, const NamedParameters& np, F& f)
  {
    static_assert(!has_epsilon || !has_number,
                  "epsilon and number_of_points_per_edge: only one of them can be given");
    if constexpr(has_directional_cost<NamedParameters>)
      return f(directional_graph(std::move(triangulation), np));
    else if constexpr(has_number == has_epsilon) // neither is given
      return f(Steiner_graph<Fixed_number_of_points>(std::move(triangulation),
                                                     Fixed_number_of_points(0)));
    else if constexpr(has_number)
      return f(Steiner_graph<Fixed_number_of_points>(std::move(triangulation), np));
    else
      return f(Steiner_graph<Geometric_points>(std::move(triangulation), np));
  }

  // Returns whether a graph may have the given number of points per edge.
  static bool is_in_limit(const Intrinsic_triangulation& triangulation, const NamedParameters& np)
  {
    return !has_more_points(triangulation, Fixed_number_of_points(np),
                            maximum_number_of_points(triangulation, maximum_number_of_points(np)));
  }

private:
  static auto directional_graph(Intrinsic_triangulation triangulation, const NamedParameters& np)
  {
    if constexpr(has_number)
      return Directional_graph<Fixed_number_of_points>(std::move(triangulation), np);
    else if constexpr(has_epsilon)
      return Directional_graph<Directional_points>(std::move(triangulation), np);
    else
      return Directional_graph<Fixed_number_of_points>(
          std::move(triangulation), Fixed_number_of_points(0),
          parameters::choose_parameter(
              parameters::get_parameter(np, internal_np::direction_to_source), false));
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_COST_GRAPHS_H
