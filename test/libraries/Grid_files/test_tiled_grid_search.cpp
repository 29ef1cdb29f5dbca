// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Grid_files/Tiled_grid_search.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "files/Temporary_folder.h"
#include "grids/Terrain_in_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Searches in tiles against a search of the whole grid.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

// Rows of predecessors, as texts.
std::vector<std::string> predecessors(const Terrain_in_tiles& terrain, const Tiled& tiled)
{
  std::vector<std::string> result;
  for(std::size_t row = 0; row < terrain.shape.rows; ++row)
  {
    result.emplace_back();
    tiled.for_each_predecessor(row, [&](const std::size_t column, const Grid_place& p) {
      result.back() += std::to_string(column) + ": " + std::to_string(p.column) + ' ' +
                       std::to_string(p.row) + ' ' + std::to_string(p.slot) + '\n';
    });
  }
  return result;
}

TEST(Tiled_grid_search, finds_the_bits_of_one_graph)
{
  Random random(test_seed());
  for(int i = 0; i < 24; ++i)
  {
    const std::vector<Grid_cell> sources{{random.below(20), random.below(20)},
                                         {random.below(20), random.below(20)}};
    Terrain_in_tiles terrain = random_terrain(random, sources);
    terrain.epsilon = i % 4 == 3 ? random.between(0.3, 1) : 0;
    const std::size_t side = 1 + random.below(i % 2 == 0 ? 80 : 25);
    SCOPED_TRACE("terrain " + std::to_string(i) + ", side " + std::to_string(side));
    const Temporary_folder folder;
    Tiled tiled(terrain.shape.columns, terrain.shape.rows, terrain, sources, side,
                i % 2 == 0 ? "" : folder.name());
    EXPECT_TRUE(tiled.run());
    expect_distances_of_one_graph(terrain, sources, tiled);
    for(int k = 0; k < 5; ++k)
      expect_path_of_distance(
          terrain, sources, tiled,
          {random.below(terrain.shape.columns), random.below(terrain.shape.rows)});
  }
}

void expect_bits_of_one_graph_on_heights(const int number_of_terrains)
{
  Random random(test_seed());
  for(int i = 0; i < number_of_terrains; ++i)
  {
    const std::vector<Grid_cell> sources{{random.below(20), random.below(20)}};
    const Terrain_in_tiles terrain = random_hills(random, sources);
    SCOPED_TRACE("terrain " + std::to_string(i));
    const auto [columns, rows] = std::make_pair(terrain.shape.columns, terrain.shape.rows);
    std::vector<std::string> expected;
    for(const std::size_t side : {100u, 30u, 15u})
    {
      Tiled tiled(columns, rows, terrain, sources, side);
      EXPECT_TRUE(tiled.run());
      expect_distances_of_one_graph(terrain, sources, tiled);
      EXPECT_TRUE(tiled.order_ties());
      if(expected.empty())
        expected = predecessors(terrain, tiled);
      EXPECT_EQ(predecessors(terrain, tiled), expected);
      expect_path_of_distance(terrain, sources, tiled, {random.below(columns), random.below(rows)});
    }
  }
}

TEST(Tiled_grid_search, finds_the_bits_of_one_graph_on_heights_and_in_degrees)
{
  expect_bits_of_one_graph_on_heights(1);
}

TEST(Tiled_grid_search, finds_the_bits_of_one_graph_on_many_heights_and_in_degrees)
{
  expect_bits_of_one_graph_on_heights(8);
}

TEST(Tiled_grid_search, goes_round_periodic_grids)
{
  Random random(test_seed());
  for(int i = 0; i < 3; ++i)
  {
    const std::vector<Grid_cell> sources{{random.below(20), random.below(20)}};
    Terrain_in_tiles terrain;
    do // until it has enough columns
      terrain = i % 2 == 0 ? random_terrain(random, sources) : random_hills(random, sources);
    while(terrain.shape.columns < 60);
    terrain.shape.is_periodic = true;
    if(terrain.shape.first_latitude)
      terrain.shape.cell_width = 360. / static_cast<double>(terrain.shape.columns);
    const auto [columns, rows] = std::make_pair(terrain.shape.columns, terrain.shape.rows);
    std::vector<std::string> expected;
    for(const std::size_t side : {100u, 25u, 9u})
    {
      SCOPED_TRACE("terrain " + std::to_string(i) + ", side " + std::to_string(side));
      Tiled tiled(columns, rows, terrain, sources, side, "", "", true);
      EXPECT_TRUE(tiled.run());
      expect_distances_of_one_graph(terrain, sources, tiled);
      expect_path_of_distance(terrain, sources, tiled, {columns - 1 - random.below(9), 5});
      EXPECT_TRUE(tiled.order_ties());
      if(expected.empty())
        expected = predecessors(terrain, tiled);
      EXPECT_EQ(predecessors(terrain, tiled), expected);
    }
  }
}

struct Progress_recorder : CGAL::Approximate_geodesics::Geodesic_visitor_base
{
  void on_progress(const std::size_t done, const std::size_t all)
  {
    parts.push_back(static_cast<double>(done) / static_cast<double>(all));
  }

  std::vector<double> parts;
};

TEST(Tiled_grid_search, tells_of_progress_in_a_single_tile)
{
  const Terrain_in_tiles terrain{{300, 300, 1, 1, {}}, std::vector<double>(90000, 1), 0};
  Tiled tiled(300, 300, terrain, {{50, 50}}, 300);
  for(int i = 0; i < 2; ++i)
  {
    Progress_recorder recorder;
    EXPECT_TRUE(i == 0 ? tiled.run(recorder) : tiled.order_ties(recorder));
    EXPECT_GT(recorder.parts.size(), 10);
    EXPECT_EQ(recorder.parts.front(), 0);
    EXPECT_TRUE(std::is_sorted(recorder.parts.begin(), recorder.parts.end()));
    EXPECT_GT(recorder.parts.back(), 0.9);
    EXPECT_LE(recorder.parts.back(), 1);
  }
}

TEST(Tiled_grid_search, visits_each_tile_once_where_all_cells_are_equal)
{
  const Terrain_in_tiles terrain{{100, 100, 1, 1, {}}, std::vector<double>(10000, 1), 0};
  Tiled tiled(100, 100, terrain, {{50, 50}}, 20);
  EXPECT_TRUE(tiled.run());
  EXPECT_EQ(tiled.number_of_tiles(), 25u);
  EXPECT_EQ(tiled.number_of_visits(), 25u);
}

TEST(Tiled_grid_search, predecessors_lead_to_the_source)
{
  Random random(test_seed());
  const Terrain_in_tiles terrain = random_terrain(random, {{3, 4}});
  Tiled tiled(terrain.shape.columns, terrain.shape.rows, terrain, {{3, 4}}, 10);
  EXPECT_TRUE(tiled.run());
  for(std::size_t row = 0; row < terrain.shape.rows; ++row)
    tiled.for_each_predecessor(row, [&](const std::size_t column, const Grid_place& p) {
      EXPECT_LT(tiled.distance({p.column, p.row}), tiled.distance({column, row}));
    });
}

TEST(Tiled_grid_search, has_the_same_predecessors_with_tiles_of_any_size_after_ties_are_ordered)
{
  Random random(test_seed());
  for(int i = 0; i < 4; ++i)
  {
    const std::vector<Grid_cell> sources{{random.below(20), random.below(20)}};
    Terrain_in_tiles terrain = random_terrain(random, sources);
    terrain.epsilon = i % 2 == 0 ? 0 : 0.5;
    const Grid_cell target{random.below(terrain.shape.columns), random.below(terrain.shape.rows)};
    std::vector<std::string> expected;
    for(const std::size_t side : {100u, 30u, 7u})
    {
      Tiled tiled(terrain.shape.columns, terrain.shape.rows, terrain, sources, side);
      EXPECT_TRUE(tiled.run());
      EXPECT_TRUE(tiled.order_ties());
      if(expected.empty())
        expected = predecessors(terrain, tiled);
      EXPECT_EQ(predecessors(terrain, tiled), expected);
      if(terrain.epsilon == 0) // else arcs that the search leaves out may be shorter, by rounding
        expect_path_of_distance(terrain, sources, tiled, target);
    }
  }
}

TEST(Tiled_grid_search, paths_end_where_arcs_cost_nothing)
{
  Terrain_in_tiles terrain{{60, 60, 1, 1, {}}, std::vector<double>(3600, 0), 0};
  for(std::size_t i = 0; i < 3600; i += 7)
    terrain.friction[i] = 1;
  for(const double e : {0., 0.5})
  {
    terrain.epsilon = e;
    Tiled tiled(60, 60, terrain, {{50, 50}}, 10);
    EXPECT_TRUE(tiled.run());
    EXPECT_TRUE(tiled.order_ties());
    for(std::size_t i = 0; i < 60; ++i)
      EXPECT_EQ(tiled.path({i, 59 - i}).front(), (Grid_place{50, 50, 0}));
  }
}

// ----- bad input

TEST(Tiled_grid_search, has_one_tile_if_its_side_is_large)
{
  Random random(test_seed());
  const std::vector<Grid_cell> sources{{0, 0}};
  const Terrain_in_tiles terrain = random_terrain(random, sources);
  Tiled tiled(terrain.shape.columns, terrain.shape.rows, terrain, sources,
              (std::numeric_limits<std::size_t>::max)());
  EXPECT_TRUE(tiled.run());
  expect_distances_of_one_graph(terrain, sources, tiled);
}

TEST(Tiled_grid_search, refuses_bad_arguments)
{
  const Terrain_in_tiles terrain{{10, 10, 1, 1, {}}, std::vector<double>(100, 1), 0};
  expect_message<std::invalid_argument>(
      [&] {
        Tiled(10, 10, terrain, {{10, 3}}, 5);
      },
      "source cell (10, 3) does not exist");
  expect_message<std::invalid_argument>([&] { Tiled(0, 10, terrain, {}, 5); },
                                        "the grid has no cells: 0 columns and 10 rows");
  expect_message<std::invalid_argument>([&] { Tiled(10, 10, terrain, {}, 0); },
                                        "tiles have no columns and rows");
}

TEST(Tiled_grid_search, without_sources_reaches_nothing)
{
  const Terrain_in_tiles terrain{{10, 10, 1, 1, {}}, std::vector<double>(100, 1), 0};
  Tiled tiled(10, 10, terrain, {}, 5);
  EXPECT_TRUE(tiled.run());
  EXPECT_EQ(tiled.distance({3, 3}), blocked_in_tiles);
  EXPECT_TRUE(tiled.path({3, 3}).empty());
}

} // namespace
