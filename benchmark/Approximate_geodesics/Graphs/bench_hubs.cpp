// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What discrete geodesic graphs cost a vertex of meshes in which one vertex has very many
// neighbors. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/hubs.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using AG::Discrete_geodesic_graph;
using AG::Lazy_discrete_geodesic_graph;

class Hub_benchmark
{
public:
  Hub_benchmark(const double epsilon, const std::size_t number_of_rounds)
    : m_epsilon(epsilon),
      m_number_of_rounds(number_of_rounds),
      m_table({"surface", "neighbors", "build us/vertex", "arcs/vertex", "bytes/vertex",
               "search us/vertex", "prepare lazy us/vertex", "lazy search us/vertex"})
  {
  }

  void run(const std::string& surface, const std::size_t neighbors, const Mesh& mesh)
  {
    std::cerr << surface << ", " << neighbors << " neighbors ...\n";
    const AG::Intrinsic_triangulation triangulation(mesh);
    const std::vector<Vertex> sources = random_sources(mesh, m_number_of_rounds);
    const Discrete_geodesic_graph built(triangulation, parameters::epsilon(m_epsilon));
    const Lazy_discrete_geodesic_graph lazy(triangulation, parameters::epsilon(m_epsilon));
    AG::Propagation<Discrete_geodesic_graph> search(built);
    AG::Propagation<Lazy_discrete_geodesic_graph> lazy_search(lazy);
    Contest contest;
    contest.add([&](auto) {
      const Discrete_geodesic_graph graph(triangulation, parameters::epsilon(m_epsilon));
    });
    contest.add([&](auto) {
      const Lazy_discrete_geodesic_graph graph(triangulation, parameters::epsilon(m_epsilon));
    });
    contest.add(
        [&](const auto round) { search.run_from(triangulation.vertex(sources[round].idx())); });
    contest.add([&](const auto round) {
      lazy_search.run_from(triangulation.vertex(sources[round].idx()));
    });
    contest.run(sources.size());

    const double n = double(mesh.number_of_vertices());
    const auto cost = [&](const std::size_t i) { return contest.median_seconds(i) / n * 1e6; };
    m_table.add_row()
        .add(surface)
        .add(double(neighbors), 0)
        .add(cost(0), 2)
        .add(double(built.number_of_arcs()) / n, 1)
        .add(double(built.memory()) / n, 1)
        .add(cost(2), 2)
        .add(cost(1), 2)
        .add(cost(3), 2);
  }

  const Table& table() const { return m_table; }

private:
  double m_epsilon;
  std::size_t m_number_of_rounds;
  Table m_table;
};

static void compare(const double epsilon, const Options& options, const Report& report)
{
  Hub_benchmark benchmark(epsilon, options.number_of_rounds);
  const auto run = [&](const std::string& surface, Mesh (*make)(std::size_t)) {
    const std::size_t largest = options.is_quick ? 1000 : 100000;
    for(std::size_t size = largest / 100; size <= largest; size *= 10)
      benchmark.run(surface, size, make(size));
  };
  run("flat", flat_fan);
  run("cone", cone);
  run("saddle", saddle);
  run("square", square_fan);
  run("star", star);
  run("two hubs", two_hubs);
  report.print("hubs",
               "One vertex with many neighbors, epsilon = " + Table::text_of(epsilon, 2) +
                   " (times as medians of " + std::to_string(options.number_of_rounds) + ")",
               benchmark.table());
}

int main(int argc, char* argv[])
{
  double epsilon = 0.1;
  More_options more;
  more.add_options()("epsilon,e", boost::program_options::value(&epsilon), "the bound");
  const auto measure = [&](const Options& options, const Report& report) {
    compare(epsilon, options, report);
  };
  return run_benchmark(argc, argv, "bench_hubs", {{}, 3, ""}, measure, more);
}
