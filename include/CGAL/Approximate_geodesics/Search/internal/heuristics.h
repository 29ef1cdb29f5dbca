// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HEURISTICS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HEURISTICS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <type_traits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// For searches that do not lead to a goal: nothing is known of the rest of the way.
struct No_heuristic
{
  template <typename Node>
  constexpr double operator()(Node /* node */) const
  {
    return 0;
  }
};

template <typename Estimate>
constexpr bool is_heuristic = !std::is_same_v<Estimate, No_heuristic>;

// Whether the key that a node was entered with is larger than the one that it would be entered with
// at this distance. Those that lead to a goal were computed twice, and rounded, or raised where an
// estimate fell too much by rounding. It is no harm to take a stale entry for a new one.
template <typename Node, typename Estimate>
bool is_larger(const double key, const double distance, const Node node, const Estimate& estimate)
{
  if constexpr(is_heuristic<Estimate>)
  {
    constexpr double rounding = 1e-6;
    return distance + estimate(node) < key * (1 - rounding);
  }
  else
    return distance < key;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HEURISTICS_H
