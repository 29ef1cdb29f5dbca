// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_TRAITS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_TRAITS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <type_traits>
#include <utility>

// Type traits of arguments that refer to a mesh.

namespace CGAL::Approximate_geodesics::internal {

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

// Whether the point type belongs to a kernel.
template <typename Point, typename = void>
constexpr bool is_point_of_kernel = false;

template <typename Point>
constexpr bool
    is_point_of_kernel<Point,
                       std::void_t<typename Kernel_traits<Point>::Kernel::Construct_barycenter_3>> =
        true;

// Detects the traits of CGAL's exact class, passed by mistake in place of the mesh.
template <typename T, typename = void>
constexpr bool is_traits_of_exact_class = false;

template <typename T>
constexpr bool
    is_traits_of_exact_class<T,
                             std::void_t<typename T::Triangle_mesh,
                                         typename T::Compute_parametric_distance_along_segment_2>> =
        true;

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_TRAITS_H
