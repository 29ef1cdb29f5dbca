// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESIC_PATH_H
#define CGAL_APPROXIMATE_GEODESIC_PATH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/straighten.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <optional>

namespace CGAL {
namespace Approximate_geodesics::internal {

// Writes the points of the path, and returns its length.
template <typename TriangleMesh,
          typename OutputIterator,
          typename Source,
          typename Target,
          typename NamedParameters>
double write_path(const TriangleMesh& tmesh,
                  OutputIterator points,
                  const Source& source,
                  const Target& target,
                  const NamedParameters& np)
{
  double length = infinity;
  const auto write = [&](auto& search, const double limit) {
    search.run_to(source, target, positions_for_one_run(search, np), np);
    const Intrinsic_point end = search.translation().intrinsic_point(target);
    const double distance = search.search().distance(end);
    if(distance <= limit)
    {
      const Path path = find_path(search, end, np);
      for(auto p = path.points.rbegin(); p != path.points.rend(); ++p)
        *points++ = search.point(*p, np);
      length = path.points.empty() ? infinity : path.length;
    }
    return distance;
  };
  if constexpr(may_read_part<TriangleMesh, NamedParameters>() &&
               !are_other_sources<TriangleMesh, Source>)
  {
    const auto search_part = [&](const auto& part, const double limit) {
      std::optional<double> distance;
      search_once<Source, Target>(part, np, true,
                                  [&](auto& search) { distance = write(search, limit); });
      return distance;
    };
    if(Part_to_read(tmesh, np).between(source, target, search_part))
      return length;
  }
  search_once<Source, Target>(tmesh, np, true, [&](auto& search) { write(search, infinity); });
  return length;
}

} // namespace Approximate_geodesics::internal

/*!
 * \ingroup PkgApproximateGeodesicsFunctions
 *
 * computes an approximately shortest path from `source` to `target`, and returns its length.
 *
 * If an error bound `epsilon` is given, the path runs across faces, and is at most
 * \f$1 + \varepsilon\f$ times as long as a shortest path on the surface; with the bound `0`, it is
 * a shortest path. If no bound is given, it is a shortest path along the edges of the mesh, which
 * has no error bound in general.
 *
 * The run stops when the distance to `target` is final. Across faces, it is an A* search with
 * straight-line distances, unless there are weights, edge lengths, or a visitor. The returned
 * length is that of the polyline, up to rounding.
 *
 * With weights, "length" means cost, and `epsilon` bounds costs between vertices; for other points,
 * the error increases by `Approximate_geodesics::Steiner_graph::cost_to_corner()`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam OutputIterator a model of `OutputIterator` that takes points of the vertex point map
 * \tparam Source `boost::graph_traits<TriangleMesh>::%vertex_descriptor`,
 *         `Approximate_geodesics::Face_location`, `Approximate_geodesics::Surface_point`,
 *         `Approximate_geodesics::Source_curve`, `Approximate_geodesics::Source_region`, or a model
 *         of `ConstRange` with one of these as value type
 * \tparam Target one of the first three types of `Source`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param points receives the points of the path, from `source` to `target`: vertices, intersections
 *               with edges, and the ends; a single point if `source` and `target` are equal, and
 *               none if there is no path
 * \param source the start of the path: a vertex, an `Approximate_geodesics::Face_location`, or an
 *               `Approximate_geodesics::Surface_point`; or a range of these, in which case the path
 *               starts at the source nearest to `target`; or curves, at their nearest point
 * \param target the end of the path, a single point of these types
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `straighten`
 *           and, as for `approximate_geodesic_distances()`, `vertex_point_map`, which the points of
 *           the path are taken from, `edge_length_map`, `epsilon`, `concurrency_tag`,
 *           `number_of_points_per_edge`, `face_weight_map`, `edge_is_constrained_map`,
 *           `maximum_number_of_points`, `maximum_number_of_points_per_edge`, `accept_weaker_bound`,
 *           `maximum_distance`, `visitor`, `vertex_index_map`, `halfedge_index_map` and
 *           `geom_traits`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{straighten}
 *     \cgalParamDescription{whether to shorten the path to a locally shortest path on the surface.
 *                           It never gets longer, except for rounding on caps (see page \ref
 *                           AG_bad_meshes), and in most cases becomes a shortest path.}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *     \cgalParamExtra{It does not support face weights.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the length of the path, in the unit of the coordinates (or of `edge_length_map`), or
 *         infinity if `target` is not reachable, or not within `maximum_distance`, or the visitor
 *         stopped the run.
 *
 * \throws std::invalid_argument as `approximate_geodesic_distances()` does.
 * \throws std::length_error as `approximate_geodesic_distances()` does.
 *
 * If a small part of the mesh suffices, only this part is read and checked, see section \ref
 * AG_parts; run time and memory are then proportional to its size. Otherwise they are those of
 * `approximate_geodesic_distances()`.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `CGAL::Approximate_geodesics::Surface_mesh_shortest_path`
 */
template <typename TriangleMesh,
          typename OutputIterator,
          typename Source,
          typename Target,
          typename NamedParameters = parameters::Default_named_parameters>
double approximate_geodesic_path(const TriangleMesh& tmesh,
                                 OutputIterator points,
                                 const Source& source,
                                 const Target& target,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace AG = Approximate_geodesics;
  constexpr bool is_source = AG::internal::is_source<TriangleMesh, Source> ||
                             AG::internal::are_other_sources<TriangleMesh, Source>;
  constexpr bool are_ends = is_source && AG::internal::is_surface_point<TriangleMesh, Target>;
  static_assert(are_ends,
                "source, target: a vertex descriptor, Face_location, or Surface_point; or a range "
                "of sources; for curves and regions, include <CGAL/Geodesic_constructions.h>");
  static_assert(
      !AG::internal::query_ignores_any<NamedParameters, internal_np::maximum_distance_t,
                                       internal_np::straighten_t, internal_np::visitor_t>,
      "approximate_geodesic_path() does not read one of these named parameters: see its manual");

  if constexpr(are_ends) // avoids consecutive errors
    return AG::internal::write_path(tmesh, points, source, target, np);
  else
    return 0;
}

} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESIC_PATH_H
