// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"
#include "grids/cells.h"

#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/isolines_on_grid.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

// Graphs of grids, and functions on them, that end for want of memory.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

class Interrupted_on_grid : public testing::Test
{
protected:
  // What functions write to, and has room.
  struct Results
  {
    explicit Results(const std::size_t number_of_cells)
    {
      costs.reserve(number_of_cells);
      points.reserve(100);
      polylines.reserve(100);
    }

    Cell_values costs = {};
    std::vector<Grid_point> points = {};
    std::vector<std::vector<Grid_point>> polylines = {};
  };

  // Costs and points are written after all that could fail; polylines are found one after the
  // other. Most allocations are those of the graph; the last ones, of the search, all fail, too.
  void expect_survival_of(const std::function<void(Results&)>& function) const
  {
    const auto call = [&](Results& results) {
      results.polylines.clear();
      function(results);
    };
    Results first(m_friction.size());
    const std::ptrdiff_t number = number_of_allocations([&] { call(first); });
    constexpr std::ptrdiff_t of_search = 50;
    for(const std::ptrdiff_t first_failure :
        {std::ptrdiff_t(1), (std::max)(number - of_search, std::ptrdiff_t(1))})
      expect_survival<Results>({[&] { return Results(m_friction.size()); }, call,
                                [](Results& results) { return values(results); },
                                [](Results& results) {
                                  EXPECT_TRUE(results.costs.empty());
                                  EXPECT_TRUE(results.points.empty());
                                },
                                0, first_failure});
  }

  static Values values(const Results& results)
  {
    Values result = results.costs;
    const auto append = [&](const std::vector<Grid_point>& points) {
      for(const Grid_point& p : points)
        result.insert(result.end(), {p.x, p.y});
    };
    append(results.points);
    for(const std::vector<Grid_point>& polyline : results.polylines)
      append(polyline);
    return result;
  }

  Random m_random = Random(test_seed());
  const Grid_shape m_shape{9, 7, 1, 1.2, {}};
  const Cell_values m_friction = random_friction(m_random, m_shape);
  const Cell_values m_heights =
      values_of_cells(m_shape, [](double x, double y) { return std::sin(x) + 0.2 * y; });
};

TEST_F(Interrupted_on_grid, graphs)
{
  expect_survival([&] {
    const Grid_graph graph(m_shape, m_friction, parameters::epsilon(1.));
    return distances_of_cells(graph, {});
  });
  expect_survival([&] {
    const Grid_graph graph(
        m_shape, m_friction,
        parameters::heights(m_heights).face_weight_map(AG::directional_cost(AG::Hiking_time())));
    return distances_of_cells(graph.reversed(), {});
  });
  const auto cost = [](const Grid_cell&, const AG::Grid_vector& d) { return 2 - d.x(); };
  expect_survival([&] {
    const Grid_graph graph(m_shape, m_friction,
                           parameters::face_weight_map(AG::directional_cost(cost)));
    return distances_of_cells(graph.reversed(), {});
  });
}

TEST_F(Interrupted_on_grid, functions)
{
  const std::vector<Grid_cell> sources{{0, 0}, {8, 6}};
  expect_survival_of([&](Results& r) {
    CGAL::approximate_geodesic_distances_on_grid(m_shape, m_friction, std::back_inserter(r.costs),
                                                 sources, parameters::epsilon(1.));
  });
  expect_survival_of([&](Results& r) {
    CGAL::approximate_geodesic_path_on_grid(m_shape, 1, std::back_inserter(r.points), sources,
                                            Grid_cell{4, 3}, parameters::heights(m_heights));
  });
  expect_survival_of([&](Results& r) {
    AG::isolines_on_grid(m_shape, m_heights, 0.5, std::back_inserter(r.polylines));
  });
}

} // namespace
