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

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * The energy that walking takes on slopes, in joules per kilogram of the walker and meter of the
 * ground, as Minetti, Moia, Roi, Susta and Ferretti have measured it \cgalCite{mmrsf-ecwre-02}:
 * \f$280.5\,s^5 - 58.7\,s^4 - 76.8\,s^3 + 51.9\,s^2 + 19.6\,s + 2.5\f$, where one gains \f$s\f$
 * meters of height per meter on the map. It is smallest at about -15 %.
 *
 * The mesh is in meters, with the z axis upward. Measurements end at slopes of 45 %: directions
 * that are steeper have infinite cost, and steep faces are climbed in zigzags.
 *
 * \cgalModels{DirectionalCostFunction}
 */
class Walking_energy
{
public:
  /// slopes beyond were not measured.
  static constexpr double STEEPEST_SLOPE = 0.45;

  /// returns the joules per kilogram and meter in a direction.
  template <typename Face, typename Vector_3>
  double operator()(const Face& /* face */, const Vector_3& direction) const
  {
    const double s = internal::slope(direction);
    if(!(std::abs(s) <= STEEPEST_SLOPE))
      return std::numeric_limits<double>::infinity();
    return ((((280.5 * s - 58.7) * s - 76.8) * s + 51.9) * s + 19.6) * s + 2.5;
  }
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_WALKING_ENERGY_H
