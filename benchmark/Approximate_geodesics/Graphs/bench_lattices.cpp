// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What discrete geodesic graphs cost a vertex of regular meshes, from small ones to large ones:
// rows of vertices in one line are where cones could run on and on. See --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/lattices.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <cstddef>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using AG::Intrinsic_triangulation;

static constexpr std::size_t LARGEST_WITH_ERRORS = 200000; // vertices

// Does what usual expansions do, and counts the windows that they look through.
struct Window_counter : AG::internal::Leave_out_detours
{
  bool prune(const AG::internal::Window&) const
  {
    ++windows;
    return false;
  }
  std::size_t& windows;
};

class Lattice_benchmark
{
public:
  Lattice_benchmark(const double epsilon, const std::size_t number_of_rounds)
    : m_epsilon(epsilon),
      m_number_of_rounds(number_of_rounds),
      m_table({"surface", "vertices", "build us/vertex", "windows/vertex", "arcs/vertex",
               "bytes/vertex", "mean %", "largest %", "lazy us/vertex", "lazy arcs/vertex",
               "lazy mean %", "lazy largest %"})
  {
  }

  void run(const std::string& surface, const Mesh& mesh)
  {
    std::cerr << surface << ", " << mesh.number_of_vertices() << " vertices ...\n";
    const double n = double(mesh.number_of_vertices());
    const Intrinsic_triangulation triangulation(mesh);
    const std::vector<Vertex> sources = random_sources(mesh, m_number_of_rounds);
    const AG::Lazy_discrete_geodesic_graph lazy(triangulation, parameters::epsilon(m_epsilon));
    AG::Propagation<AG::Lazy_discrete_geodesic_graph> lazy_search(lazy);
    std::optional<AG::Discrete_geodesic_graph> built;
    Contest contest;
    contest.add([&](auto) { built.emplace(triangulation, parameters::epsilon(m_epsilon)); });
    contest.add([&](const auto round) {
      lazy_search.run_from(triangulation.vertex(sources[round].idx()));
    });
    contest.run(sources.size());

    AG::Propagation<AG::Discrete_geodesic_graph> search(*built);
    Table::Row row = m_table.add_row();
    row.add(surface)
        .add(n, 0)
        .add(contest.median_seconds(0) / n * 1e6, 2)
        .add(mean_number_of_windows(triangulation), 1)
        .add(double(built->number_of_arcs()) / n, 1)
        .add(double(built->memory()) / n, 1);
    std::optional<Exact_case> expected;
    if(mesh.number_of_vertices() <= LARGEST_WITH_ERRORS)
      expected.emplace(surface, mesh, sources);
    add_errors(row, search, expected);
    row.add(contest.median_seconds(1) / n * 1e6, 2)
        .add(mean_number_of_arcs(lazy_search, sources) / n, 1);
    add_errors(row, lazy_search, expected);
  }

  const Table& table() const { return m_table; }

private:
  // of vertices chosen at random
  double mean_number_of_windows(const Intrinsic_triangulation& triangulation) const
  {
    constexpr std::size_t count = 10000;
    const AG::internal::Unfolding unfolding(triangulation);
    const AG::internal::Cone_expansion<AG::internal::Unfolding> expansion(
        triangulation, unfolding, AG::internal::Cone_rules(m_epsilon));
    std::mt19937_64 random(1);
    std::size_t windows = 0;
    for(std::size_t i = 0; i < count; ++i)
      expansion.expand(
          Intrinsic_triangulation::Index(random() % triangulation.number_of_vertices()),
          [](const AG::internal::Straight_arc&) {}, Window_counter{{}, windows});
    return double(windows) / count;
  }

  // that searches look at
  template <typename Search>
  static double mean_number_of_arcs(Search& search, const std::vector<Vertex>& sources)
  {
    std::size_t arcs = 0;
    search.collect_statistics(true);
    for(const Vertex source : sources)
    {
      search.run_from(search.graph().triangulation().vertex(source.idx()));
      arcs += search.statistics().relaxations;
    }
    search.collect_statistics(false);
    return double(arcs) / double(sources.size());
  }

  template <typename Search>
  static void add_errors(Table::Row& row, Search& search, const std::optional<Exact_case>& expected)
  {
    Errors errors;
    if(expected)
    {
      const Intrinsic_triangulation& triangulation = search.graph().triangulation();
      for(std::size_t i = 0; i < expected->sources().size(); ++i)
      {
        search.run_from(triangulation.vertex(expected->sources()[i].idx()));
        for(const Vertex v : expected->mesh().vertices())
          errors.add(search.distance(triangulation.vertex(v.idx())), expected->distance(i, v));
      }
    }
    row.add_if(expected.has_value(), 100 * errors.mean(), 4)
        .add_if(expected.has_value(), 100 * errors.largest(), 2);
  }

  double m_epsilon;
  std::size_t m_number_of_rounds;
  Table m_table;
};

static void compare(const double epsilon, const Options& options, const Report& report)
{
  using Numbers = std::vector<std::size_t>;
  Lattice_benchmark benchmark(epsilon, options.number_of_rounds);
  const auto run = [&](const std::string& surface, Mesh (*make)(std::size_t)) {
    for(const std::size_t side : options.is_quick ? Numbers{20, 40} : Numbers{100, 200, 400, 1000})
      benchmark.run(surface, make(side));
  };
  run("flat", flat_lattice);
  run("wavy", wavy_lattice);
  run("heights", height_field);
  run("cylinder", cylinder);
  run("sphere", subdivided_sphere);
  run("globe", globe);
  for(const std::string& name : options.meshes)
    for(const std::size_t step : options.is_quick ? Numbers{0, 1} : Numbers{0, 1, 2, 3, 4})
    {
      const std::string subdivided = name + "+" + std::to_string(step);
      benchmark.run(subdivided, read_mesh(subdivided));
    }
  report.print("lattices",
               "Regular meshes, epsilon = " + Table::text_of(epsilon, 2) +
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
  return run_benchmark(argc, argv, "bench_lattices", {{"elephant"}, 3, ""}, measure, more);
}
