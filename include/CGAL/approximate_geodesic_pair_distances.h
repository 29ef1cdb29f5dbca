// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESIC_PAIR_DISTANCES_H
#define CGAL_APPROXIMATE_GEODESIC_PAIR_DISTANCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>
#include <CGAL/Geodesic_queries/internal/compiled_matrices.h>
#include <CGAL/Geodesic_queries/internal/find_pairs.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics::internal {

// Writes the distances of pairs, unless the visitor stopped the computation.
template <typename Graph, typename OutputIterator, typename NamedParameters>
bool write_pair_distances(const Graph& graph,
                          const std::vector<Point_pair>& pairs,
                          OutputIterator distances,
                          const NamedParameters& np)
{
  const auto find = [](const Surface_search<Graph>& search, const Intrinsic_point& p) {
    return search.distance(p);
  };
  Workspaces<Surface_search<Graph>> workspaces(graph);
  const auto found = find_pairs(graph, workspaces, pairs, np, find);
  if(found)
    std::copy(found->begin(), found->end(), distances);
  return found.has_value();
}

} // namespace Approximate_geodesics::internal

/*!
 * \ingroup PkgGeodesicQueriesPairs
 *
 * computes approximate geodesic distances between pairs of points.
 *
 * Pairs with the same source share a search, which ends when the distances of their targets are
 * final. So it is best if there are fewer different sources than targets.
 *
 * The distance of a pair is bitwise identical to that of a search from its source with its target
 * as the only target, by `Approximate_geodesics::Surface_search::run()`, except for the cases in
 * section \ref AG_same_bits. It depends neither on other pairs nor on the number of threads.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam PairRange a model of `ConstRange` with a `std::pair` as value type, of two points of type
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`,
 *         `Approximate_geodesics::Face_location`, or `Approximate_geodesics::Surface_point`
 * \tparam OutputIterator a model of `OutputIterator` that takes values of type `double`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed. Instead, a model of `SurfaceGraph` can be
 *        given, with pairs of `Approximate_geodesics::Intrinsic_point`s.
 * \param pairs the sources and the targets; duplicates are allowed
 * \param distances receives one distance per pair, in the order of the pairs and in the unit of the
 *        mesh: from the source to the target if costs depend on the direction, and infinity if
 *        there is no path
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
 * `maximum_distance`, `concurrency_tag`, and `visitor`, as for
 * `approximate_geodesic_distance_matrix()`, where a row is a source; and, with a mesh, the
 * parameters of meshes and graphs that this function reads, except for `direction_to_source`
 *
 * \return whether distances were written: if the visitor stopped the computation, none is.
 *
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does; the
 *         message gives the position of an invalid pair. Nothing is written then.
 *
 * The run time is that of a search per different source, and of building the graph, which is that
 * of `approximate_geodesic_distance_matrix()`. Each thread needs a workspace of 40 bytes per node.
 *
 * \sa `approximate_geodesic_distance_matrix()`
 */
template <typename TriangleMesh,
          typename PairRange,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
bool approximate_geodesic_pair_distances(const TriangleMesh& tmesh,
                                         const PairRange& pairs,
                                         OutputIterator distances,
                                         const NamedParameters& np = parameters::default_values())
{
  namespace AG = Approximate_geodesics;
  if constexpr(AG::internal::is_surface_graph<TriangleMesh>)
  {
    static_assert(!AG::internal::ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                             internal_np::visitor_t>,
                  "approximate_geodesic_pair_distances() with a graph reads maximum_distance, "
                  "concurrency_tag and visitor; pass the others to the graph");
    return AG::internal::write_pair_distances(tmesh, {pairs.begin(), pairs.end()}, distances, np);
  }
  else
  {
    using Pair = AG::internal::Element_of_range<PairRange>;
    constexpr bool are_pairs = AG::internal::is_pair_of_points<TriangleMesh, Pair>;
    static_assert(are_pairs, "pairs: a range of std::pair, of two vertex descriptors, "
                             "Face_locations or Surface_points");
    static_assert(!AG::internal::query_ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                                   internal_np::visitor_t>,
                  "approximate_geodesic_pair_distances() does not read one of these named "
                  "parameters: its documentation lists the supported ones");
    if constexpr(are_pairs)
      return AG::internal::with_graph<AG::Discrete_geodesic_graph>(
          tmesh, np,
          [&](const auto& graph) {
            const AG::Mesh_translation translation(tmesh, AG::internal::vertex_index_map(tmesh, np),
                                                   graph.triangulation());
            return AG::internal::write_pair_distances(
                graph, AG::internal::point_pairs(translation, pairs), distances, np);
          },
          Sequential_tag()); // pairs are parallel, so that exact searches need not be
    else
      return false;
  }
}

} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESIC_PAIR_DISTANCES_H
