// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_WALKING_ENERGY_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_WALKING_ENERGY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/internal/slope.h>

#include <cmath>
#include <limits>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * The energy of walking on slopes, in joules per kilogram of body mass and meter of surface length,
 * as measured by Minetti, Moia, Roi, Susta and Ferretti \cgalCite{mmrsf-ecwre-02}:
 * \f$280.5\,s^5 - 58.7\,s^4 - 76.8\,s^3 + 51.9\,s^2 + 19.6\,s + 2.5\f$ for a slope of \f$s\f$
 * meters of height per horizontal meter. The minimum is at about -15 %.
 *
 * The mesh is in meters, with the z axis upward. The measurements cover slopes of up to 45 %;
 * steeper directions have infinite cost, and steep faces are climbed in zigzags.
 *
 * \cgalModels{DirectionalCostFunction}
 */
class Walking_energy
{
public:
  /// the steepest measured slope.
  static constexpr double STEEPEST_SLOPE = 0.45;

  /// returns the energy per unit of length in a direction, in joules per kilogram and meter.
  template <typename Face, typename Vector_3>
  double operator()(const Face& /* face */, const Vector_3& direction) const
  {
    const double s = internal::slope(direction);
    if(!(std::abs(s) <= STEEPEST_SLOPE))
      return std::numeric_limits<double>::infinity();
    return ((((280.5 * s - 58.7) * s - 76.8) * s + 51.9) * s + 19.6) * s + 2.5;
  }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_WALKING_ENERGY_H
