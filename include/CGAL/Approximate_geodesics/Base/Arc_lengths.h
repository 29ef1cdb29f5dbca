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

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 *
 * The shortest, mean and longest length of the arcs of a graph, in units of the graph. Priority
 * queues derive their parameters from them. All are `0` for a graph without arcs.
 */
struct Arc_lengths
{
  /// the length of the shortest arc.
  double shortest = 0;
  /// the mean length of the arcs, or an estimate.
  double mean = 0;
  /// the length of the longest arc, or an estimate; longer arcs are allowed.
  double longest = 0;
};

/*!
 * \ingroup PkgApproximateGeodesicsOwnGraphs
 * \relates Arc_lengths
 *
 * computes the minimum, mean and maximum of `lengths`. Run time is \cgalBigO{n}.
 */
inline Arc_lengths summarize_arc_lengths(const std::vector<double>& lengths)
{
  if(lengths.empty())
    return {};

  constexpr std::size_t LANES = 8; // independent accumulators let the loop vectorize
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

namespace internal {

// Accumulates `Arc_lengths`.
class Arc_length_summary
{
public:
  void add(const double length) { add(length, length, length, 1); }

  void add(const Arc_length_summary& other)
  {
    add(other.m_shortest, other.m_sum, other.m_longest, other.m_number);
  }

  void add(const double shortest, const double sum, const double longest, const std::size_t number)
  {
    m_shortest = (std::min)(m_shortest, shortest);
    m_sum += sum;
    m_longest = (std::max)(m_longest, longest);
    m_number += number;
  }

  std::size_t number_of_arcs() const { return m_number; }

  // Returns the lengths multiplied by `unit`, a power of two.
  Arc_lengths result(const double unit = 1) const
  {
    if(m_number == 0)
      return {};
    return {m_shortest * unit, m_sum / static_cast<double>(m_number) * unit, m_longest * unit};
  }

private:
  double m_shortest = std::numeric_limits<double>::infinity();
  double m_sum = 0;
  double m_longest = 0;
  std::size_t m_number = 0;
};

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_ARC_LENGTHS_H
