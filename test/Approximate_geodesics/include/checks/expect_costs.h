// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXPECT_COSTS_H
#define APPROXIMATE_GEODESICS_TEST_EXPECT_COSTS_H

#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesics_test {

constexpr double rounding_of_costs = 1e-12; // relative, of the cost of a path

// Expects the same numbers up to rounding, and infinity at the same places. Where points are very
// close to each other, places themselves are rounded.
inline void expect_about_the_same(const std::vector<double>& found,
                                  const std::vector<double>& expected,
                                  const double tolerance)
{
  ASSERT_EQ(found.size(), expected.size());
  constexpr double rounding_of_places = 1e-15;
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < found.size(); ++i)
    if(found[i] != expected[i] &&
       !(std::abs(found[i] - expected[i]) <= tolerance * expected[i] + rounding_of_places) &&
       ++wrong <= 3)
      ADD_FAILURE() << "at " << i << ": " << found[i] << " instead of " << expected[i]
                    << ", relative error " << found[i] / expected[i] - 1;
  EXPECT_EQ(wrong, 0u);
}

// Expects that costs are between the exact ones and `1 + epsilon` times those.
inline void expect_within_bound(const std::vector<double>& found,
                                const std::vector<double>& exact,
                                const double epsilon)
{
  ASSERT_EQ(found.size(), exact.size());
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < exact.size(); ++i)
  {
    const double limit =
        epsilon < infinity ? exact[i] * (1 + epsilon) * (1 + rounding_of_costs) : infinity;
    if(!(found[i] >= exact[i] * (1 - rounding_of_costs) && found[i] <= limit) && ++wrong <= 3)
      ADD_FAILURE() << "at " << i << ": " << found[i] << " where " << exact[i]
                    << " is exact, relative error " << found[i] / exact[i] - 1;
  }
  EXPECT_EQ(wrong, 0u);
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXPECT_COSTS_H
