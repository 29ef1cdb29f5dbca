// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_GAUGE_FORMULA_H
#define CGAL_GEODESIC_COSTS_INTERNAL_GAUGE_FORMULA_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Plane_vector.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A convex gauge of a face in closed form: the cost of a vector by its rise and its horizontal
 * length, or a Randers metric, which is a Euclidean norm of a linear image plus a linear
 * functional. It needs no samples.
 *
 * The opposite of a vector has the cost of the vector for the reversed formula, to the last bit.
 */
class Gauge_formula
{
public:
  // The cost of a vector: convex in every plane, and positively homogeneous. No unit vector costs
  // more than the vertical one with the same sign of the rise.
  using Slope_cost = double (*)(double rise, double run);

  Gauge_formula() = default;

  // The same cost in all directions: no formula unless it is finite, and positive.
  static Gauge_formula of_weight(const double weight)
  {
    Gauge_formula result;
    result.m_factor = weight < (std::numeric_limits<double>::max)() ? weight : 0;
    return result;
  }

  // Costs depend on the slope; `rises` are those of the axes of the plane of the face.
  static Gauge_formula
  of_slopes(const Slope_cost cost, const double factor, const Plane_vector rises)
  {
    Gauge_formula result;
    result.m_slope_cost = cost;
    result.m_factor = factor;
    result.m_linear = rises;
    return result;
  }

  // The cost of (x, y) is the root of `xx x^2 + 2 xy x y + yy y^2`, plus a linear functional.
  // Returns no formula unless it is finite, and positive in all directions, also after rounding.
  static Gauge_formula
  of_norm(const double xx, const double xy, const double yy, const Plane_vector linear)
  {
    Gauge_formula result;
    const double determinant = xx * yy - xy * xy, trace = xx + yy;
    const double x = linear.x, y = linear.y;
    if(!(xx > 0 && determinant > SMALLEST_RATIO * trace * trace))
      return result;
    const double square_of_drift = (yy * x * x - 2 * xy * x * y + xx * y * y) / determinant;
    if(!(square_of_drift <= LARGEST_DRIFT * LARGEST_DRIFT))
      return result;
    result.m_factor = std::sqrt(xx);
    result.m_shear = xy / xx;
    result.m_stretch = std::sqrt(determinant) / xx;
    result.m_linear = 1 / result.m_factor * linear;
    return result;
  }

  // Returns whether there is a formula.
  explicit operator bool() const { return m_factor > 0; }

  double operator()(const Plane_vector v) const
  {
    if(m_slope_cost)
    {
      const double rise = dot(m_linear, v);
      return m_factor * m_slope_cost(rise, std::sqrt((std::max)(dot(v, v) - rise * rise, 0.)));
    }
    const double x = v.x + m_shear * v.y, y = m_stretch * v.y;
    return m_factor * (std::sqrt(x * x + y * y) + dot(m_linear, v));
  }

  // Returns an upper bound of the cost of unit vectors.
  double largest() const
  {
    if(m_slope_cost)
      return m_factor * (std::max)(m_slope_cost(1, 0), m_slope_cost(-1, 0));
    return m_factor * (1 + std::abs(m_shear) + m_stretch + length(m_linear));
  }

  Gauge_formula reversed() const
  {
    Gauge_formula result = *this;
    result.m_linear = -1 * m_linear;
    return result;
  }

  void multiply(const double factor) { m_factor *= factor; }

private:
  // Beyond these, cancellation makes formulas less accurate than samples, whose error is bounded.
  static constexpr double SMALLEST_RATIO = 1e-8;  // of the determinant to the squared trace
  static constexpr double LARGEST_DRIFT = 0.9999; // the norm of the functional

  Slope_cost m_slope_cost = nullptr;
  double m_factor = 0; // 0 if there is no formula
  double m_shear = 0;
  double m_stretch = 1;
  Plane_vector m_linear{0, 0};
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_GAUGE_FORMULA_H
