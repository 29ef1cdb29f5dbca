// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Opposite_ranks.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Vertex_adjacency.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * How a mesh hangs together: the arrays of an `Intrinsic_triangulation` that say so.
 */
struct Connectivity : Vertex_adjacency
{
  bool has_border() const { return 3 * number_of_faces < number_of_halfedges(); }

  Opposite_ranks opposite_rank;
  std::vector<bool> is_border; // per halfedge, or empty if there is no border
  std::size_t number_of_faces = 0;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H
