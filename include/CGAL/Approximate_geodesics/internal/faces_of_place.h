// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_FACES_OF_PLACE_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_FACES_OF_PLACE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Place.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// The halfedges of the face to the left of `h`, from that on.
inline std::array<Place::Index, 3> halfedges_of_face(const Intrinsic_triangulation& triangulation,
                                                     const Place::Index h)
{
  const Place::Index second = triangulation.next(h);
  return {h, second, triangulation.next(second)};
}

// Calls `f(h)` for a halfedge of every face that a place lies in, or at the border of.
template <typename F>
void for_each_face(const Intrinsic_triangulation& triangulation, const Place& place, F f)
{
  const auto call = [&](const Place::Index h) {
    if(!triangulation.is_border(h))
      f(h);
  };
  if(place.is_vertex())
    for(Place::Index h = triangulation.first_halfedge(place.vertex);
        h < triangulation.beyond_halfedge(place.vertex); ++h)
      call(h);
  else
    call(place.halfedge);
  if(place.is_on_edge())
    call(triangulation.opposite(place.halfedge));
}

// Barycentric coordinates in the face to the left of a halfedge: those of its source, its target,
// and the third vertex.
using Weights = std::array<double, 3>;

// Calls `f(weights)` with where a place is in the face to the left of `h`. That is nowhere if the
// place lies in other faces only, and can be twice if two sides of the face are the same edge.
template <typename F>
void for_each_weights(const Intrinsic_triangulation& triangulation,
                      const Place& place,
                      const Place::Index h,
                      F f)
{
  const std::array<Place::Index, 3> sides = halfedges_of_face(triangulation, h);
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t source = i, target = (i + 1) % 3, third = (i + 2) % 3;
    Weights weights{0, 0, 0};
    if(place.is_vertex())
    {
      if(triangulation.target(sides[third]) != place.vertex)
        continue;
      weights[source] = 1;
    }
    else if(sides[i] == place.halfedge)
    {
      weights[source] = 1 - place.t - place.s;
      weights[target] = place.t;
      weights[third] = place.s;
    }
    else if(place.is_on_edge() && triangulation.opposite(sides[i]) == place.halfedge)
    {
      weights[source] = place.t;
      weights[target] = 1 - place.t;
    }
    else
      continue;
    f(weights);
  }
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_FACES_OF_PLACE_H
