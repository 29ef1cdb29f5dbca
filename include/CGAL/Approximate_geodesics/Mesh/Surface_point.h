// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/type_traits/detected_or.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
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

template <typename T>
using Begin_of_range = decltype(*std::begin(std::declval<const T&>()));

// The type of the elements of a range, or `T` itself.
template <typename T>
using Element_of_range = std::decay_t<boost::detected_or_t<T, Begin_of_range, T>>;

template <typename TriangleMesh, typename T>
constexpr bool is_vertex =
    std::is_convertible_v<T, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>;

// Whether `T` is a vertex of a mesh, or a range of vertices.
template <typename TriangleMesh, typename T>
constexpr bool are_vertices =
    is_vertex<TriangleMesh, T> || is_vertex<TriangleMesh, Element_of_range<T>>;

// Whether `T` is a single point on the surface of a mesh.
template <typename TriangleMesh, typename T>
constexpr bool is_surface_point =
    is_vertex<TriangleMesh, T> || std::is_same_v<T, Surface_point<TriangleMesh>> || is_pair<T>;

// Whether `T` is a point on the surface of a mesh, or a range of points.
template <typename TriangleMesh, typename T>
constexpr bool is_source =
    is_surface_point<TriangleMesh, T> || is_surface_point<TriangleMesh, Element_of_range<T>>;

// Whether a descriptor is not null, in range and not marked as removed, as far as the mesh type can
// tell.
template <typename TriangleMesh, typename Descriptor, typename Size>
bool may_be_element(const Descriptor d,
                    const Descriptor null,
                    [[maybe_unused]] const Size size,
                    [[maybe_unused]] const TriangleMesh& tmesh)
{
  bool result = d != null;
  if constexpr(std::is_convertible_v<Descriptor, std::size_t>)
    result = result && static_cast<std::size_t>(d) < static_cast<std::size_t>(size);
  if constexpr(is_valid<const TriangleMesh&>(
                   [](auto& t) -> decltype(t.is_removed(std::declval<Descriptor>())) {}))
    result = result && !tmesh.is_removed(d);
  return result;
}

// Returns the location of `(1 - t - s) a + t b + s c`, where `a` and `b` are the source and the
// target of `h`, and `c` is the third vertex of its face.
template <typename TriangleMesh>
Face_location<TriangleMesh>
location_in_face(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                 const double t,
                 const double s,
                 const TriangleMesh& tmesh)
{
  const auto f = face(h, tmesh);
  const auto first = halfedge(f, tmesh);
  const double rest = 1 - t - s;
  if(h == first)
    return {f, {rest, t, s}};
  if(h == next(first, tmesh))
    return {f, {s, rest, t}};
  return {f, {t, s, rest}};
}

// Names an element that is not in the mesh by its index, if descriptors are integers.
template <typename Descriptor>
[[noreturn]] void reject_element(const std::string& kind, const Descriptor d, const Descriptor null)
{
  std::string name = (d == null ? "the null " : "the ") + kind;
  if constexpr(std::is_convertible_v<Descriptor, std::size_t>)
    if(d != null)
      name = kind + ' ' + std::to_string(static_cast<std::size_t>(d));
  reject(name + " is not in the mesh");
}

// The following functions check points that users pass.

template <typename TriangleMesh>
void check_point(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                 const double t,
                 const TriangleMesh& tmesh)
{
  const auto null = boost::graph_traits<TriangleMesh>::null_halfedge();
  if(!may_be_element(h, null, num_halfedges(tmesh), tmesh))
    reject_element("halfedge", h, null);
  if(!(t >= 0 && t <= 1)) // or NaN
    reject("the parameter along a halfedge is " + text_of(t) + "; it must be a number from 0 to 1");
}

constexpr double rounding_of_weights = 1e-15; // of barycentric coordinates

template <typename FT>
std::string text_of(const std::array<FT, 3>& numbers)
{
  const auto text = [&](const std::size_t i) { return text_of(CGAL::to_double(numbers[i])); };
  return text(0) + ", " + text(1) + ", " + text(2);
}

// Returns barycentric coordinates whose sum is 1, with values within rounding errors snapped to
// zero. Throws if they are negative, not finite, or have another sum, or if the face is not in the
// mesh.
template <typename TriangleMesh, typename FT>
std::array<double, 3>
checked_weights(const typename boost::graph_traits<TriangleMesh>::face_descriptor f,
                const std::array<FT, 3>& coordinates,
                const TriangleMesh& tmesh)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  const bool may_be_face = may_be_element(f, Graph_traits::null_face(), num_faces(tmesh), tmesh);
  const auto h = may_be_face ? halfedge(f, tmesh) : Graph_traits::null_halfedge();
  if(h == Graph_traits::null_halfedge() || face(h, tmesh) != f) // or `f` was removed
    reject_element("face", f, Graph_traits::null_face());

  constexpr double tolerance = 1e-9;
  std::array<double, 3> result{CGAL::to_double(coordinates[0]), CGAL::to_double(coordinates[1]),
                               CGAL::to_double(coordinates[2])};
  double sum = result[0] + result[1] + result[2];
  const double smallest = *std::min_element(result.begin(), result.end());
  if(!(smallest >= -tolerance && std::abs(sum - 1) <= tolerance)) // or NaN
    reject("barycentric coordinates are " + text_of(coordinates) +
           "; they must not be negative, and their sum must be 1");
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
