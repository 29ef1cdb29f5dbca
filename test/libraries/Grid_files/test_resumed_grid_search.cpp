// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "files/Temporary_folder.h"
#include "grids/Terrain_in_tiles.h"

#include <CGAL/Approximate_geodesics/Grid_files/Tiled_grid_search.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

// Searches in tiles that end before the end, and go on from the files of their folder.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

// Counts tiles, and stops after some.
struct Tile_counter : AG::Geodesic_visitor_base
{
  bool go_further() { return number++ < most; }

  int number = 0, most = 0;
};

TEST(Resumed_grid_search, resumes_with_tiles_of_any_size)
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

// Windows of which one cannot be read.
struct Unreadable_windows
{
  Grid_graph operator()(const Grid_window& window) const
  {
    if(--*number_until_failure == 0)
      throw std::runtime_error("cannot be read");
    return (*terrain)(window);
  }

  const Terrain_in_tiles* terrain;
  int* number_until_failure;
};

TEST(Resumed_grid_search, goes_on_after_a_window_could_not_be_read)
{
  Random random(test_seed());
  const std::vector<Grid_cell> sources{{3, 4}};
  Terrain_in_tiles terrain{{40, 50, 1, 1, {}}, {}, 0};
  for(std::size_t i = 0; i < terrain.shape.number_of_cells(); ++i)
    terrain.friction.push_back(random.between(1, 10));
  int number_until_failure = 0, number_of_failures = 0;
  const Unreadable_windows windows{&terrain, &number_until_failure};
  AG::Tiled_grid_search<Unreadable_windows> tiled(terrain.shape.columns, terrain.shape.rows,
                                                  windows, sources, 10);
  for(bool is_done = false; !is_done;)
    try
    {
      number_until_failure = 2;
      is_done = tiled.run();
    }
    catch(const std::runtime_error&)
    {
      ++number_of_failures;
    }
  EXPECT_GE(number_of_failures, 19); // of 20 tiles, each of which is settled once at least
  expect_distances_of_one_graph(terrain, sources, tiled);
}

TEST(Resumed_grid_search, follows_all_arcs_again_after_a_crash_of_the_system)
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

TEST(Resumed_grid_search, finds_lost_sources_and_predecessors_after_a_crash_of_the_system)
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

TEST(Resumed_grid_search, is_killed_and_resumed)
{
  Random random(test_seed());
  std::size_t number_of_all_kills = 0;
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
    std::size_t longest = 1000;
    while(!ends_before([&] { make().run(); }, 500 + random.below(longest)))
    {
      ++number_of_kills;
      longest += 300 + longest / 20; // so that slow machines come to an end, too
    }
    std::cout << number_of_kills << " kills" << std::endl;
    number_of_all_kills += number_of_kills;
    Tiled tiled = make();
    EXPECT_EQ(tiled.run(), true);
    expect_distances_of_one_graph(terrain, sources, tiled);
    expect_path_of_distance(terrain, sources, tiled, {10, 10});
  }
  EXPECT_GT(number_of_all_kills, 0u);
}

TEST(Resumed_grid_search, refuses_a_folder_that_another_process_uses)
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

TEST(Resumed_grid_search, needs_room_on_disk_before_it_starts)
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

TEST(Resumed_grid_search, refuses_a_folder_of_another_task)
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

} // namespace
