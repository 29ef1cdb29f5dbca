// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/internal/Face_gauges.h>

#include "meshes/test_costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// What gauges of convex costs say of their own error, next to the error that they have.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::internal::Face_gauges;
using AG::internal::Gauge_samples;
using AG::internal::Plane_vector;

constexpr double full_circle = 6.283185307179586;

using Plane_cost = std::function<double(const Plane_vector&)>;

Plane_vector direction(const double angle) { return {std::cos(angle), std::sin(angle)}; }

Plane_cost cost_in_plane(const Half_planes& norm)
{
  return [norm](const Plane_vector v) { return norm.cost(Vector(v.x, v.y, 0)); };
}

// The gauge of a face, whose sides have these angles to the first one.
struct Sampled_gauge
{
  Sampled_gauge(const Plane_cost& cost, const double tolerance, const double second = 2)
  {
    samples.sample(sides(second), tolerance, cost);
    gauges.reserve(3, 1);
    gauges.add(std::array<AG::internal::Index, 3>{0, 1, 2}, sides(second), samples);
  }

  static std::array<Plane_vector, 3> sides(const double second)
  {
    return {Plane_vector{1, 0}, direction(second), direction(second + 0.5 * full_circle / 3)};
  }

  // The largest relative error, in directions all around and next to those that were sampled.
  double error(const Plane_cost& cost) const
  {
    constexpr int number = 4000;
    double result = 0;
    const auto look = [&](const Plane_vector v) {
      result = (std::max)(result, gauges.cost(0, v) / cost(v) - 1);
    };
    for(int i = 0; i < number; ++i)
      look(direction(full_circle * (i + 0.5) / number));
    std::vector<Plane_vector> known;
    AG::internal::Gauge_hull::Id id = 0;
    do
    {
      known.push_back(samples.hull()[id].vector);
      id = samples.hull()[id].next;
    } while(id != 0);
    for(std::size_t i = 0; i < known.size(); ++i)
    {
      const Plane_vector next = known[(i + 1) % known.size()];
      for(const double part : {0.01, 0.3, 0.5, 0.7, 0.99})
        look((1 - part) * known[i] + part * next);
    }
    return result;
  }

  Gauge_samples samples;
  Face_gauges gauges;
};

// ... at once, refined, and refined more, as far as directions are refined: to a sine of 1e-5
void expect_claimed_error(const Plane_cost& cost,
                          const double second_side = 2,
                          const double smallest_error = 0)
{
  constexpr double rounding = 1e-9;
  for(const double tolerance : {10., 0.01, 0.001})
  {
    const Sampled_gauge gauge(cost, tolerance, second_side);
    EXPECT_LE(gauge.error(cost), gauge.gauges.sampling_error() + rounding);
    EXPECT_LE(gauge.gauges.sampling_error(), (std::max)(tolerance, smallest_error));
  }
}

TEST(Gauges, know_their_error_for_regular_polygons)
{
  for(int corners = 3; corners <= 24; ++corners)
    for(double turn = 0; turn < 1; turn += 0.0625)
    {
      SCOPED_TRACE(std::to_string(corners) + " sides, turned by " + std::to_string(turn));
      expect_claimed_error(cost_in_plane(Half_planes::regular(corners, turn)));
    }
}

TEST(Gauges, know_their_error_for_random_polygons)
{
  Random random(test_seed());
  for(int i = 0; i < 200; ++i)
  {
    SCOPED_TRACE(i);
    const Half_planes norm = Half_planes::random(random, 3 + i % 10);
    expect_claimed_error(cost_in_plane(norm), random.between(1, 2));
  }
}

TEST(Gauges, know_their_error_for_narrow_polygons)
{
  Random random(test_seed());
  for(int i = 0; i < 100; ++i)
  {
    SCOPED_TRACE(i);
    Half_planes norm = Half_planes::random(random, 4 + i % 5);
    const double stretch = std::pow(10., random.between(0, 2));
    for(Vector& side : norm.sides)
      side = Vector(stretch * side.x(), side.y(), 0);
    expect_claimed_error(cost_in_plane(norm), 2, 0.005);
  }
}

// Flat sides and arcs that meet smoothly, or in corners.
TEST(Gauges, know_their_error_for_flat_sides_and_arcs)
{
  Random random(test_seed());
  for(int i = 0; i < 50; ++i)
  {
    SCOPED_TRACE(i);
    const Half_planes norm = Half_planes::random(random, 3 + i % 6);
    const double size = random.between(0.3, 1.5);
    expect_claimed_error([&](const Plane_vector v) {
      return (std::max)(norm.cost(Vector(v.x, v.y, 0)), size * length(v));
    });
    expect_claimed_error(
        [&](const Plane_vector v) { return norm.cost(Vector(v.x, v.y, 0)) + size * length(v); });
  }
}

TEST(Gauges, know_their_error_for_winds)
{
  for(const double drift : {0., 0.3, 0.9, 0.99})
    for(double angle = 0; angle < full_circle; angle += 0.3)
    {
      const Wind wind{Vector(drift * std::cos(angle), drift * std::sin(angle), 0), 1};
      expect_claimed_error([&](const Plane_vector v) { return wind.cost(Vector(v.x, v.y, 0)); });
    }
}

// Costs as coarse as numbers of single precision: flat sides are not quite so.
TEST(Gauges, know_their_error_in_single_precision)
{
  Random random(test_seed());
  for(int i = 0; i < 100; ++i)
  {
    const Half_planes norm = Half_planes::random(random, 3 + i % 8);
    const Plane_cost cost = cost_in_plane(norm);
    const Sampled_gauge gauge([&](const Plane_vector v) { return double(float(cost(v))); }, 0.01);
    EXPECT_LE(gauge.error(cost), gauge.gauges.sampling_error() + 1e-5);
    EXPECT_LE(gauge.gauges.sampling_error(), 0.01);
  }
}

// ... to the last bit, also where directions are free or forbidden.
TEST(Gauges, turn_with_the_costs)
{
  Random random(test_seed());
  const auto expect_turned = [](const Plane_cost& cost) {
    const Sampled_gauge gauge(cost, 0.01);
    const Sampled_gauge turned([&](const Plane_vector v) { return cost(-1 * v); }, 0.01);
    EXPECT_EQ(gauge.gauges.sampling_error(), turned.gauges.sampling_error());
    for(int i = 0; i < 1000; ++i)
    {
      const Plane_vector v = direction(full_circle * (i + 0.5) / 1000);
      ASSERT_EQ(gauge.gauges.cost(0, v), turned.gauges.cost(0, -1 * v)) << "direction " << i;
    }
  };
  for(int i = 0; i < 50; ++i)
  {
    SCOPED_TRACE(i);
    const Plane_cost norm = cost_in_plane(Half_planes::random(random, 3 + i % 8));
    const double least = random.between(-1, 1);
    expect_turned(norm);
    expect_turned([&](const Plane_vector v) { return norm(v) + 0.3 * std::sin(9 * v.x) + 0.3; });
    expect_turned([&](const Plane_vector v) { return (std::max)(v.x + least, 0.) * norm(v); });
    expect_turned([&](const Plane_vector v) { return v.x > least ? norm(v) : infinity; });
  }
}

// Where all is straight between corners, there is nothing to look at.
TEST(Gauges, have_few_directions_beside_flat_sides)
{
  for(double turn = 0; turn < 1; turn += 0.0625)
  {
    const Sampled_gauge gauge(cost_in_plane(Half_planes::regular(4, turn)), 0.001);
    EXPECT_LE(gauge.samples.hull().number_of_directions(), 150u);
    EXPECT_LE(gauge.gauges.all_sectors().size(), 8u);
  }
}

} // namespace
