// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_RUN_PARAMETERS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_RUN_PARAMETERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_visitor.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>
#include <CGAL/number_utils.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Reads the named parameters that say how far a run goes.
template <typename Search, typename MeshPlaces, typename NamedParameters>
typename Search::Stop_rule stop_rule(const typename Search::Search::Graph& graph,
                                     const MeshPlaces& places,
                                     const NamedParameters& np)
{
  typename Search::Stop_rule result;
  result.maximum_distance = CGAL::to_double(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::maximum_distance), result.maximum_distance));
  if constexpr(is_given<NamedParameters, internal_np::targets_t>)
    for(const auto& target : parameters::get_parameter(np, internal_np::targets))
      add_target(result, graph, places.place(target));
  return result;
}

// Runs a search under the visitor that the named parameters give, if any.
template <typename Search, typename Vertices, typename NamedParameters>
void run(Search& search,
         std::vector<Source> sources,
         const typename Search::Stop_rule& stop,
         const Vertices& vertices,
         const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
  {
    auto visitor = parameters::get_parameter(np, internal_np::visitor);
    search.run(std::move(sources), stop, make_vertex_visitor(visitor, vertices));
  }
  else
    search.run(std::move(sources), stop, Geodesic_visitor_base());
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_RUN_PARAMETERS_H
