// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/internal/Steiner/Rivals.h>

#include "checks/test_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

// Which points of a row a point has to look at, beside rivals on its own side of the corner.

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::internal::cell;
using CGAL::Approximate_geodesics::internal::Corner;
using CGAL::Approximate_geodesics::internal::Point_row;
using CGAL::Approximate_geodesics::internal::Reached_point;

// A row of equally spaced points, a corner, and a point between two rivals.
struct Contest
{
  Contest(Random& random, const double label, const double spread)
    : corner(1, 1, random.between(0.1, 1.9)),
      weight(std::pow(10, random.between(-3, 3))),
      row{0, 200, nullptr, 1, 0, corner, weight}
  {
    double x[3] = {random.between(0, 1), random.between(0, 1), random.between(0, 1)};
    std::sort(x, x + 3);
    for(int i = 0; i < 3; ++i)
      points[i] = {weight * (label + spread * random.between(0, 1)), x[i]};
  }

  double cost(const Reached_point& p, const std::uint32_t rank) const
  {
    return p.label +
           weight * corner.distance(p.distance_from_corner, row.distance_from_corner(rank));
  }

  bool is_beaten(const std::uint32_t rank) const
  {
    return (std::min)(cost(points[0], rank), cost(points[2], rank)) < cost(points[1], rank);
  }

  auto worthwhile() const { return cell(row, points[1], points[0], points[2]); }

  Corner corner;
  double weight;
  Point_row row;
  Reached_point points[3]; // by their distance from the corner
};

// ... so that distances are the same bits as with all arcs
TEST(Rivals, win_by_sums_that_are_smaller_after_rounding)
{
  Random random(test_seed());
  int number_of_contests = 0, number_beaten = 0, number_left_out = 0;
  for(const double spread : {0., 1e-12, 1e-3, 1.})
    for(int i = 0; i < 500; ++i)
    {
      const Contest contest(random, random.between(0, 10), spread);
      const auto [first, beyond] = contest.worthwhile();
      for(std::uint32_t rank = 0; rank < contest.row.size; ++rank)
      {
        const bool is_left_out = rank < first || rank >= beyond;
        if(is_left_out)
        {
          EXPECT_TRUE(contest.is_beaten(rank)) << rank << " of " << first << ", " << beyond;
        }
        number_beaten += contest.is_beaten(rank) ? 1 : 0;
        number_left_out += is_left_out ? 1 : 0;
      }
      ++number_of_contests;
    }
  EXPECT_GT(number_beaten, 50 * number_of_contests);
  EXPECT_GT(number_left_out, number_beaten * 0.99); // few are in doubt
}

// A rival counts only where it has arcs, and the point looks at what its own arcs lead to.
TEST(Rivals, win_where_they_have_arcs)
{
  Random random(test_seed());
  for(int i = 0; i < 200; ++i)
  {
    const Contest contest(random, random.between(0, 10), 1e-2);
    std::uint32_t ends[4]; // the start of the arcs of the point, that of the farther one, ...
    for(std::uint32_t& end : ends)
      end = static_cast<std::uint32_t>(random.below(contest.row.size + 1));
    std::sort(ends, ends + 4);
    const auto all = contest.worthwhile();
    const auto found = cell(contest.row, contest.points[1], contest.points[0], contest.points[2],
                            {ends[0], ends[3]}, ends[2], ends[1]);
    for(std::uint32_t rank = 0; rank < contest.row.size; ++rank)
    {
      const bool has_arc = rank >= ends[0] && rank < ends[3];
      const bool loses =
          (rank < all.first && rank < ends[2]) || (rank >= all.beyond && rank >= ends[1]);
      EXPECT_EQ(rank >= found.first && rank < found.beyond, has_arc && !loses) << rank;
    }
  }
}

// Points near the other end of a long edge are at the same distance from the corner, after
// rounding. If none of two were better, both would look at the whole row.
TEST(Rivals, win_if_they_are_at_the_same_place)
{
  const Point_row row{0, 200, nullptr, 1, 0, Corner(1, 1, 1), 1};
  const Reached_point here{1, 0.5};
  const auto [first, beyond] = cell(row, here, here, {1, 0.75});
  EXPECT_EQ(first, beyond);
}

// Beside labels that are this large, sums are the same wherever a path goes on.
TEST(Rivals, share_the_row_where_sums_are_the_same)
{
  const Point_row row{0, 200, nullptr, 1, 0, Corner(1, 1, 0.2), 1};
  const double label = 1e200;
  const auto [first, beyond] = cell(row, {label, 0.5}, {label, 0.25}, {label, 0.75});
  EXPECT_LT(beyond - first, 100);
  EXPECT_GT(first, 0);
  EXPECT_LT(beyond, row.size);
}

} // namespace
