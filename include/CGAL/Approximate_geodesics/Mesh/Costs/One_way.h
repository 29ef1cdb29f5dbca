// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_ONE_WAY_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_ONE_WAY_H

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
 * A cost function that restricts the directions in each face to those close to a given direction.
 * All others have infinite cost, so paths have no error bound `epsilon`.
 *
 * \tparam FaceVectorMap a model of `ReadablePropertyMap` with faces as key type and a `%Vector_3`
 *         as value type
 *
 * \cgalModels{DirectionalCostFunction}
 */
template <typename FaceVectorMap>
class One_way
{
public:
  /// constructs the cost function. In a face with a zero vector, all directions are admissible.
  /// \param ways the directions of the faces, vectors of any length
  /// \param cost the cost per unit of length in admissible directions
  /// \param smallest_cosine the smallest cosine of the angle between an admissible direction and
  ///        that of the face: `0` admits half of the directions. Zigzags can follow any direction
  ///        in a gap of less than 180 degrees.
  /// \throws std::invalid_argument if `cost` is negative, infinite, or NaN, or if `smallest_cosine`
  ///         is not between `-1` and `1`.
  explicit One_way(FaceVectorMap ways, const double cost = 1, const double smallest_cosine = 0)
    : m_ways(std::move(ways)), m_cost(cost), m_smallest_cosine(smallest_cosine)
  {
    if(!(cost >= 0) || std::isinf(cost))
      internal::reject("the cost of one-way faces is " + internal::text_of(cost) +
                       "; it must be a finite number that is not negative");
    if(!(smallest_cosine >= -1 && smallest_cosine <= 1))
      internal::reject("the smallest cosine is " + internal::text_of(smallest_cosine) +
                       "; it must be a number from -1 to 1");
  }

  /// returns the cost per unit of length in a direction; not a number if that of the face is none,
  /// or infinite, which is refused when the mesh is read.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    constexpr double rounding = 1e-12;
    const auto& way = get(m_ways, face);
    const double x = CGAL::to_double(way.x()), y = CGAL::to_double(way.y());
    const double length =
        std::hypot(std::hypot(x, y), CGAL::to_double(way.z())); // does not overflow
    if(!std::isfinite(length))
      return std::numeric_limits<double>::quiet_NaN();
    const bool is_allowed =
        CGAL::to_double(way * direction) >= (m_smallest_cosine - rounding) * length;
    return is_allowed ? m_cost : std::numeric_limits<double>::infinity();
  }

private:
  FaceVectorMap m_ways;
  double m_cost;
  double m_smallest_cosine;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_ONE_WAY_H
