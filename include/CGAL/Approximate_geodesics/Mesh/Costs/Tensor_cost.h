// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_TENSOR_COST_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_TENSOR_COST_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsCosts
 *
 * A Riemannian metric that is constant in each face, given by one metric tensor per face: in the
 * direction \f$d\f$, a path costs \f$\sqrt{d^T A\,d}\f$ per unit of length, where \f$A\f$ is a
 * symmetric matrix.
 *
 * If a matrix is not finite, or not positive semidefinite in the plane of its face, beyond
 * rounding, costs are NaN, and reading the mesh fails.
 *
 * \tparam FaceTensorMap a model of `ReadablePropertyMap` with faces as key type and as value type
 *         `std::array<double, 6>`: the entries xx, xy, xz, yy, yz and zz of the matrix
 *
 * \cgalModels{DirectionalCostFunction}
 */
template <typename FaceTensorMap>
class Tensor_cost
{
public:
  /// constructs the cost function from the tensors.
  explicit Tensor_cost(FaceTensorMap tensors) : m_tensors(std::move(tensors)) {}

  /// returns the cost per unit of length in a direction.
  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& direction) const
  {
    const std::array<double, 6> a = get(m_tensors, face);
    const double x = CGAL::to_double(direction.x()), y = CGAL::to_double(direction.y()),
                 z = CGAL::to_double(direction.z());
    const double square = a[0] * x * x + a[3] * y * y + a[5] * z * z +
                          2 * (a[1] * x * y + a[2] * x * z + a[4] * y * z);
    return std::isfinite(square) ? std::sqrt(square) : std::numeric_limits<double>::quiet_NaN();
  }

private:
  FaceTensorMap m_tensors;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_COSTS_TENSOR_COST_H
