// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_COST_FORMULAS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_COST_FORMULAS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_costs/internal/Gauge_formula.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The weights of faces as a cost function.
 */
template <typename FaceWeightMap>
class Weight_cost
{
public:
  explicit Weight_cost(FaceWeightMap weights) : m_weights(std::move(weights)) {}

  template <typename Face, typename Vector_3>
  double operator()(const Face& face, const Vector_3& /* direction */) const
  {
    return CGAL::to_double(get(m_weights, face));
  }

  template <typename Face>
  Gauge_formula formula(const Face& face, const Space_vector&, const Space_vector&) const
  {
    return Gauge_formula::of_weight(CGAL::to_double(get(m_weights, face)));
  }

private:
  FaceWeightMap m_weights;
};

/*
 * The gauges of cost functions, as far as they are known in closed form, in the plane of a face
 * with the axes `x` and `y`.
 */
struct Cost_formulas
{
  template <typename Face>
  Gauge_formula of(const Hiking_time& cost, const Face& /* face */) const
  {
    return Gauge_formula::of_slopes(hiking_with_zigzags, 0.6 / cost.m_factor, {x[2], y[2]});
  }

  template <typename Face>
  Gauge_formula of(const Walking_energy& /* cost */, const Face& /* face */) const
  {
    return Gauge_formula::of_slopes(walking_with_zigzags, 1, {x[2], y[2]});
  }

  // The cost is the root of (d w)^2 + r, minus d w, divided by r = v^2 - |w|^2.
  template <typename Map, typename Face>
  Gauge_formula of(const Drift_time<Map>& cost, const Face& face) const
  {
    const Space_vector w = space_vector(get(cost.m_drift, face));
    const double rest = cost.m_speed * cost.m_speed - dot(w, w);
    if(!(rest > 0))
      return {};
    const double u = dot(w, x) / rest, v = dot(w, y) / rest;
    return Gauge_formula::of_norm(u * u + 1 / rest, u * v, v * v + 1 / rest, {-u, -v});
  }

  template <typename Map, typename Face>
  Gauge_formula of(const Tensor_cost<Map>& cost, const Face& face) const
  {
    const std::array<double, 6> a = get(cost.m_tensors, face);
    const auto product = [&a](const Space_vector& p, const Space_vector& q) {
      return a[0] * p[0] * q[0] + a[3] * p[1] * q[1] + a[5] * p[2] * q[2] +
             a[1] * (p[0] * q[1] + p[1] * q[0]) + a[2] * (p[0] * q[2] + p[2] * q[0]) +
             a[4] * (p[1] * q[2] + p[2] * q[1]);
    };
    return Gauge_formula::of_norm(product(x, x), product(x, y), product(y, y), {0, 0});
  }

  template <typename CostFunction, typename Face>
  Gauge_formula of(const Directional_cost<CostFunction>& cost, const Face& face) const
  {
    return of(cost.m_function, face);
  }

  template <typename CostFunction, typename Face>
  Gauge_formula of(const Reversed_cost<CostFunction>& cost, const Face& face) const
  {
    return of(cost.m_function, face).reversed();
  }

  template <typename CostFunction, typename Face>
  Gauge_formula of([[maybe_unused]] const CostFunction& cost,
                   [[maybe_unused]] const Face& face) const
  {
    if constexpr(is_valid<const CostFunction&>(
                     [](auto& f) -> decltype(f.formula(std::declval<const Face&>(), Space_vector(),
                                                       Space_vector())) {}))
      return cost.formula(face, x, y);
    else
      return {};
  }

  // Zigzags have the slope where a unit of height costs least.
  static double hiking_with_zigzags(const double rise, const double run)
  {
    constexpr double slope = 0.26673643495531381, uphill = 11.756865910878317,
                     downhill = 8.2849233798159030; // per unit of height
    if(!(std::abs(rise) < slope * run))
      return rise > 0 ? uphill * rise : -downhill * rise;
    return std::sqrt(rise * rise + run * run) * std::exp(3.5 * std::abs(rise / run + 0.05));
  }

  static double walking_with_zigzags(const double rise, const double run)
  {
    constexpr double up = 0.28930815840763749, uphill = 38.904522028198365;
    constexpr double down = 0.19178515446816457, downhill = 5.5191136206655039;
    if(!(rise < up * run && -rise < down * run))
      return rise > 0 ? uphill * rise : -downhill * rise;
    return std::sqrt(rise * rise + run * run) * Walking_energy::energy(rise / run);
  }

  const Space_vector &x, &y;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_COST_FORMULAS_H
