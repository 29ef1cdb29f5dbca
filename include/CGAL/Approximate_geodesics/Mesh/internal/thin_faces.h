// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_THIN_FACES_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_THIN_FACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Double_double.h>
#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Thin_faces.h>

#include <array>
#include <cstddef>
#include <vector>

// Computes the shapes of thin faces from coordinates, with twice as many digits as these have.

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

using Accurate_vector = std::array<Double_double, 3>;

inline Accurate_vector accurate_difference(const Space_vector& a, const Space_vector& b)
{
  return {exact_sum(a[0], -b[0]), exact_sum(a[1], -b[1]), exact_sum(a[2], -b[2])};
}

inline double accurate_dot(const Accurate_vector& a, const Accurate_vector& b)
{
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).high;
}

// the area of the parallelogram with these sides
inline double accurate_area(const Accurate_vector& a, const Accurate_vector& b)
{
  return accurate_length({(a[1] * b[2] - a[2] * b[1]).high, (a[2] * b[0] - a[0] * b[2]).high,
                          (a[0] * b[1] - a[1] * b[0]).high});
}

// The shape of a face with these corners.
inline Thin_face thin_face(const Space_vector& p, const Space_vector& q, const Space_vector& r)
{
  const std::array<Accurate_vector, 3> side{accurate_difference(q, p), accurate_difference(r, q),
                                            accurate_difference(p, r)};
  Thin_face result{};
  std::size_t longest = 0; // left out of the area, whose error grows with the two sides
  std::array<double, 3> squared_length{};
  for(std::size_t i = 0; i < 3; ++i)
  {
    result.at_corner[i] = -accurate_dot(side[i], side[(i + 2) % 3]);
    squared_length[i] = accurate_dot(side[i], side[i]);
    if(squared_length[i] > squared_length[longest])
      longest = i;
  }
  result.doubled_area = accurate_area(side[(longest + 1) % 3], side[(longest + 2) % 3]);
  return result;
}

// The faces of a triangulation whose shapes its lengths say too little of. Its vertices have these
// points, in its unit.
inline Thin_faces thin_faces(const std::vector<Space_vector>& points,
                             const Intrinsic_triangulation& triangulation)
{
  using Index = Intrinsic_triangulation::Index;

  Thin_faces result;
  for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
    for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
    {
      const Index third = triangulation.counterclockwise(v, h); // seen from the other end
      const Index target = triangulation.target(h), apex = triangulation.target(third);
      if((target < v) | (apex < v) || triangulation.is_border(h)) // mostly another one is the first
        continue;
      const Thin_faces::Halfedges sides = triangulation.halfedges_of_face(h);
      if(h < sides[1] && h < sides[2] &&
         Thin_faces::is_thin(triangulation.length(h), triangulation.length(sides[1]),
                             triangulation.length(third)))
        result.add(sides, thin_face(points[v], points[target], points[apex]));
    }
  result.shrink_to_fit();
  return result;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_THIN_FACES_H
