// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_VERTEX_ADJACENCY_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_VERTEX_ADJACENCY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The vertices of a mesh by their indices, and which of them are neighbors: as much of an
 * `Intrinsic_triangulation` as a search along edges needs, under the same names. Halfedges are
 * grouped in the same way.
 */
struct Vertex_adjacency
{
  using Index = std::uint32_t;

  Index number_of_vertices() const { return static_cast<Index>(first_of_vertex.size() - 1); }
  Index number_of_halfedges() const { return first_of_vertex.back(); }

  Index first_halfedge(const Index v) const { return first_of_vertex[v]; }
  Index beyond_halfedge(const Index v) const { return first_of_vertex[v + 1]; }
  Index degree(const Index v) const { return beyond_halfedge(v) - first_halfedge(v); }

  Index target(const Index h) const { return target_of_halfedge[h]; }

  // for messages: takes some time
  Index source(const Index h) const
  {
    const auto beyond = std::upper_bound(first_of_vertex.begin(), first_of_vertex.end(), h);
    return static_cast<Index>(beyond - first_of_vertex.begin()) - 1;
  }

  // the index of a vertex in the mesh
  static Index index(const Index v) { return v; }

  std::vector<Index> first_of_vertex; // and one beyond
  std::vector<Index> target_of_halfedge;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_VERTEX_ADJACENCY_H
