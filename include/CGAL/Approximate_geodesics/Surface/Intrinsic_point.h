// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * A place on a triangulated surface: a vertex, a point inside an edge, or a point inside a face.
 *
 * It is given by the numbers that an `Intrinsic_triangulation` has for vertices and halfedges.
 * Where the halfedge has the source \f$a\f$ and the target \f$b\f$, and the third vertex of the
 * face to its left is \f$c\f$, the point is \f$(1 - t - s)\, a + t\, b + s\, c\f$.
 */
struct Intrinsic_point
{
  /// the number of a vertex, or of a halfedge.
  using Index = Intrinsic_triangulation::Index;

  /// the place of a vertex.
  static Intrinsic_point at_vertex(const Index v)
  {
    return {v, Intrinsic_triangulation::null_index, 0, 0};
  }

  /// the place on the edge of `h`, at the part `t` of the way from its source to its target.
  static Intrinsic_point on_edge(const Index h, const double t)
  {
    return {Intrinsic_triangulation::null_index, h, t, 0};
  }

  /// the place inside the face to the left of `h`, where `t` and `s` are the weights of the target
  /// of `h` and of the third vertex.
  static Intrinsic_point in_face(const Index h, const double t, const double s)
  {
    return {Intrinsic_triangulation::null_index, h, t, s};
  }

  /// returns whether the place is a vertex.
  bool is_vertex() const { return vertex != Intrinsic_triangulation::null_index; }

  /// returns whether the place is a point inside a face.
  bool is_in_face() const { return !is_vertex() && s > 0; }

  /// returns whether the place is a point of an edge, and not a vertex.
  bool is_on_edge() const { return !is_vertex() && !is_in_face(); }

  Index vertex;   ///< the vertex, or `Intrinsic_triangulation::null_index`
  Index halfedge; ///< a halfedge of the edge or the face, or `Intrinsic_triangulation::null_index`
  double t;       ///< the weight of the halfedge's target
  double s;       ///< the weight of the third vertex of its face
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTRINSIC_POINT_H
