// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_LABEL_PRUNING_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_LABEL_PRUNING_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

namespace CGAL::Approximate_geodesics::internal {

// Does what another visitor does, but for windows that a search with these labels need not look
// through: if all that lies behind one is reached well enough over an end of its edge. See
// `Cone_front`, which does this for many cones together.
template <typename Visitor, typename Labels>
struct Label_pruning : Visitor
{
  static constexpr bool wants_distances = true;

  bool prune(const Window& w) const
  {
    const double edge = triangulation.length(w.halfedge);
    return labels.distance(w.left_end) - label_of_tip < factor * (w.right_distance - edge) ||
           labels.distance(w.right_end) - label_of_tip < factor * (w.left_distance - edge);
  }

  const Intrinsic_triangulation& triangulation;
  const Labels& labels;
  double label_of_tip;
  double factor; // of what is left of the way, in comparisons
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_LABEL_PRUNING_H
