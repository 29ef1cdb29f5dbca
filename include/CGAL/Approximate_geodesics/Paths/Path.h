// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsPaths
 *
 * A path on a triangulated surface. Between two points that follow each other, it runs straight
 * through a face, or along an edge.
 */
struct Path
{
  /// the points; none if there is no path.
  std::vector<Intrinsic_point> points;

  /// the length, in the unit of the mesh; the cost, if faces have weights.
  double length = 0;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_PATH_H
