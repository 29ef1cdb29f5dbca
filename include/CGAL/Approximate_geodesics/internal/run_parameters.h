// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_RUN_PARAMETERS_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_RUN_PARAMETERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/internal/Vertex_visitor.h>
#include <CGAL/Approximate_geodesics/internal/named_parameters.h>
#include <CGAL/number_utils.h>

#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Reads the named parameters that say how far a run goes.
template <typename Propagation, typename Vertices, typename NamedParameters>
typename Propagation::Stop_rule stop_rule(const Vertices& vertices, const NamedParameters& np)
{
  typename Propagation::Stop_rule result;
  result.maximum_distance = CGAL::to_double(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::maximum_distance), result.maximum_distance));
  if constexpr(is_given<NamedParameters, internal_np::targets_t>)
    for(const auto v : parameters::get_parameter(np, internal_np::targets))
      result.targets.push_back(vertices.node(v));
  return result;
}

// Runs `propagation` under the visitor that the named parameters give, if any.
template <typename Propagation, typename Vertices, typename NamedParameters>
void run(Propagation& propagation,
         const std::vector<typename Propagation::Seed>& seeds,
         const typename Propagation::Stop_rule& stop,
         const Vertices& vertices,
         const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
  {
    auto visitor = parameters::get_parameter(np, internal_np::visitor);
    propagation.run(seeds, stop, make_vertex_visitor(visitor, vertices));
  }
  else
    propagation.run(seeds, stop);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_RUN_PARAMETERS_H
