// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_NODES_BESIDE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_NODES_BESIDE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>

#include <cstddef>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// Whether an attached point tells the nodes on sides of faces, as that of a Steiner graph does.
template <typename Attachment>
constexpr bool tells_nodes_on_sides = is_valid<const Attachment&>(
    [](auto& a) -> decltype(a.for_each_node_on_side(Index(),
                                                    std::declval<void (*)(Index, double)>())) {});

// Calls `f(node, cost, foot)` for the nodes of the faces that contain the segment between two
// points of a curve, if they are nearest to a point inside it. Costs must not depend on the
// direction.
template <typename Attachment, typename F>
void for_each_node_of_sides(const Intrinsic_triangulation& triangulation,
                            const Attachment& attached,
                            const Intrinsic_point& from,
                            const Intrinsic_point& to,
                            F f)
{
  for_each_segment(triangulation, from, to, [&](const Curve_segment& segment) {
    const Index h = segment.from.halfedge;
    if(!triangulation.is_open(h))
      return;
    const Segment_layout layout(triangulation, segment);
    for(std::size_t i = 0; i < 3; ++i)
      attached.for_each_node_on_side(layout.halfedge(i), [&](const Index node, const double part) {
        const Plane_vector p = layout.corner(i) + part * layout.edge(i, (i + 1) % 3);
        if(const double t = layout.nearest_part(p); t > 0 && t < 1)
          f(node, attached.cost_across(h, {0, p.y}), segment.point(triangulation, t));
      });
  });
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_NODES_BESIDE_H
