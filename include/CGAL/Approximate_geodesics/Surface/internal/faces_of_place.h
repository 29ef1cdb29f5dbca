// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACES_OF_PLACE_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACES_OF_PLACE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <array>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// The halfedges of the face to the left of `h`, from that on.
inline std::array<Intrinsic_point::Index, 3>
halfedges_of_face(const Intrinsic_triangulation& triangulation, const Intrinsic_point::Index h)
{
  const Intrinsic_point::Index second = triangulation.next(h);
  return {h, second, triangulation.next(second)};
}

// Calls `f(h)` for a halfedge of every face that a place lies in, or at the border of.
template <typename F>
void for_each_face(const Intrinsic_triangulation& triangulation, const Intrinsic_point& place, F f)
{
  const auto call = [&](const Intrinsic_point::Index h) {
    if(!triangulation.is_border(h))
      f(h);
  };
  if(place.is_vertex())
    for(Intrinsic_point::Index h = triangulation.first_halfedge(place.vertex);
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

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_FACES_OF_PLACE_H
