// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_INDEX_MAPS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_INDEX_MAPS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

// Index maps: the one given, as it is, or else the mesh's own. CGAL's functions assert that a map
// that is given is right; here, it is checked when it is used, in all build types, and a wrong one
// is refused with an exception that names the index.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

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

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_INDEX_MAPS_H
