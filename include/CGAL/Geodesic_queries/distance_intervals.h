// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_DISTANCE_INTERVALS_H
#define CGAL_GEODESIC_QUERIES_DISTANCE_INTERVALS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>

#include <algorithm>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicQueriesIntervals
 *
 * computes, for each vertex, an interval that contains its geodesic distance to the nearest source.
 *
 * A search with the bound \f$\varepsilon\f$ finds the length \f$d\f$ of a path that is at most
 * \f$1 + \varepsilon\f$ times as long as a shortest path. So the distance is in the interval
 * \f$[d/(1 + \varepsilon), d]\f$. Intervals are extended by a relative \f$10^{-12}\f$ for rounding;
 * with the bound `0`, they consist of the exact distance and this margin. With weights or barriers,
 * and sources that are not vertices, the lower end is reduced by
 * \f$(2 + \varepsilon)/(1 + \varepsilon)\f$ times the largest cost from a source to the nearest
 * corner of its face: see `Steiner_graph::cost_to_corner()` and
 * `Directional_graph::cost_to_corner()`. With `accept_weaker_bound`, \f$\varepsilon\f$ is the
 * guaranteed bound.
 *
 * If a vertex is not connected to a source, both ends are infinity. If a vertex was not reached
 * within `maximum_distance`, the upper end is infinity.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexIntervalMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type that
 *         is constructible from two numbers of type `double`, the lower and the upper end: for
 *         example `std::pair<double, double>`, or `CGAL::Interval_nt<>`
 * \tparam Sources as for `approximate_geodesic_distances()`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param intervals receives the intervals, in the unit of the mesh
 * \param sources a point of the surface, or a range of such points
 * \param np a sequence of \ref bgl_namedparameters "Named Parameters": `epsilon`, which is
 *           required, and those among `vertex_point_map`, `edge_length_map`, `face_weight_map`,
 *           `direction_to_source`, `edge_is_constrained_map`, `accept_weaker_bound`,
 *           `maximum_number_of_points`, `maximum_number_of_points_per_edge`, `initial_distances`,
 *           `maximum_distance`, `visitor`, `concurrency_tag`, `vertex_index_map`,
 *           `halfedge_index_map`, and `geom_traits` that `approximate_geodesic_distances()` reads
 *
 * \pre A visitor does not stop the run.
 *
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does. In
 *         this case, nothing is written.
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
      !internal::query_ignores_any<NamedParameters, internal_np::direction_to_source_t,
                                   internal_np::initial_distances_t,
                                   internal_np::maximum_distance_t, internal_np::visitor_t>,
      "distance_intervals() does not support one of these named parameters: its documentation "
      "lists the supported ones");
  using Interval = typename boost::property_traits<VertexIntervalMap>::value_type;

  const double limit = internal::maximum_distance(np);
  internal::search_once(tmesh, np, false, [&](auto& search) {
    search.run_from(sources, np);
    const auto& distances = search.search().search();
    const double epsilon = distances.graph().epsilon();
    double cost_to_corner = 0;
    for(const Source_point& source : search.source_points(sources))
      cost_to_corner =
          (std::max)(cost_to_corner, internal::cost_to_corner(distances.graph(), source.point));
    for(const auto v : vertices(tmesh))
    {
      const double upper = distances.distance(search.translation().node(v));
      const double lower =
          internal::smallest_distance((std::min)(upper, limit), epsilon, cost_to_corner);
      put(intervals, v, Interval(lower, upper * (1 + internal::rounding_of_distances)));
    }
  });
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_DISTANCE_INTERVALS_H
