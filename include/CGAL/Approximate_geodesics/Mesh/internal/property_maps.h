// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_PROPERTY_MAPS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_PROPERTY_MAPS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/function_property_map.hpp>

#include <functional>
#include <utility>

// The property maps of a mesh: the given map, or else the internal one. CGAL's functions assert
// that a given index map is valid. Here, indices are checked when they are used, in all build
// types, and invalid ones are rejected with an exception that names the index.

namespace CGAL::Approximate_geodesics::internal {

template <typename TriangleMesh, typename NamedParameters>
auto vertex_index_map(const TriangleMesh& tmesh, const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::vertex_index_t>)
    return parameters::get_parameter(np, internal_np::vertex_index);
  else
    return get_initialized_vertex_index_map(tmesh, np);
}

template <typename TriangleMesh, typename NamedParameters>
auto halfedge_index_map(const TriangleMesh& tmesh, const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::halfedge_index_t>)
    return parameters::get_parameter(np, internal_np::halfedge_index);
  else
    return get_initialized_halfedge_index_map(tmesh, np);
}

template <typename TriangleMesh, typename NamedParameters>
auto vertex_point_map(const TriangleMesh& tmesh, const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::vertex_point_t>)
    return parameters::get_parameter(np, internal_np::vertex_point);
  else
    return get_const_property_map(CGAL::vertex_point, tmesh);
}

// Whether the point type belongs to a kernel.
template <typename Point>
constexpr bool is_point_of_kernel = is_valid<Point>(
    [](auto p) -> typename Kernel_traits<decltype(p)>::Kernel::Construct_barycenter_3 {});

template <typename Vector_3>
Space_vector space_vector(const Vector_3& v)
{
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

template <typename Kernel>
typename Kernel::Vector_3 vector_3(const Space_vector& v)
{
  using FT = typename Kernel::FT;
  return typename Kernel::Vector_3(FT(v[0]), FT(v[1]), FT(v[2]));
}

// Whether `Map` is a writable property map for distances.
template <typename Map, typename Key>
constexpr bool takes_distances =
    is_valid<Map&>([](auto& map) -> decltype(put(map, std::declval<const Key&>(), double())) {});

// A type-erased readable property map, so that the map type is not a template argument of classes
// that store it.
template <typename Key, typename Value>
using Function_property_map =
    boost::function_property_map<std::function<Value(const Key&)>, Key, Value>;

template <typename Key, typename Value, typename Map>
Function_property_map<Key, Value> function_property_map(const Map& map)
{
  return Function_property_map<Key, Value>(
      [map](const Key& key) { return static_cast<Value>(get(map, key)); });
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_PROPERTY_MAPS_H
