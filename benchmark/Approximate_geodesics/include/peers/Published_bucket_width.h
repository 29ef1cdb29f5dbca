// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_PUBLISHED_BUCKET_WIDTH_H
#define BENCHMARK_PUBLISHED_BUCKET_WIDTH_H

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>

#include <algorithm>
#include <limits>

namespace CGAL::Approximate_geodesics {

/*
 * The policy of Schwartz, de Rezende and Pedrini for the width of buckets (2015): the longest arc
 * divided by a number. This number is 100 at first, and grows by 100 after every run whose nonempty
 * buckets held more than 64 entries on average.
 *
 * The publication does not specify the lower bound of the width, which depends on the mesh. Here it
 * is a hundredth of the shortest arc, and at least a millionth of the longest one; scanned models
 * never reach it.
 */
class Published_bucket_width
{
public:
  // Chooses the width for the first run.
  explicit Published_bucket_width(const Arc_lengths& arcs = Arc_lengths())
    : m_longest_arc(arcs.longest > 0 ? arcs.longest : 1),
      m_narrowest(
          (std::max)({arcs.shortest / 100, m_longest_arc * NARROWEST_PART, SMALLEST_INVERTIBLE}))
  {
  }

  // Returns the bucket width, in units of the graph.
  double width() const { return (std::max)(m_longest_arc / m_divisor, m_narrowest); }

  // Chooses the width for the next run from the statistics of the last one.
  void update(const Bucket_statistics& last_run)
  {
    if(last_run.mean_occupancy() > LARGEST_OCCUPANCY && width() > m_narrowest)
      m_divisor += STEP;
  }

private:
  static constexpr double STEP = 100;
  static constexpr double LARGEST_OCCUPANCY = 64;
  static constexpr double NARROWEST_PART = 1e-6;
  static constexpr double SMALLEST_INVERTIBLE = 4 / (std::numeric_limits<double>::max)();

  double m_longest_arc;
  double m_narrowest;
  double m_divisor = STEP;
};

} // namespace CGAL::Approximate_geodesics

#endif // BENCHMARK_PUBLISHED_BUCKET_WIDTH_H
