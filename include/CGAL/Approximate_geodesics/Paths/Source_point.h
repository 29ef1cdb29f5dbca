// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_SOURCE_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_SOURCE_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * A point where a search on a surface starts.
 */
struct Source_point
{
  /// the point.
  Intrinsic_point point;

  /// the initial distance, in the unit of the mesh: finite and not negative.
  double distance = 0;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_SOURCE_POINT_H
