// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_QUERY_PARAMETERS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_QUERY_PARAMETERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// For constructors, which do not run a search.
template <typename NamedParameters>
constexpr void refuse_run_parameters()
{
  static_assert(
      !ignores_any<NamedParameters, internal_np::epsilon_t, internal_np::maximum_number_of_points_t,
                   internal_np::maximum_number_of_points_per_edge_t,
                   internal_np::accept_weaker_bound_t, internal_np::number_of_points_per_edge_t,
                   internal_np::nb_points_per_distance_unit_t, internal_np::edge_length_t,
                   internal_np::face_weight_t, internal_np::direction_to_source_t,
                   internal_np::edge_is_constrained_t>,
      "the constructor does not run: maximum_distance, targets and visitor are for "
      "build_sequence_tree(), straighten is for a path, initial distances go with sources");
}

template <typename NamedParameters>
double maximum_distance(const NamedParameters& np)
{
  return CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_distance),
                                   std::numeric_limits<double>::infinity()));
}

// Reads the named parameters that limit a run.
template <typename StopRule, typename Translation, typename NamedParameters>
StopRule stop_rule(const Translation& translation, const NamedParameters& np)
{
  StopRule result;
  result.maximum_distance = maximum_distance(np);
  if constexpr(is_given<NamedParameters, internal_np::targets_t>)
    result.targets = intrinsic_points(
        translation, parameters::get_parameter(np, internal_np::targets), "target");
  return result;
}

// Reads the initial distances of sources or seeds.
template <typename NamedParameters, typename Source>
void set_initial_distances([[maybe_unused]] const NamedParameters& np,
                           [[maybe_unused]] std::vector<Source>& sources)
{
  if constexpr(is_given<NamedParameters, internal_np::initial_distances_t>)
  {
    std::size_t number = 0;
    for(const auto& distance : parameters::get_parameter(np, internal_np::initial_distances))
    {
      if(number < sources.size())
        sources[number].distance = CGAL::to_double(distance);
      ++number;
    }
    if(number != sources.size())
      reject("there are " + std::to_string(number) + " initial distances, and " +
             std::to_string(sources.size()) + " sources");
  }
}

// Straightens a path if the named parameters request it.
template <typename NamedParameters>
void straighten_if_wanted([[maybe_unused]] const Intrinsic_triangulation& triangulation,
                          [[maybe_unused]] const NamedParameters& np,
                          [[maybe_unused]] Path& path)
{
  if constexpr(is_given<NamedParameters, internal_np::straighten_t>)
    if(parameters::get_parameter(np, internal_np::straighten))
    {
      if(triangulation.has_weights() || triangulation.has_directional_costs())
        reject("paths on weighted faces cannot be straightened: cheapest paths are not straight");
      Path straight = Path_straightener(triangulation).shortened(path);
      if(straight.length < path.length)
        path = std::move(straight);
    }
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_QUERY_PARAMETERS_H
