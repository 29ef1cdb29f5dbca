// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_FARTHEST_POINT_SAMPLING_H
#define CGAL_GEODESIC_CONSTRUCTIONS_FARTHEST_POINT_SAMPLING_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <array>
#include <cstddef>
#include <queue>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

template <typename TriangleMesh>
using No_vertices = std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 0>;

// Chooses candidates, which have the nodes `node(i)`, and calls `add(i)` for each of them. Returns
// the covering radius. Keys of the queue are updated lazily when an entry gets to the top:
// distances decrease over time, so a stored distance is an upper bound.
template <typename Graph, typename NodeOf, typename F>
double sample_farthest(const Graph& graph,
                       const std::vector<Intrinsic_point>& sources,
                       const std::size_t number_of_candidates,
                       const std::size_t number_of_points,
                       const NodeOf& node,
                       F add)
{
  Propagation<Graph> search(graph);
  std::vector<Seed> seeds;
  for(const Intrinsic_point& source : sources)
    seeds.push_back({source.vertex});
  search.run(seeds);

  using Entry = std::pair<double, std::size_t>; // with `~i`: among equal distances, the first one
  std::priority_queue<Entry> queue;
  for(std::size_t i = 0; i < number_of_candidates; ++i)
    queue.emplace(infinity, ~i);
  const auto find_farthest = [&] {
    while(!queue.empty())
    {
      const Entry top = queue.top();
      const double distance = search.distance(node(~top.second));
      if(distance == top.first)
        return top;
      queue.pop();
      queue.emplace(distance, top.second);
    }
    return Entry(0, 0);
  };
  Entry farthest = find_farthest();
  for(std::size_t i = 0; i < number_of_points && farthest.first > 0; ++i)
  {
    search.run_further({{node(~farthest.second)}});
    add(~farthest.second);
    farthest = find_farthest();
  }
  return farthest.first;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsFields
 *
 * chooses vertices that are evenly distributed on the surface: each chosen vertex has the largest
 * distance from the sources and from all vertices chosen before.
 *
 * The distance of an unconnected component of the mesh, including an isolated vertex, is infinite:
 * each component gets a point before any gets a second one. Ties are broken by the order of
 * `vertices(tmesh)`.
 *
 * If paths follow edges, and there are no sources, the covering radius is at most twice the optimum
 * for the same number of vertices.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam OutputIterator a model of `OutputIterator` that takes
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
 * \tparam Integer an integer type
 * \tparam Sources `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, or a model of
 *         `ConstRange` with that value type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param points receives the points, in the order in which they are chosen
 * \param number_of_points the number of points. Fewer are chosen if all distances are zero, hence
 *        at most as many as there are vertices.
 * \param sources a vertex, or a range of vertices, treated as if chosen before; they are not
 *        written to `points`. If there are none, the first point is the first vertex. They can be
 *        omitted: named parameters then follow the number of points.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map`, `edge_length_map`, `epsilon`, `maximum_number_of_points`,
 *           `maximum_number_of_points_per_edge`, `accept_weaker_bound`,
 *           `number_of_points_per_edge`, `face_weight_map`, `edge_is_constrained_map`,
 *           `vertex_index_map`, `halfedge_index_map` and `geom_traits`, as for
 *           `approximate_geodesic_distances()`, and `concurrency_tag`, as for
 *           `Discrete_geodesic_graph`, which is used if `epsilon` is given
 *
 * \return the covering radius: the largest distance of a vertex from the nearest source or point.
 *         It is infinite if a connected component of the mesh has neither, and `0` if there are no
 *         vertices.
 *
 * \throws std::invalid_argument if `number_of_points` is negative.
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does. In
 *         all cases, nothing is written.
 *
 * The first points require a search of the whole mesh each; every further point requires a search
 * of its own Voronoi cell only. In total, \f$k\f$ points cost about as much as \f$\log k\f$
 * searches.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `voronoi_partition()`
 */
template <typename TriangleMesh,
          typename OutputIterator,
          typename Integer,
          typename Sources = internal::No_vertices<TriangleMesh>,
          typename NamedParameters = parameters::Default_named_parameters>
double farthest_point_sampling(const TriangleMesh& tmesh,
                               OutputIterator points,
                               const Integer number_of_points,
                               const Sources& sources = Sources(),
                               const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::is_named_parameters<Sources>) // sources are omitted
    return farthest_point_sampling(tmesh, points, number_of_points,
                                   internal::No_vertices<TriangleMesh>(), sources);
  else
  {
    static_assert(
        !internal::query_ignores_any<NamedParameters>,
        "farthest_point_sampling() reads epsilon, number_of_points_per_edge, and parameters that "
        "describe the mesh only; it always searches the whole mesh");
    static_assert(internal::are_vertices<TriangleMesh, Sources>,
                  "farthest_point_sampling() takes a vertex or a range of vertices as sources");

    static_assert(std::is_integral_v<Integer>,
                  "farthest_point_sampling() takes the output iterator, then the number of points");
    if constexpr(std::is_signed_v<Integer>)
      if(number_of_points < 0)
        internal::reject("the number of points is " + std::to_string(number_of_points) +
                         "; it must not be negative");
    // precomputing all arcs pays off for ten or more points
    return internal::with_graph<Discrete_geodesic_graph>(tmesh, np, [&](const auto& graph) {
      const Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np),
                                         graph.triangulation());
      const std::vector candidates(vertices(tmesh).begin(), vertices(tmesh).end());
      return internal::sample_farthest(
          graph, internal::intrinsic_points(translation, sources, "source"), candidates.size(),
          static_cast<std::size_t>(number_of_points),
          [&](const std::size_t i) { return translation.node(candidates[i]); },
          [&](const std::size_t i) { *points++ = candidates[i]; });
    });
  }
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_FARTHEST_POINT_SAMPLING_H
