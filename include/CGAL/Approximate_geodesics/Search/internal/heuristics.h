// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HEURISTICS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HEURISTICS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <type_traits>

namespace CGAL::Approximate_geodesics::internal {

// The heuristic of Dijkstra's algorithm: nothing is known about the rest of the way.
struct No_heuristic
{
  template <typename Node>
  constexpr double operator()(Node /* node */) const
  {
    return 0;
  }
};

template <typename Heuristic>
constexpr bool is_heuristic = !std::is_same_v<Heuristic, No_heuristic>;

// Whether an entry is stale: its key is larger than the one that its node would be entered with
// now, at this distance. With a heuristic, both keys were rounded, and the first one may have been
// raised; then small differences do not count, as it does no harm to expand a stale entry.
template <typename Node, typename Heuristic>
bool is_stale(const double key, const double distance, const Node node, const Heuristic& heuristic)
{
  if constexpr(is_heuristic<Heuristic>)
  {
    constexpr double rounding = 1e-6;
    return distance + heuristic(node) < key * (1 - rounding);
  }
  else
    return distance < key;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_HEURISTICS_H
