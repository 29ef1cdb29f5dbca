// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_DRIFT_TIME_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_DRIFT_TIME_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * The travel time per unit of length in a current or a wind: Zermelo's navigation problem
 * \cgalCite{z-nbrwv-31}. A boat or an airplane moves with the speed \f$v\f$ relative to a medium
 * that drifts with the velocity \f$w\f$, which is constant in each face. Its ground speed in the
 * direction \f$d\f$ is \f$d\cdot w + \sqrt{v^2 - |w|^2 + (d\cdot w)^2}\f$.
 *
 * If the drift is faster than the boat, unattainable directions have infinite cost.
 *
 * \tparam FaceVectorMap a model of `ReadablePropertyMap` with faces as key type and a `%Vector_3`
 *         as value type
 *
 * \cgalModels{DirectionalCostFunction}
 */
template <typename FaceVectorMap>
class Drift_time
{
public:
  /// constructs the cost function from the drift velocities and the speed of the boat, in the same
  /// unit.
  /// \pre Each velocity lies in the plane of its face; a normal component increases the cost.
  /// \throws std::invalid_argument if `speed` is not a finite number above `0`.
  Drift_time(FaceVectorMap drift, const double speed) : m_drift(std::move(drift)), m_speed(speed)
  {
    if(!(speed > 0) || std::isinf(speed))
      internal::reject("the speed through the drift is " + internal::text_of(speed) +
                       "; it must be a finite number larger than 0");
  }

  /// returns the time per unit of length in a direction.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    const auto& drift = get(m_drift, face);
    const double ahead = CGAL::to_double(drift * direction);
    const double square = CGAL::to_double(drift * drift);
    const double radicand = m_speed * m_speed - square + ahead * ahead;
    const double progress = radicand < 0 ? 0 : ahead + std::sqrt(radicand);
    return progress <= 0 ? std::numeric_limits<double>::infinity() : 1 / progress;
  }

private:
  FaceVectorMap m_drift;
  double m_speed;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_DRIFT_TIME_H
