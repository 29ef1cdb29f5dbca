// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// An arc as it is stored: lengths are in a unit of the rows, and rounded up.
struct Stored_arc
{
  std::uint32_t target;
  float length;
};

// The smallest `float` that is not below `x`.
inline float round_up(const double x)
{
  const float result = static_cast<float>(x);
  return static_cast<double>(result) >= x
             ? result
             : std::nextafter(result, std::numeric_limits<float>::infinity());
}

// A unit in which arcs fit a `float`: a power of two near the longest edge.
inline double unit_of_arcs(const Intrinsic_triangulation& triangulation)
{
  const auto& lengths = triangulation.lengths();
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  return longest > 0 ? std::ldexp(1., std::ilogb(longest)) : 1;
}

// Replaces `arcs` by those of `node`, in the way they are stored: sorted, and the shortest one of
// several to the same target. `for_each_arc(f)` calls `f(target, length)`.
template <typename ForEachArc>
void find_stored_arcs(const Intrinsic_triangulation::Index node,
                      const double unit,
                      std::vector<Stored_arc>& arcs,
                      ForEachArc for_each_arc)
{
  arcs.clear();
  for_each_arc([&](const Intrinsic_triangulation::Index target, const double length) {
    if(target != node)
      arcs.push_back({target, round_up(length / unit)});
  });
  std::sort(arcs.begin(), arcs.end(), [](const Stored_arc& a, const Stored_arc& b) {
    return std::tie(a.target, a.length) < std::tie(b.target, b.length);
  });
  const auto end =
      std::unique(arcs.begin(), arcs.end(),
                  [](const Stored_arc& a, const Stored_arc& b) { return a.target == b.target; });
  arcs.erase(end, arcs.end());
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H
