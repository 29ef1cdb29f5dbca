// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_WINDING_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_WINDING_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

// A halfedge that straight lines from the origin meet, laid out between two points.
struct Crossing
{
  using Index = Intrinsic_triangulation::Index;

  Index halfedge = Intrinsic_triangulation::null_index;
  Plane_vector source = {0, 0}, target = {0, 0};

  Plane_vector point(const double t) const { return source + t * (target - source); }

  // Where a ray crosses the edge: 0 at the source, which is to its left, and 1 at the target;
  // `otherwise` if they are parallel.
  double part(const Plane_vector ray, const double otherwise) const
  {
    const double left = cross(ray, source), right = cross(ray, target);
    return left > right ? (std::clamp)(left / (left - right), 0., 1.) : otherwise;
  }
};

/*
 * Decides when to give up straight lines that come back to a halfedge.
 *
 * On a mesh in space, a segment in a face is a shortest path. So a shortest path meets a face only
 * once, while straight lines may wind around a spike many times. To detect that, lines remember
 * where they met one halfedge, and replace it by a later one each time the number of faces doubles,
 * as in Brent's cycle detection (R. P. Brent, An improved Monte Carlo factorization algorithm,
 * 1980).
 *
 * If only lengths are given, edges may wind around the surface like a spring, so that a shortest
 * path crosses them repeatedly. Then lines are given up if the path straight to the edge, where
 * they first met it, and then along the edge, is not longer. Faces that are thinner than rounding
 * errors are met only once in any case.
 */
class Winding
{
public:
  explicit Winding(const Intrinsic_triangulation& triangulation)
    : m_may_return(triangulation.lines_may_return())
  {
  }

  // Whether the lines between two rays are given up at a halfedge, given an earlier one. The next
  // face has this height, in lengths of the halfedge.
  bool is_over(const Crossing& here,
               const Crossing& earlier,
               const Plane_vector left_ray,
               const Plane_vector right_ray,
               const double height) const
  {
    constexpr double smallest_height = 1e-8;
    return here.halfedge == earlier.halfedge && (!m_may_return || !(height > smallest_height) ||
                                                 is_detour(here, earlier, left_ray, right_ray));
  }

  // Whether a line remembers the halfedge that it meets after `depth` faces.
  static bool is_milestone(const std::uint32_t depth) { return (depth & (depth + 1)) == 0; }

private:
  // Whether all points of the edge that the lines meet now are reached by an alternative path that
  // is not longer, up to rounding. It is enough to check both ends: outward along the edge from the
  // earlier points, the alternative grows by the length along the edge, and a line does not grow
  // faster; between these points, the alternative is a line as well, and which of two lines is
  // longer changes at most once along an edge.
  static bool is_detour(const Crossing& here,
                        const Crossing& earlier,
                        const Plane_vector left_ray,
                        const Plane_vector right_ray)
  {
    const double left = earlier.part(left_ray, 0), right = earlier.part(right_ray, 1);
    const double edge = length(here.target - here.source);
    const auto is_beaten = [&](const double t) {
      const double nearest = (std::clamp)(t, (std::min)(left, right), (std::max)(left, right));
      const double detour = length(earlier.point(nearest)) + std::abs(t - nearest) * edge;
      return detour <= length(here.point(t)) * (1 + 1e-12) + edge * 1e-15;
    };
    return is_beaten(here.part(left_ray, 0)) && is_beaten(here.part(right_ray, 1));
  }

  bool m_may_return;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_WINDING_H
