// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_MAXIMUM_DEGREE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_MAXIMUM_DEGREE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Points_on_edges.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// An upper bound of the number of arcs that start from a node of a Steiner graph.
inline std::size_t maximum_degree(const Intrinsic_triangulation& triangulation,
                                  const Points_on_edges& points)
{
  using Index = Intrinsic_triangulation::Index;
  // on the edge opposite to the source of `h`, in the face to the left of `h`
  const auto number_of_opposite_points = [&](const Index h) {
    return triangulation.is_border(h)
               ? std::size_t(0)
               : std::size_t(points.number_of_points(points.edge(triangulation.next(h))));
  };
  std::size_t result = 0;
  for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
  {
    std::size_t degree = 1; // to the vertex, from one of its sectors
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      degree += 2 + number_of_opposite_points(h); // a barrier is two edges
    result = (std::max)(result, degree);
  }
  points.for_each_first_halfedge([&](const Index h, Index /* edge */) {
    std::size_t degree = 4; // along the edge, and to the third vertices of both faces
    for(const Index side : {h, triangulation.opposite(h)})
      if(!triangulation.is_border(side))
        degree +=
            number_of_opposite_points(side) + number_of_opposite_points(triangulation.next(side));
    result = (std::max)(result, degree);
  });
  return result;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_MAXIMUM_DEGREE_H
