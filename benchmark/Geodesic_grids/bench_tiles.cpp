// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Grids in tiles that are kept in files, beside smaller ones in memory: time per cell, and peak
// memory. Each search is a process of its own. See --help.

#include "measuring/child_process.h"
#include "measuring/measure.h"
#include "measuring/resident_memory.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Grid_files/Tiled_grid_search.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>

#include <boost/program_options.hpp>

#include <sys/resource.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using AG::Grid_graph;
using AG::Grid_shape;
using AG::Grid_window;

// A square grid whose friction is computed when it is asked for: smooth bands, and noise from cell
// to cell. The largest is some 30 times the smallest.
class Endless_terrain
{
public:
  Grid_graph operator()(const Grid_window& window) const
  {
    std::vector<double> friction;
    friction.reserve(window.columns * window.rows);
    for(std::size_t row = 0; row < window.rows; ++row)
      for(std::size_t column = 0; column < window.columns; ++column)
        friction.push_back(at(window.first_column + column, window.first_row + row));
    return Grid_graph(Grid_shape{window.columns, window.rows, 1, 1, {}}, friction);
  }

private:
  static double at(const std::size_t column, const std::size_t row)
  {
    constexpr double size_of_bands = 50;
    const double x = static_cast<double>(column) / size_of_bands,
                 y = static_cast<double>(row) / size_of_bands;
    return std::exp(1.5 * std::sin(x + 3 * std::sin(0.7 * y)) + 0.5 * noise(column, row));
  }

  // from 0 to 1
  static double noise(const std::size_t column, const std::size_t row)
  {
    auto n = static_cast<std::uint32_t>(column * 2654435761u + row * 2246822519u);
    n = (n ^ n >> 15) * 2146121005u;
    n = (n ^ n >> 13) * 2221713035u;
    return static_cast<double>(n ^ n >> 16) / 4294967296.;
  }
};

// What a child process reports.
enum Figure
{
  WALL_CLOCK,
  PROCESSOR,
  MEMORY,
  VISITS,
  TILES,
  CHECKSUM,
  NUMBER_OF_FIGURES
};

static double processor_seconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Measures `f()`, which returns a sum of distances.
template <typename F>
static void measure(double* const figures, F f)
{
  const double before = processor_seconds();
  figures[WALL_CLOCK] = seconds_of([&] { figures[CHECKSUM] = f(); });
  figures[PROCESSOR] = processor_seconds() - before;
  figures[MEMORY] = peak_memory();
}

// The sum of the distances in the corners tells whether both searches find the same bits.
static double search_in_memory(const std::size_t side)
{
  const Grid_graph graph = Endless_terrain()({0, 0, side, side});
  AG::Propagation<Grid_graph> search(graph);
  search.run_from(graph.node({side / 2, side / 2}));
  return search.distance(graph.node({0, 0})) + search.distance(graph.node({side - 1, side - 1}));
}

struct Tile_options
{
  std::size_t side, tile_side;
  std::string folder;
};

static double search_in_tiles(const Tile_options& options, double* const figures)
{
  const Endless_terrain terrain;
  const std::size_t side = options.side;
  AG::Tiled_grid_search<Endless_terrain> search(side, side, terrain, {{side / 2, side / 2}},
                                                options.tile_side, options.folder);
  search.run();
  const double result = search.distance({0, 0}) + search.distance({side - 1, side - 1});
  figures[VISITS] = static_cast<double>(search.number_of_visits());
  figures[TILES] = static_cast<double>(search.number_of_tiles());
  search.remove_files();
  return result;
}

class Tile_table
{
public:
  Tile_table()
    : m_table({"cells", "where", "us/cell", "ratio", "CPU us/cell", "ratio", "MB", "visits/tile"})
  {
  }

  // The first row is what ratios are of.
  template <typename F>
  double add(const std::size_t side, const std::string& where, F f)
  {
    constexpr unsigned no_limit = 1000000;
    const std::vector<double> figures = numbers_from_child(NUMBER_OF_FIGURES, no_limit, f);
    const double cells = static_cast<double>(side) * static_cast<double>(side);
    const double wall_clock = figures[WALL_CLOCK] / cells, processor = figures[PROCESSOR] / cells;
    if(m_wall_clock == 0)
    {
      m_wall_clock = wall_clock;
      m_processor = processor;
    }
    m_table.add_row()
        .add(std::to_string(side) + " x " + std::to_string(side))
        .add(where)
        .add(wall_clock * 1e6, 2)
        .add(wall_clock / m_wall_clock, 2)
        .add(processor * 1e6, 2)
        .add(processor / m_processor, 2)
        .add(figures[MEMORY] / 1e6, 0)
        .add(figures[TILES] > 0 ? figures[VISITS] / figures[TILES] : 1, 2);
    return figures[CHECKSUM];
  }

  const Table& table() const { return m_table; }

private:
  Table m_table;
  double m_wall_clock = 0, m_processor = 0;
};

static Table compare(const std::size_t side, const Tile_options& large)
{
  Tile_table table;
  const double expected = table.add(side, "memory", [&](double* const figures) {
    measure(figures, [&] { return search_in_memory(side); });
  });
  const auto add_tiles = [&](const Tile_options& options) {
    return table.add(options.side, "tiles of " + std::to_string(options.tile_side),
                     [&](double* const figures) {
                       measure(figures, [&] { return search_in_tiles(options, figures); });
                     });
  };
  if(add_tiles({side, large.tile_side, large.folder}) != expected)
    throw std::runtime_error("distances differ");
  add_tiles(large);
  return table.table();
}

int main(int argc, char* argv[])
{
  namespace po = boost::program_options;
  std::size_t side = 1000;
  Tile_options large{4000, 512, ""};
  More_options more;
  more.add_options()("side,s", po::value(&side), "the rows and columns of the grid in memory");
  more.add_options()("large-side,l", po::value(&large.side), "those of the large grid");
  more.add_options()("tile-side,t", po::value(&large.tile_side), "those of a tile");
  more.add_options()("folder,f", po::value(&large.folder)->default_value("bench_tiles_files"),
                     "where to keep files of 12 bytes per cell");
  const auto measure_all = [&](const Options& options, const Report& report) {
    if(options.is_quick)
    {
      side = 100;
      large.side = 300;
      large.tile_side = 50;
    }
    report.print("tiles", "Friction that varies, one search from the middle", compare(side, large));
  };
  return run_benchmark(argc, argv, "bench_tiles", {{}, 1, ""}, measure_all, more);
}
