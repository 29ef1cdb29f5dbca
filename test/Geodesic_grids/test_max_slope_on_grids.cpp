// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_grids/Grid_graph.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "grids/cells.h"
#include "paths/dijkstra.h"

#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

// The limit of slopes on grids: no line is steeper anywhere, and no zigzag takes its place.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::directional_cost;
using AG::Grid_vector;
using CGAL::parameters::heights;

// ----- walls

double limited_cost(const Grid_shape& shape,
                    const Cell_values& height,
                    const double limit,
                    const Grid_cell& from,
                    const Grid_cell& to)
{
  std::vector<Grid_point> path;
  return CGAL::approximate_geodesic_path_on_grid(shape, 1, std::back_inserter(path), from, to,
                                                 heights(height).max_slope(limit));
}

TEST(Max_slope_on_grids, makes_a_wall_a_wall)
{
  const Grid_shape shape{40, 40, 10, 10, {}};
  const Cell_values step =
      values_of_cells(shape, [](const double x, double) { return x < 200 ? 0. : 100.; });
  const Cell_values ridge = values_of_cells(
      shape, [](const double x, double) { return std::abs(x - 205) < 1 ? 100. : 0.; });
  const Cell_values diagonal = values_of_cells( // cells that touch at corners
      shape, [](const double x, const double y) { return std::abs(x - y) < 1 ? 100. : 0.; });
  for(const Cell_values* const wall : {&step, &ridge, &diagonal})
  {
    EXPECT_EQ(no_way, limited_cost(shape, *wall, 0.6, {2, 20}, {37, 20}));
    EXPECT_LT(limited_cost(shape, *wall, 20, {2, 20}, {37, 20}), 1000);
  }
  // what a cost of infinity does not forbid
  const auto forbid = [](const double s) { return std::abs(s) <= 0.6 ? 1. : no_way; };
  const auto costs = heights(step).face_weight_map(directional_cost(forbid));
  const std::size_t other_side = shape.index({37, 20});
  EXPECT_LT(costs_of_cells(shape, 1, {2, 20}, costs)[other_side], 1000);
  EXPECT_EQ(no_way, costs_of_cells(shape, 1, {2, 20}, costs.max_slope(0.6))[other_side]);
}

TEST(Max_slope_on_grids, leads_round_a_hill)
{
  // a hill with a path of slope 0.4 to its top from the west, and steep sides
  const Grid_shape shape{61, 61, 2, 2, {}};
  const Cell_values height = values_of_cells(shape, [](const double x, const double y) {
    const double r = std::hypot(x - 61, y - 61), top = 12;
    const bool is_on_ramp = std::abs(y - 61) < 4 && x < 61;
    return is_on_ramp ? std::clamp(top + 0.4 * (10 - r), 0., top) : r < 10 ? top : 0.;
  });
  const Grid_cell east{58, 30}, top{30, 30}, west{1, 30};
  const double straight = limited_cost(shape, height, 0.5, west, top);
  EXPECT_NEAR(28 + 30 * std::hypot(1, 0.4), straight, 1.5); // where the ramp begins and ends
  EXPECT_GT(limited_cost(shape, height, 0.5, east, top), straight + 56);
  EXPECT_EQ(no_way, limited_cost(shape, height, 0.02, east, top));
}

// ----- planes

TEST(Max_slope_on_grids, makes_paths_zigzag_at_centers_on_a_plane)
{
  const Grid_shape shape{81, 61, 5, 5, {}};
  const double steepness = 0.5, limit = 0.3;
  const Cell_values height =
      values_of_cells(shape, [=](double, const double y) { return 1000 + steepness * y; });
  const Grid_cell source{40, 30};
  const Grid_point p = shape.center(source);
  const Cell_values found = costs_of_cells(shape, 1, source, heights(height).max_slope(limit));
  const Cell_values back =
      costs_of_cells(shape, 1, source, heights(height).max_slope(limit).direction_to_source(true));
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    const Grid_point q = shape.center(shape.cell(i));
    const double rise = steepness * std::abs(q.y - p.y);
    const double expected =
        (std::max)(std::hypot(q.x - p.x, q.y - p.y, rise), rise * std::hypot(1, limit) / limit);
    EXPECT_GE(found[i], expected * (1 - 1e-9));
    if(std::abs(q.y - p.y) >= 75 || rise == 0) // near by, lines are few
    {
      EXPECT_LE(found[i], expected * 1.08);
    }
    EXPECT_NEAR(found[i], back[i], 1e-9 * found[i]);
  }
  const double exact = limited_cost(shape, height, steepness, {40, 5}, {40, 55});
  EXPECT_NEAR(std::hypot(250, 125), exact, 1e-9); // a slope that is the limit is within it
  EXPECT_LT(exact, 0.997 * limited_cost(shape, height, 0.499, {40, 5}, {40, 55}));
}

TEST(Max_slope_on_grids, allows_planes_ten_times_as_steep)
{
  const Grid_shape shape{241, 61, 1, 1, {}};
  const Cell_values height = values_of_cells(shape, [](double, const double y) { return y; });
  const Grid_cell below{120, 0}, above{120, 60};
  EXPECT_EQ(no_way, limited_cost(shape, height, 0.099, below, above));
  double largest = 1;
  for(const double limit : {0.1, 0.15, 0.19, 0.24, 0.3, 0.4, 0.5, 0.7, 0.9})
  {
    const double shortest = 60 * std::hypot(1, limit) / limit; // of a zigzag
    const double ratio = limited_cost(shape, height, limit, below, above) / shortest;
    EXPECT_GE(ratio, 1 - 1e-9);
    largest = (std::max)(largest, ratio);
  }
  EXPECT_GT(largest, 1.2);
  EXPECT_LT(largest, 1.23);
}

// ----- an oracle

// Height on the surface of two triangles between four centers, divided by a diagonal; `u` and `v`
// are between 0 and 1.
double height_on_triangles(const double h00,
                           const double h10,
                           const double h01,
                           const double h11,
                           const double u,
                           const double v,
                           const bool by_first_diagonal)
{
  if(by_first_diagonal) // from 00 to 11
    return u > v ? h00 + u * (h10 - h00) + v * (h11 - h10)
                 : h00 + v * (h01 - h00) + u * (h11 - h01);
  return u + v < 1 ? h00 + u * (h10 - h00) + v * (h01 - h00)
                   : h11 + (1 - u) * (h01 - h11) + (1 - v) * (h10 - h11);
}

// The steepest slope of a line, which is linear between a thousand points but for few of them.
double steepest_slope(const Grid_shape& shape, const Cell_values& height, Grid_cell a, Grid_cell b)
{
  const double x = double(a.column), y = double(a.row);
  const double dx = double(b.column) - x, dy = double(b.row) - y;
  const double length = std::hypot(dx * shape.cell_width, dy * shape.cell_height);
  double result = 0;
  for(const bool by_first_diagonal : {true, false})
  {
    const auto at = [&](const double t) {
      const double px = x + t * dx, py = y + t * dy;
      const double i = (std::min)(std::floor(px), double(shape.columns - 2)),
                   j = (std::min)(std::floor(py), double(shape.rows - 2));
      const auto h = [&](const std::size_t m, const std::size_t n) {
        return height[shape.index({std::size_t(i) + m, std::size_t(j) + n})];
      };
      return height_on_triangles(h(0, 0), h(1, 0), h(0, 1), h(1, 1), px - i, py - j,
                                 by_first_diagonal);
    };
    constexpr int number = 1024;
    for(int k = 0; k + 2 <= number; ++k)
    {
      const double first = at(double(k) / number), middle = at(double(k + 1) / number),
                   last = at(double(k + 2) / number);
      if(std::abs(first + last - 2 * middle) < 1e-9) // no bend between
        result = (std::max)(result, std::abs(last - first) * number / 2 / length);
    }
  }
  return result;
}

// Labels with which all lines from a node are reported.
struct Only_label
{
  double distance(const std::size_t other) const { return other == node ? 0 : no_way; }
  static AG::Grid_graph::Node predecessor(std::size_t /* node */)
  {
    return (std::numeric_limits<AG::Grid_graph::Node>::max)();
  }

  std::size_t node;
};

TEST(Max_slope_on_grids, allows_the_lines_that_are_not_steeper_on_triangles)
{
  Random random(test_seed());
  for(int round = 0; round < 4; ++round)
  {
    const Grid_shape shape{7, 6, 1, random.between(0.7, 1.5), {}};
    Cell_values height;
    for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
      height.push_back(double(random.below(4)));
    const double limit = random.between(0.8, 2);
    const AG::Grid_graph limited(shape, 1, heights(height).max_slope(limit)),
        unlimited(shape, 1, heights(height));
    const Grid_cell source{random.below(7), random.below(6)};
    const Cell_values expected = textbook_distances<double>(
        shape.number_of_cells(), shape.index(source), [&](const auto node, const auto& relax) {
          const Grid_cell cell = shape.cell(node);
          unlimited.for_each_arc(
              static_cast<AG::Grid_graph::Node>(node), Only_label{node},
              [&](const AG::Grid_graph::Node other, const auto cost, const auto... /* number */) {
                if constexpr(std::is_same_v<decltype(cost), const double>)
                  if(steepest_slope(shape, height, cell, shape.cell(other)) <= limit)
                    relax(other, cost);
              });
        });
    const Cell_values found = distances_of_cells(limited, source);
    for(std::size_t i = 0; i < found.size(); ++i)
      if(expected[i] == no_way)
        EXPECT_EQ(no_way, found[i]);
      else
        EXPECT_NEAR(expected[i], found[i], 1e-12 * expected[i]);
  }
}

// ----- with other costs

TEST(Max_slope_on_grids, holds_with_any_cost)
{
  Random random(test_seed());
  const Grid_shape shape{30, 25, 3, 3, {}};
  const Cell_values height = values_of_cells(
      shape, [](const double x, const double y) { return 8 * std::sin(x / 9) * std::cos(y / 7); });
  const Cell_values friction = random_friction(random, shape);
  const double limit = 0.45;
  const auto expect_within = [&](const auto& np) {
    for(const Grid_cell target : {Grid_cell{29, 24}, Grid_cell{0, 24}, Grid_cell{15, 12}})
    {
      std::vector<Grid_point> path;
      const double cost = CGAL::approximate_geodesic_path_on_grid(
          shape, friction, std::back_inserter(path), Grid_cell{0, 0}, target, np.max_slope(limit));
      std::vector<Grid_point> other;
      EXPECT_GE(cost, CGAL::approximate_geodesic_path_on_grid(
                          shape, friction, std::back_inserter(other), Grid_cell{0, 0}, target, np));
      const auto cell = [](const Grid_point& p) {
        return Grid_cell{std::size_t(p.x / 3), std::size_t(p.y / 3)};
      };
      for(std::size_t i = 1; i < path.size(); ++i)
        EXPECT_LE(steepest_slope(shape, height, cell(path[i - 1]), cell(path[i])),
                  limit * (1 + 1e-6));
    }
  };
  expect_within(heights(height));
  expect_within(heights(height).face_weight_map(directional_cost(AG::Hiking_time())));
  expect_within(heights(height).face_weight_map(
      directional_cost([](const Grid_cell&, const Grid_vector& d) { return 2 + d.x(); })));
}

TEST(Max_slope_on_grids, is_none_if_it_is_infinite)
{
  const Grid_shape shape{12, 9, 1, 1, {}};
  const Cell_values height =
      values_of_cells(shape, [](const double x, const double y) { return x * y; });
  EXPECT_EQ(costs_of_cells(shape, 1, {3, 3}, heights(height)),
            costs_of_cells(shape, 1, {3, 3}, heights(height).max_slope(no_way)));
}

TEST(Max_slope_on_grids, is_refused_by_name)
{
  const Grid_shape shape{2, 1, 1, 1, {}};
  const Cell_values level = equal_cells(shape, 0);
  for(const double limit : {-1., std::numeric_limits<double>::quiet_NaN()})
    expect_message<std::invalid_argument>(
        [&] { AG::Grid_graph(shape, 1, heights(level).max_slope(limit)); }, "max_slope is",
        "must be a number that is not negative");
}

} // namespace
