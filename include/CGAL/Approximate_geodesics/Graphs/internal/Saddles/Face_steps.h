// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_FACE_STEPS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_FACE_STEPS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The data for laying out the face to the left of a halfedge whose edge is laid out: not as two
 * points, but as one point and the vector to the other. Vectors of the edges ahead follow from that
 * vector alone, by a rotation and a scaling. So the direction of each is accurate, however far away
 * and however short it is; that of the difference of two points would not be.
 */
struct Face_step : Unfolded_face
{
  static Face_step
  of(const Intrinsic_triangulation& triangulation, const Index source, const Index h)
  {
    Apex_position position{0, 0, 0};
    const Unfolded_face face = Unfolded_face::of(triangulation, source, h, &position);
    return {face, position.beyond};
  }

  double beyond; // of the apex: from the target of the halfedge backward

  bool has_face() const { return apex != null_index; }

  Plane_vector right_edge(const Plane_vector edge) const
  {
    return {beyond * edge.x + across * edge.y, beyond * edge.y - across * edge.x};
  }
};

// The angle at the source of a halfedge in the face to its left, as a unit vector. At an edge of
// length zero, it is a right angle.
inline Plane_vector unit_corner(const Face_step& step)
{
  const Plane_vector corner{step.along, step.across};
  const double l = length(corner);
  return l > 0 && l < 1e300 ? 1 / l * corner : Plane_vector{0, 1};
}

using Face_steps = Unfolded_faces<Face_step>;

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_FACE_STEPS_H
