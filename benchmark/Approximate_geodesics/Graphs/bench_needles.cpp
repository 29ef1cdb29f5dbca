// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What discrete geodesic graphs cost a vertex, and a path, on meshes whose faces are far longer
// than wide, beside an ordinary mesh with as many vertices and exact distances. See --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/needles.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <cstddef>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using AG::Intrinsic_triangulation;

class Needle_benchmark
{
public:
  Needle_benchmark(const double epsilon, const std::size_t number_of_rounds)
    : m_epsilon(epsilon),
      m_number_of_rounds(number_of_rounds),
      m_table({"surface", "vertices", "exact us/vertex", "prepare lazy us/vertex",
               "lazy search us/vertex", "mean %", "largest %", "ms/path", "build us/vertex",
               "arcs/vertex", "bytes/vertex", "search us/vertex", "mean %", "largest %", "ms/path"})
  {
  }

  void run(const std::string& surface, const Mesh& mesh)
  {
    std::cerr << surface << " ...\n";
    m_n = double(mesh.number_of_vertices());
    const Intrinsic_triangulation t(mesh);
    const std::vector<Vertex> sources = random_sources(mesh, m_number_of_rounds);
    std::optional<AG::Lazy_discrete_geodesic_graph> lazy;
    std::optional<AG::Discrete_geodesic_graph> built;
    Contest contest;
    contest.add([&](auto) { lazy.emplace(t, parameters::epsilon(m_epsilon)); });
    contest.add([&](auto) { built.emplace(t, parameters::epsilon(m_epsilon)); });
    contest.run(sources.size());

    const AG::Saddle_vertex_graph exact(t);
    AG::Propagation<AG::Saddle_vertex_graph> exact_search(exact);
    AG::Propagation<AG::Lazy_discrete_geodesic_graph> lazy_search(*lazy);
    AG::Propagation<AG::Discrete_geodesic_graph> search(*built);
    Errors lazy_errors, errors;
    Contest searches;
    const auto source = [&](const std::size_t i) { return t.vertex(sources[i].idx()); };
    searches.add([&](const auto i) { exact_search.run_from(source(i)); });
    searches.add([&](const auto i) { lazy_search.run_from(source(i)); });
    searches.add([&](const auto i) { search.run_from(source(i)); });
    searches.add([&](auto) {
      for(Intrinsic_triangulation::Index v = 0; v < t.number_of_vertices(); ++v)
      {
        lazy_errors.add(lazy_search.distance(v), exact_search.distance(v));
        errors.add(search.distance(v), exact_search.distance(v));
      }
    });
    searches.run(sources.size());
    AG::Surface_search<AG::Lazy_discrete_geodesic_graph> lazy_paths(*lazy);
    AG::Surface_search<AG::Discrete_geodesic_graph> paths(*built);
    lazy_paths.run({{at_vertex(source(0))}});
    paths.run({{at_vertex(source(0))}});
    Contest path_contest;
    path_contest.add([&](auto) { find_paths(lazy_paths); });
    path_contest.add([&](auto) { find_paths(paths); });
    path_contest.run(sources.size());

    m_table.add_row()
        .add(surface)
        .add(m_n, 0)
        .add(cost(searches, 0), 2)
        .add(cost(contest, 0), 2)
        .add(cost(searches, 1), 2)
        .add(100 * lazy_errors.mean(), 4)
        .add(100 * lazy_errors.largest(), 2)
        .add(path_contest.median_seconds(0) / NUMBER_OF_PATHS * 1e3, 2)
        .add(cost(contest, 1), 2)
        .add(double(built->number_of_arcs()) / m_n, 1)
        .add(double(built->memory()) / m_n, 1)
        .add(cost(searches, 2), 2)
        .add(100 * errors.mean(), 4)
        .add(100 * errors.largest(), 2)
        .add(path_contest.median_seconds(1) / NUMBER_OF_PATHS * 1e3, 2);
  }

  const Table& table() const { return m_table; }

private:
  static constexpr Intrinsic_triangulation::Index NUMBER_OF_PATHS = 20;

  static AG::Intrinsic_point at_vertex(const Intrinsic_triangulation::Index v)
  {
    return AG::Intrinsic_point::at_vertex(v);
  }

  template <typename Search>
  static void find_paths(const Search& search)
  {
    const auto n = search.graph().triangulation().number_of_vertices();
    for(Intrinsic_triangulation::Index i = 0; i < NUMBER_OF_PATHS; ++i)
      if(search.find_path(at_vertex(n / NUMBER_OF_PATHS * i)).points.empty())
        throw std::logic_error("a vertex cannot be reached");
  }

  double cost(const Contest& contest, const std::size_t i) const
  {
    return contest.median_seconds(i) / m_n * 1e6;
  }

  double m_epsilon;
  std::size_t m_number_of_rounds;
  double m_n = 0;
  Table m_table;
};

static void compare(const double epsilon, const Options& options, const Report& report)
{
  Needle_benchmark benchmark(epsilon, options.number_of_rounds);
  const std::size_t part = options.is_quick ? 10 : 1;
  benchmark.run("ordinary", tube(300 / part, 300 / part, 1));
  benchmark.run("ordinary, uneven", tube(300 / part, 300 / part, 1, 0.3));
  benchmark.run("3000 x 30", tube(3000 / part, 30, 160));
  benchmark.run("3000 x 30, uneven", tube(3000 / part, 30, 160, 0.3));
  benchmark.run("30 x 3000", tube(30, 3000 / part, 1. / 630));
  benchmark.run("30 x 3000, uneven", tube(30, 3000 / part, 1. / 630, 0.3));
  benchmark.run("helix", helix(20000 / part));
  benchmark.run("prism", extruded(10000 / part, 1, 0));
  benchmark.run("gear", extruded(10000 / part, 1, 0.1));
  report.print("needles",
               "Faces that are far longer than wide, epsilon = " + Table::text_of(epsilon, 2) +
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
  return run_benchmark(argc, argv, "bench_needles", {{}, 3, ""}, measure, more);
}
