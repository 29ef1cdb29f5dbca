// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_HIKING_TIME_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_HIKING_TIME_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/slope.h>

#include <cmath>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * The time that walking takes on slopes, in seconds per meter of the ground, by Tobler's hiking
 * function \cgalCite{t-tpgam-93}: the speed is \f$6\,e^{-3.5\,|s + 0.05|}\f$ kilometers per hour
 * where one gains \f$s\f$ meters of height per meter on the map. It is largest, 6 km/h, slightly
 * downhill.
 *
 * The mesh is in meters, with the z axis upward. Slopes above about 27 % are climbed in zigzags of
 * that slope, and those below about -27 % descended likewise, which takes less time than going
 * straight.
 *
 * \cgalModels{DirectionalCostFunction}
 */
class Hiking_time
{
public:
  /// multiplies speeds by `factor`: Tobler's figures are for footpaths, and he suggests `0.6` off
  /// paths, and `1.25` on horseback.
  /// \throws std::invalid_argument if `factor` is not a finite number above `0`.
  explicit Hiking_time(const double factor = 1) : m_factor(factor)
  {
    if(!(factor > 0) || std::isinf(factor))
      internal::reject("the factor of hiking speeds is " + internal::text_of(factor) +
                       "; it must be a finite number larger than 0");
  }

  /// returns the seconds per meter in a direction.
  template <typename Face, typename Vector_3>
  double operator()(const Face& /* face */, const Vector_3& direction) const
  {
    return 0.6 / m_factor * std::exp(3.5 * std::abs(internal::slope(direction) + 0.05));
  }

private:
  double m_factor;
};

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_HIKING_TIME_H
