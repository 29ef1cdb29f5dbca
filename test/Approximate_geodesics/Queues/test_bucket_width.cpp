// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/fixed_bucket_width.h"

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::Arc_lengths;
using CGAL::Approximate_geodesics::Balanced_bucket_width;
using CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue;
using CGAL::Approximate_geodesics::Bucket_statistics;
using CGAL::Approximate_geodesics::summarize_arc_lengths;

Bucket_statistics figures(const std::size_t visited, const std::size_t late)
{
  Bucket_statistics result;
  result.entries = 10000;
  result.visited_buckets = visited;
  result.late_entries = late;
  return result;
}

TEST(Balanced_bucket_width, starts_with_half_the_mean_arc)
{
  EXPECT_EQ(Balanced_bucket_width({1, 3, 8}).width(), 1.5);
  EXPECT_EQ(Balanced_bucket_width({0, 0x1p-40, 1}).width(), 1e-9); // indices have to fit
  EXPECT_GT(Balanced_bucket_width({0, 0, 0}).width(), 0);          // no arcs, or none with a length
  EXPECT_GT(Balanced_bucket_width().width(), 0);
}

TEST(Balanced_bucket_width, narrows_when_many_entries_are_late)
{
  Balanced_bucket_width policy({1, 4, 8});
  const double width = policy.width();
  policy.update(figures(100, 801));
  EXPECT_LT(policy.width(), width);
}

TEST(Balanced_bucket_width, widens_when_buckets_outnumber_late_entries)
{
  Balanced_bucket_width policy({1, 4, 8});
  const double width = policy.width();
  policy.update(figures(1000, 1));
  EXPECT_GT(policy.width(), width);
}

TEST(Balanced_bucket_width, stays_when_balanced_or_after_small_runs)
{
  Balanced_bucket_width policy({1, 4, 8});
  const double width = policy.width();
  policy.update(figures(1000, 500));
  EXPECT_EQ(policy.width(), width);
  Bucket_statistics small = figures(1, 100);
  small.entries = 10;
  policy.update(small);
  EXPECT_EQ(policy.width(), width);
}

TEST(Balanced_bucket_width, stays_between_its_limits)
{
  Balanced_bucket_width policy({1, 4, 8});
  for(std::size_t i = 0; i < 200; ++i)
    policy.update(figures(0, 1));
  const double narrowest = policy.width();
  EXPECT_GT(narrowest, 0);
  EXPECT_LE(narrowest, 1); // it got somewhere
  for(std::size_t i = 0; i < 400; ++i)
    policy.update(figures(1, 0));
  EXPECT_EQ(policy.width(), 8); // wider than the longest arc there is nothing to gain
}

// Over any mesh, wider buckets mean fewer of them and more late entries. Whatever the constants,
// the width comes to rest, and does so where neither is much larger than the other.
TEST(Balanced_bucket_width, settles_without_oscillating)
{
  for(const double late_at_width_1 : {1e-2, 1., 1e2, 1e4, 1e6})
  {
    Balanced_bucket_width policy({1, 4, 8e3});
    std::vector<double> widths;
    for(std::size_t run = 0; run < 100; ++run)
    {
      const double w = policy.width();
      widths.push_back(w);
      policy.update(figures(static_cast<std::size_t>(1e5 / w),
                            static_cast<std::size_t>(late_at_width_1 * w * w)));
    }
    for(std::size_t run = 60; run < 100; ++run)
      EXPECT_EQ(widths[run], widths[59]) << "late entries at width 1: " << late_at_width_1;
    for(std::size_t run = 2; run < 100; ++run)
      EXPECT_FALSE(widths[run] == widths[run - 2] && widths[run] != widths[run - 1]);
  }
}

// Buckets of width 1; by hand: bucket 1 gives two entries, 2 none, 3 gives two of which one is
// late, and 4 gives one. Bucket 0 was empty.
TEST(Bucket_statistics, are_those_of_a_run_by_hand)
{
  Basic_adaptive_bucket_queue<Fixed_bucket_width> queue(0, {1, 1, 10});
  queue.push(0, 1.5);
  queue.push(1, 1.25);
  queue.push(2, 3.5);
  queue.extract_min();
  queue.extract_min();
  queue.push(3, 3.75);
  queue.push(4, 4.5);
  queue.extract_min();
  EXPECT_EQ(queue.statistics().entries, 4u);
  queue.extract_min();
  ASSERT_TRUE(queue.is_empty());

  const Bucket_statistics s = queue.statistics();
  EXPECT_EQ(s.width, 1);
  EXPECT_EQ(s.visited_buckets, 5u);
  EXPECT_EQ(s.used_buckets, 3u);
  EXPECT_EQ(s.entries, 5u);
  EXPECT_EQ(s.late_entries, 1u);
  EXPECT_EQ(s.comparisons, 0u); // no bucket was sorted
  EXPECT_EQ(s.sum_of_squared_occupancies, 4 + 4 + 1);
  EXPECT_DOUBLE_EQ(s.mean_occupancy(), 5. / 3);
  // of 2, 2, 1; a difference of numbers near 3, so that their last bits are lost
  EXPECT_NEAR(s.standard_deviation_of_occupancy(), std::sqrt(2.) / 3, 1e-14);

  queue.clear();
  EXPECT_EQ(queue.statistics().entries, 0u);
  EXPECT_EQ(queue.statistics().visited_buckets, 0u);
}

// What is in the first bucket before the run starts has not come while it was drained.
TEST(Bucket_statistics, do_not_count_seeds_as_late)
{
  Basic_adaptive_bucket_queue<Fixed_bucket_width> queue(0, {1, 1, 10});
  for(unsigned node = 0; node < 1000; ++node)
    queue.push(node, 0);
  while(!queue.is_empty())
    queue.extract_min();
  EXPECT_EQ(queue.statistics().late_entries, 0u);
  EXPECT_EQ(queue.statistics().comparisons, 0u);
}

TEST(Bucket_statistics, of_nothing_are_zero)
{
  EXPECT_EQ(Bucket_statistics().mean_occupancy(), 0);
  EXPECT_EQ(Bucket_statistics().standard_deviation_of_occupancy(), 0);
}

TEST(Arc_lengths, are_summarized)
{
  EXPECT_EQ(summarize_arc_lengths({}).longest, 0);
  std::vector<double> lengths; // 1 to n, not in order; the sums are integers, hence exact
  for(std::size_t n = 1; n < 40; ++n)
  {
    lengths.insert(lengths.begin() + static_cast<std::ptrdiff_t>(n / 2), static_cast<double>(n));
    const Arc_lengths arcs = summarize_arc_lengths(lengths);
    EXPECT_EQ(arcs.shortest, 1);
    EXPECT_EQ(arcs.mean, static_cast<double>(n + 1) / 2);
    EXPECT_EQ(arcs.longest, static_cast<double>(n));
  }
}

} // namespace
