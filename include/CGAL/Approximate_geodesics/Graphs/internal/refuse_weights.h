// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_REFUSE_WEIGHTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_REFUSE_WEIGHTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <string>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// For graphs other than Steiner graphs, which do not heed what these parameters say.
template <typename NamedParameters>
void refuse_weights(const Intrinsic_triangulation& triangulation,
                    const NamedParameters& /* np */,
                    const char* const name)
{
  static_assert(!is_given<NamedParameters, internal_np::face_weight_t>,
                "face_weight_map: this graph knows no weights; use Steiner_graph");
  static_assert(!is_given<NamedParameters, internal_np::edge_is_constrained_t>,
                "edge_is_constrained_map: this graph knows no barriers; use Steiner_graph");
  static_assert(!is_given<NamedParameters, internal_np::number_of_points_per_edge_t>,
                "number_of_points_per_edge: this graph has no points on edges; use Steiner_graph");
  if(triangulation.has_weights() || triangulation.has_barriers())
    reject(std::string("a triangulation with ") +
           (triangulation.has_weights() ? "weights" : "barriers") + " was given to " + name +
           ", which does not heed them; use Steiner_graph");
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_REFUSE_WEIGHTS_H
