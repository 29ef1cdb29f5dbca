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

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_FACES_OF_PLACE_H
