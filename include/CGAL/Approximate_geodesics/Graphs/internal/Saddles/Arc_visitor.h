// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ARC_VISITOR_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ARC_VISITOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Arrival.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

namespace CGAL::Approximate_geodesics::internal {

// Reports what is seen to a search, and knows what its labels tell.
template <typename Labels, typename F>
struct Arc_visitor : Sight_visitor_base
{
  using Node = Intrinsic_triangulation::Index;

  static constexpr bool knows_arrivals = true;

  double bound(const Node v) const { return labels.bound(v); }
  double label(const Node v) const { return labels.distance(v); }
  const Arrival& arrival(const Node v) const { return labels.arrival(v); }
  bool has_predecessor(const Node v) const
  {
    return labels.predecessor(v) != Intrinsic_triangulation::null_index;
  }

  void on_vertex(const Node v,
                 const Sight_path& path,
                 const Sight& sight,
                 const Plane_vector apex,
                 const Plane_vector left_edge)
  {
    f(v, path.length, sight.arrival(path, apex, left_edge));
  }

  const Labels& labels;
  F& f;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ARC_VISITOR_H
