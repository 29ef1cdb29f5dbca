// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_RANDOM_POINTS_H
#define APPROXIMATE_GEODESICS_TEST_RANDOM_POINTS_H

#include "oracles/test_oracles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace geodesics_test {

// Up to so many points on every edge, at random places that depend on the edge only. Some are very
// close to each other, or to an end.
class Random_points
{
public:
  using Index = Triangulation::Index;
  static constexpr bool makes_equal_parts = false;

  explicit Random_points(const std::size_t largest_number, const std::uint64_t seed = 1)
    : m_largest_number(largest_number), m_seed(seed)
  {
  }

  void prepare(const Triangulation& /* triangulation */, std::size_t /* maximum_number */) {}

  std::size_t number_of_points(const Triangulation& triangulation, const Index h) const
  {
    return random(triangulation, h).below(m_largest_number + 1);
  }

  void place(const Triangulation& triangulation,
             const Index h,
             float* const positions,
             const std::size_t number_of_points) const
  {
    Random r = random(triangulation, h);
    r.below(1);
    const auto half = static_cast<std::ptrdiff_t>(r.below(number_of_points + 1));
    const auto size = static_cast<std::ptrdiff_t>(number_of_points);
    for(std::ptrdiff_t i = 0; i < size; ++i)
    {
      const double part =
          0.49 * std::pow(10, r.between(0, 1) < 0.2 ? r.between(-6, 0) : 0) * r.between(0.01, 1);
      positions[i] = static_cast<float>(i < half ? part : -part);
    }
    std::sort(positions, positions + half);
    std::sort(positions + half, positions + size);
  }

  double epsilon(const Triangulation& /* triangulation */) const { return infinity; }
  std::size_t memory() const { return 0; }

private:
  Random random(const Triangulation& triangulation, const Index h) const
  {
    return Random(m_seed + 1000003 * (std::min)(h, triangulation.opposite(h)));
  }

  std::size_t m_largest_number;
  std::uint64_t m_seed;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_RANDOM_POINTS_H
