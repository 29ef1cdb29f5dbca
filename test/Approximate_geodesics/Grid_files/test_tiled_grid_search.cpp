// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Grid_files/Tiled_grid_search.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "files/Temporary_folder.h"

#include <CGAL/Approximate_geodesics/Graphs/Grid_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/cost_functions.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

// Searches in tiles against a search of the whole grid.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Grid_cell;
using AG::Grid_graph;
using AG::Grid_place;
using AG::Grid_shape;
using AG::Grid_window;

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
    const std::vector<double> values = window(friction, w);
    if(!heights.empty())
      return Grid_graph(part, values,
                        CGAL::parameters::heights(window(heights, w))
                            .direction_to_source(goes_to_sources)
                            .face_weight_map(AG::directional_cost(AG::Hiking_time())));
    return epsilon > 0 ? Grid_graph(part, values, CGAL::parameters::epsilon(epsilon))
                       : Grid_graph(part, values);
  }

  std::vector<double> window(const std::vector<double>& values, const Grid_window& w) const
  {
    std::vector<double> result;
    for(std::size_t row = 0; row < w.rows; ++row)
      for(std::size_t column = 0; column < w.columns; ++column)
        result.push_back(values[shape.index({w.first_column + column, w.first_row + row})]);
    return result;
  }

  Grid_graph whole() const { return (*this)({0, 0, shape.columns, shape.rows}); }
};

using Tiled = AG::Tiled_grid_search<Terrain_in_tiles>;

// Friction from 1 to 10, whole numbers or any, with blocked cells; the sources are open.
Terrain_in_tiles random_terrain(Random& random, const std::vector<Grid_cell>& sources)
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
Terrain_in_tiles random_hills(Random& random, const std::vector<Grid_cell>& sources)
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

void expect_distances_of_one_graph(const Terrain_in_tiles& terrain,
                                   const std::vector<Grid_cell>& sources,
                                   const Tiled& tiled)
{
  const Grid_graph graph = terrain.whole();
  AG::Propagation<Grid_graph> search(graph);
  std::vector<AG::Seed> seeds;
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
double cost_of_arc(const Grid_graph& graph, const Grid_graph::Node from, const Grid_graph::Node to)
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
void expect_path_of_distance(const Terrain_in_tiles& terrain,
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
  const AG::internal::Grid_nodes nodes(terrain.shape.columns, terrain.shape.rows,
                                       (graph.number_of_nodes() - terrain.shape.number_of_cells()) /
                                           number_of_blocks);
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
    const AG::Grid_point found = tiled.position(p), expected = graph.position(node(p));
    EXPECT_NEAR(found.x * terrain.shape.cell_width, expected.x, 1e-12 * (1 + expected.x));
    EXPECT_NEAR(found.y * terrain.shape.cell_height, expected.y, 1e-12 * (1 + expected.y));
  }
}

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

TEST(Tiled_grid_search, finds_the_bits_of_one_graph_on_heights_and_in_degrees)
{
  Random random(test_seed());
  for(int i = 0; i < 8; ++i)
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

// ----- ends before the end

// Counts tiles, and stops after some.
struct Tile_counter : AG::Geodesic_visitor_base
{
  bool go_further() { return number++ < most; }

  int number = 0, most = 0;
};

TEST(Tiled_grid_search, resumes_with_tiles_of_any_size)
{
  Random random(test_seed());
  for(int i = 0; i < 10; ++i)
  {
    const Temporary_folder folder;
    const std::vector<Grid_cell> sources{{random.below(20), random.below(20)}};
    const Terrain_in_tiles terrain = random_terrain(random, sources);
    const auto make = [&] {
      return Tiled(terrain.shape.columns, terrain.shape.rows, terrain, sources,
                   5 + random.below(40), folder.file("work"));
    };
    for(Tile_counter visitor; !make().run(visitor);)
      visitor = {{}, 0, visitor.most + 1};
    Tiled tiled = make();
    EXPECT_TRUE(tiled.run());
    EXPECT_EQ(tiled.number_of_visits(), 0u);
    expect_distances_of_one_graph(terrain, sources, tiled);
    tiled.remove_files();
    EXPECT_TRUE(folder.contents().empty());
  }
}

TEST(Tiled_grid_search, follows_all_arcs_again_after_a_crash_of_the_system)
{
  Random random(test_seed());
  const Temporary_folder folder;
  const std::vector<Grid_cell> sources{{3, 4}};
  const Terrain_in_tiles terrain = random_terrain(random, sources);
  const auto make = [&] {
    return Tiled(terrain.shape.columns, terrain.shape.rows, terrain, sources, 10, folder.name());
  };
  Tile_counter visitor;
  visitor.most = 6;
  make().run(visitor);
  { // a page of closed labels that never came to disk
    std::fstream labels(folder.file("labels"), std::ios::in | std::ios::out | std::ios::binary);
    labels.seekp(static_cast<std::streamoff>(7 * terrain.shape.columns * sizeof(double)));
    labels << std::string(3 * terrain.shape.columns * sizeof(double), '\0');
  }
  std::ofstream(folder.file("boot")) << "another one\n";
  Tiled tiled = make();
  EXPECT_TRUE(tiled.run());
  expect_distances_of_one_graph(terrain, sources, tiled);
}

TEST(Tiled_grid_search, finds_lost_sources_and_predecessors_after_a_crash_of_the_system)
{
  Random random(test_seed());
  for(const char* const name : {"labels", "predecessors"})
  {
    SCOPED_TRACE(name);
    const Temporary_folder folder;
    const std::vector<Grid_cell> sources{{3, 4}, {15, 12}};
    const Terrain_in_tiles terrain = random_terrain(random, sources);
    const auto make = [&] {
      return Tiled(terrain.shape.columns, terrain.shape.rows, terrain, sources, 10, folder.name());
    };
    EXPECT_TRUE(make().run());
    { // all pages but the last ones
      std::fstream file(folder.file(name), std::ios::in | std::ios::out | std::ios::binary);
      const std::size_t size_of_entry = *name == 'l' ? 8 : 4;
      file << std::string((terrain.shape.number_of_cells() * 3 / 4) * size_of_entry, '\0');
    }
    std::ofstream(folder.file("boot")) << "another one\n";
    Tiled tiled = make();
    EXPECT_TRUE(tiled.run());
    expect_distances_of_one_graph(terrain, sources, tiled);
    for(std::size_t i = 0; i < 20; ++i)
      expect_path_of_distance(terrain, sources, tiled, {i, i});
  }
}

#if defined(__unix__) || defined(__APPLE__)

// Runs `f` in another process, and kills that after some microseconds. Returns whether it has ended
// before.
bool ends_before(const std::function<void()>& f, const std::size_t microseconds)
{
  const pid_t child = fork();
  if(child == 0)
  {
    f();
    _exit(0);
  }
  usleep(static_cast<useconds_t>(microseconds));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status);
}

TEST(Tiled_grid_search, is_killed_and_resumed)
{
  Random random(test_seed());
  for(int i = 0; i < 4; ++i)
  {
    const Temporary_folder folder;
    const std::vector<Grid_cell> sources{{random.below(20), random.below(20)}};
    Terrain_in_tiles terrain = random_terrain(random, sources);
    terrain.epsilon = i % 2 == 0 ? 0 : 0.5;
    const auto make = [&] {
      return Tiled(terrain.shape.columns, terrain.shape.rows, terrain, sources,
                   5 + random.below(20), folder.name());
    };
    std::size_t number_of_kills = 0;
    while(!ends_before([&] { make().run(); }, 500 + random.below(1000 + 300 * number_of_kills)))
      ++number_of_kills;
    std::cout << number_of_kills << " kills" << std::endl;
    Tiled tiled = make();
    EXPECT_EQ(tiled.run(), true);
    expect_distances_of_one_graph(terrain, sources, tiled);
    expect_path_of_distance(terrain, sources, tiled, {10, 10});
  }
}

TEST(Tiled_grid_search, refuses_a_folder_that_another_process_uses)
{
  const Temporary_folder folder;
  const Terrain_in_tiles terrain{{10, 10, 1, 1, {}}, std::vector<double>(100, 1), 0};
  const Tiled tiled(10, 10, terrain, {{5, 5}}, 5, folder.name());
  const pid_t child = fork();
  if(child == 0)
  {
    int result = 1;
    try
    {
      const Tiled second(10, 10, terrain, {{5, 5}}, 5, folder.name());
    }
    catch(const std::invalid_argument& e)
    {
      result = std::string(e.what()).find("another process works in") == std::string::npos;
    }
    _exit(result);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

// Files cannot become longer than this as long as an object lives, as if the disk was full.
class File_size_limit
{
public:
  explicit File_size_limit(const rlim_t size)
  {
    getrlimit(RLIMIT_FSIZE, &m_before);
    const rlimit limit{size, m_before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  ~File_size_limit()
  {
    setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
  }

private:
  rlimit m_before;
  void (*m_handler)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

TEST(Tiled_grid_search, needs_room_on_disk_before_it_starts)
{
  const Temporary_folder folder;
  const Terrain_in_tiles terrain{{100, 100, 1, 1, {}}, std::vector<double>(10000, 1), 0};
  const auto make = [&] { return Tiled(100, 100, terrain, {{5, 5}}, 50, folder.name()); };
  {
    const File_size_limit limit(50000);
    expect_message<std::runtime_error>(make, "labels cannot be written: File too large");
    EXPECT_FALSE(folder.has("labels"));
    EXPECT_FALSE(folder.has("task"));
  }
  Tiled tiled = make();
  EXPECT_TRUE(tiled.run());
  expect_distances_of_one_graph(terrain, {{5, 5}}, tiled);
}

#endif

// ----- bad input

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

TEST(Tiled_grid_search, refuses_a_folder_of_another_task)
{
  const Temporary_folder folder;
  const Terrain_in_tiles terrain{{10, 10, 1, 1, {}}, std::vector<double>(100, 1), 0};
  const auto make = [&](const std::size_t columns, const Grid_cell& source,
                        const std::string& costs) {
    return Tiled(columns, 10, terrain, {source}, 5, folder.name(), costs);
  };
  make(10, {1, 2}, "a");
  make(10, {1, 2}, "a"); // the same
  expect_message<std::invalid_argument>(
      [&] {
        make(9, {1, 2}, "a");
      },
      "files of another task", "10 columns, 10 rows");
  expect_message<std::invalid_argument>(
      [&] {
        make(10, {1, 3}, "a");
      },
      "another task", "sources: 21");
  expect_message<std::invalid_argument>([&] { make(10, {1, 2}, "b"); }, "another task", "costs: b");
  std::ofstream(folder.file("labels")) << "short";
  expect_message<std::invalid_argument>(
      [&] {
        make(10, {1, 2}, "a");
      },
      "labels has 5 bytes in place of 800");
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
