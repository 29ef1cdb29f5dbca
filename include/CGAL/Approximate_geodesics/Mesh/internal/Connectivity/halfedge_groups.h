// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_HALFEDGE_GROUPS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_HALFEDGE_GROUPS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

// The numbering of the halfedges around a vertex of a mesh.

namespace CGAL::Approximate_geodesics::internal {

// Returns the first halfedge from `v`, or a null halfedge if `v` is isolated.
template <typename TriangleMesh>
auto first_halfedge_from(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                         const TriangleMesh& tmesh)
{
  const auto h = halfedge(v, tmesh);
  return h == boost::graph_traits<TriangleMesh>::null_halfedge() ? h : opposite(h, tmesh);
}

// Returns the next halfedge around the source of `h`, or a null halfedge if the mesh is invalid
// there.
template <typename TriangleMesh>
auto counterclockwise(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                      const TriangleMesh& tmesh)
{
  const auto before = prev(h, tmesh);
  return before == boost::graph_traits<TriangleMesh>::null_halfedge() ? before
                                                                      : opposite(before, tmesh);
}

// Returns all halfedges in the order of `connectivity`, which must be valid.
template <typename TriangleMesh, typename Vertices, typename Connectivity>
auto halfedges_in_groups(const Vertices& vertices,
                         const Connectivity& connectivity,
                         const TriangleMesh& tmesh)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result;
  result.reserve(connectivity.number_of_halfedges());
  for(typename Connectivity::Index v = 0; v < vertices.size(); ++v)
  {
    auto h = first_halfedge_from(vertices[v], tmesh);
    for(auto left = connectivity.degree(v); left > 0; --left)
    {
      result.push_back(h);
      h = counterclockwise(h, tmesh);
    }
  }
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_HALFEDGE_GROUPS_H
