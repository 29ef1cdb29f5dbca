// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/internal/Cells/Focal_curve.h>

#include "checks/test_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// Curves around a point, and the order of directions.

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::internal::Direction_range;
using CGAL::Approximate_geodesics::internal::Focal_curve;
using CGAL::Approximate_geodesics::internal::Plane_vector;
namespace internal = CGAL::Approximate_geodesics::internal;

// As where the compiler may contract a product and a sum to a fused operation, which rounds once:
// on most processors, it does so by default.
#if defined(__x86_64__) && defined(__clang__)
#define WITH_FUSED_OPERATIONS __attribute__((target("fma"), flatten))
#elif defined(__x86_64__) && defined(__GNUC__)
#define WITH_FUSED_OPERATIONS __attribute__((target("fma"), optimize("O2"), flatten))
#endif

#ifdef WITH_FUSED_OPERATIONS
WITH_FUSED_OPERATIONS bool is_before_if_fused(const Plane_vector u, const Plane_vector v)
{
  return internal::is_before(u, v);
}

bool has_fused_operations() { return __builtin_cpu_supports("fma") != 0; }
#else
bool is_before_if_fused(const Plane_vector u, const Plane_vector v)
{
  return internal::is_before(u, v);
}

bool has_fused_operations() { return true; }
#endif

// Vectors of many magnitudes, whose products are exact up to one rounding.
std::vector<Plane_vector> vectors(Random& random)
{
  std::vector<Plane_vector> result;
  for(int exponent = -400; exponent <= 400; exponent += 5)
  {
    const double size = std::ldexp(1, exponent);
    for(int i = 0; i < 10; ++i)
      result.push_back({random.between(-size, size), random.between(-size, size)});
  }
  return result;
}

template <typename F>
void expect_an_order(const std::vector<Plane_vector>& vectors, const F& is_before)
{
  std::size_t number_before_itself = 0, number_both_ways = 0;
  for(const Plane_vector u : vectors)
  {
    number_before_itself += is_before(u, u) ? 1 : 0;
    const Plane_vector next{std::nextafter(u.x, 2 * u.x), u.y};
    for(const Plane_vector v : {next, Plane_vector{2 * u.x, 2 * u.y}})
      number_both_ways += is_before(u, v) && is_before(v, u) ? 1 : 0;
  }
  EXPECT_EQ(number_before_itself, 0u);
  EXPECT_EQ(number_both_ways, 0u);
}

TEST(FocalCurve, directions_have_an_order)
{
  Random random(test_seed());
  expect_an_order(vectors(random), internal::is_before);
  if(has_fused_operations())
    expect_an_order(vectors(random), is_before_if_fused);
  EXPECT_TRUE(internal::is_before({1, 0}, {0, 1}));
  EXPECT_FALSE(internal::is_before({0, 1}, {1, 0}));
}

TEST(FocalCurve, ranges_of_one_direction_are_empty)
{
  Random random(test_seed());
  for(const Plane_vector u : vectors(random))
  {
    const Plane_vector direction = 1 / std::hypot(u.x, u.y) * u;
    EXPECT_TRUE((Direction_range{direction, direction}.is_empty()));
    EXPECT_FALSE((Direction_range{direction, direction}.contains(direction)));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE((Direction_range{{nan, 0}, {0, 1}}.is_empty()));
}

TEST(FocalCurve, of_a_hyperbola_has_a_constant_difference)
{
  const Plane_vector focus{3, 1};
  for(const double difference : {-3., -0.5, 0., 0.5, 3.})
  {
    const Focal_curve curve = Focal_curve::hyperbola(focus, difference);
    for(double angle = 0; angle < 6; angle += 0.1)
    {
      const Plane_vector u{std::cos(angle), std::sin(angle)};
      if(!(curve.at(u) > 1e-3)) // it is not met in this direction, or far away
        continue;
      const Plane_vector p = curve.point(u);
      EXPECT_NEAR(length(p - focus), length(p) + difference, 1e-9);
    }
  }
}

TEST(FocalCurve, curves_meet_where_their_difference_vanishes)
{
  const Focal_curve curve = Focal_curve::hyperbola({3, 1}, 0.5),
                    line = Focal_curve::line({0.5, 0}, {-1, 3});
  const Direction_range range{{std::cos(-1.5), std::sin(-1.5)}, {std::cos(1.5), std::sin(1.5)}};
  int number = 0;
  (curve - line).for_each_root(range, [&](const Plane_vector u) {
    ++number;
    EXPECT_NEAR(length(u), 1, 1e-12);
    const Plane_vector p = curve.point(u);
    EXPECT_NEAR(cross(p - Plane_vector{0.5, 0}, {-1, 3}), 0, 1e-9);
    EXPECT_NEAR(length(p - Plane_vector{3, 1}), length(p) + 0.5, 1e-9);
  });
  EXPECT_GE(number, 1);
  double largest = -1e300; // no value between exceeds the maximum, and some come close
  for(double angle = -1.5; angle <= 1.5; angle += 1e-3)
    largest = (std::max)(largest, curve.at({std::cos(angle), std::sin(angle)}));
  EXPECT_LE(largest, curve.maximum(range) * (1 + 1e-12));
  EXPECT_GE(largest, curve.maximum(range) * (1 - 1e-5));
}

} // namespace
