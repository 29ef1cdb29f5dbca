// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_DISTANCE_INTERVALS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_DISTANCE_INTERVALS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/smallest_distance.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// What a graph says that a bound between vertices has to be extended by for another point.
template <typename Graph>
auto cost_to_corner(const Graph& graph, const Intrinsic_point& point, int /* preferred */)
    -> decltype(graph.cost_to_corner(point))
{
  return graph.cost_to_corner(point);
}
template <typename Graph>
double cost_to_corner(const Graph& /* graph */, const Intrinsic_point& /* point */, long)
{
  return 0;
}

// Of the sources, the one that is farthest from all vertices, if that matters to the bound.
template <typename Graph>
double largest_cost_to_corner(const Graph& graph, const std::vector<Source_point>& sources)
{
  double result = 0;
  for(const Source_point& source : sources)
  {
    const double cost = graph.unit() * cost_to_corner(graph, source.point, 0);
    if(!std::isinf(cost))
      result = (std::max)(result, cost);
  }
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * computes, for each vertex, an interval that contains its geodesic distance to the nearest source.
 *
 * A search with the bound \f$\varepsilon\f$ finds the length \f$d\f$ of a path that is at most
 * \f$1 + \varepsilon\f$ times as long as the shortest one; so that one has a length between
 * \f$d/(1 + \varepsilon)\f$ and \f$d\f$. With the bound `0`, the interval is the exact distance,
 * give or take \f$10^{-12}\f$ of it, by which all intervals are extended for rounding. With weights
 * or barriers, and sources that are not vertices, the lower end is smaller by
 * \f$(2 + \varepsilon)/(1 + \varepsilon)\f$ times the largest cost from a source to the nearest
 * corner of its face: see `Steiner_graph::cost_to_corner()`, and that of `Directional_graph`. With
 * `accept_weaker_bound`, \f$\varepsilon\f$ is the bound that does hold.
 *
 * A vertex that no path connects with a source has the distance infinity; so both ends are
 * infinity. One that was not reached within `maximum_distance` has an interval without upper end.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexIntervalMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type that
 *         is made of two numbers of type `double`, the lower and the upper end: for example
 *         `std::pair<double, double>`, or `CGAL::Interval_nt<>`
 * \tparam Sources as for `approximate_geodesic_distances()`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param intervals receives the intervals, in the unit of the mesh
 * \param sources a vertex, another point of the surface, or a range of them
 * \param np a sequence of \ref bgl_namedparameters "Named Parameters": `epsilon`, which has to be
 *           given, and those among `vertex_point_map`, `edge_length_map`, `face_weight_map`,
 *           `direction_to_source`, `edge_is_constrained_map`, `accept_weaker_bound`,
 * `maximum_number_of_points`, `maximum_number_of_points_per_edge`, `initial_distances`,
 * `maximum_distance`, `visitor`, `concurrency_tag`, `vertex_index_map`, `halfedge_index_map`, and
 * `geom_traits` that `approximate_geodesic_distances()` reads
 *
 * \pre A visitor does not end the run.
 *
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does;
 *         nothing has been written then.
 *
 * Run time and memory are those of `approximate_geodesic_distances()`.
 *
 * \sa `approximate_geodesic_distances()`
 */
template <typename TriangleMesh,
          typename VertexIntervalMap,
          typename Sources,
          typename NamedParameters>
void distance_intervals(const TriangleMesh& tmesh,
                        VertexIntervalMap intervals,
                        const Sources& sources,
                        const NamedParameters& np)
{
  static_assert(internal::is_given<NamedParameters, internal_np::epsilon_t>,
                "distance_intervals() needs epsilon, the error bound: 0 for exact distances");
  static_assert(
      !internal::ignores_any<NamedParameters, internal_np::epsilon_t,
                             internal_np::maximum_number_of_points_t,
                             internal_np::maximum_number_of_points_per_edge_t,
                             internal_np::accept_weaker_bound_t, internal_np::edge_length_t,
                             internal_np::face_weight_t, internal_np::direction_to_source_t,
                             internal_np::edge_is_constrained_t, internal_np::initial_distances_t,
                             internal_np::maximum_distance_t, internal_np::visitor_t>,
      "distance_intervals() does not read one of these named parameters: its documentation lists "
      "those that it does");
  using Interval = typename boost::property_traits<VertexIntervalMap>::value_type;

  const double limit = CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_distance),
                                   std::numeric_limits<double>::infinity()));
  internal::search_once(tmesh, np, false, [&](auto& search) {
    search.run_from(sources, np);
    const auto& distances = search.search().search();
    const double epsilon = distances.graph().epsilon();
    const double cost_to_corner =
        internal::largest_cost_to_corner(distances.graph(), search.source_points(sources));
    for(const auto v : vertices(tmesh))
    {
      const double upper = distances.distance(search.translation().node(v));
      const double lower =
          internal::smallest_distance((std::min)(upper, limit), epsilon, cost_to_corner);
      put(intervals, v, Interval(lower, upper * (1 + internal::rounding_of_distances)));
    }
  });
}

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_DISTANCE_INTERVALS_H
