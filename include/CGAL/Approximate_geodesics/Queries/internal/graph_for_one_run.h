// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_GRAPH_FOR_ONE_RUN_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_GRAPH_FOR_ONE_RUN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Fixed_number_of_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Builds the graph that named parameters ask for, for a single run: one with weights and barriers
// if there are any, one with a bound if a bound is wanted, and else that of the edges.
template <typename TriangleMesh, typename NamedParameters>
auto graph_for_one_run(const TriangleMesh& tmesh, const NamedParameters& np)
{
  constexpr bool has_epsilon = is_given<NamedParameters, internal_np::epsilon_t>;
  constexpr bool has_number = is_given<NamedParameters, internal_np::number_of_points_per_edge_t>;
  constexpr bool has_weights = is_given<NamedParameters, internal_np::face_weight_t> ||
                               is_given<NamedParameters, internal_np::edge_is_constrained_t>;
  static_assert(!has_epsilon || !has_number,
                "epsilon and number_of_points_per_edge: only one of them can be given");

  Intrinsic_triangulation triangulation(tmesh, np);
  if constexpr(has_number)
    return Steiner_graph<Fixed_number_of_points>(std::move(triangulation), np);
  else if constexpr(has_weights && has_epsilon)
    return Steiner_graph<Geometric_points>(std::move(triangulation), np);
  else if constexpr(has_weights)
    return Steiner_graph<Fixed_number_of_points>(std::move(triangulation),
                                                 Fixed_number_of_points(0));
  else if constexpr(has_epsilon)
    return Lazy_discrete_geodesic_graph(std::move(triangulation), np);
  else
    return Edge_graph(std::move(triangulation), np);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_GRAPH_FOR_ONE_RUN_H
