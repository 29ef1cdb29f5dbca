// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESIC_DISTANCES_H
#define CGAL_APPROXIMATE_GEODESIC_DISTANCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/search_part_once.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// By the cheapest means that gives the answer.
template <typename TriangleMesh,
          typename VertexDistanceMap,
          typename Sources,
          typename NamedParameters>
void write_distances(const TriangleMesh& tmesh,
                     VertexDistanceMap vertex_distance_map,
                     const Sources& sources,
                     const NamedParameters& np)
{
  if(write_distances_of_part(tmesh, vertex_distance_map, sources, np))
    return;
  if constexpr(concerns_vertices_only<TriangleMesh, NamedParameters, Sources>())
    if(search_vertices_once(tmesh, np, [&](auto& search) {
         if(!search.run_from(sources, np))
           return false;
         search.write_results(vertex_distance_map, np);
         return true;
       }))
      return;
  search_once(tmesh, np, false, [&](auto& search) {
    search.run_from(sources, np);
    search.write_results(vertex_distance_map, np);
  });
}

} // namespace internal
} // namespace Approximate_geodesics

/*!
 * \ingroup PkgApproximateGeodesicsFunctions
 *
 * computes, for each vertex, the approximate geodesic distance to the nearest source.
 *
 * If an error bound `epsilon` is given, paths run across faces, and are at most
 * \f$1 + \varepsilon\f$ times as long as the shortest ones on the surface; on scanned models, the
 * mean error is about \f$\varepsilon/100\f$ for \f$\varepsilon = 0.1\f$. With the bound `0`,
 * distances are exact, up to rounding. If no bound is given, paths are the shortest ones along the
 * edges of the mesh, which are about 5 % too long on average on scanned models, and for which there
 * is no bound in general. A distance is never below that along the surface. Distances are in the
 * unit of the coordinates. Vertices that no source reaches, or that are not final when the run ends
 * early, get infinity, and so does every vertex if there is no source.
 *
 * Faces can have weights, and edges can be barriers. Distances are then costs; with `epsilon`,
 * those between vertices are at most \f$1 + \varepsilon\f$ times those of the cheapest paths on the
 * surface. Other sources add to this, by at most \f$2 + \varepsilon\f$ times what it costs from
 * there to the nearest corner of the face. A mesh with faces too thin for that is refused, unless
 * `accept_weaker_bound` is given. Weights can depend on the direction; distances are then those of
 * the ways from the sources, unless `direction_to_source` is `true`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexDistanceMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type that
 *         `double` converts to
 * \tparam Sources `boost::graph_traits<TriangleMesh>::%vertex_descriptor`,
 *         `Approximate_geodesics::Face_location`, `Approximate_geodesics::Surface_point`, or a
 *         model of `ConstRange` with one of these as value type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param vertex_distance_map receives one distance per vertex
 * \param sources a point of the surface, or a range of such points; duplicates are allowed
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
 *           listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
 *                    `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *     \cgalParamExtra{Not needed if `edge_length_map` is given.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_length_map}
 *     \cgalParamDescription{a property map associating lengths to the edges of `tmesh`, to be
 *                           used in place of the distances of their end points}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a
 *                    number type convertible by `CGAL::to_double()` as value type}
 *     \cgalParamDefault{unused}
 *     \cgalParamExtra{The lengths need not fulfill the triangle inequality, unless paths run
 *                     across faces.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{epsilon}
 *     \cgalParamDescription{an error bound: paths run across faces, and are at most
 *                           `1 + epsilon` times as long as the shortest ones on the surface}
 *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
 *     \cgalParamDefault{none: paths run along edges}
 *     \cgalParamExtra{`0` means exact, up to rounding; there must be neither weights nor barriers
 *                     then.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{whether several threads take part: in computing lengths, and in the
 *                           search if `epsilon` is given and there are neither weights nor
 *                           barriers. Their number does not change the result. Whether
 *                           there are several can change it within the bound.}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
 *                    `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Sequential_tag`}
 *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_points_per_edge}
 *     \cgalParamDescription{paths run across faces, and from one to the next through one of so many
 *                           points on their edge, at equal distances. There is no error bound.}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{none: paths run along edges}
 *     \cgalParamExtra{It cannot be given together with `epsilon`. It is a name of \cgal, so that
 *                     other names follow only if the chain begins with one of this package, as in
 *                     `face_weight_map(weights).number_of_points_per_edge(1)`; see
 *                     \ref AG_chains.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_weight_map}
 *     \cgalParamDescription{a property map associating weights to the faces of `tmesh`: what a path
 *                           in the face costs per unit of length. `0` makes it free, and infinity
 *                           forbidden. A path along an edge costs the smaller weight of its two
 *                           faces.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and a number
 *                    type convertible by `CGAL::to_double()` as value type; or what
 *                    `Approximate_geodesics::directional_cost()` returns, for costs that depend on
 *                    the direction}
 *     \cgalParamDefault{unused: all faces have weight `1`}
 *     \cgalParamExtra{If it is given, costs take the place of lengths and distances.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{direction_to_source}
 *     \cgalParamDescription{whether distances are those to the sources, and not from them, where
 *                           costs depend on the direction}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *     \cgalParamExtra{It can only be given together with costs that depend on the direction.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map saying which edges of `tmesh` are barriers, which
 *                           paths may run along, and not cross}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and
 *                    `bool` as value type}
 *     \cgalParamDefault{unused: no edge is a barrier}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_number_of_points}
 *     \cgalParamDescription{so many points may be needed on all edges together, for the bound
 *                           `epsilon` with weights or barriers or as `number_of_points_per_edge`}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{1000 per edge on average, but at least \f$10^6\f$ and at most
 *                       \f$10^8\f$}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_number_of_points_per_edge}
 *     \cgalParamDescription{so many points may be needed on an edge because of a thin face, for the
 *                           bound `epsilon` with weights or barriers}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{`1000000`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{accept_weaker_bound}
 *     \cgalParamDescription{whether faces that need more points get few, and the bound becomes the
 *                           weaker one that
 *                           `CGAL::Approximate_geodesics::Steiner_graph::epsilon()` tells; else
 *                           they are refused}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{initial_distances}
 *     \cgalParamDescription{what is added to the distances from each of the sources}
 *     \cgalParamType{a model of `ConstRange` with a number type convertible by `CGAL::to_double()`
 *                    as value type, and of the size of `sources`}
 *     \cgalParamDefault{`0` for all of them}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_distance}
 *     \cgalParamDescription{the distance beyond which vertices are not reached}
 *     \cgalParamType{a number type convertible to `double`}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{targets}
 *     \cgalParamDescription{points of the surface; the run ends as soon as the distances to all
 *                           of them are final}
 *     \cgalParamType{a model of `ConstRange` with one of the value types of `sources`}
 *     \cgalParamDefault{none: the run goes on to the end, as it does if the range is empty}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{nearest_source_map}
 *     \cgalParamDescription{a property map that receives, for each vertex, the position in
 *                           `sources` of its nearest source}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an
 *                    integer type as value type}
 *     \cgalParamDefault{unused}
 *     \cgalParamExtra{Vertices that were not reached get `-1`, converted to the value type.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{predecessor_map}
 *     \cgalParamDescription{a property map that receives, for each vertex, the one before it on
 *                           a shortest path from its nearest source}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key and value
 *                    type}
 *     \cgalParamDefault{unused}
 *     \cgalParamExtra{A source gets itself, as does a vertex with no other one between it and a
 *                     source that is not a vertex; and a vertex that was not reached gets
 *                     `boost::graph_traits<TriangleMesh>::%null_vertex()`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{an object that is notified of settled vertices and of progress, and
 *                           that may stop the run}
 *     \cgalParamType{a class model of `GeodesicVisitor`, or a `std::reference_wrapper` of one}
 *     \cgalParamDefault{`CGAL::Approximate_geodesics::Geodesic_visitor_base`}
 *     \cgalParamExtra{The visitor is copied unless it is given as `std::ref(visitor)`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{a property map associating to each vertex of `tmesh` a unique index
 *                           between `0` and `num_vertices(tmesh) - 1`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and an
 *                    integer type as value type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{halfedge_index_map}
 *     \cgalParamDescription{a property map associating to each halfedge of `tmesh` a unique index
 *                           between `0` and `num_halfedges(tmesh) - 1`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and an
 *                    integer type as value type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{an instance of a geometric traits class}
 *     \cgalParamType{a class model of `Kernel`}
 *     \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws std::invalid_argument if the mesh or its weights are not as
 *         `CGAL::Approximate_geodesics::Intrinsic_triangulation` requires, if a source or target is
 *         not a point of its surface, if an initial distance is negative or infinite or there are
 *         more or fewer than sources, if `maximum_distance` is negative or not a number, if the
 *         bound `epsilon` is not a finite number or is negative, or `0` with weights or barriers,
 *         if `number_of_points_per_edge` is negative or not an integer, or if paths run across
 *         faces and a face breaks the triangle inequality. The message says what is wrong and
 *         where. If an exception leaves this function, nothing has been written to any property
 *         map.
 * \throws std::length_error if `tmesh` has more halfedges, or the graph more nodes, than 32-bit
 *         numbers can tell apart; or if points on edges are needed, and these are more than
 *         `maximum_number_of_points`, or, with weights or barriers and `epsilon`, a face takes more
 *         than `maximum_number_of_points_per_edge`. The message names the edge with most points, or
 *         the face, and the number.
 *
 * Run time is \cgalBigO{n} in practice for `n` vertices, and \cgalBigO{n \log n} in the worst case
 * if their degrees are bounded; memory is \cgalBigO{n}. The method is Dijkstra's algorithm
 * \cgalCite{d-ntpcg-59} with buckets in place of a heap. Along edges, and if sources and targets
 * are given as vertex descriptors, it runs on arrays in the order of the mesh, which are read in
 * about half the time of a triangulation; given `epsilon`, it runs on a
 * `CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph`, or, if it is `0`, on a
 * `CGAL::Approximate_geodesics::Saddle_vertex_graph`, where run time is more than linear on smooth
 * surfaces; given weights, barriers or a number of points per edge, on a
 * `CGAL::Approximate_geodesics::Steiner_graph`, where the number of nodes takes the place of that
 * of vertices. If `maximum_distance` is given, and `targets` are not, and a small part of the mesh
 * is enough, only that is read and checked, see section \ref AG_parts, and only writing takes
 * longer for a larger mesh. The mesh is read again by every call: if it is used more than once,
 * `CGAL::Approximate_geodesics::Surface_mesh_shortest_path` is several times as fast.
 *
 * \sa `approximate_geodesic_path()`
 * \sa `CGAL::Approximate_geodesics::Surface_mesh_shortest_path`
 */
template <typename TriangleMesh,
          typename VertexDistanceMap,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
void approximate_geodesic_distances(const TriangleMesh& tmesh,
                                    VertexDistanceMap vertex_distance_map,
                                    const Sources& sources,
                                    const NamedParameters& np = parameters::default_values())
{
  namespace AG = Approximate_geodesics;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  constexpr bool is_map = AG::internal::takes_distances<VertexDistanceMap, vertex_descriptor>;
  constexpr bool are_sources = AG::internal::is_source<TriangleMesh, Sources>;
  static_assert(
      is_map,
      "approximate_geodesic_distances(tmesh, vertex_distance_map, sources): distances are written "
      "to a property map with vertex descriptors as keys; one of a std::vector is "
      "boost::make_iterator_property_map(vector.begin(), get(boost::vertex_index, tmesh))");
  static_assert(
      are_sources,
      "approximate_geodesic_distances(tmesh, vertex_distance_map, sources): a source is a "
      "vertex descriptor, a Face_location or a Surface_point, and sources are one of them "
      "or a range");
  static_assert(
      !AG::internal::ignores_any<
          NamedParameters, internal_np::epsilon_t, internal_np::maximum_number_of_points_t,
          internal_np::maximum_number_of_points_per_edge_t, internal_np::accept_weaker_bound_t,
          internal_np::number_of_points_per_edge_t, internal_np::edge_length_t,
          internal_np::face_weight_t, internal_np::direction_to_source_t,
          internal_np::edge_is_constrained_t, internal_np::initial_distances_t,
          internal_np::maximum_distance_t, internal_np::targets_t, internal_np::nearest_source_t,
          internal_np::geodesic_predecessor_t, internal_np::visitor_t>,
      "approximate_geodesic_distances() does not read one of these named parameters: its "
      "documentation lists those that it does; straighten is for paths");

  if constexpr(is_map && are_sources) // or else there would be more errors
    AG::internal::write_distances(tmesh, vertex_distance_map, sources, np);
}

} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESIC_DISTANCES_H
