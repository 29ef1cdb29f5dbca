// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_LINES_IN_FACES_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_LINES_IN_FACES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Face_point.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Points_by_face.h>
#include <CGAL/Approximate_geodesics/Surface/internal/are_same.h>
#include <CGAL/Approximate_geodesics/Surface/internal/faces_of_place.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Calls `f(vertex, length)` for the straight lines from a place to the corners of its faces.
template <typename F>
void for_each_line_to_corner(const Intrinsic_triangulation& triangulation,
                             const Intrinsic_point& place,
                             F f)
{
  if(place.is_vertex())
  {
    f(place.vertex, 0.);
    return;
  }
  for_each_face(triangulation, place, [&](const Intrinsic_point::Index h) {
    for_each_face_point(triangulation, place, h, [&](const Face_point& p) {
      for(const Intrinsic_point::Index side : halfedges_of_face(triangulation, h))
        f(triangulation.source(side), distance(triangulation, p, Face_point::at_source(side)));
    });
  });
}

// The cost of the way along an edge between two places that lie on it, or infinity.
inline double cost_along_edge(const Intrinsic_triangulation& triangulation,
                              const Intrinsic_point& from,
                              const Intrinsic_point& to)
{
  const Intrinsic_point::Index h = from.halfedge, opposite = triangulation.opposite(h);
  if(!from.is_on_edge() || !to.is_on_edge() || (to.halfedge != h && to.halfedge != opposite))
    return std::numeric_limits<double>::infinity();
  const double difference = from.t - (to.halfedge == h ? to.t : 1 - to.t);
  const double weight =
      (std::min)(triangulation.weight_of_edge(h), triangulation.weight_of_edge(opposite));
  return weight * (std::abs(difference) * triangulation.length(h));
}

// Calls `f(i, cost)` for the straight lines from a place to those of the given ones that are in the
// same face.
template <typename F>
void for_each_line_in_face(const Intrinsic_triangulation& triangulation,
                           const Intrinsic_point& place,
                           const Points_by_face& places,
                           F f)
{
  for_each_face(triangulation, place, [&](const Intrinsic_point::Index h) {
    places.for_each_in_face(triangulation, h, [&](const std::size_t i) {
      if(are_same(place, places[i], triangulation))
      {
        f(i, 0.);
        return;
      }
      f(i, cost_along_edge(triangulation, place, places[i]));
      const double weight = triangulation.weight(h);
      if(!(weight < std::numeric_limits<double>::infinity()))
        return;
      for_each_face_point(triangulation, place, h, [&](const Face_point& p) {
        for_each_face_point(triangulation, places[i], h, [&](const Face_point& q) {
          f(i, weight * distance(triangulation, p, q));
        });
      });
    });
  });
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_LINES_IN_FACES_H
