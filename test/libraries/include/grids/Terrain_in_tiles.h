// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_TERRAIN_IN_TILES_H
#define APPROXIMATE_GEODESICS_TEST_TERRAIN_IN_TILES_H

#include "checks/test_random.h"

#include <CGAL/Approximate_geodesics/Grid_files/Tiled_grid_search.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

// Terrains for searches in tiles, and what these have to find.

namespace geodesics_test {

using CGAL::Approximate_geodesics::Grid_cell;
using CGAL::Approximate_geodesics::Grid_graph;
using CGAL::Approximate_geodesics::Grid_place;
using CGAL::Approximate_geodesics::Grid_shape;
using CGAL::Approximate_geodesics::Grid_window;

constexpr double blocked_in_tiles = std::numeric_limits<double>::infinity();

struct Terrain_in_tiles
{
  Grid_shape shape;
  std::vector<double> friction;
  double epsilon = 0;               // none
  std::vector<double> heights = {}; // none
  bool goes_to_sources = false;

  Grid_graph operator()(const Grid_window& w) const
  {
    Grid_shape part = shape;
    part.columns = w.columns;
    part.rows = w.rows;
    part.rows_before = w.first_row;
    part.rows_after = shape.rows - w.first_row - w.rows;
    part.is_periodic = shape.is_periodic && w.columns == shape.columns;
    const std::vector<double> values = window(friction, w);
    if(!heights.empty())
      return Grid_graph(part, values,
                        CGAL::parameters::heights(window(heights, w))
                            .direction_to_source(goes_to_sources)
                            .face_weight_map(CGAL::Approximate_geodesics::directional_cost(
                                CGAL::Approximate_geodesics::Hiking_time())));
    return epsilon > 0 ? Grid_graph(part, values, CGAL::parameters::epsilon(epsilon))
                       : Grid_graph(part, values);
  }

  std::vector<double> window(const std::vector<double>& values, const Grid_window& w) const
  {
    std::vector<double> result;
    for(std::size_t row = 0; row < w.rows; ++row)
      for(std::size_t column = 0; column < w.columns; ++column)
        result.push_back(
            values[shape.index({(w.first_column + column) % shape.columns, w.first_row + row})]);
    return result;
  }

  Grid_graph whole() const { return (*this)({0, 0, shape.columns, shape.rows}); }
};

using Tiled = CGAL::Approximate_geodesics::Tiled_grid_search<Terrain_in_tiles>;

// Friction from 1 to 10, whole numbers or any, with blocked cells; the sources are open.
inline Terrain_in_tiles random_terrain(Random& random, const std::vector<Grid_cell>& sources)
{
  Terrain_in_tiles result{{20 + random.below(60), 20 + random.below(60), 1, 1, {}}, {}, 0};
  if(random.below(2) == 0)
    result.shape.cell_height = random.between(0.3, 3);
  const double share_of_blocked = random.below(2) == 0 ? 0 : random.between(0, 0.4);
  const bool is_whole = random.below(2) == 0;
  for(std::size_t i = 0; i < result.shape.number_of_cells(); ++i)
  {
    const double f = random.between(1, 10);
    result.friction.push_back(random.between(0, 1) < share_of_blocked ? blocked_in_tiles
                              : is_whole                              ? std::floor(f)
                                                                      : f);
  }
  for(const Grid_cell& source : sources)
    result.friction[result.shape.index(source)] = 1;
  return result;
}

// Hills with some noise, in degrees or not. Friction differs, and heights are missing, in all
// columns or in the first ones.
inline Terrain_in_tiles random_hills(Random& random, const std::vector<Grid_cell>& sources)
{
  Terrain_in_tiles result = random_terrain(random, sources);
  result.shape.cell_width = 100;
  result.shape.cell_height *= 100;
  result.shape.no_data = std::nan("");
  if(random.below(2) == 0)
  {
    result.shape.first_latitude = random.between(-60, 80);
    result.shape.cell_width = result.shape.cell_height = random.between(0.001, 0.3);
  }
  const std::size_t number_of_rough_columns = random.below(2) == 0 ? 5 : result.shape.columns;
  const double equal_friction = random.between(1, 2);
  const double share_of_missing = random.below(2) == 0 ? 0 : random.between(0, 0.2);
  for(std::size_t i = 0; i < result.shape.number_of_cells(); ++i)
  {
    const auto [column, row] = result.shape.cell(i);
    const double height =
        300 * std::sin(static_cast<double>(column) / 7) * std::cos(static_cast<double>(row) / 9) +
        random.between(0, 30);
    const bool is_rough = column < number_of_rough_columns;
    const bool is_missing = is_rough && random.between(0, 1) < share_of_missing;
    result.heights.push_back(is_missing ? std::nan("") : height);
    if(!is_rough)
      result.friction[i] = equal_friction;
  }
  for(const Grid_cell& source : sources)
    result.heights[result.shape.index(source)] = 100;
  result.goes_to_sources = random.below(2) == 0;
  return result;
}

template <typename Tiled_search>
void expect_distances_of_one_graph(const Terrain_in_tiles& terrain,
                                   const std::vector<Grid_cell>& sources,
                                   const Tiled_search& tiled)
{
  const Grid_graph graph = terrain.whole();
  CGAL::Approximate_geodesics::Propagation<Grid_graph> search(graph);
  std::vector<CGAL::Approximate_geodesics::Seed> seeds;
  for(const Grid_cell& source : sources)
    seeds.push_back({graph.node(source)});
  search.run(seeds);
  for(std::size_t row = 0; row < terrain.shape.rows; ++row)
    tiled.for_each_distance(row, [&](const std::size_t column, const double distance) {
      ASSERT_EQ(distance, search.distance(graph.node({column, row}))) << column << ", " << row;
    });
}

struct No_predecessors
{
  double distance(Grid_graph::Node node) const { return node == from ? 0 : blocked_in_tiles; }
  Grid_graph::Node predecessor(Grid_graph::Node) const
  {
    return std::numeric_limits<Grid_graph::Node>::max();
  }

  Grid_graph::Node from;
};

// Returns the smallest cost of an arc, or infinity if there is none.
inline double
cost_of_arc(const Grid_graph& graph, const Grid_graph::Node from, const Grid_graph::Node to)
{
  double result = blocked_in_tiles;
  const auto look_at = [&](const std::size_t node, const double cost) {
    if(node == to)
      result = std::min(result, cost);
  };
  graph.for_each_arc(from, No_predecessors{from}, [&](const auto... arguments) {
    if constexpr(sizeof...(arguments) == 2)
      look_at(arguments...);
    else
    {
      const auto [first, costs, number] = std::make_tuple(arguments...);
      for(std::size_t i = 0; i < number; ++i)
        look_at(first + i, costs[i]);
    }
  });
  return result;
}

// The costs of arcs add up to the distance, to the last bit.
inline void expect_path_of_distance(const Terrain_in_tiles& terrain,
                                    const std::vector<Grid_cell>& sources,
                                    const Tiled& tiled,
                                    const Grid_cell& target)
{
  const std::vector<Grid_place> path = tiled.path(target);
  ASSERT_EQ(path.empty(), tiled.distance(target) == blocked_in_tiles);
  if(path.empty())
    return;
  const Grid_graph graph = terrain.whole();
  const std::size_t number_of_blocks = (terrain.shape.columns + 1) * (terrain.shape.rows + 1);
  const CGAL::Approximate_geodesics::internal::Grid_nodes nodes(
      terrain.shape.columns, terrain.shape.rows,
      (graph.number_of_nodes() - terrain.shape.number_of_cells()) / number_of_blocks);
  const auto node = [&](const Grid_place& p) {
    return static_cast<Grid_graph::Node>(nodes.node(p));
  };
  double length = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
    length += cost_of_arc(graph, node(path[i - 1]), node(path[i]));
  EXPECT_EQ(length, tiled.distance(target));
  EXPECT_EQ(path.back(), (Grid_place{target.column, target.row, 0}));
  EXPECT_TRUE(std::any_of(sources.begin(), sources.end(), [&](const Grid_cell& source) {
    return path.front() == Grid_place{source.column, source.row, 0};
  }));
  for(const Grid_place& p : path)
  {
    const CGAL::Approximate_geodesics::Grid_point found = tiled.position(p),
                                                  expected = graph.position(node(p));
    EXPECT_NEAR(found.x * terrain.shape.cell_width, expected.x, 1e-12 * (1 + expected.x));
    EXPECT_NEAR(found.y * terrain.shape.cell_height, expected.y, 1e-12 * (1 + expected.y));
  }
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_TERRAIN_IN_TILES_H
