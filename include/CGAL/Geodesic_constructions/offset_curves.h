// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_OFFSET_CURVES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_OFFSET_CURVES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>
#include <CGAL/Geodesic_constructions/Source_curve.h>
#include <CGAL/Geodesic_constructions/internal/Offsets/Offset_tracer.h>
#include <CGAL/Geodesic_constructions/isolines.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicConstructionsSources
 *
 * A polyline at constant distance from a curve, or from other sources. What is nearer to the
 * sources is on its left, seen from outside.
 */
template <typename Point_3>
struct Offset_curve
{
  /// the distance from the sources.
  double distance = 0;

  /// whether the curve is closed: the first point is not repeated then. It is open only where it
  /// ends at a border of the mesh.
  bool is_closed = false;

  /// the points, in order.
  std::vector<Point_3> points = {};
};

namespace internal {

inline std::vector<double> checked_offsets(std::vector<double> distances)
{
  for(std::size_t i = 0; i < distances.size(); ++i)
    if(!(distances[i] > 0 && distances[i] < infinity))
      reject("offset " + std::to_string(i) + ", counted from 0, is " + text_of(distances[i]) +
             "; it must be a finite number larger than 0");
  std::sort(distances.begin(), distances.end());
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  return distances;
}

// The smallest difference of two offsets, or of the first one and the source, but no less than a
// small part of them and of an edge: errors relative to less would take points without end.
inline double smallest_step(const std::vector<double>& distances, const double mean_edge)
{
  constexpr double part_of_largest = 1e-5, part_of_edge = 1e-3;
  double result = distances.front();
  for(std::size_t i = 1; i < distances.size(); ++i)
    result = (std::min)(result, distances[i] - distances[i - 1]);
  return (std::max)({result, part_of_largest * distances.back(), part_of_edge * mean_edge});
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsSources
 *
 * computes curves at given distances from sources, such as tool paths at constant distance from
 * each other.
 *
 * Distances are exact at vertices, and so are their slopes along edges, from the directions in
 * which shortest paths arrive. The distances of points between follow from these, also where
 * shortest paths from several directions meet. The curve is right up to about 1 % of the smallest
 * step between two offsets, also between its points, if steps are not far smaller than edges. Where
 * shortest paths bend at most vertices, as on rough scans, about 1 % of the points are farther off,
 * up to 5 % of a step; this is an estimate, and no bound. At points that have several shortest
 * paths to the sources (the medial axis), offset curves have corners; where three paths or more
 * meet, these may be cut off by up to a face.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam Sources as for `approximate_geodesic_distances()`
 * \tparam Distances a number type convertible by `CGAL::to_double()`, or a model of `ConstRange`
 *         with such a value type
 * \tparam OutputIterator a model of `OutputIterator` that takes `Offset_curve<Point_3>`, where
 *         `Point_3` is the value type of the vertex point map
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param sources a point, a curve or a region of the surface, or a range of these
 * \param distances the distances of the offset curves, in the unit of the mesh: finite, and larger
 *        than `0`; their order does not matter
 * \param curves receives the offset curves, ordered by distance; a distance may have any number of
 *        them
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *        `vertex_point_map`, `vertex_index_map`, `halfedge_index_map`, `geom_traits` and
 *        `concurrency_tag`, as for `approximate_geodesic_distances()`
 *
 * \return the output iterator, after the last curve.
 *
 * \throws std::invalid_argument as `approximate_geodesic_distances()` does with `epsilon(0)`, and
 * if a distance is not finite or not larger than `0`.
 * \throws std::length_error if faces would be divided into more than \f$2^{18}\f$ parts, and
 * \f$2^{12}\f$ for each face and distance. The message names the face where that is so. Nothing is
 * written after an exception.
 *
 * Run time is that of an exact search up to the largest distance, linear in the number of vertices
 * and points after it, and that of a query of the search for each point in faces near sources. Of
 * these, there are up to tens of thousands for each edge that a curve crosses, if steps are far
 * smaller than edges. Where the medial axis crosses an edge, paths are followed back over the edges
 * around. Memory is that of the search, and of the parts of faces.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `isolines()`
 */
template <typename TriangleMesh,
          typename Sources,
          typename Distances,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator offset_curves(const TriangleMesh& tmesh,
                             const Sources& sources,
                             const Distances& distances,
                             OutputIterator curves,
                             const NamedParameters& np = parameters::default_values())
{
  const std::vector<double> offsets = internal::checked_offsets(internal::numbers(distances));
  if(offsets.empty())
    return curves;
  static_assert(!internal::ignores_any<NamedParameters>,
                "offset_curves() is exact, and ignores one of these named parameters");
  const Saddle_vertex_graph graph = internal::exact_graph(tmesh, np);
  Mesh_translation translation(tmesh, internal::vertex_index_map(tmesh, np), graph.triangulation());
  translation.list_vertices();
  auto point_map = internal::vertex_point_map(tmesh, np);
  using Point_3 = typename boost::property_traits<decltype(point_map)>::value_type;
  internal::Mesh_search<Saddle_vertex_graph, Adaptive_bucket_queue, decltype(translation),
                        decltype(point_map)>
      search(graph, translation, std::move(point_map));
  const double margin = 2 * graph.arc_lengths().longest * graph.unit();
  search.run_from(sources, parameters::maximum_distance(offsets.back() + margin));
  const double mean_edge = graph.arc_lengths().mean * graph.unit();
  internal::Offset_tracer tracer(search.search(), offsets,
                                 internal::smallest_step(offsets, mean_edge));
  for(const auto& line : tracer.trace())
  {
    Offset_curve<Point_3> curve{offsets[line.number], line.is_closed, {}};
    for(const Intrinsic_point& p : line.points)
      curve.points.push_back(search.point(p, np));
    *curves++ = std::move(curve);
  }
  return curves;
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_OFFSET_CURVES_H
