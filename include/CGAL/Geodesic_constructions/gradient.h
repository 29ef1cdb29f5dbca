// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_GRADIENT_H
#define CGAL_GEODESIC_CONSTRUCTIONS_GRADIENT_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Mesh/internal/Mesh_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Approximate_geodesics {
namespace internal {

/*
 * Returns the gradient of the linear function with the given finite values at the corners of a
 * triangle; the zero vector if the triangle is degenerate or the gradient overflows a `double`.
 *
 * The triangle is scaled to about unit size, because products of four lengths could underflow or
 * overflow.
 */
template <typename Traits>
typename Traits::Vector_3 gradient_of_face(const std::array<typename Traits::Point_3, 3>& points,
                                           const std::array<double, 3>& values,
                                           const Traits& traits)
{
  using FT = typename Traits::FT;
  using Vector_3 = typename Traits::Vector_3;
  const auto vector = traits.construct_vector_3_object();
  const auto scaled = traits.construct_scaled_vector_3_object();
  const auto sum = traits.construct_sum_of_vectors_3_object();
  const auto cross_product = traits.construct_cross_product_vector_3_object();

  Vector_3 u = vector(points[0], points[1]), v = vector(points[0], points[2]);
  FT size(0);
  for(const Vector_3& w : {u, v})
    for(int i = 0; i < 3; ++i)
      size = (CGAL::max)(size, FT(CGAL::abs(w[i])));
  if(CGAL::is_zero(size))
    return vector(NULL_VECTOR);

  u = scaled(u, FT(1) / size);
  v = scaled(v, FT(1) / size);
  const Vector_3 normal = cross_product(u, v);
  const FT square = traits.compute_squared_length_3_object()(normal);
  if(CGAL::is_zero(square))
    return vector(NULL_VECTOR);
  const auto slope = [&](const double value) { // the difference may overflow
    return FT(value / 2 - values[0] / 2) / size * FT(2);
  };
  const Vector_3 result = scaled(sum(scaled(cross_product(v, normal), slope(values[1])), //
                                     scaled(cross_product(normal, u), slope(values[2]))),
                                 FT(1) / square);
  for(int i = 0; i < 3; ++i)
    if(!std::isfinite(CGAL::to_double(result[i])))
      return vector(NULL_VECTOR);
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicConstructionsFields
 *
 * computes the gradient of a piecewise linear function given by its values at the vertices.
 *
 * If the function is a distance field, its gradient points away from the sources, opposite to the
 * direction of shortest paths to them. Its length is about `1`, or about the weight of the face; it
 * deviates on faces at sources and on the cut locus, and slightly everywhere if distances are
 * measured along edges.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam VertexDistanceMap a model of `ReadablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type
 *         convertible by `CGAL::to_double()` as value type
 * \tparam FaceVectorMap a model of `WritablePropertyMap` with
 *         `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `%Vector_3` of the
 *         traits class as value type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tmesh the triangle mesh; it is not changed
 * \param vertex_distance_map one value per vertex, for example from
 *        `approximate_geodesic_distances()`
 * \param face_vector_map receives one vector per face: the zero vector if a value at one of its
 *        corners is infinite (for example, not reached) or NaN, if the face is degenerate, or if
 *        the gradient overflows a `double`
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among
 *           `vertex_point_map` and `geom_traits`, as for `approximate_geodesic_distances()`
 *
 * \throws std::invalid_argument if a face is not a triangle. The message names the face. In this
 *         case, nothing is written.
 *
 * Run time is \cgalBigO{n} for `n` faces.
 *
 * \sa `approximate_geodesic_distances()`
 * \sa `isolines()`
 */
template <typename TriangleMesh,
          typename VertexDistanceMap,
          typename FaceVectorMap,
          typename NamedParameters = parameters::Default_named_parameters>
void gradient(const TriangleMesh& tmesh,
              const VertexDistanceMap& vertex_distance_map,
              FaceVectorMap face_vector_map,
              const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::ignores_any<NamedParameters>,
                "gradient() reads vertex_point_map and geom_traits only; other parameters "
                "are for the function that computes the distances");
  using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;

  internal::check_triangles(tmesh);
  const auto point_map = internal::vertex_point_map(tmesh, np);
  const auto traits =
      parameters::choose_parameter<Traits>(parameters::get_parameter(np, internal_np::geom_traits));

  for(const auto f : faces(tmesh))
  {
    std::array<typename Traits::Point_3, 3> points;
    std::array<double, 3> values;
    bool is_reached = true;
    std::size_t i = 0;
    for(const auto v : vertices_around_face(halfedge(f, tmesh), tmesh))
    {
      points[i] = get(point_map, v);
      values[i] = CGAL::to_double(get(vertex_distance_map, v));
      is_reached = is_reached && std::isfinite(values[i]);
      ++i;
    }
    put(face_vector_map, f,
        is_reached ? internal::gradient_of_face(points, values, traits)
                   : traits.construct_vector_3_object()(NULL_VECTOR));
  }
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_CONSTRUCTIONS_GRADIENT_H
