// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/approximate_geodesic_distances_on_grid.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "grids/cells.h"

#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <vector>

// The functions on grids, against the graph, and against the costs of their paths.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using CGAL::parameters::epsilon;

double cost_of_polyline(const Grid_graph& graph, const std::vector<Grid_point>& points)
{
  constexpr std::size_t parts = 20000;
  const Grid_shape& shape = graph.shape();
  double result = 0;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    for(std::size_t k = 0; k < parts; ++k)
    {
      const double t = (static_cast<double>(k) + 0.5) / parts;
      const auto at = [&](const double p, const double q) { return p + t * (q - p); };
      const double x = at(points[i].x, points[i + 1].x) / shape.cell_width,
                   y = at(points[i].y, points[i + 1].y) / shape.cell_height;
      double friction = no_way; // the smallest one, on a side
      for(const double dx : {-1e-9, 1e-9})
        for(const double dy : {-1e-9, 1e-9})
          if(const Grid_cell c{static_cast<std::size_t>(x + dx), static_cast<std::size_t>(y + dy)};
             x + dx >= 0 && y + dy >= 0 && c.column < shape.columns && c.row < shape.rows)
            friction = (std::min)(friction, graph.friction(c));
      result += friction * straight_distance(points[i], points[i + 1]) / parts;
    }
  return result;
}

TEST(Grid_functions, find_distances_and_paths)
{
  Random random(test_seed());
  for(std::size_t i = 0; i < 20; ++i)
  {
    const Grid_shape shape{2 + random.below(9), 2 + random.below(9), 1, 1.25, {}};
    const Cell_values friction = random_friction(random, shape);
    const Grid_cell target = shape.cell(random.below(shape.number_of_cells()));
    const auto check = [&](const Grid_graph& graph, const auto&... np) {
      std::vector<double> distances;
      CGAL::approximate_geodesic_distances_on_grid(shape, friction, std::back_inserter(distances),
                                                   Grid_cell{}, np...);
      EXPECT_EQ(distances, distances_of_cells(graph, {}));
      std::vector<Grid_point> points;
      const double cost = CGAL::approximate_geodesic_path_on_grid(
          shape, friction, std::back_inserter(points), Grid_cell{}, target, np...);
      const double expected = distances[shape.index(target)];
      if(std::isinf(expected))
      {
        EXPECT_EQ(cost, no_way);
        EXPECT_TRUE(points.empty());
        return;
      }
      EXPECT_NEAR(cost, expected, slack_of_costs);
      ASSERT_FALSE(points.empty());
      EXPECT_EQ(straight_distance(points.front(), shape.center({})), 0);
      EXPECT_EQ(straight_distance(points.back(), shape.center(target)), 0);
      EXPECT_NEAR(cost_of_polyline(graph, points), cost, 1e-3 * cost);
    };
    check(Grid_graph(shape, friction));
    check(Grid_graph(shape, friction, epsilon(0.2)), epsilon(0.2));
  }
}

struct Settled_cells : AG::Geodesic_visitor_base
{
  explicit Settled_cells(std::vector<Grid_cell>& settled) : cells(settled) {}
  void on_settled(const Grid_cell& cell, double /* distance */) { cells.push_back(cell); }
  bool go_further() { return cells.size() < 50; }
  std::vector<Grid_cell>& cells;
};

TEST(Grid_functions, take_ranges_limits_and_visitors)
{
  using CGAL::parameters::maximum_distance;
  const Grid_shape shape{40, 30, 1, 1, {}};
  const std::vector<int> friction(shape.number_of_cells(), 2);
  const std::vector<Grid_cell> sources{{0, 0}, {39, 29}};
  std::vector<double> all, near, stopped, none;
  CGAL::approximate_geodesic_distances_on_grid(shape, friction, std::back_inserter(all), sources);
  CGAL::approximate_geodesic_distances_on_grid(shape, friction, std::back_inserter(near), sources,
                                               maximum_distance(20));
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    const Grid_point p = shape.center(shape.cell(i));
    const double expected = 2 * (std::min)(straight_distance(p, shape.center(sources[0])),
                                           straight_distance(p, shape.center(sources[1])));
    EXPECT_GE(all[i], expected * (1 - slack_of_costs));
    EXPECT_LE(all[i], expected * 1.003);
    EXPECT_EQ(near[i], all[i] <= 20 ? all[i] : no_way);
  }
  std::vector<Grid_cell> settled;
  CGAL::approximate_geodesic_distances_on_grid(shape, friction, std::back_inserter(stopped),
                                               sources,
                                               CGAL::parameters::visitor(Settled_cells(settled)));
  EXPECT_GE(settled.size(), 50u);
  EXPECT_LT(settled.size(), all.size());
  EXPECT_TRUE(settled.front() == sources[0] || settled.front() == sources[1]);
  CGAL::approximate_geodesic_distances_on_grid(shape, friction, std::back_inserter(none),
                                               std::vector<Grid_cell>());
  EXPECT_EQ(none, std::vector<double>(all.size(), no_way));
  std::vector<Grid_point> path;
  const double cost = CGAL::approximate_geodesic_path_on_grid(
      shape, friction, std::back_inserter(path), sources, Grid_cell{38, 29});
  EXPECT_EQ(cost, 2);
  EXPECT_EQ(path.size(), 2u);
  expect_message<std::invalid_argument>(
      [&] {
        CGAL::approximate_geodesic_distances_on_grid(shape, friction, all.begin(),
                                                     std::vector<Grid_cell>{{0, 0}, {0, 30}});
      },
      "source 1", "(0, 30)", "30 rows");
  expect_message<std::invalid_argument>(
      [&] {
        CGAL::approximate_geodesic_distances_on_grid(shape, friction, all.begin(), sources,
                                                     maximum_distance(-1));
      },
      "maximum distance");
  expect_message<std::invalid_argument>(
      [&] {
        CGAL::approximate_geodesic_path_on_grid(shape, friction, path.begin(), sources,
                                                Grid_cell{40, 0});
      },
      "(40, 0)");
}

} // namespace
