// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_ARE_SAME_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_ARE_SAME_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Whether two places are the same point of the same edge or face, or the same vertex.
inline bool are_same(const Intrinsic_point& p,
                     const Intrinsic_point& q,
                     const Intrinsic_triangulation& triangulation)
{
  if(p.is_vertex() || q.is_vertex())
    return p.vertex == q.vertex;
  if(p.halfedge == q.halfedge)
    return p.t == q.t && p.s == q.s;
  return p.is_on_edge() && q.is_on_edge() && p.halfedge == triangulation.opposite(q.halfedge) &&
         p.t == 1 - q.t;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_ARE_SAME_H
