// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tasks of all sizes by one thread and by two: the second must never make a task slower. See
// --help.

#include "measuring/measure.h"
#include "measuring/threads.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_pair_distances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

// The least time of a task by one thread and by two, which take turns. A turn repeats a short task,
// so that the clock's steps do not matter.
template <typename F>
static std::array<double, 2> least_seconds(const std::size_t number_of_rounds, const F& task)
{
  constexpr double shortest_turn = 2e-3;
  std::array<double, 2> result;
  result.fill(std::numeric_limits<double>::infinity());
  std::size_t repetitions = 1;
  for(std::size_t round = 0; round <= number_of_rounds; ++round) // the first one only warms up
    for(std::size_t i = 0; i < result.size(); ++i)
      with_threads(i + 1, [&](const auto tag) {
        const double seconds = seconds_of([&] {
          for(std::size_t n = 0; n < repetitions; ++n)
            task(tag);
        });
        if(round > 0)
          result[i] = (std::min)(result[i], seconds / double(repetitions));
        else if(i == 0)
          repetitions += static_cast<std::size_t>(shortest_turn / seconds);
      });
  return result;
}

static void
add_mesh(Mesh mesh, const std::string& name, const std::size_t number_of_rounds, Table& table)
{
  const auto distances = mesh.add_property_map<Vertex, double>("v:distances").first;
  const std::vector<Vertex> sources = random_sources(mesh, 16);
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for(const Vertex source : sources)
    for(const Vertex target : random_sources(mesh, 4))
      pairs.emplace_back(source, target);
  auto row = table.add_row();
  row.add(name).add(double(mesh.number_of_vertices()), 0);
  const auto add = [&](const auto& task) {
    const auto [one, two] = least_seconds(number_of_rounds, task);
    row.add(one * 1e3, 3).add(two / one, 2);
  };
  add([&](const auto tag) {
    CGAL::approximate_geodesic_distances(mesh, distances, sources[0],
                                         parameters::epsilon(0.1).concurrency_tag(tag));
  });
  add([&](const auto tag) {
    CGAL::approximate_geodesic_distances(mesh, distances, sources[0],
                                         parameters::epsilon(0.).concurrency_tag(tag));
  });
  add([&](const auto tag) {
    const AG::Discrete_geodesic_graph graph(
        AG::Intrinsic_triangulation(mesh, parameters::concurrency_tag(tag)),
        parameters::epsilon(0.1).concurrency_tag(tag));
  });
  add([&](const auto tag) {
    AG::Dense_rows<float> rows;
    CGAL::approximate_geodesic_distance_matrix(mesh, rows, sources,
                                               parameters::concurrency_tag(tag));
  });
  add([&](const auto tag) {
    std::vector<double> results;
    CGAL::approximate_geodesic_pair_distances(mesh, pairs, std::back_inserter(results),
                                              parameters::concurrency_tag(tag));
  });
}

int main(int argc, char* argv[])
{
  const auto compare = [](const Options& options, const Report& report) {
    if(!HAS_THREADS)
    {
      std::cout << "NOTICE: what several threads do needs TBB, and is not measured.\n";
      return;
    }
    const std::size_t rounds = options.number_of_rounds;
    Table table({"mesh", "vertices", "call ms", "2 : 1", "exact ms", "2 : 1", "build ms", "2 : 1",
                 "matrix ms", "2 : 1", "pairs ms", "2 : 1"});
    for(const std::size_t side : {3u, 10u, 20u, 32u, 45u, 64u, 90u, 128u, 190u})
      if(side <= 32 || !options.is_quick)
        add_mesh(terrain(side), "terrain", rounds, table);
    for(const std::string& name : options.meshes)
      add_mesh(read_mesh(name), short_name(name), rounds, table);
    report.print("threads",
                 "Tasks by one thread, and what two take of its time: one call and a build at "
                 "epsilon 0.1, an exact search, 16 rows of a matrix and 64 pairs along edges; the "
                 "least of " +
                     std::to_string(rounds) + " alternating rounds",
                 table);
  };
  return run_benchmark(argc, argv, "bench_threads", {{"elephant", "bunny00"}, 15, ""}, compare);
}
