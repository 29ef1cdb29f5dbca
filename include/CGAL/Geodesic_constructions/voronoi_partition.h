// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_VORONOI_PARTITION_H
#define CGAL_GEODESIC_CONSTRUCTIONS_VORONOI_PARTITION_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

// The nearest source of a corner of a face, and its distance.
struct Corner_source
{
  double distance;
  std::size_t source;
};

inline std::size_t source_of_face(const std::array<Corner_source, 3>& corners)
{
  const auto& [a, b, c] = corners;
  if(a.source == b.source || a.source == c.source)
    return a.source;
  if(b.source == c.source)
    return b.source;
  return std::min_element(
             corners.begin(), corners.end(),
             [](const Corner_source& p, const Corner_source& q) { return p.distance < q.distance; })
      ->source;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsFields
 *
 * computes a Voronoi partition of the faces: finds the nearest source of every face.
 *
 * The nearest source of a face is that of the majority of its corners, or, if all three differ,
 * that of the corner with the smallest distance. So the cells are unions of faces. The named
 * parameter `nearest_source_map` additionally receives the nearest sources of the vertices.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceSourceMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as
 *         value type
 * \tparam Sources a model of `ConstRange` with value type
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param face_source_map receives, for each face, the position of its nearest source in `sources`;
 *        `-1`, converted to the value type, for faces with two or three corners that are not
 *        reached
 * \param sources the sources, vertices of `tmesh`; among duplicates, only the first one gets faces
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": all parameters of
 *           `approximate_geodesic_distances()`
 *
 * \throws std::invalid_argument, std::length_error as `approximate_geodesic_distances()` does. In
 *         this case, nothing is written.
 *
 * Run time and memory are those of `approximate_geodesic_distances()`: there is a single run for
 * any number of sources.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `farthest_point_sampling()`
 */
template <typename TriangleMesh,
          typename FaceSourceMap,
          typename Sources,
          typename NamedParameters = parameters::Default_named_parameters>
void voronoi_partition(const TriangleMesh& tmesh,
                       FaceSourceMap face_source_map,
                       const Sources& sources,
                       const NamedParameters& np = parameters::default_values())
{
  const auto index_map = internal::vertex_index_map(tmesh, np);
  std::vector<double> distance_of(num_vertices(tmesh));
  std::vector<std::size_t> source_of(num_vertices(tmesh));
  const auto distance_map = boost::make_iterator_property_map(distance_of.begin(), index_map);
  const auto source_map = boost::make_iterator_property_map(source_of.begin(), index_map);
  approximate_geodesic_distances(
      tmesh, distance_map, sources,
      parameters::combine(np, parameters::nearest_source_map(source_map)));

  if constexpr(internal::is_given<NamedParameters, internal_np::nearest_source_t>)
  {
    const auto map = parameters::get_parameter(np, internal_np::nearest_source);
    using Value = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
    for(const auto v : vertices(tmesh))
      put(map, v, static_cast<Value>(get(source_map, v)));
  }

  using Value = typename boost::property_traits<FaceSourceMap>::value_type;
  for(const auto f : faces(tmesh))
  {
    std::array<internal::Corner_source, 3> corners;
    std::size_t i = 0;
    for(const auto v : vertices_around_face(halfedge(f, tmesh), tmesh))
      corners[i++] = {get(distance_map, v), get(source_map, v)};
    put(face_source_map, f, static_cast<Value>(internal::source_of_face(corners)));
  }
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_VORONOI_PARTITION_H
