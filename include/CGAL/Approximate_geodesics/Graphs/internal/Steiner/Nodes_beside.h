// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_NODES_BESIDE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_NODES_BESIDE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_curve.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

// Calls `f(node, cost, foot)` for the nodes of the faces that contain the segment between two
// points of a curve, if they are nearest to a point inside it. Costs must not depend on the
// direction.
template <typename Costs, typename F>
void for_each_node_beside(const Intrinsic_triangulation& triangulation,
                          const Steiner_nodes& nodes,
                          const Costs& costs,
                          const Intrinsic_point& from,
                          const Intrinsic_point& to,
                          F f)
{
  for_each_segment(triangulation, from, to, [&](const Curve_segment& segment) {
    const Index h = segment.from.halfedge;
    if(!triangulation.is_open(h))
      return;
    const Segment_layout layout(triangulation, segment);
    const auto offer = [&](const Index node, const Plane_vector position) {
      if(const double t = layout.nearest_part(position); t > 0 && t < 1)
        f(node, costs.across(h, {0, position.y}), segment.point(triangulation, t));
    };
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Index side = layout.halfedge(i);
      offer(nodes.at_corner(triangulation.source(side), side), layout.corner(i));
      nodes.for_each_node_on_edge(side, [&](const Index node, const double part) {
        offer(node, layout.corner(i) + part * layout.edge(i, (i + 1) % 3));
      });
    }
  });
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_NODES_BESIDE_H
