// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_SLOPE_LIMIT_H
#define CGAL_GEODESIC_COSTS_INTERNAL_SLOPE_LIMIT_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The steepest slope that a straight piece of a path may have, uphill and downhill: so many units
 * of height per horizontal unit.
 */
class Slope_limit
{
public:
  // no limit
  Slope_limit() = default;

  explicit Slope_limit(const double max_slope) : m_max_slope(max_slope)
  {
    if(!(max_slope >= 0))
      reject("max_slope is " + text_of(max_slope) +
             "; it must be a number that is not negative, or infinity");
  }

  bool is_none() const { return m_max_slope == std::numeric_limits<double>::infinity(); }

  // Returns whether a piece may rise or fall so much over this horizontal length. A slope that is
  // the limit may be rounded; `error` is a bound of the rounding error of the rise.
  // \pre There is a limit.
  bool allows(const double rise, const double run, const double error) const
  {
    constexpr double rounding = 1e-10;
    return std::abs(rise) <= (1 + rounding) * m_max_slope * run + error;
  }

  // Returns the largest rise per unit of length on the surface. \pre There is a limit.
  double largest_sine() const { return m_max_slope / std::hypot(1, m_max_slope); }

private:
  double m_max_slope = std::numeric_limits<double>::infinity();
};

// Reads the named parameter `max_slope`.
template <typename NamedParameters>
Slope_limit slope_limit([[maybe_unused]] const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::max_slope_t>)
    return Slope_limit(CGAL::to_double(parameters::get_parameter(np, internal_np::max_slope)));
  else
    return Slope_limit();
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_SLOPE_LIMIT_H
