// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_TRACE_ARC_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_TRACE_ARC_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/internal/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/internal/Unfolding.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Of the straight lines from one vertex to another that the graph has, the one of the given length.
template <typename Unfolding, typename Filter>
Straight_arc find_arc(const Cone_expansion<Unfolding>& expansion,
                      const Filter filter,
                      const Intrinsic_triangulation::Index source,
                      const Intrinsic_triangulation::Index target,
                      const double length)
{
  Straight_arc result{Intrinsic_triangulation::null_index, 0, {0, 0}, 0};
  double smallest_difference = std::numeric_limits<double>::infinity();
  expansion.expand(
      source,
      [&](const Straight_arc& arc) {
        const double difference = std::abs(arc.length - length);
        if(arc.target == target && difference < smallest_difference)
        {
          smallest_difference = difference;
          result = arc;
        }
      },
      filter);
  CGAL_postcondition(result.target == target);
  return result;
}

// Calls `f(h, t)` for every edge that `arc` crosses, from its source on: at the point that is at
// the part `t` of the way from the source to the target of the halfedge `h`.
template <typename F>
void for_each_crossing(const Intrinsic_triangulation& triangulation, const Straight_arc& arc, F f)
{
  using Index = Intrinsic_triangulation::Index;

  if(triangulation.target(arc.start) == arc.target && arc.position.y == 0)
    return; // an edge
  const Unfolding_on_demand unfolding(triangulation);
  const Unfolded_face first = unfolding.face(arc.start);
  const double length_of_start = triangulation.length(arc.start);
  Index h = first.right;
  Plane_vector right{length_of_start, 0};
  Plane_vector left{length_of_start * first.along, length_of_start * first.across};
  // An arc to a vertex crosses each of the faces before that once, so the number is a safety net.
  for(Index i = 0; h != Intrinsic_triangulation::null_index && i < triangulation.number_of_faces();
      ++i)
  {
    const double to_left = cross(arc.position, left), to_right = cross(right, arc.position);
    const double sum = to_left + to_right;
    f(h, sum > 0 ? (std::clamp)(to_left / sum, 0., 1.) : 0.5);
    const Unfolded_face face = unfolding.face(h);
    const Plane_vector apex = face.position_of_apex(left, right);
    const Plane_vector rest = apex - arc.position;
    if(face.apex == arc.target && length(rest) <= 1e-6 * (length(arc.position)))
      return;
    if(cross(arc.position, apex) >= 0)
    {
      left = apex;
      h = face.right;
    }
    else
    {
      right = apex;
      h = face.left;
    }
  }
}

// Likewise for the arc of the given length in a discrete geodesic graph, whose arcs were found with
// `filter`, or are some of those.
template <typename Filter, typename F>
void trace_arc(const Intrinsic_triangulation& triangulation,
               const double epsilon,
               const Filter filter,
               const Intrinsic_triangulation::Index source,
               const Intrinsic_triangulation::Index target,
               const double length,
               F f)
{
  const Unfolding_on_demand unfolding(triangulation);
  const Cone_expansion<Unfolding_on_demand> expansion(triangulation, unfolding, epsilon);
  for_each_crossing(triangulation, find_arc(expansion, filter, source, target, length), f);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_TRACE_ARC_H
