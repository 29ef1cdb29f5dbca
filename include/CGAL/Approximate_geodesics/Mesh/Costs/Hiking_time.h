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

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * The walking time on slopes, in seconds per meter of surface length, by Tobler's hiking function
 * \cgalCite{t-tpgam-93}: the speed is \f$6\,e^{-3.5\,|s + 0.05|}\f$ kilometers per hour for a slope
 * of \f$s\f$ meters of height per horizontal meter. The maximum, 6 km/h, is slightly downhill.
 *
 * The mesh is in meters, with the z axis upward. Slopes steeper than about 27 %, uphill and
 * downhill, are traversed in zigzags of that slope, which takes less time than the straight path.
 *
 * \cgalModels{DirectionalCostFunction}
 */
class Hiking_time
{
public:
  /// constructs the cost function, with all speeds multiplied by `factor`. Tobler's function is for
  /// footpaths; he suggests `0.6` off paths, and `1.25` on horseback.
  /// \throws std::invalid_argument if `factor` is not a finite number above `0`.
  explicit Hiking_time(const double factor = 1) : m_factor(factor)
  {
    if(!(factor > 0) || std::isinf(factor))
      internal::reject("the factor of hiking speeds is " + internal::text_of(factor) +
                       "; it must be a finite number larger than 0");
  }

  /// returns the time per unit of length in a direction, in seconds per meter.
  template <typename Face, typename Vector_3>
  double operator()(const Face& /* face */, const Vector_3& direction) const
  {
    return 0.6 / m_factor * std::exp(3.5 * std::abs(internal::slope(direction) + 0.05));
  }

private:
  double m_factor;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_HIKING_TIME_H
