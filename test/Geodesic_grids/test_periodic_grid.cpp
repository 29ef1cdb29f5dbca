// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "grids/cells.h"

#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/isolines_on_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

// Grids whose columns go round, against three copies of them side by side.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::directional_cost;
using AG::Grid_vector;
using AG::Hiking_time;
using CGAL::parameters::epsilon;
using CGAL::parameters::heights;

Grid_shape periodic(Grid_shape shape)
{
  shape.is_periodic = true;
  return shape;
}

Grid_shape three_of(Grid_shape shape)
{
  shape.columns *= 3;
  shape.is_periodic = false;
  return shape;
}

Cell_values three_of(const Grid_shape& shape, const Cell_values& values)
{
  Cell_values result;
  for(std::size_t i = 0; i < 3 * values.size(); ++i)
    result.push_back(values[shape.index(
        {three_of(shape).cell(i).column % shape.columns, three_of(shape).cell(i).row})]);
  return result;
}

// Returns the least of the costs of the three copies of each cell, from a source in the middle one.
// `cost(shape, source)` returns those of the copies.
template <typename Cost>
Cell_values least_of_copies(const Grid_shape& shape, const Grid_cell& source, const Cost& cost)
{
  const Cell_values all =
      cost(three_of(shape), Grid_cell{source.column + shape.columns, source.row});
  Cell_values result(shape.number_of_cells(), no_way);
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    const Grid_cell cell = three_of(shape).cell(i);
    double& least = result[shape.index({cell.column % shape.columns, cell.row})];
    least = std::min(least, all[i]);
  }
  return result;
}

void expect_equal(const Cell_values& found, const Cell_values& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    if(std::isinf(expected[i]))
      EXPECT_EQ(found[i], expected[i]) << i;
    else
      EXPECT_NEAR(found[i], expected[i], expected[i] * slack_of_costs) << i;
}

TEST(Periodic_grid, has_costs_of_copies_side_by_side)
{
  Random random(test_seed());
  for(int turn = 0; turn < 20; ++turn)
  {
    const Grid_shape shape =
        periodic({31 + random.below(12), 4 + random.below(20), random.between(0.5, 2), 1});
    const Grid_cell source{random.below(2) == 0 ? 0 : random.below(shape.columns), 0};
    Cell_values friction = random_friction(random, shape);
    friction[shape.index(source)] = 1;
    expect_equal(costs_of_cells(shape, friction, source),
                 least_of_copies(shape, source, [&](const Grid_shape& s, const Grid_cell& c) {
                   return costs_of_cells(s, three_of(shape, friction), c);
                 }));
  }
}

TEST(Periodic_grid, has_heights_and_directions_of_copies)
{
  Random random(test_seed());
  for(int turn = 0; turn < 8; ++turn)
  {
    const Grid_shape shape = periodic({33, 12, 10, 12, std::nan("")});
    const Grid_cell source{random.below(shape.columns), 5};
    Cell_values h = values_of_cells(shape, [&](double, double) { return random.between(0, 9); });
    const Cell_values all = h; // what stands for missing ones depends on neighbors of the copies
    const Cell_values all_of_three = three_of(shape, all);
    for(std::size_t i = 0; i < 40; ++i)
      h[random.below(h.size())] = std::nan("");
    h[shape.index(source)] = 3;
    const Cell_values h_of_three = three_of(shape, h);
    const auto hiking = directional_cost(Hiking_time());
    expect_equal(costs_of_cells(shape, 1, source, heights(h).face_weight_map(hiking)),
                 least_of_copies(shape, source, [&](const Grid_shape& s, const Grid_cell& c) {
                   return costs_of_cells(s, 1, c, heights(h_of_three).face_weight_map(hiking));
                 }));
    expect_equal(costs_of_cells(shape, 1, source, heights(all).max_slope(0.4)),
                 least_of_copies(shape, source, [&](const Grid_shape& s, const Grid_cell& c) {
                   return costs_of_cells(s, 1, c, heights(all_of_three).max_slope(0.4));
                 }));
    const auto wind = [&](const Grid_cell& cell, const Grid_vector& d) {
      return 2 + d.x() * std::sin(0.7 * static_cast<double>(cell.column % shape.columns)) + d.z();
    };
    const auto cost = directional_cost(wind);
    expect_equal(costs_of_cells(shape, 1, source,
                                heights(h).face_weight_map(cost).direction_to_source(true)),
                 least_of_copies(shape, source, [&](const Grid_shape& s, const Grid_cell& c) {
                   return costs_of_cells(
                       s, 1, c,
                       heights(h_of_three).face_weight_map(cost).direction_to_source(true));
                 }));
  }
}

TEST(Periodic_grid, has_great_circles_across_the_antimeridian)
{
  const Grid_shape shape = periodic({360, 120, 1, 1, {}, 60});
  const Grid_cell source{359, 60}, beside{0, 60}, far{30, 20};
  const Grid_graph graph(shape, 1);
  const Cell_values found = costs_of_cells(shape, 1, source);
  const double degree = std::acos(-1.) / 180;
  EXPECT_NEAR(found[shape.index(beside)], 6378137 * degree, 20);
  const double first = -0.5 * degree, second = 39.5 * degree, longitudes = 31 * degree;
  const double expected =
      6371008.8 * std::acos(std::sin(first) * std::sin(second) +
                            std::cos(first) * std::cos(second) * std::cos(longitudes));
  EXPECT_NEAR(found[shape.index(far)] / expected, 1, 0.008);
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LE(graph.lower_bound(graph.node(source), static_cast<Grid_graph::Node>(i)),
              found[i] * (1 + slack_of_costs));
}

TEST(Periodic_grid, lets_paths_and_isolines_go_on_beyond_the_last_column)
{
  const Grid_shape shape = periodic({40, 20, 2, 2});
  std::vector<Grid_point> path;
  const double cost = CGAL::approximate_geodesic_path_on_grid(shape, 1, std::back_inserter(path),
                                                              Grid_cell{37, 10}, Grid_cell{3, 10});
  EXPECT_EQ(cost, 12);
  EXPECT_EQ(path.front().x, 75);
  EXPECT_EQ(path.back().x, 87);
  for(std::size_t i = 1; i < path.size(); ++i)
    EXPECT_GT(path[i].x, path[i - 1].x);

  std::vector<std::vector<Grid_point>> lines;
  AG::isolines_on_grid(shape, costs_of_cells(shape, 1, Grid_cell{0, 10}), 10,
                       std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 1);
  const double turns = std::round((lines[0].front().x - 1) / shape.width());
  for(const Grid_point& p : lines[0]) // a circle
    EXPECT_NEAR(std::hypot(p.x - 1 - turns * shape.width(), p.y - 21), 10, 0.2);
  lines.clear();
  AG::isolines_on_grid(shape, values_of_cells(shape, [](double, double y) { return y; }), 10,
                       std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 1);
  EXPECT_EQ(lines[0].size(), 41);
  EXPECT_EQ(std::abs(lines[0].back().x - lines[0].front().x), shape.width());
}

TEST(Periodic_grid, rejects_what_does_not_go_round)
{
  const auto rejects = [](const Grid_shape& shape, const char* const text) {
    expect_message<std::invalid_argument>([&] { Grid_graph(shape, 1); }, text);
  };
  rejects(periodic({30, 3, 1, 1}), "periodic and has 30 columns");
  rejects(periodic({359, 3, 1, 1, {}, 10}), "359 degrees");
  expect_message<std::invalid_argument>(
      [] {
        Grid_graph(periodic({40, 3, 1, 1}), 1, epsilon(0.1));
      },
      "periodic");
}

TEST(Geographic_grid, has_the_ellipsoid_of_another_body)
{
  Grid_shape shape{10, 12, 0.1, 0.1, {}, 30};
  shape.ellipsoid = {1737400, 0}; // the Moon
  const double degree = std::acos(-1.) / 180;
  const Cell_values found = costs_of_cells(shape, 1, Grid_cell{0, 0});
  EXPECT_NEAR(found[shape.index({0, 11})], 1.1 * degree * 1737400, 1e-3);
  EXPECT_NEAR(found[1], 0.1 * degree * 1737400 * std::cos(29.95 * degree), 1e-3);
  const auto rejects = [&](const AG::Grid_ellipsoid& ellipsoid, const char* const text) {
    shape.ellipsoid = ellipsoid;
    expect_message<std::invalid_argument>([&] { Grid_graph(shape, 1); }, text);
  };
  rejects({0, 0}, "equatorial radius");
  rejects({std::nan(""), 0}, "equatorial radius");
  rejects({1, 1}, "flattening is 1");
}

TEST(Grid, rounds_no_data_to_the_type_of_values)
{
  for(const double no_data : {-9999.9, 1e20, -3.4028235e38, 1e39})
  {
    const Grid_shape shape{3, 1, 1, 1, no_data};
    std::vector<float> values{1, 1, static_cast<float>(no_data)};
    if(no_data > 3.5e38)
      values[2] = std::numeric_limits<float>::infinity();
    EXPECT_EQ(costs_of_cells(shape, values, Grid_cell{0, 0}), (Cell_values{0, 1, no_way}));
    EXPECT_EQ(costs_of_cells(shape, 1, Grid_cell{0, 0}, heights(values)),
              (Cell_values{0, 1, no_way}));
    EXPECT_EQ(Grid_graph(shape, Cell_values{1, 1, 2}).friction({2, 0}), 2);
  }
}

} // namespace
