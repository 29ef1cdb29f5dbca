// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_FACE_WEIGHTS_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_FACE_WEIGHTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSurface
 *
 * What a path costs per unit of length in each face of an `Intrinsic_triangulation`.
 * `read_face_weights()` makes it from a property map.
 */
struct Face_weights
{
  /// weights that are smaller than this in the unit, but not zero, are raised to it.
  static constexpr double SMALLEST_WEIGHT = (std::numeric_limits<double>::min)();

  /// for each halfedge, the weight of the face to its left, in units of `unit`: not negative;
  /// infinity if paths must not enter the face, or if there is none.
  std::vector<double> of_halfedge;

  /// the unit, a power of two.
  double unit = 1;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_FACE_WEIGHTS_H
