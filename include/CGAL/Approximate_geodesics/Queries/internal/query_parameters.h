// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_QUERY_PARAMETERS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_QUERY_PARAMETERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Returns a graph with a bound, which is `0` for an exact one.
template <typename Graph, typename ConcurrencyTag>
Graph graph_with_epsilon(Intrinsic_triangulation triangulation, const double epsilon)
{
  return Graph(std::move(triangulation),
               parameters::epsilon(epsilon).concurrency_tag(ConcurrencyTag()));
}

// Returns the exact graph of a mesh, for queries that are always exact.
template <typename TriangleMesh, typename NamedParameters>
Saddle_vertex_graph exact_graph(const TriangleMesh& tmesh, const NamedParameters& np)
{
  return graph_with_epsilon<Saddle_vertex_graph, Concurrency_tag<NamedParameters>>(
      Intrinsic_triangulation(tmesh, np), 0);
}

// Whether a query that reads the parameters of meshes and graphs, and `Read`, ignores a parameter.
template <typename NamedParameters, typename... Read>
constexpr bool query_ignores_any = ignores_any<NamedParameters,
                                               internal_np::edge_length_t,
                                               internal_np::face_weight_t,
                                               internal_np::max_slope_t,
                                               internal_np::edge_is_constrained_t,
                                               internal_np::epsilon_t,
                                               internal_np::number_of_points_per_edge_t,
                                               internal_np::maximum_number_of_points_t,
                                               internal_np::maximum_number_of_points_per_edge_t,
                                               internal_np::accept_weaker_bound_t,
                                               Read...>;

// Whether paths run across faces.
template <typename NamedParameters>
constexpr bool needs_faces =
    has_costs<NamedParameters> || is_any_given<NamedParameters,
                                               internal_np::epsilon_t,
                                               internal_np::number_of_points_per_edge_t,
                                               internal_np::straighten_t>;

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
             std::to_string(sources.size()) + " sources; there must be one for each of them");
  }
}

// Calls a function with the graph that costs, barriers, or points on edges select. It is defined in
// the package of costs.
template <typename NamedParameters>
class Cost_graphs;

// Calls `f` with a graph for the named parameter `epsilon`. If its value is known at compile time,
// only one graph is instantiated.
template <typename GraphWithBound, typename ExactTag, typename NamedParameters, typename F>
auto with_epsilon(Intrinsic_triangulation triangulation, const NamedParameters& np, const F& f)
{
  static_assert(!is_given<NamedParameters, internal_np::direction_to_source_t>,
                "direction_to_source: distances there and back are the same in this graph; use "
                "Directional_graph");
  using Tag = Concurrency_tag<NamedParameters>;
  const auto number = parameters::get_parameter(np, internal_np::epsilon);
  using Number = std::decay_t<decltype(number)>;
  if constexpr(is_zero<Number>)
    return f(graph_with_epsilon<Saddle_vertex_graph, ExactTag>(std::move(triangulation), 0));
  else
  {
    const double epsilon = value_of_number(number);
    if constexpr(!is_nonzero<Number>)
      if(epsilon == 0)
        return f(
            graph_with_epsilon<Saddle_vertex_graph, ExactTag>(std::move(triangulation), epsilon));
    return f(graph_with_epsilon<GraphWithBound, Tag>(std::move(triangulation), epsilon));
  }
}

// Calls `f` with the graph that the named parameters select: a graph with weights and barriers if
// there are any; otherwise, if `epsilon` is given, a graph of the given type, or the exact graph,
// whose searches are parallel as the tag says; otherwise the edge graph. Returns the result of `f`.
template <typename GraphWithBound,
          typename NamedParameters,
          typename F,
          typename ExactTag = Concurrency_tag<NamedParameters>>
auto with_graph_on(Intrinsic_triangulation triangulation,
                   const NamedParameters& np,
                   F f,
                   ExactTag /* tag */ = ExactTag())
{
  constexpr bool has_epsilon = is_given<NamedParameters, internal_np::epsilon_t>;
  constexpr bool has_number = is_given<NamedParameters, internal_np::number_of_points_per_edge_t>;
  constexpr bool has_weights = has_costs<NamedParameters>;
  static_assert((has_weights && has_epsilon) || !limits_points<NamedParameters>,
                "maximum_number_of_points_per_edge, accept_weaker_bound: they are for epsilon with "
                "weights or barriers; any other bound holds on every mesh");
  static_assert((has_weights && has_epsilon) || has_number ||
                    !is_given<NamedParameters, internal_np::maximum_number_of_points_t>,
                "maximum_number_of_points: it is for number_of_points_per_edge, and for epsilon "
                "with weights or barriers; other graphs have no points on edges");

  if constexpr(has_weights || has_number)
  {
    using Graphs = Cost_graphs<NamedParameters>;
    check_costs<NamedParameters, is_defined<Graphs>>();
    if constexpr(is_defined<Graphs>)
      return Graphs::with_graph(std::move(triangulation), np, f);
  }
  else if constexpr(has_epsilon)
    return with_epsilon<GraphWithBound, ExactTag>(std::move(triangulation), np, f);
  else
    return f(Edge_graph(std::move(triangulation), np));
}

// Reads a mesh, and calls `f` with the graph that the named parameters select.
template <typename GraphWithBound,
          typename TriangleMesh,
          typename NamedParameters,
          typename F,
          typename ExactTag = Concurrency_tag<NamedParameters>>
auto with_graph(const TriangleMesh& tmesh,
                const NamedParameters& np,
                F f,
                ExactTag tag = ExactTag())
{
  return with_graph_on<GraphWithBound>(Intrinsic_triangulation(tmesh, np), np, f, tag);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_QUERY_PARAMETERS_H
