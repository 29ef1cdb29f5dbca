// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESIC_DISTANCES_H
#define CGAL_APPROXIMATE_GEODESIC_DISTANCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>

namespace CGAL {
namespace Approximate_geodesics::internal {

// Reads as little of the mesh as the query allows.
template <typename TriangleMesh,
          typename VertexDistanceMap,
          typename Sources,
          typename NamedParameters>
void write_distances(const TriangleMesh& tmesh,
                     VertexDistanceMap vertex_distance_map,
                     const Sources& sources,
                     const NamedParameters& np)
{
  const auto write = [&](auto& search) {
    search.run_from(sources, np);
    search.write_results(vertex_distance_map, np);
  };
  if constexpr(may_read_part<TriangleMesh, NamedParameters>() &&
               !are_other_sources<TriangleMesh, Sources> &&
               is_given<NamedParameters, internal_np::maximum_distance_t> &&
               !is_given<NamedParameters, internal_np::targets_t>)
    if(const auto part = Part_to_read(tmesh, np).around(sources))
      if(search_once<Sources>(*part, np, false, write))
        return;
  search_once<Sources>(tmesh, np, false, write);
}

} // namespace Approximate_geodesics::internal

/*!
 * \ingroup PkgApproximateGeodesicsFunctions
 *
 * computes, for each vertex, the approximate geodesic distance to the nearest source.
 *
 * If an error bound `epsilon` is given, paths run across faces, and are at most
 * \f$1 + \varepsilon\f$ times as long as shortest paths on the surface; on scanned models, the mean
 * error is about \f$\varepsilon/100\f$ for \f$\varepsilon = 0.1\f$. With the bound `0`, distances
 * are exact, up to rounding. If no bound is given, paths are shortest paths along the edges of the
 * mesh, which are about 5 % too long on average on scanned models, and have no error bound in
 * general. A distance is never smaller than the geodesic distance on the surface. Distances are in
 * the unit of the coordinates. Vertices get the distance infinity if they are not reachable, if
 * their distances are not final when the run ends early, or if there is no source.
 *
 * Faces can have weights, and edges can be barriers. Distances are then costs; with `epsilon`,
 * those between vertices are at most \f$1 + \varepsilon\f$ times the cost of cheapest paths on the
 * surface. A source that is not a vertex adds an error of at most \f$2 + \varepsilon\f$ times the
 * cost from there to the nearest corner of its face. A mesh with faces too thin for the bound is
 * rejected, unless `accept_weaker_bound` is given. Weights can depend on the direction; distances
 * are then those from the sources, unless `direction_to_source` is `true`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexDistanceMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type to
 *         which `double` is convertible
 * \tparam Sources `boost::graph_traits<TriangleMesh>::%vertex_descriptor`,
 *         `Approximate_geodesics::Face_location`, `Approximate_geodesics::Surface_point`,
 *         `Approximate_geodesics::Source_curve`, `Approximate_geodesics::Source_region` (both in
 *         `CGAL/Geodesic_constructions.h`), or a model of `ConstRange` with one of these as value
 *         type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param vertex_distance_map receives one distance per vertex
 * \param sources a point, a curve or a region of the surface, or a range of these; duplicates are
 *        allowed
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
 *     \cgalParamDescription{a property map associating lengths to the edges of `tmesh`, used
 *                           instead of the distances of their end points}
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
 *     \cgalParamExtra{`0` means exact, up to rounding; it does not support weights and barriers.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{enables parallel computation of lengths, and a parallel search if
 *                           `epsilon` is given without weights and barriers. The result does not
 *                           depend on the number of threads, but sequential and parallel results
 *                           may differ within the bound.}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
 *                    `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Sequential_tag`}
 *     \cgalParamExtra{`CGAL::Parallel_tag` requires TBB.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_points_per_edge}
 *     \cgalParamDescription{the number of equally spaced points per edge: paths run across faces,
 *                           and cross edges at these points. There is no error bound.}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{none: paths run along edges}
 *     \cgalParamExtra{It excludes `epsilon`, and needs the header `CGAL/Geodesic_costs.h`. As this
 *                     is a parameter of \cgal, a chain with parameters of this package must start
 *                     with one of these, as in
 *                     `face_weight_map(weights).number_of_points_per_edge(1)`; see \ref AG_chains.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{max_slope}
 *     \cgalParamDescription{the steepest slope, uphill and downhill, of straight pieces of paths,
 *                           in units of z per horizontal unit. Costs depend on the direction
 *                           then; see `Approximate_geodesics::Directional_graph`.}
 *     \cgalParamType{a number type convertible by `CGAL::to_double()`}
 *     \cgalParamDefault{infinity: there is no limit}
 *     \cgalParamExtra{Needs the header `CGAL/Geodesic_costs.h`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_weight_map}
 *     \cgalParamDescription{a property map associating weights to the faces of `tmesh`: the cost of
 *                           a path in the face per unit of length. `0` is free, and infinity is
 *                           impassable. The weight of an edge is the smaller weight of its two
 *                           faces.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and a number
 *                    type convertible by `CGAL::to_double()` as value type; or the result of
 *                    `Approximate_geodesics::directional_cost()`, for costs that depend on the
 *                    direction}
 *     \cgalParamDefault{unused: all faces have weight `1`}
 *     \cgalParamExtra{Lengths and distances are then costs. Needs the header
 *                     `CGAL/Geodesic_costs.h`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{direction_to_source}
 *     \cgalParamDescription{whether to compute distances to the sources instead of from them, if
 *                           costs depend on the direction}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *     \cgalParamExtra{It requires costs that depend on the direction.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that marks edges of `tmesh` as barriers: paths may
 *                           follow them, but not cross them}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and
 *                    `bool` as value type}
 *     \cgalParamDefault{unused: no edge is a barrier}
 *     \cgalParamExtra{Needs the header `CGAL/Geodesic_costs.h`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_number_of_points}
 *     \cgalParamDescription{the maximum number of points on all edges together, for the bound
 *                           `epsilon` with weights or barriers, or for `number_of_points_per_edge`}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{1000 per edge on average, but at least \f$10^6\f$ and at most
 *                       \f$10^8\f$}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_number_of_points_per_edge}
 *     \cgalParamDescription{the maximum number of points that a thin face may require on an edge,
 *                           for the bound `epsilon` with weights or barriers}
 *     \cgalParamType{an integer type}
 *     \cgalParamDefault{`1000000`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{accept_weaker_bound}
 *     \cgalParamDescription{whether to use fewer points on faces that exceed
 *                           `maximum_number_of_points_per_edge`, which weakens the bound to
 *                           `CGAL::Approximate_geodesics::Steiner_graph::epsilon()`; otherwise the
 *                           mesh is rejected}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{initial_distances}
 *     \cgalParamDescription{the initial distances of the sources, which are added to the distances
 *                           from them. With `epsilon(0)`, distances of more than \f$10^{10}\f$
 *                           times the longest edge are rejected.}
 *     \cgalParamType{a model of `ConstRange` with a number type convertible by `CGAL::to_double()`
 *                    as value type, and of the size of `sources`}
 *     \cgalParamDefault{`0` for all of them}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{signed_distances}
 *     \cgalParamDescription{whether distances are negative to the left of the curves that are the
 *                           sources, seen from outside: isolines of distances are then on both
 *                           sides, and go along with the curves}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *     \cgalParamExtra{A curve has to be closed, or to end at borders, and all curves together have
 *                     to separate their left side from their right side: a meridian of a torus, a
 *                     curve that crosses itself, or a point does not. The other kind of source is
 *                     refused. A region has distances of `0` inside. Vertices that are not reached
 *                     get infinity on both sides. The header `CGAL/Geodesic_constructions.h` has to
 *                     be included, as for curves.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_distance}
 *     \cgalParamDescription{the distance beyond which vertices are not reached}
 *     \cgalParamType{a number type convertible to `double`}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{targets}
 *     \cgalParamDescription{points of the surface; the run stops as soon as the distances of all
 *                           targets are final}
 *     \cgalParamType{a model of `ConstRange` with one of the value types of `sources`}
 *     \cgalParamDefault{none: the run is complete, as with an empty range}
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
 *     \cgalParamDescription{a property map that receives, for each vertex, the previous vertex on a
 *                           shortest path from its nearest source}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key and value
 *                    type}
 *     \cgalParamDefault{unused}
 *     \cgalParamExtra{The predecessor of a source is the source itself; the same holds for a vertex
 *                     without a previous vertex on the path from a source that is not a vertex.
 *                     Vertices that were not reached get
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
 * \throws std::invalid_argument if the mesh or its weights do not meet the requirements of
 *         `CGAL::Approximate_geodesics::Intrinsic_triangulation`, if a source or target is not a
 *         point of its surface, if an initial distance is negative or infinite or their number
 *         differs from that of the sources, if `maximum_distance` is negative or NaN, if `epsilon`
 *         is negative or not finite, or `0` with weights or barriers, if
 *         `number_of_points_per_edge` is negative or not an integer, if paths run across faces and
 *         a face violates the triangle inequality, or if `signed_distances` are wanted and the
 *         sources do not have two sides. The message names the error and the element.
 *         If an exception is thrown, no property map is written.
 * \throws std::length_error if the number of halfedges of `tmesh`, or of nodes of the graph,
 *         exceeds the range of 32-bit indices; or if points on edges are required, and their number
 *         exceeds `maximum_number_of_points`, or, with weights or barriers and `epsilon`, a face
 *         requires more than `maximum_number_of_points_per_edge`. The message names the edge with
 *         most points, or the face, and the number.
 *
 * Run time is \cgalBigO{n} in practice for `n` vertices, and \cgalBigO{n \log n} in the worst case
 * if their degrees are bounded; memory is \cgalBigO{n}. The method is Dijkstra's algorithm
 * \cgalCite{d-ntpcg-59} with buckets instead of a heap. Along edges, and if sources and targets are
 * vertex descriptors, it runs on arrays in the order of the mesh, which are read in about half the
 * time of a triangulation; given `epsilon`, it runs on a
 * `CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph`, or, if it is `0`, on a
 * `CGAL::Approximate_geodesics::Saddle_vertex_graph`, where run time is superlinear on smooth
 * surfaces; given weights, barriers or a number of points per edge, on a
 * `CGAL::Approximate_geodesics::Steiner_graph`, where `n` is the number of nodes instead of
 * vertices. If `maximum_distance` is given without `targets`, and a small part of the mesh
 * suffices, only this part is read and checked, see section \ref AG_parts; then only the time for
 * writing depends on the size of the mesh. Every call reads the mesh: for several runs on a mesh,
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
  constexpr bool are_sources = AG::internal::is_source<TriangleMesh, Sources> ||
                               AG::internal::are_other_sources<TriangleMesh, Sources>;
  static_assert(
      is_map,
      "approximate_geodesic_distances(tmesh, vertex_distance_map, sources): distances are written "
      "to a property map with vertex descriptors as keys; one of a std::vector is "
      "boost::make_iterator_property_map(vector.begin(), get(boost::vertex_index, tmesh))");
  static_assert(
      are_sources,
      "approximate_geodesic_distances(tmesh, vertex_distance_map, sources): a source is a "
      "vertex descriptor, a Face_location or a Surface_point, and sources are one of them "
      "or a range; for curves and regions, include <CGAL/Geodesic_constructions.h>");
  static_assert(
      !AG::internal::query_ignores_any<
          NamedParameters, internal_np::direction_to_source_t, internal_np::initial_distances_t,
          internal_np::maximum_distance_t, internal_np::targets_t, internal_np::nearest_source_t,
          internal_np::geodesic_predecessor_t, internal_np::signed_distances_t,
          internal_np::visitor_t>,
      "approximate_geodesic_distances() does not read one of these named parameters: its "
      "documentation lists the supported ones; straighten is for paths");

  if constexpr(is_map && are_sources) // avoids consecutive errors
    AG::internal::write_distances(tmesh, vertex_distance_map, sources, np);
}

} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESIC_DISTANCES_H
