// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRAPH_PARAMETERS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRAPH_PARAMETERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

// Reads the named parameter `epsilon`. Larger values than the largest useful bound are replaced by
// that, since they would overflow when multiplied.
template <typename NamedParameters>
double checked_epsilon(const NamedParameters& np)
{
  constexpr double by_default = 0.1, largest = 1e6;
  const double epsilon = value_of_number(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::epsilon), by_default));
  if(epsilon == 0)
    reject("epsilon is 0; exact distances are those of Saddle_vertex_graph, which supports neither "
           "weights nor barriers");
  return (std::min)(checked_positive(epsilon, "epsilon"), largest);
}

// Throws an error if costs depend on the direction, for graphs that do not support that.
inline void reject_directional_costs(const Intrinsic_triangulation& triangulation,
                                     const char* const name)
{
  if(triangulation.has_directional_costs())
    reject(std::string(name) + " does not support costs that depend on the direction, which the "
                               "triangulation has; use Directional_graph");
}

// Whether parameters are given that only placements with a bound read.
template <typename NamedParameters>
constexpr bool limits_points = is_any_given<NamedParameters,
                                            internal_np::maximum_number_of_points_per_edge_t,
                                            internal_np::accept_weaker_bound_t>;

// Returns the triangulation. Rejects weights, barriers and their parameters, for graphs other than
// Steiner graphs.
template <typename NamedParameters>
Intrinsic_triangulation without_weights(Intrinsic_triangulation triangulation,
                                        const NamedParameters& /* np */,
                                        const char* const name)
{
  static_assert(!is_given<NamedParameters, internal_np::face_weight_t>,
                "face_weight_map: this graph does not support weights; use Steiner_graph");
  static_assert(!is_given<NamedParameters, internal_np::max_slope_t>,
                "max_slope: this graph does not support it; use Directional_graph");
  static_assert(!is_given<NamedParameters, internal_np::edge_is_constrained_t>,
                "edge_is_constrained_map: this graph does not support barriers; use Steiner_graph");
  static_assert(!is_any_given<NamedParameters, internal_np::number_of_points_per_edge_t,
                              internal_np::nb_points_per_distance_unit_t,
                              internal_np::maximum_number_of_points_t>,
                "number_of_points_per_edge, number_of_points_per_distance_unit, "
                "maximum_number_of_points: this graph has no points on edges; use Steiner_graph");
  static_assert(!is_given<NamedParameters, internal_np::direction_to_source_t>,
                "direction_to_source: distances there and back are the same in this graph; use "
                "Directional_graph");
  reject_directional_costs(triangulation, name);
  static_assert(!limits_points<NamedParameters>,
                "maximum_number_of_points_per_edge, accept_weaker_bound: the bound of this graph "
                "holds on every mesh; they are for Steiner_graph");
  if(triangulation.has_weights() || triangulation.has_barriers())
    reject(std::string(name) + " does not support " +
           (triangulation.has_weights() ? "weights" : "barriers") +
           ", which the triangulation has; use Steiner_graph");
  return triangulation;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRAPH_PARAMETERS_H
