// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_EPSILON_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_EPSILON_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Reads the named parameter `epsilon`. Above the largest bound that is of any use, it is that one,
// since others would overflow when multiplied.
template <typename NamedParameters>
double checked_epsilon(const NamedParameters& np)
{
  constexpr double by_default = 0.1, largest = 1e6;
  const double epsilon = CGAL::to_double(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::epsilon), by_default));
  if(!(epsilon > 0) || std::isinf(epsilon))
    reject("epsilon is " + text_of(epsilon) + "; it must be a finite number larger than 0");
  return (std::min)(epsilon, largest);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_EPSILON_H
