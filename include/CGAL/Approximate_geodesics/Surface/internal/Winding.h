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

/*
 * Where straight lines from the origin meet a halfedge, which is laid out between these two points.
 */
struct Crossing
{
  using Index = Intrinsic_triangulation::Index;

  Index halfedge = Intrinsic_triangulation::null_index;
  Plane_vector source = {0, 0}, target = {0, 0};

  Plane_vector point(const double t) const { return source + t * (target - source); }

  // The part of the way from the source, which is to the left of the ray, to the target that the
  // ray is at; `otherwise` if it goes along the edge.
  double part(const Plane_vector ray, const double otherwise) const
  {
    const double left = cross(ray, source), right = cross(ray, target);
    return left > right ? (std::clamp)(left / (left - right), 0., 1.) : otherwise;
  }
};

/*
 * Decides when to give up straight lines that come back to a halfedge.
 *
 * In space, a segment in a face is a shortest path. So a shortest path meets a face only once,
 * while straight lines may wind round a spike for long. To notice that they have come round again,
 * they remember where they met one halfedge, a later one each time that the way is twice as long,
 * as Brent does to find a cycle (R. P. Brent, An improved Monte Carlo factorization algorithm,
 * 1980).
 *
 * If only lengths are given, the edges themselves can wind round the surface, as on a spring, and a
 * shortest path crosses them again and again. Then lines are given up if it is no longer to go
 * straight to the edge, as when they first met it, and then along the edge. Faces that are thinner
 * than their lengths can tell are met once in any case.
 */
class Winding
{
public:
  explicit Winding(const Intrinsic_triangulation& triangulation)
    : m_may_return(triangulation.lines_may_return())
  {
  }

  // Whether a shortest path may come back to a face.
  bool may_return() const { return m_may_return; }

  // Whether the lines between two rays are given up at a halfedge, given an earlier one. The face
  // ahead is `height` times as high above it as it is long.
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
  // Whether all points of the edge that the lines meet now are reached on a way that is no longer,
  // up to rounding. What a way saves gets less from the lines' earlier points outwards along the
  // edge, as that of a line does not grow faster than the way along the edge. Between these points,
  // it is a straight line, too; and which of two lines is longer changes at most once on an edge.
  // So it is enough to look at both ends.
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
