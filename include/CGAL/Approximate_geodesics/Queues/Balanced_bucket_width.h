// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_BALANCED_BUCKET_WIDTH_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_BALANCED_BUCKET_WIDTH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Bucket_statistics.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * The default policy for the width of the buckets of an adaptive bucket queue.
 *
 * Wide buckets cause late entries: nodes that enter a bucket while it is being drained may have to
 * be expanded again. Narrow buckets are many and often empty; visiting one costs as much as a few
 * late entries. After every run, the width changes by a factor of \f$\sqrt 2\f$ unless the two
 * overheads are balanced. The first width is half the mean arc length, which is nearly balanced on
 * scanned models.
 *
 * \cgalModels{BucketWidthPolicy}
 */
class Balanced_bucket_width
{
public:
  /// chooses the width for the first run.
  explicit Balanced_bucket_width(const Arc_lengths& arcs = Arc_lengths())
    : m_narrowest((std::max)(arcs.longest * NARROWEST_PART, SMALLEST_INVERTIBLE)),
      m_widest((std::max)(arcs.longest, m_narrowest)),
      m_width(arcs.longest > 0 ? (std::clamp)(arcs.mean / 2, m_narrowest, m_widest) : 1)
  {
  }

  /// returns the width of the buckets, in units of the graph.
  double width() const { return m_width; }

  /// chooses the width for the next run from the statistics of the last one.
  void update(const Bucket_statistics& last_run)
  {
    if(last_run.entries < SMALLEST_SAMPLE)
      return;
    if(last_run.late_entries > COST_OF_VISIT * last_run.visited_buckets)
      m_width = (std::max)(m_width / STEP, m_narrowest);
    else if(SLACK * last_run.late_entries < last_run.visited_buckets)
      m_width = (std::min)(m_width * STEP, m_widest);
  }

private:
  static constexpr double STEP = 1.4142135623730951;
  static constexpr std::size_t COST_OF_VISIT = 8; // upper bound, in late entries
  static constexpr std::size_t SLACK = 2;         // hysteresis: prevents oscillation
  static constexpr double NARROWEST_PART = 1e-9;  // of the longest arc: limits bucket indices
  static constexpr double SMALLEST_INVERTIBLE = 4 / (std::numeric_limits<double>::max)();
  static constexpr std::size_t SMALLEST_SAMPLE = 1000; // smaller runs are not representative

  double m_narrowest;
  double m_widest;
  double m_width;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_BALANCED_BUCKET_WIDTH_H
