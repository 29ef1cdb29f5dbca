// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How time and memory of a search grow with the mesh: generated terrains of 10^4 to 10^7 vertices.
// See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/searches_of_arrays.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

class Growth_benchmark
{
public:
  explicit Growth_benchmark(const std::size_t number_of_rounds)
    : m_number_of_rounds(number_of_rounds),
      m_table({"vertices", "build ns/vertex", "search ns/vertex", "breadth first ns/vertex",
               "ours : breadth first", "graph bytes/vertex", "workspace bytes/vertex",
               "bytes/vertex"})
  {
  }

  void run(const std::size_t side)
  {
    std::cerr << "Terrain of " << side * side << " vertices ...\n";
    const Mesh mesh = terrain(side);
    const double vertices = double(mesh.number_of_vertices());
    std::optional<AG::Edge_graph> built;
    const double build = seconds_of([&] { built.emplace(AG::Intrinsic_triangulation(mesh)); });
    const AG::Edge_graph& graph = *built;

    AG::Propagation<AG::Edge_graph> search(graph);
    Breadth_first_search breadth_first(graph.triangulation());
    const auto sources = random_sources(mesh, m_number_of_rounds);
    const auto node = [&](const std::size_t i) { return graph.triangulation().vertex(sources[i]); };
    Contest contest;
    const auto ours = contest.add([&](const auto round) { search.run_from(node(round)); });
    const auto floor = contest.add([&](const auto round) { breadth_first.run_from(node(round)); });
    contest.run(sources.size());

    m_times.push_back(contest.median_seconds(ours) / vertices);
    m_table.add_row()
        .add(vertices, 0)
        .add(build / vertices * 1e9, 1)
        .add(m_times.back() * 1e9, 1)
        .add(contest.median_seconds(floor) / vertices * 1e9, 1)
        .add(contest.ratio(ours, floor), 2)
        .add(double(graph.memory()) / vertices, 1)
        .add(double(search.memory()) / vertices, 1)
        .add(double(graph.memory() + search.memory()) / vertices, 1);
  }

  const Table& table() const { return m_table; }

  // time per vertex of the last mesh, in that of the one `number` before it
  double ratio(const std::size_t number) const
  {
    return m_times.back() / m_times[m_times.size() - 1 - number];
  }

private:
  std::size_t m_number_of_rounds;
  Table m_table;
  std::vector<double> m_times; // in seconds per vertex
};

int main(int argc, char* argv[])
{
  const auto measure_growth = [](const Options& options, const Report& report) {
    Growth_benchmark benchmark(options.number_of_rounds);
    const std::vector<std::size_t> sides = {100, 178, 317, 563, 1000, 1779, 3163};
    for(const std::size_t side : options.is_quick ? std::vector<std::size_t>{20, 50} : sides)
      benchmark.run(side);
    report.print("growth",
                 "Generated terrains (medians of " + std::to_string(options.number_of_rounds) +
                     " sources)",
                 benchmark.table());
    if(!options.is_quick)
      std::cout << "Time per vertex, 10 million vertices : 100,000 vertices = "
                << Table::text_of(benchmark.ratio(4), 2) << '\n';
  };
  return run_benchmark(argc, argv, "bench_growth", {{}, 11, ""}, measure_growth);
}
