// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESIC_DISTANCE_MATRIX_H
#define CGAL_APPROXIMATE_GEODESIC_DISTANCE_MATRIX_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Geodesic_queries/internal/compiled_matrices.h>

namespace CGAL {
namespace Approximate_geodesics::internal {

// Builds the graph first.
template <typename TriangleMesh, typename Rows, typename Sources, typename NamedParameters>
bool compute_mesh_distances(const TriangleMesh& tmesh,
                            Rows& rows,
                            const Sources& sources,
                            const NamedParameters& np)
{
  const auto compute = [&](const auto& graph) {
    const Mesh_translation surface(tmesh, vertex_index_map(tmesh, np), graph.triangulation());
    const auto all = [&] { return intrinsic_points(surface, vertices(tmesh), "target"); };
    return compute_distance_matrix(graph, rows, matrix_points(surface, sources, all, np), np);
  };
  // rows are parallel, so that exact searches need not be
  return with_graph<Discrete_geodesic_graph>(tmesh, np, compute, Sequential_tag());
}

} // namespace Approximate_geodesics::internal

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * computes approximate geodesic distances from many sources to many targets, and passes them to
 * `rows`: one row per source, with one column per target.
 *
 * The type of `rows` determines which distances are stored, and where:
 *
 * - `Approximate_geodesics::Dense_rows` stores all distances in memory,
 * - `Approximate_geodesics::Radius_rows` stores distances up to `maximum_distance` in memory,
 * - `Approximate_geodesics::Nearest_rows` stores the smallest distances of each row in memory,
 * - `Approximate_geodesics::Npy_file` writes all distances to a file for NumPy,
 * - `Approximate_geodesics::Csr_file` writes distances up to `maximum_distance`, or the smallest
 *   ones of each row, to a folder of files for NumPy and SciPy,
 * - a function object receives the rows in order.
 *
 * Distances are bitwise identical to those of `Approximate_geodesics::Surface_mesh_shortest_path`
 * with the same graph if the source or the target is a vertex. Otherwise the straight line between
 * both is determined from the source, and the same bound holds. Distances do not depend on the
 * number of threads.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or of `SurfaceGraph`
 * \tparam Rows a model of `DistanceRowSink`, or of `Callable` with arguments of types
 *         `std::size_t` and `const Approximate_geodesics::Distance_row&`
 * \tparam Sources `boost::graph_traits<TriangleMesh>::%vertex_descriptor`,
 *         `Approximate_geodesics::Face_location`, `Approximate_geodesics::Surface_point`, or a
 *         model of `ConstRange` with one of these as value type; for a graph, a model of
 *         `ConstRange` with value type `Approximate_geodesics::Intrinsic_point` or an integer type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed. Instead, a model of `SurfaceGraph` can be
 *        given, with sources and targets of type `Approximate_geodesics::Intrinsic_point`, or of an
 *        integer type, the indices of vertices. Other named parameters than those listed below are
 *        then for the graph, and all vertices have the order of their indices. Several threads may
 *        share a graph.
 * \param rows receives the rows. A function object is called once per row, in order, by any thread,
 *        but never concurrently.
 * \param sources the points of the surface for the rows; duplicates are allowed
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
 *           listed below, and `vertex_point_map`, `edge_length_map`, `epsilon`,
 *           `maximum_number_of_points`, `maximum_number_of_points_per_edge`, `accept_weaker_bound`,
 *           `number_of_points_per_edge`, `face_weight_map`, `direction_to_source`,
 *           `edge_is_constrained_map`, `vertex_index_map`, `halfedge_index_map` and `geom_traits`,
 *           as for `approximate_geodesic_distances()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{targets}
 *     \cgalParamDescription{the points of the surface for the columns}
 *     \cgalParamType{a model of `ConstRange` with one of the value types of `sources`}
 *     \cgalParamDefault{all vertices, in the order of `vertices(tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_distance}
 *     \cgalParamDescription{the distance beyond which targets are not reached: their distance is
 *                           infinity, and sparse rows do not contain them}
 *     \cgalParamType{a number type convertible to `double`}
 *     \cgalParamDefault{infinity}
 *     \cgalParamExtra{Run time is proportional to the number of reached nodes.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{symmetric}
 *     \cgalParamDescription{whether to replace each distance and its transpose by the smaller of
 *                           the two, which is also the length of a path}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`: the two may differ by rounding and within the error bound}
 *     \cgalParamExtra{Targets must be the same points as sources, in the same order, and costs must
 *                     not depend on the direction. Supported by `Dense_rows`, `Radius_rows`, and
 *                     `Npy_file`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{enables the computation of rows in parallel}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
 *                    `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Sequential_tag`}
 *     \cgalParamExtra{`CGAL::Parallel_tag` requires TBB. The number of threads is that of the
 *                     enclosing `tbb::task_arena`.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{an object that is notified of progress, and that may stop the
 *                           computation}
 *     \cgalParamType{a class model of `DistanceMatrixVisitor`, or a `std::reference_wrapper` of
 *                    one}
 *     \cgalParamDefault{`CGAL::Approximate_geodesics::Distance_matrix_visitor_base`}
 *     \cgalParamExtra{The visitor is copied unless it is given as `std::ref(visitor)`.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return whether all rows are complete: `false` if the visitor has stopped the computation.
 *
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does, if a
 *         source or a target is not a point of the triangulation of a given graph, and if
 *         `symmetric` is `true` and targets differ from sources. Then `rows` is not used.
 * \throws any exception of `rows` or the visitor, which stops the computation.
 *
 * The run time of a row is that of a search. Each thread needs a workspace of 40 bytes per node of
 * the graph, and a row. If `epsilon` is given, the graph is a
 * `Approximate_geodesics::Discrete_geodesic_graph`, which takes as long to build as about ten rows.
 *
 * \sa `approximate_geodesic_distances()`
 */
template <typename TriangleMesh,
          typename Rows,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
bool approximate_geodesic_distance_matrix(const TriangleMesh& tmesh,
                                          Rows&& rows,
                                          const Sources& sources,
                                          const NamedParameters& np = parameters::default_values())
{
  namespace AG = Approximate_geodesics;
  if constexpr(!AG::internal::check_rows<Rows>())
    return false;
  else if constexpr(AG::internal::is_surface_graph<TriangleMesh>)
  {
    static_assert(
        !AG::internal::ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                   internal_np::targets_t, internal_np::symmetric_t,
                                   internal_np::visitor_t>,
        "approximate_geodesic_distance_matrix() with a graph reads targets, maximum_distance, "
        "symmetric, concurrency_tag and visitor; pass the others to the graph");
    const auto& surface = tmesh.triangulation();
    const auto all = [&] { return AG::internal::all_vertices(surface); };
    return AG::internal::compute_distance_matrix(
        tmesh, rows, AG::internal::matrix_points(surface, sources, all, np), np);
  }
  else
  {
    static_assert(
        AG::internal::is_source<TriangleMesh, Sources>,
        "approximate_geodesic_distance_matrix(tmesh, rows, sources): a source is a vertex "
        "descriptor, a Face_location or a Surface_point, and sources are one of them or a "
        "range");
    static_assert(
        !AG::internal::query_ignores_any<NamedParameters, internal_np::direction_to_source_t,
                                         internal_np::maximum_distance_t, internal_np::targets_t,
                                         internal_np::symmetric_t, internal_np::visitor_t>,
        "approximate_geodesic_distance_matrix() does not read one of these named parameters: its "
        "documentation lists the supported ones");
    return AG::internal::compute_mesh_distances(tmesh, rows, sources, np);
  }
}

} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESIC_DISTANCE_MATRIX_H
