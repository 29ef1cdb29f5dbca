// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/internal/Steiner/Gauge_polygon.h>

#include "meshes/test_costs.h"

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

// How far apart directions may be in the corners of faces, and gauges that have a formula.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::internal::Cost_formulas;
using AG::internal::Face_gauges;
using AG::internal::Gauge_formula;
using AG::internal::Gauge_polygon;
using AG::internal::Gauge_samples;
using AG::internal::Plane_vector;
using AG::internal::Space_vector;

using Gauge = std::function<double(const Plane_vector&)>;

constexpr double straight_angle = 3.14159265358979323846;

Plane_vector unit_vector(const double angle) { return {std::cos(angle), std::sin(angle)}; }

// A polygon of a gauge, and the gauge that it is.
struct Sampled_polygon
{
  explicit Sampled_polygon(const Gauge& gauge, const double tolerance = 1e-3)
  {
    const std::array<Plane_vector, 3> sides{unit_vector(0), unit_vector(2), unit_vector(4)};
    samples.sample(sides, tolerance, gauge);
    gauges.reserve(3, 1);
    gauges.add(std::array<AG::internal::Index, 3>{0, 1, 2}, sides, samples);
    polygon.assign(gauges, 0);
  }

  double cost(const Plane_vector v) const { return gauges.cost(0, v); }

  Gauge_samples samples;
  Face_gauges gauges;
  Gauge_polygon polygon;
};

Gauge stretched_norm(const Half_planes& norm, const double stretch = 1)
{
  return [=](const Plane_vector v) { return norm.cost(Vector(stretch * v.x, v.y, 0)); };
}

// Convex gauges with corners and flat pieces, smooth ones, narrow ones, and ones that cost up to a
// hundred times as much in one direction as in the opposite one.
std::vector<Gauge> random_gauges(Random& random)
{
  const Half_planes norm = Half_planes::random(random, 3 + int(random.between(0, 6)));
  const double angle = random.between(0, 2 * straight_angle), size = random.between(0.3, 1.5);
  const auto wind = [angle](const double drift) {
    const Wind result{drift * Vector(std::cos(angle), std::sin(angle), 0), 1};
    return [result](const Plane_vector v) { return result.cost(Vector(v.x, v.y, 0)); };
  };
  return {
      stretched_norm(norm),
      stretched_norm(norm, 20),
      [=](const Plane_vector v) { return (std::max)(stretched_norm(norm)(v), size * length(v)); },
      [=](const Plane_vector v) { return stretched_norm(norm)(v) + size * length(v); },
      wind(0.5),
      wind(0.98)};
}

// A corner at the origin, whose sides have the directions `a` and `b`.
struct Test_corner
{
  explicit Test_corner(Random& random)
    : Test_corner(random.between(0, 2 * straight_angle),
                  straight_angle * std::pow(random.between(0.03, 0.99), 2))
  {
  }

  Test_corner(const double turn, const double angle)
    : a(unit_vector(turn)), b(unit_vector(turn + angle))
  {
  }

  Plane_vector way(const double z, const double w) const { return w * b - z * a; }

  Plane_vector a, b;
};

// Next to random segments from the part `x` of one side to a part of the other one.
template <typename Cost>
void expect_bend(const Gauge_polygon::Bend& bend,
                 const Test_corner& corner,
                 Random& random,
                 const Cost& cost)
{
  for(int k = 0; k < 200; ++k)
  {
    const double x = random.between(0, 1), y = random.between(0, 1);
    const double far = k % 3 == 0 ? 1 : std::exp(random.between(0, 4));
    for(const double sign : {1., -1.})
      for(const bool is_first : {true, false})
      {
        const auto between = [&](const double near, const double other) {
          return cost(sign * (is_first ? corner.way(near, other) : corner.way(other, near)));
        };
        const double one_end = x * between(1, far) + (1 - x) * between(0, far);
        ASSERT_LE(one_end - between(x, far), bend.turn * x * (1 - x) + 1e-12 * one_end);
        const double both_ends = (std::min)(x, y) * between(1, 1) +
                                 std::abs(x - y) * (x < y ? between(0, 1) : between(1, 0));
        ASSERT_LE(both_ends, (1 + bend.excess) * (1 + 1e-12) * between(x, y));
      }
  }
}

// Both ends of a segment are rounded to the ends of intervals, outward where the same random number
// is below their positions.
TEST(Gauge_steps, let_ends_of_segments_be_rounded_together)
{
  Random random(test_seed());
  for(int i = 0; i < 60; ++i)
    for(const Gauge& gauge : random_gauges(random))
    {
      const Test_corner corner(random);
      Sampled_polygon sampled(gauge);
      const double error = std::pow(10., random.between(-2.5, -0.3));
      const double step = sampled.polygon.step(corner.a, corner.b, error);
      ASSERT_GT(step, 0);
      for(int k = 0; k < 100; ++k)
      {
        const double p = std::exp(random.between(-3, 3)), q = std::exp(random.between(-3, 3));
        const double shorter = random.between(0.5, 1);
        const double p2 = p * std::exp(k % 3 == 0 ? shorter * step : step),
                     q2 = q * std::exp(k % 3 == 1 ? shorter * step : step);
        const double x = random.between(0, 1), y = random.between(0, 1);
        for(const double sign : {1., -1.})
        {
          const auto cost = [&](const double z, const double w) {
            return sampled.cost(sign * corner.way(z, w));
          };
          const double expected = (std::min)(x, y) * cost(p2, q2) +
                                  (1 - (std::max)(x, y)) * cost(p, q) +
                                  std::abs(x - y) * (x < y ? cost(p, q2) : cost(p2, q));
          const double straight = cost(p + x * (p2 - p), q + y * (q2 - q));
          ASSERT_LE(expected, (1 + 1e-9) * (1 + error) * straight);
        }
      }
    }
}

// ... and are not much smaller than they have to be.
TEST(Gauge_steps, are_known_for_lengths)
{
  Sampled_polygon sampled([](const Plane_vector v) { return length(v); }, 1e-5);
  for(const double angle : {0.01, 0.5, 1., 1.5, 2., 3.})
    for(const double error : {0.1, 0.01, 0.001})
    {
      SCOPED_TRACE(std::to_string(angle) + ", " + std::to_string(error));
      const Test_corner corner(0.3, angle);
      const double turn = 2 * std::acos(1 / (1 + error)), middle = (straight_angle - angle) / 2;
      const double step = sampled.polygon.step(corner.a, corner.b, error);
      if(turn >= straight_angle - angle)
      {
        EXPECT_EQ(Gauge_polygon::LARGEST_STEP, step);
        continue;
      }
      const double largest =
          2 * std::log(std::sin(middle + turn / 2) / std::sin(middle - turn / 2));
      EXPECT_LE(step, 1.02 * largest);
      EXPECT_GE(step, 0.8 * largest);
    }
}

// One end of a segment is rounded to a vertex or to the end of a side of any length, or both are.
TEST(Gauge_bends, bound_what_rounding_near_a_vertex_costs)
{
  Random random(test_seed());
  for(int i = 0; i < 60; ++i)
    for(const Gauge& gauge : random_gauges(random))
    {
      Test_corner corner(random);
      corner.a = random.between(0.5, 2) * corner.a;
      corner.b = random.between(0.5, 2) * corner.b;
      Sampled_polygon sampled(gauge);
      expect_bend(sampled.polygon.bend(corner.a, corner.b), corner, random,
                  [&](const Plane_vector v) { return sampled.cost(v); });
    }
}

// ... also where the polygon is made of samples, and not exact.
TEST(Gauge_bends, hold_for_formulas)
{
  Random random(test_seed());
  for(int i = 0; i < 100; ++i)
  {
    Mesh mesh;
    const auto place = [&] {
      return Point(random.between(-1, 1), random.between(-1, 1), random.between(-0.4, 0.4));
    };
    mesh.add_face(mesh.add_vertex(place()), mesh.add_vertex(place()), mesh.add_vertex(place()));
    const Triangulation t(mesh, with_cost(AG::Hiking_time()));
    Node h = 0;
    while(!t.is_open(h))
      ++h;
    Gauge_samples samples;
    Gauge_polygon polygon;
    ASSERT_TRUE(t.gauges().has_formula(t.gauges().face(h)));
    const double error = polygon.assign(t, h, 0.01, samples);
    Test_corner corner(random);
    corner.a = random.between(0.5, 2) * t.gauges().side(h);
    corner.b = -random.between(0.5, 2) * t.gauges().side(t.halfedges_of_face(h)[2]);
    auto bend = polygon.bend(corner.a, corner.b);
    bend.excess = (1 + bend.excess) * (1 + error) - 1;
    expect_bend(bend, corner, random,
                [&](const Plane_vector v) { return t.gauges().cost(t.gauges().face(h), v); });
  }
}

// The slope of the length changes along the side of a regular triangle from -1/2 to 1/2, and the
// chord over 60 degrees is too high by that over an edge of a hexagon.
TEST(Gauge_bends, are_known_for_lengths)
{
  Sampled_polygon sampled([](const Plane_vector v) { return length(v); }, 1e-5);
  const Test_corner corner(0.3, straight_angle / 3);
  const auto bend = sampled.polygon.bend(corner.a, corner.b);
  EXPECT_NEAR(1, bend.turn, 0.02);
  EXPECT_NEAR(2 / std::sqrt(3.) - 1, bend.excess, 1e-4);
  EXPECT_NEAR(std::sqrt(0.75), sampled.polygon.height(corner.a, corner.b), 1e-4);
  EXPECT_NEAR(std::sqrt(3.), sampled.polygon.height(2 * corner.a, 2 * corner.b), 1e-4);
}

// Directions beside a corner of the unit ball may differ in proportion to the error, and without
// corners in proportion to its root.
TEST(Gauge_steps, are_as_large_as_corners_allow)
{
  const Test_corner corner(0.3, 1);
  Sampled_polygon square([](const Plane_vector v) { return std::abs(v.x) + std::abs(v.y); });
  Sampled_polygon disk([](const Plane_vector v) { return length(v); }, 1e-5);
  const auto ratio = [&](Sampled_polygon& sampled) {
    return sampled.polygon.step(corner.a, corner.b, 0.04) /
           sampled.polygon.step(corner.a, corner.b, 0.01);
  };
  EXPECT_NEAR(4, ratio(square), 0.6);
  EXPECT_NEAR(2, ratio(disk), 0.3);
}

// Where the gauge is linear in all directions that cross a corner, anything goes.
TEST(Gauge_steps, are_largest_where_gauges_are_linear)
{
  Sampled_polygon square([](const Plane_vector v) { return std::abs(v.x) + std::abs(v.y); });
  const Test_corner wide(-0.14, 1.84), narrow(0.2, 0.5);
  EXPECT_LT(square.polygon.step(narrow.a, narrow.b, 0.01), 1);
  EXPECT_EQ(Gauge_polygon::LARGEST_STEP, square.polygon.step(wide.a, wide.b, 0.01));
}

// ----- formulas

template <typename Value>
using One_value = boost::static_property_map<Value, Face>;

// The plane with these slopes along its axes.
std::array<Space_vector, 2> axes(const double slope, const double turn)
{
  const double run = 1 / std::hypot(1, slope), c = std::cos(turn), s = std::sin(turn);
  return {Space_vector{c, s * run, s * slope * run}, Space_vector{-s, c * run, c * slope * run}};
}

// Next to the gauge that samples find, and to that of the opposite directions.
template <typename Cost>
void expect_formula(const Cost& cost, const double slope, const double turn)
{
  SCOPED_TRACE(std::to_string(slope) + ", " + std::to_string(turn));
  constexpr double tolerance = 1e-4;
  const auto [x, y] = axes(slope, turn);
  const auto function = directional_cost(cost);
  const Gauge_formula formula = Cost_formulas{x, y}.of(function, Face(0));
  ASSERT_TRUE(formula);
  const Gauge_formula back = Cost_formulas{x, y}.of(directional_cost(reversed_cost(cost)), Face(0));
  const Sampled_polygon sampled(
      [&, x = x, y = y](const Plane_vector v) {
        return function(Face(0), Vector(v.x * x[0] + v.y * y[0], v.x * x[1] + v.y * y[1],
                                        v.x * x[2] + v.y * y[2]));
      },
      tolerance);
  constexpr int number = 997;
  double least = infinity;
  for(int i = 0; i < number; ++i)
  {
    const Plane_vector v = 3 * unit_vector(2 * straight_angle * i / number);
    least = (std::min)(least, formula(v));
    EXPECT_LE(formula(v), (1 + 1e-9) * sampled.cost(v));
    EXPECT_GE(formula(v), (1 - 2 * tolerance) * sampled.cost(v));
    EXPECT_LE(formula(v), 3 * formula.largest());
    EXPECT_EQ(formula(v), back(-1 * v));
    const Plane_vector w = unit_vector(i);
    EXPECT_LE(formula(v + w), (1 + 1e-12) * (formula(v) + formula(w)));
  }
  EXPECT_GT(least, 0);
}

TEST(Gauge_formulas, are_the_gauges_of_their_functions)
{
  for(const double slope : {0., 0.03, 0.2, 0.3, 0.44, 1., 30.})
    for(const double turn : {0., 1.1, 3.7})
    {
      expect_formula(AG::Hiking_time(0.6), slope, turn);
      expect_formula(AG::Walking_energy(), slope, turn);
      const auto [x, y] = axes(slope, turn + 1);
      const double drift = slope < 0.4 ? 0.3 : 0.98;
      expect_formula(AG::Drift_time(One_value<Vector>(1.5 * drift * Vector(x[0], x[1], x[2])), 1.5),
                     slope, turn);
      expect_formula(AG::Tensor_cost(One_value<std::array<double, 6>>({2, 0.5, -0.3, 9, 0.1, 1})),
                     slope, turn);
    }
}

// Zigzags cost as much as straight lines where these have their slope.
TEST(Gauge_formulas, are_continuous)
{
  const auto [x, y] = axes(1, 0);
  const auto expect_continuous = [&, x = x, y = y](const auto& cost) {
    const Gauge_formula formula = Cost_formulas{x, y}.of(cost, Face(0));
    double last = formula(unit_vector(0));
    for(int i = 1; i <= 100000; ++i)
    {
      const double next = formula(unit_vector(2 * straight_angle * i / 100000));
      ASSERT_NEAR(last, next, 1e-3 * last);
      last = next;
    }
  };
  expect_continuous(AG::Hiking_time());
  expect_continuous(AG::Walking_energy());
}

TEST(Gauge_formulas, are_not_there_where_directions_are_forbidden_or_free)
{
  const auto [x, y] = axes(0, 0);
  const auto has_formula = [&, x = x, y = y](const auto& cost) {
    return bool(Cost_formulas{x, y}.of(directional_cost(cost), Face(0)));
  };
  EXPECT_TRUE(has_formula(AG::Drift_time(One_value<Vector>(Vector(0, 0.9, 0)), 1)));
  for(const double drift : {1., 1.5, infinity, not_a_number})
    EXPECT_FALSE(has_formula(AG::Drift_time(One_value<Vector>(Vector(0, drift, 0)), 1)));
  using Tensor = std::array<double, 6>;
  EXPECT_TRUE(has_formula(AG::Tensor_cost(One_value<Tensor>({1, 0, 0, 1e-3, 0, 0}))));
  for(const double value : {0., -1., infinity, not_a_number})
    EXPECT_FALSE(has_formula(AG::Tensor_cost(One_value<Tensor>({1, 0, 0, value, 0, 1}))));
  EXPECT_FALSE(has_formula(AG::One_way(One_value<Vector>(Vector(1, 0, 0)))));
  EXPECT_FALSE(has_formula([](const Face, const Vector&) { return 1; }));
}

} // namespace
