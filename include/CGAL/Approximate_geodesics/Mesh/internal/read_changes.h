// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_CHANGES_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_CHANGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/number_utils.h>

#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Converts pairs of a face of a mesh and its new weight.
template <typename Translation, typename Changes>
std::vector<Weight_change> weight_changes(const Translation& translation, const Changes& changes)
{
  std::vector<Weight_change> result;
  for(const auto& [face, weight] : changes)
    result.push_back({translation.halfedge_of(face), CGAL::to_double(weight)});
  return result;
}

// Converts pairs of an edge and whether it is a barrier.
template <typename Translation, typename Changes>
std::vector<Barrier_change> barrier_changes(const Translation& translation, const Changes& changes)
{
  constexpr double middle = 0.5;
  std::vector<Barrier_change> result;
  for(const auto& [edge, is_barrier] : changes)
    result.push_back(
        {translation.intrinsic_point(halfedge(edge, translation.mesh()), middle).halfedge,
         is_barrier});
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_READ_CHANGES_H
