// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Opposite_ranks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The edges of a mesh: what a search along edges requires of an `Intrinsic_triangulation`, under
 * the same names, with halfedges grouped in the same way. Vertices have their indices in the mesh.
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

  // Run time is logarithmic.
  Index source(const Index h) const
  {
    const auto beyond = std::upper_bound(first_of_vertex.begin(), first_of_vertex.end(), h);
    return static_cast<Index>(beyond - first_of_vertex.begin()) - 1;
  }

  // the index of a vertex in the mesh
  static Index index(const Index v) { return v; }

  std::vector<Index> first_of_vertex; // prefix sums of the degrees
  std::vector<Index> target_of_halfedge;
};

/*
 * The connectivity of a mesh: the same arrays as in an `Intrinsic_triangulation`.
 */
struct Connectivity : Vertex_adjacency
{
  bool has_border() const { return 3 * number_of_faces < number_of_halfedges(); }

  Opposite_ranks opposite_rank;
  std::vector<bool> is_border; // per halfedge, or empty if there is no border
  std::size_t number_of_faces = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H
