// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_ARC_LENGTHS_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_ARC_LENGTHS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 *
 * What a priority queue knows about the arcs of a graph when it is made: their shortest, mean and
 * longest length, in units of the graph. All are `0` for a graph without arcs.
 */
struct Arc_lengths
{
  /// the length of the shortest arc.
  double shortest = 0;
  /// the mean length of the arcs; an estimate is good enough.
  double mean = 0;
  /// the length of the longest arc, or an estimate; queues work with longer ones, too.
  double longest = 0;
};

/*!
 * \ingroup PkgApproximateGeodesicsClasses
 * \relates Arc_lengths
 *
 * computes the minimum, mean and maximum of `lengths`. Run time is \cgalBigO{n}.
 */
inline Arc_lengths summarize_arc_lengths(const std::vector<double>& lengths)
{
  if(lengths.empty())
    return {};

  constexpr std::size_t LANES = 8; // independent of each other, so that the loop vectorizes
  std::array<double, LANES> shortest, sum, longest;
  shortest.fill(std::numeric_limits<double>::infinity());
  sum.fill(0);
  longest.fill(0);
  const auto add = [&](const std::size_t lane, const double length) {
    shortest[lane] = (std::min)(shortest[lane], length);
    sum[lane] += length;
    longest[lane] = (std::max)(longest[lane], length);
  };
  std::size_t i = 0;
  for(; i + LANES <= lengths.size(); i += LANES)
    for(std::size_t lane = 0; lane < LANES; ++lane)
      add(lane, lengths[i + lane]);
  for(; i < lengths.size(); ++i)
    add(0, lengths[i]);

  return {*std::min_element(shortest.begin(), shortest.end()),
          std::accumulate(sum.begin(), sum.end(), 0.) / static_cast<double>(lengths.size()),
          *std::max_element(longest.begin(), longest.end())};
}

} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_ARC_LENGTHS_H
