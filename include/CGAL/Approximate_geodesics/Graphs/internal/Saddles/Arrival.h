// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ARRIVAL_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ARRIVAL_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Where a straight line comes from that ends at a vertex. Either it comes along a halfedge that
 * ends at the vertex; or through a face, and then it has crossed the halfedge whose face is that
 * one. The direction back is a number from 0 to 2 that grows with the angle, from 0 to pi, to the
 * left of the side from the vertex to the source of the halfedge.
 *
 * The direction is unknown where the face is so thin at the vertex that rounding errors of
 * positions could change it. Then paths may go on in all directions: this costs time, and changes
 * no distance.
 */
struct Arrival
{
  using Index = Intrinsic_triangulation::Index;

  Index halfedge = Intrinsic_triangulation::null_index;
  float direction = 0;

  static constexpr float ALONG_HALFEDGE = -1;
  static constexpr float UNKNOWN = -2;
  static constexpr double ROUNDING = 1e-6; // of the angle

  static Arrival along(const Index halfedge) { return {halfedge, ALONG_HALFEDGE}; }

  // `way` is that from the tip to the vertex, and `side` that from the source of the halfedge.
  static Arrival across(const Index halfedge, const Plane_vector way, const Plane_vector side)
  {
    const double x = dot(side, way), y = cross(side, way);
    if(!(y > 0)) // along the side, but for rounding
      return {halfedge, x < 0 ? 2.f : 0.f};
    const double sum = std::abs(x) + y;
    return {halfedge, static_cast<float>(x < 0 ? 1 - x / sum : y / sum)};
  }

  static Arrival in_unknown_direction(const Index halfedge) { return {halfedge, UNKNOWN}; }

  // whether the vertex is where lines start from
  bool is_none() const { return halfedge == Intrinsic_triangulation::null_index; }
  bool is_unknown() const { return direction == UNKNOWN; }
  bool has_direction() const { return direction >= 0; }
  bool is_along_halfedge() const { return direction == ALONG_HALFEDGE; }

  // the direction back, as a unit vector, where the side is the x axis
  Plane_vector way_back() const
  {
    const double d = direction;
    const Plane_vector result = d > 1 ? Plane_vector{1 - d, 2 - d} : Plane_vector{1 - d, d};
    return 1 / length(result) * result;
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_ARRIVAL_H
