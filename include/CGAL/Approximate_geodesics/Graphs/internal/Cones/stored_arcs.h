// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// An arc as it is stored: lengths are in a unit of the rows, and rounded up.
struct Stored_arc
{
  std::uint32_t target;
  float length;
};

// The smallest `float` that is not below `x`, which is not negative. Whether it is the nearest one
// cannot be predicted, so there is no branch: the next `float` is that of the next number.
inline float round_up(const double x)
{
  static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == sizeof(std::uint32_t));
  float result = static_cast<float>(x);
  std::uint32_t bits;
  std::memcpy(&bits, &result, sizeof(bits));
  bits += static_cast<std::uint32_t>(static_cast<double>(result) < x);
  std::memcpy(&result, &bits, sizeof(bits));
  return result;
}

// A unit in which arcs fit a `float`: a power of two near the longest edge.
inline double unit_of_arcs(const Intrinsic_triangulation& triangulation)
{
  const auto& lengths = triangulation.lengths();
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  return longest > 0 ? std::ldexp(1., std::ilogb(longest)) : 1;
}

// Sorts arcs by their targets, and leaves the shortest one of several to the same.
inline void sort_many_arcs(std::vector<Stored_arc>& arcs)
{
  std::sort(arcs.begin(), arcs.end(), [](const Stored_arc& a, const Stored_arc& b) {
    return std::tie(a.target, a.length) < std::tie(b.target, b.length);
  });
  const auto end =
      std::unique(arcs.begin(), arcs.end(),
                  [](const Stored_arc& a, const Stored_arc& b) { return a.target == b.target; });
  arcs.erase(end, arcs.end());
}

constexpr std::size_t FEW_ARCS = 128; // a multiple of the number of lanes

// Does the same for few arcs: each goes where the number of smaller targets says. To count them all
// takes vector instructions and no branch, and half of the time that sorting takes.
inline void sort_few_arcs(std::vector<Stored_arc>& arcs)
{
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  constexpr std::size_t lanes = 16;
  std::array<std::uint32_t, FEW_ARCS> targets;
  std::array<Stored_arc, FEW_ARCS> sorted;
  const std::size_t size = arcs.size(), counted = (size + lanes - 1) / lanes * lanes;
  std::fill_n(targets.begin(), counted, none);
  std::fill_n(sorted.begin(), size, Stored_arc{none, std::numeric_limits<float>::infinity()});
  std::transform(arcs.begin(), arcs.end(), targets.begin(),
                 [](const Stored_arc& arc) { return arc.target; });
  for(const Stored_arc& arc : arcs)
  {
    std::uint32_t rank = 0;
    for(std::size_t i = 0; i < counted; ++i)
      rank += static_cast<std::uint32_t>(targets[i] < arc.target);
    sorted[rank] = {arc.target, (std::min)(sorted[rank].length, arc.length)};
  }
  const auto end =
      std::copy_if(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(size), arcs.begin(),
                   [=](const Stored_arc& a) { return a.target != none; });
  arcs.erase(end, arcs.end());
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
  if(arcs.size() <= FEW_ARCS)
    sort_few_arcs(arcs);
  else
    sort_many_arcs(arcs);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_STORED_ARCS_H
