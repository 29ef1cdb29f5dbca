// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_READ_CHANGES_H
#define CGAL_GEODESIC_COSTS_INTERNAL_READ_CHANGES_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Geodesic_costs/read_face_weights.h>
#include <CGAL/Geodesic_costs/triangulation_changes.h>
#include <CGAL/number_utils.h>

#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Reads changes of weights and barriers in terms of a mesh.
 */
template <typename Translation>
class Change_reader
{
public:
  Change_reader(const Translation& translation, const Intrinsic_triangulation& triangulation)
    : m_translation(translation), m_triangulation(triangulation)
  {
  }

  // Reads the weights of all faces.
  template <typename FaceWeightMap>
  Face_weights face_weights(const FaceWeightMap& face_weight_map) const
  {
    return read_face_weights(m_translation.mesh(), m_triangulation, face_weight_map,
                             parameters::vertex_index_map(m_translation.index_map()));
  }

  // Converts pairs of a face and its new weight.
  template <typename Changes>
  std::vector<Weight_change> weights(const Changes& changes) const
  {
    std::vector<Weight_change> result;
    for(const auto& [face, weight] : changes)
      result.push_back({m_translation.halfedge_of(face), CGAL::to_double(weight)});
    return result;
  }

  // Converts pairs of an edge and whether it is a barrier.
  template <typename Changes>
  std::vector<Barrier_change> barriers(const Changes& changes) const
  {
    constexpr double middle = 0.5;
    std::vector<Barrier_change> result;
    for(const auto& [edge, is_barrier] : changes)
      result.push_back(
          {m_translation.intrinsic_point(halfedge(edge, m_translation.mesh()), middle).halfedge,
           is_barrier});
    return result;
  }

private:
  const Translation& m_translation;
  const Intrinsic_triangulation& m_triangulation;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_READ_CHANGES_H
