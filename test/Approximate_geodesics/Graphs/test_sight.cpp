// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>

#include "checks/test_random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using CGAL::Approximate_geodesics::internal::Plane_vector;
using CGAL::Approximate_geodesics::internal::Sight;
using CGAL::Approximate_geodesics::internal::Sight_ray;
using geodesics_test::Random;
using geodesics_test::test_seed;

Plane_vector at_angle(const double angle, const double distance)
{
  return {distance * std::cos(angle), distance * std::sin(angle)};
}

// What is seen past two vertices through an edge behind them.
struct Narrow_sight
{
  explicit Narrow_sight(Random& random)
  {
    const double right_angle = random.between(-3, 3),
                 left_angle = right_angle + std::exp2(random.between(-12, 0)),
                 distance = std::exp2(random.between(1, 6));
    const auto ray = [&](const double angle) {
      const double nearer = random.between(0.1, 1);
      return Sight_ray(at_angle(angle, nearer), nearer);
    };
    sight.left_ray = ray(left_angle);
    sight.right_ray = ray(right_angle);
    sight.left_distance = distance * random.between(1, 1.5);
    sight.right_distance = distance * random.between(1, 1.5);
    sight.left = at_angle(left_angle + random.between(0, 0.5), sight.left_distance);
    sight.right = at_angle(right_angle - random.between(0, 0.5), sight.right_distance);
    sight.edge = sight.right - sight.left;
  }

  // How much farther than from the vertex on one ray the crossing of the other one is.
  double excess(const Sight_ray& ray, const Sight_ray& other) const
  {
    const Plane_vector crossing = sight.crossing(other, 0);
    return length(crossing) - length(crossing - ray.direction);
  }

  Sight sight;
};

// Just where the path over the vertex is shorter than the line to the far end of what is seen.
TEST(Sight, is_beaten_over_a_vertex_on_a_ray)
{
  constexpr double label = 3, rounding = 1e-9;
  Random random(test_seed());
  for(int i = 0; i < 20000; ++i)
  {
    Narrow_sight narrow(random);
    Sight& sight = narrow.sight;
    const bool is_left = i % 2 == 0;
    Sight_ray &ray = is_left ? sight.left_ray : sight.right_ray,
              &other = is_left ? sight.right_ray : sight.left_ray;
    EXPECT_FALSE(sight.is_beaten(label)); // no bound is known
    const double excess = narrow.excess(ray, other);
    ASSERT_LE(excess, length(ray.direction) * (1 + rounding));
    ray.bound = label + excess + rounding;
    EXPECT_FALSE(sight.is_beaten(label));
    ray.bound = label + excess - std::exp2(random.between(-25, 0));
    EXPECT_EQ(sight.is_beaten(label), excess > 0) << excess << ' ' << ray.bound;
  }
}

} // namespace
