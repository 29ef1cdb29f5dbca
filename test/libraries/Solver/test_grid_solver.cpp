// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Grid_solver.h>

#include "checks/expect_message.h"

#include <CGAL/approximate_geodesic_distances_on_grid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

// Grids of arrays, as bindings have them, beside the functions.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Grid_cell;
using AG::Grid_shape;
using AG::Grid_solver;
using AG::Grid_solver_options;
using AG::Solver_cost;

const Grid_shape shape_of_solver{23, 17, 10, 8, {}};

std::vector<double> heights_of_solver()
{
  std::vector<double> result;
  for(std::size_t i = 0; i < shape_of_solver.number_of_cells(); ++i)
  {
    const Grid_cell c = shape_of_solver.cell(i);
    result.push_back(2.5 * std::sin(double(c.column) / 2) + double(c.row));
  }
  return result;
}

std::vector<double> costs_of_solver(const Grid_solver& solver, const bool is_to_source = false)
{
  std::vector<double> result(shape_of_solver.number_of_cells());
  solver.find_distances({{3, 4}}, result.data(), nullptr, nullptr,
                        {std::numeric_limits<double>::infinity(), is_to_source});
  return result;
}

template <typename... NamedParameters>
std::vector<double> costs_of_function(const NamedParameters&... np)
{
  std::vector<double> result;
  CGAL::approximate_geodesic_distances_on_grid(shape_of_solver, 1, std::back_inserter(result),
                                               Grid_cell{3, 4}, np...);
  return result;
}

TEST(Grid_solver, finds_what_the_functions_find)
{
  using CGAL::parameters::epsilon;
  using CGAL::parameters::heights;
  const std::vector<double> h = heights_of_solver();
  Grid_solver_options options;
  EXPECT_EQ(costs_of_solver(Grid_solver(shape_of_solver)), costs_of_function());
  options.epsilon = 0.2;
  EXPECT_EQ(costs_of_solver(Grid_solver(shape_of_solver, options)),
            costs_of_function(epsilon(0.2)));
  options.epsilon.reset();
  options.heights = h.data();
  EXPECT_EQ(costs_of_solver(Grid_solver(shape_of_solver, options)), costs_of_function(heights(h)));
  const auto expect_cost = [&](const Solver_cost& cost, const auto& f) {
    options.cost = cost;
    const Grid_solver solver(shape_of_solver, options);
    const auto np = heights(h).face_weight_map(AG::directional_cost(f));
    EXPECT_EQ(costs_of_solver(solver), costs_of_function(np));
    EXPECT_EQ(costs_of_solver(solver, true), costs_of_function(np.direction_to_source(true)));
  };
  expect_cost(Solver_cost::hiking_time(0.6), AG::Hiking_time(0.6));
  expect_cost(Solver_cost::walking_energy(), AG::Walking_energy());
  expect_cost(Solver_cost::naismith_time(), AG::Naismith_time());
}

TEST(Grid_solver, takes_numbers_of_cells_and_samples_of_slopes)
{
  const std::vector<double> h = heights_of_solver();
  Grid_solver_options options;
  std::vector<double> wind;
  for(std::size_t i = 0; i < h.size(); ++i)
    wind.insert(wind.end(), {0.5, 0, 0});
  options.cost = Solver_cost::drift_time(wind, 1);
  const Grid_solver with_wind(shape_of_solver, options);
  EXPECT_NEAR(costs_of_solver(with_wind)[shape_of_solver.index({13, 4})], 100 / 1.5, 1e-9);
  EXPECT_NEAR(costs_of_solver(with_wind, true)[shape_of_solver.index({13, 4})], 100 / 0.5, 1e-9);
  options.cost.reset();
  options.heights = h.data();
  for(std::size_t i = 0; i < Grid_solver_options::NUMBER_OF_SLOPES; ++i)
    options.slope_costs.push_back(
        AG::Hiking_time()(double(i) / Grid_solver_options::SLOPES_PER_UNIT - 4));
  const auto found = costs_of_solver(Grid_solver(shape_of_solver, options));
  options.slope_costs.clear();
  options.cost = Solver_cost::hiking_time();
  const auto expected = costs_of_solver(Grid_solver(shape_of_solver, options));
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-9 * expected[i]);
}

TEST(Grid_solver, finds_sources_predecessors_paths_and_isolines)
{
  const std::vector<double> h = heights_of_solver();
  for(const bool has_bound : {false, true})
  {
    Grid_solver_options options;
    if(has_bound)
      options.epsilon = 0.3;
    else
      options.heights = h.data();
    const Grid_solver solver(shape_of_solver, options);
    const std::size_t n = h.size();
    std::vector<double> costs(n);
    std::vector<std::int64_t> nearest(n), predecessors(n);
    const std::vector<Grid_cell> sources{{0, 0}, {22, 16}};
    solver.find_distances(sources, costs.data(), nearest.data(), predecessors.data());
    for(std::size_t i = 0; i < n; ++i)
    {
      std::size_t k = i;
      while(static_cast<std::size_t>(predecessors[k]) != k)
      {
        EXPECT_LT(costs[static_cast<std::size_t>(predecessors[k])], costs[k]);
        k = static_cast<std::size_t>(predecessors[k]);
      }
      EXPECT_EQ(k, shape_of_solver.index(sources[static_cast<std::size_t>(nearest[i])]));
    }
    std::vector<AG::Grid_point> path;
    const double cost = solver.find_path({0, 0}, {5, 7}, path);
    EXPECT_NEAR(cost, costs[shape_of_solver.index({5, 7})], 1e-9);
    EXPECT_EQ(path.back().x, 55);
    EXPECT_EQ(path.front().y, 4);
    EXPECT_FALSE(solver.find_isolines(costs.data(), 50).empty());
    EXPECT_GT(solver.memory(), n * sizeof(double));
  }
}

TEST(Grid_solver, has_isolines_around_sources_whatever_friction_has_for_no_data)
{
  Grid_shape shape = shape_of_solver;
  shape.no_data = 0;
  std::vector<double> friction(shape.number_of_cells(), 1);
  friction.back() = 0;
  Grid_solver_options options;
  options.friction = friction.data();
  const Grid_solver solver(shape, options);
  const std::vector<double> costs = costs_of_solver(solver);
  EXPECT_TRUE(std::isinf(costs.back()));
  EXPECT_EQ(solver.find_isolines(costs.data(), 3).size(), 1u);
}

TEST(Grid_solver, takes_grids_of_one_cell_and_of_none_that_can_be_entered)
{
  const double none = -1;
  Grid_shape shape{1, 1, 1, 1, {}};
  for(const bool is_open : {true, false})
  {
    if(!is_open)
      shape.no_data = none;
    Grid_solver_options options;
    options.heights = &none;
    const Grid_solver solver(shape, options);
    double cost = -1;
    std::int64_t source = -1, predecessor = -1;
    solver.find_distances({{0, 0}}, &cost, &source, &predecessor);
    EXPECT_EQ(cost, 0);
    EXPECT_EQ(source, 0);
    EXPECT_EQ(predecessor, 0);
    std::vector<AG::Grid_point> path;
    EXPECT_EQ(solver.find_path({0, 0}, {0, 0}, path), 0);
    EXPECT_EQ(path.size(), 1u);
    EXPECT_TRUE(solver.find_isolines(&cost, 0).empty());
  }
}

TEST(Grid_solver, can_be_interrupted)
{
  const Grid_shape shape{400, 400, 1, 1, {}};
  const Grid_solver solver(shape);
  std::vector<double> costs(shape.number_of_cells());
  const AG::Solver_watch watch{[] { return false; }, {}};
  bool is_interrupted = false;
  for(int i = 0; i < 100 && !is_interrupted; ++i) // a run may be done before the first look
    try
    {
      solver.find_distances({{3, 4}}, costs.data(), nullptr, nullptr, {}, watch);
    }
    catch(const AG::Solver_interrupted&)
    {
      is_interrupted = true;
    }
  EXPECT_TRUE(is_interrupted);
  solver.find_distances({{3, 4}}, costs.data());
  EXPECT_EQ(costs[shape.index({13, 4})], 10);
}

TEST(Grid_solver, can_be_interrupted_while_it_is_built)
{
  const Grid_shape shape{2000, 2000, 1, 1, {}};
  const std::vector<double> h(shape.number_of_cells());
  Grid_solver_options options;
  options.friction = options.heights = h.data();
  std::size_t done = 0;
  const AG::Solver_watch progress{{}, [&](const std::size_t n, std::size_t) { done = n; }};
  const Grid_solver solver(shape, options, progress);
  EXPECT_EQ(done, shape.number_of_cells());
  const AG::Solver_watch stop{[] { return false; }, {}};
  const auto build = [&] {
    for(int i = 0; i < 100; ++i) // a call may be done before the first look
      Grid_solver(shape, options, stop);
  };
  EXPECT_THROW(build(), AG::Solver_interrupted);
}

TEST(Grid_solver, rejects_bad_cells)
{
  std::vector<double> wrong(shape_of_solver.number_of_cells(), 1);
  wrong[24] = std::nan("");
  const auto rejects = [](const Grid_shape& shape, const Grid_solver_options& options,
                          const char* const text) {
    expect_message<std::invalid_argument>([&] { Grid_solver(shape, options); }, text);
  };
  Grid_solver_options with_heights, with_friction;
  with_heights.heights = with_friction.friction = wrong.data();
  rejects(shape_of_solver, with_heights, "height of cell (1, 1) is nan");
  rejects(shape_of_solver, with_friction, "friction of cell (1, 1) is nan");
  rejects({0, 3, 1, 1, {}}, {}, "no cells");
  rejects({3, 0, 1, 1, {}}, {}, "no cells");
  for(const double size : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()})
    rejects({3, 3, size, 1, {}}, {}, "width of a cell");
}

TEST(Grid_solver, limits_slopes)
{
  const std::vector<double> h = heights_of_solver();
  Grid_solver_options options;
  options.heights = h.data();
  options.max_slope = 0.1;
  const auto np = CGAL::parameters::heights(h).max_slope(0.1);
  EXPECT_EQ(costs_of_function(np), costs_of_solver(Grid_solver(shape_of_solver, options)));
  options.cost = Solver_cost::hiking_time();
  EXPECT_EQ(costs_of_function(np.face_weight_map(AG::directional_cost(AG::Hiking_time()))),
            costs_of_solver(Grid_solver(shape_of_solver, options)));
}

TEST(Grid_solver, rejects_bad_input)
{
  const std::vector<double> h = heights_of_solver();
  const auto rejects = [](const Grid_solver_options& options, const char* const text) {
    expect_message<std::invalid_argument>([&] { Grid_solver(shape_of_solver, options); }, text);
  };
  Grid_solver_options options;
  options.max_slope = 0.3;
  rejects(options, "max_slope is given, and there are no heights");
  options.max_slope = std::numeric_limits<double>::infinity();
  options.cost = Solver_cost::hiking_time();
  rejects(options, "no heights");
  options.epsilon = 0.1;
  rejects(options, "no bound");
  options.epsilon.reset();
  options.cost = Solver_cost::drift_time({1, 0, 0}, 1);
  rejects(options, "3 numbers for 391 cells");
  options.cost = Solver_cost::drift_time(std::vector<double>(3 * h.size(), std::nan("")), 1);
  rejects(options, "cell 0 has the number nan");
  options.heights = h.data();
  options.cost = Solver_cost{Solver_cost::HIKING_TIME, {}, {}};
  rejects(options, "parameters");
  options.cost = Solver_cost::sampled_cost({}, 4);
  rejects(options, "not for grids");
  options.cost.reset();
  options.slope_costs = {1, 2};
  rejects(options, "2 costs by slope");
  const Grid_solver solver(shape_of_solver);
  std::vector<double> costs(h.size());
  std::vector<AG::Grid_point> path;
  expect_message<std::invalid_argument>(
      [&] {
        solver.find_distances({{0, 0}, {23, 0}}, costs.data());
      },
      "source 1", "(23, 0)");
  expect_message<std::invalid_argument>(
      [&] {
        solver.find_path({0, 0}, {0, 17}, path);
      },
      "target", "(0, 17)");
}

} // namespace
