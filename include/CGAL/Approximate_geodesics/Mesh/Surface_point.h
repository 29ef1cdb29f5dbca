// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsPoints
 *
 * a point of the surface of a mesh, given by a face and barycentric coordinates: the weights of the
 * source and the target of `halfedge(f, tmesh)`, and of the third vertex. \cgal's functions for
 * locating points use this representation.
 */
template <typename TriangleMesh>
using Face_location =
    std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>;

/*!
 * \ingroup PkgApproximateGeodesicsPoints
 *
 * a point of the surface of a mesh: a vertex; or a halfedge, and a parameter along it from `0` at
 * its source to `1` at its target; or a face, and barycentric coordinates in it.
 */
template <typename TriangleMesh>
using Surface_point =
    std::variant<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                 std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>,
                 Face_location<TriangleMesh>>;

namespace internal {

template <typename T>
constexpr bool is_pair = false;

template <typename T, typename U>
constexpr bool is_pair<std::pair<T, U>> = true;

// Whether `T` is a single point on the surface of a mesh.
template <typename TriangleMesh, typename T>
constexpr bool is_surface_point =
    std::is_convertible_v<T, typename boost::graph_traits<TriangleMesh>::vertex_descriptor> ||
    std::is_same_v<T, Surface_point<TriangleMesh>> || is_pair<T>;

template <typename T>
using Begin_of_range = decltype(*std::begin(std::declval<const T&>()));

// Whether `T` is a point on the surface of a mesh, or a range of points.
template <typename TriangleMesh, typename T, typename = void>
constexpr bool is_source = is_surface_point<TriangleMesh, T>;

template <typename TriangleMesh, typename T>
constexpr bool is_source<TriangleMesh, T, std::void_t<Begin_of_range<T>>> =
    is_surface_point<TriangleMesh, T> ||
    is_surface_point<TriangleMesh, std::decay_t<Begin_of_range<T>>>;

// Whether `T` is a vertex of a mesh, or a range of vertices.
template <typename TriangleMesh, typename T, typename = void>
constexpr bool are_vertices =
    std::is_convertible_v<T, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>;

template <typename TriangleMesh, typename T>
constexpr bool are_vertices<TriangleMesh, T, std::void_t<Begin_of_range<T>>> =
    std::is_convertible_v<T, typename boost::graph_traits<TriangleMesh>::vertex_descriptor> ||
    std::is_convertible_v<std::decay_t<Begin_of_range<T>>,
                          typename boost::graph_traits<TriangleMesh>::vertex_descriptor>;

template <typename TriangleMesh, typename Descriptor, typename = void>
constexpr bool tells_what_is_removed = false;

template <typename TriangleMesh, typename Descriptor>
constexpr bool
    tells_what_is_removed<TriangleMesh,
                          Descriptor,
                          std::void_t<decltype(std::declval<const TriangleMesh&>().is_removed(
                              std::declval<Descriptor>()))>> = true;

// Whether a descriptor is in range and not marked as removed, as far as the mesh type can tell.
template <typename TriangleMesh, typename Descriptor, typename Size>
bool may_be_element(const Descriptor d,
                    [[maybe_unused]] const Size size,
                    [[maybe_unused]] const TriangleMesh& tmesh)
{
  if constexpr(std::is_convertible_v<Descriptor, std::size_t>)
    if(static_cast<std::size_t>(d) >= static_cast<std::size_t>(size))
      return false;
  if constexpr(tells_what_is_removed<TriangleMesh, Descriptor>)
    return !tmesh.is_removed(d);
  else
    return true;
}

// Whether `t` is the parameter of a point along a halfedge. False for NaN.
inline bool is_parameter(const double t) { return t >= 0 && t <= 1; }

constexpr double rounding_of_weights = 1e-15; // of barycentric coordinates

// Returns barycentric coordinates whose sum is 1, with values within rounding errors snapped to
// zero, or nothing if they are negative, not finite, or have another sum.
template <typename FT>
std::optional<std::array<double, 3>> barycentric_weights(const std::array<FT, 3>& coordinates)
{
  constexpr double tolerance = 1e-9;
  std::array<double, 3> result{};
  double sum = 0;
  for(std::size_t i = 0; i < 3; ++i)
  {
    result[i] = CGAL::to_double(coordinates[i]);
    sum += result[i];
    if(!(result[i] >= -tolerance))
      return std::nullopt;
  }
  if(!(std::abs(sum - 1) <= tolerance))
    return std::nullopt;
  for(double& weight : result)
    weight = weight < rounding_of_weights ? 0 : weight;
  sum = result[0] + result[1] + result[2];
  for(double& weight : result)
    weight /= sum;
  return result;
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H
