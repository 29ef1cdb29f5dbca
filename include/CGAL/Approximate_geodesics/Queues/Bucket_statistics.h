// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUEUES_BUCKET_STATISTICS_H
#define CGAL_APPROXIMATE_GEODESICS_QUEUES_BUCKET_STATISTICS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsQueues
 *
 * The statistics of a run of a bucket queue. They are updated per bucket, not per entry, so the
 * overhead is negligible.
 */
struct Bucket_statistics
{
  /// the width of the buckets, in units of the graph.
  double width = 0;
  /// the number of visited buckets, including empty ones.
  std::size_t visited_buckets = 0;
  /// the number of nonempty buckets.
  std::size_t used_buckets = 0;
  /// the number of extracted entries.
  std::size_t entries = 0;
  /// the number of extracted entries that entered a bucket while it was being drained.
  std::size_t late_entries = 0;
  /// the number of comparisons between entries.
  std::size_t comparisons = 0;
  /// the sum over all buckets of the squared number of entries.
  double sum_of_squared_occupancies = 0;

  /// adds a visited bucket with its number of extracted entries, and the number of late ones among
  /// them.
  void add_bucket(const std::size_t occupancy, const std::size_t late = 0)
  {
    ++visited_buckets;
    if(occupancy == 0)
      return;
    ++used_buckets;
    entries += occupancy;
    late_entries += late;
    sum_of_squared_occupancies += static_cast<double>(occupancy) * static_cast<double>(occupancy);
  }

  /// returns the mean number of entries of the nonempty buckets.
  double mean_occupancy() const
  {
    return used_buckets == 0 ? 0 : static_cast<double>(entries) / static_cast<double>(used_buckets);
  }

  /// returns the standard deviation of the number of entries of the nonempty buckets.
  double standard_deviation_of_occupancy() const
  {
    if(used_buckets == 0)
      return 0;
    const double mean_square = sum_of_squared_occupancies / static_cast<double>(used_buckets);
    return std::sqrt((std::max)(0., mean_square - mean_occupancy() * mean_occupancy()));
  }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUEUES_BUCKET_STATISTICS_H
