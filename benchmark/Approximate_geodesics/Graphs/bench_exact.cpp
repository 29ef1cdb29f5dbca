// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What exact distances cost: the saddle vertex graph beside CGAL's exact class and beside graphs
// with a bound, and how its time grows with the mesh. See --help.

#include "measuring/Sight_counting_graph.h"
#include "measuring/child_process.h"
#include "measuring/measure.h"
#include "measuring/resident_memory.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "meshes/Wavy_torus.h"
#include "meshes/lattices.h"
#include "meshes/surfaces.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"
#include "peers/Exact_class_comparison.h"
#include "peers/Exact_search.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

static constexpr double COARSE = 0.1, FINE = 0.01; // the bounds of the lazy graphs compared with

// CGAL's exact class is asked for meshes of up to so many vertices; on larger ones, it takes
// gigabytes and minutes.
static constexpr std::size_t LARGEST_FOR_CLASS = 60000;

static constexpr Limits LIMITS{600, (std::numeric_limits<std::size_t>::max)()};

static constexpr bool HAS_THREADS =
    std::is_same_v<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>;

using Map = Mesh::Property_map<Vertex, double>;

// ----- one source on a scan

// One source with everything included that it takes, by one call of the free function.
class First_sources
{
public:
  First_sources(Mesh& mesh, const std::vector<Vertex>& sources)
    : m_distances(mesh.add_property_map<Vertex, double>("v:distance").first),
      m_has_class(mesh.number_of_vertices() <= LARGEST_FOR_CLASS)
  {
    for(const double epsilon : {0., COARSE, FINE})
      m_contest.add([&, epsilon](const auto round) {
        CGAL::approximate_geodesic_distances(mesh, m_distances, sources[round],
                                             parameters::epsilon(epsilon));
      });
    if(m_has_class)
      m_contest.add([&](const auto round) {
        Exact_search search(mesh);
        search.run(sources[round]);
        for(const Vertex v : mesh.vertices())
          m_distances[v] = search.distance(v);
      });
    m_contest.run(sources.size());
  }

  static Table empty_table()
  {
    return Table({"mesh", "vertices", "exact ms", "exact class ms", "class : exact", "lazy 0.1 ms",
                  "lazy 0.1 : exact", "lazy 0.01 ms", "lazy 0.01 : exact"});
  }

  void add_to(Table& table, const std::string& name, const Mesh& mesh) const
  {
    table.add_row()
        .add(name)
        .add(double(mesh.number_of_vertices()), 0)
        .add(m_contest.median_seconds(0) * 1e3, 1)
        .add_if(m_has_class, m_has_class ? m_contest.median_seconds(3) * 1e3 : 0, 0)
        .add_if(m_has_class, m_has_class ? m_contest.ratio(3, 0) : 0, 1)
        .add(m_contest.median_seconds(1) * 1e3, 1)
        .add(m_contest.ratio(1, 0), 2)
        .add(m_contest.median_seconds(2) * 1e3, 1)
        .add(m_contest.ratio(2, 0), 2);
  }

private:
  Map m_distances;
  bool m_has_class;
  Contest m_contest;
};

// What the time for a first source consists of, and what a further one takes.
class Parts
{
  using Graph = AG::Saddle_vertex_graph;

public:
  Parts(const Mesh& mesh, const std::vector<Vertex>& sources)
  {
    const auto run = [&](const std::size_t i) {
      m_search->run_from(m_graph->triangulation().vertex(sources[i % sources.size()].idx()));
    };
    m_contest.add([&](auto) { m_triangulation.emplace(mesh); });
    m_contest.add([&](auto) { m_graph.emplace(std::move(*m_triangulation)); });
    m_contest.add([&](const auto round) {
      m_search.emplace(*m_graph);
      run(round);
    });
    m_contest.add([&](const auto round) { run(round + 1); });
    m_contest.add([&](auto) { measure_and_release(double(mesh.number_of_vertices())); });
    m_contest.run(sources.size());
  }

  static Table empty_table()
  {
    return Table({"mesh", "triangulation ms", "graph ms", "first search ms", "further search ms",
                  "graph bytes/vertex", "workspace bytes/vertex", "bytes/vertex"});
  }

  void add_to(Table& table, const std::string& name) const
  {
    Table::Row row = table.add_row();
    row.add(name);
    for(std::size_t part = 0; part < 4; ++part)
      row.add(m_contest.median_seconds(part) * 1e3, 1);
    row.add(m_graph_bytes, 1).add(m_workspace_bytes, 1).add(m_graph_bytes + m_workspace_bytes, 1);
  }

private:
  void measure_and_release(const double number_of_vertices)
  {
    m_graph_bytes = double(m_graph->memory()) / number_of_vertices;
    m_workspace_bytes = double(m_search->memory()) / number_of_vertices;
    m_search.reset();
    m_graph.reset();
    m_triangulation.reset();
  }

  std::optional<AG::Intrinsic_triangulation> m_triangulation;
  std::optional<Graph> m_graph;
  std::optional<AG::Propagation<Graph>> m_search;
  double m_graph_bytes = 0, m_workspace_bytes = 0; // per vertex
  Contest m_contest;
};

// What threads do for a first source, with everything included, and for a further one.
class Threads
{
  using Graph = AG::Saddle_vertex_graph;

public:
  Threads(Mesh& mesh, const std::vector<Vertex>& sources)
  {
    add<CGAL::Sequential_tag>(mesh, sources);
    add<CGAL::Parallel_if_available_tag>(mesh, sources);
    m_contest.run(sources.size());
  }

  static Table empty_table()
  {
    return Table({"mesh", "one thread ms", "all threads ms", "one : all", "further, one thread ms",
                  "further, all threads ms", "further, one : all"});
  }

  void add_to(Table& table, const std::string& name) const
  {
    Table::Row row = table.add_row();
    row.add(name);
    for(const std::size_t first : {FIRST_SOURCE, FURTHER_SOURCE})
      row.add(m_contest.median_seconds(first) * 1e3, 1)
          .add(m_contest.median_seconds(first + 2) * 1e3, 1)
          .add(m_contest.ratio(first, first + 2), 2);
  }

private:
  static constexpr std::size_t FIRST_SOURCE = 0, FURTHER_SOURCE = 1; // numbers of contestants

  template <typename Tag>
  void add(Mesh& mesh, const std::vector<Vertex>& sources)
  {
    const Map distances = mesh.add_property_map<Vertex, double>("v:distance").first;
    m_contest.add([&mesh, &sources, distances](const auto round) {
      CGAL::approximate_geodesic_distances(mesh, distances, sources[round],
                                           parameters::epsilon(0).concurrency_tag(Tag()));
    });
    const auto graph = std::make_shared<Graph>(AG::Intrinsic_triangulation(mesh),
                                               parameters::concurrency_tag(Tag()));
    const auto search = std::make_shared<AG::Propagation<Graph>>(*graph);
    m_contest.add([&sources, graph, search](const auto round) {
      search->run_from(graph->triangulation().vertex(sources[round].idx()));
    });
  }

  Contest m_contest;
};

// The memory at its largest, in bytes per vertex, beside the mesh.
template <typename F>
double peak_bytes(const Mesh& mesh, F f)
{
  return peak_memory_of(LIMITS.seconds, f) / double(mesh.number_of_vertices());
}

// The memory that one source takes in the free function and in CGAL's exact class, and how their
// distances differ.
class Class_benchmark
{
public:
  static Table empty_table()
  {
    return Table({"mesh", "peak bytes/vertex", "class peak bytes/vertex", "class : exact",
                  "distances", "largest difference", "differ", "class wrong", "ours wrong"});
  }

  Class_benchmark(Mesh& mesh, const std::vector<Vertex>& sources) : m_mesh(mesh), m_sources(sources)
  {
    const Map distances = mesh.add_property_map<Vertex, double>("v:distance").first;
    m_our_bytes = peak_bytes(mesh, [&] {
      CGAL::approximate_geodesic_distances(mesh, distances, sources[0], parameters::epsilon(0));
    });
  }

  void add_to(Table& table, const std::string& name) const
  {
    Table::Row row = table.add_row();
    row.add(name).add(m_our_bytes, 0);
    if(m_mesh.number_of_vertices() > LARGEST_FOR_CLASS)
    {
      row.add("-").add("-").add("-").add("-").add("-").add("-").add("-");
      return;
    }
    const double class_bytes = peak_bytes(m_mesh, [&] { Exact_search(m_mesh).run(m_sources[0]); });
    const Exact_case ours(name, m_mesh, m_sources);
    const Exact_class_comparison comparison(ours, LIMITS);
    row.add(class_bytes, 0)
        .add(class_bytes / m_our_bytes, 1)
        .add(double(comparison.number_of_distances()), 0)
        .add(Table::scientific(comparison.largest().relative))
        .add(double(comparison.number_of_differences()), 0)
        .add(double(comparison.number_of_theirs_too_long()), 0)
        .add(double(comparison.number_of_ours_too_long()), 0);
  }

private:
  const Mesh& m_mesh;
  const std::vector<Vertex>& m_sources;
  double m_our_bytes;
};

static void compare_on_scans(const Options& options, const Report& report)
{
  Table first_sources = First_sources::empty_table(), parts = Parts::empty_table(),
        threads = Threads::empty_table(), memory = Class_benchmark::empty_table();
  bool is_large = false;
  for(const std::string& name : options.meshes)
  {
    Mesh mesh = read_mesh(name);
    const std::vector<Vertex> sources = random_sources(mesh, options.number_of_rounds);
    is_large = is_large || mesh.number_of_vertices() > LARGEST_FOR_CLASS;
    Class_benchmark(mesh, sources).add_to(memory, short_name(name));
    First_sources(mesh, sources).add_to(first_sources, short_name(name), mesh);
    Parts(mesh, sources).add_to(parts, short_name(name));
    if(HAS_THREADS)
      Threads(mesh, sources).add_to(threads, short_name(name));
  }
  const std::string rounds = std::to_string(options.number_of_rounds) + " sources";
  report.print("exact",
               "One source with everything included: exact distances, CGAL's exact class, and the "
               "lazy graph (medians of " +
                   rounds + ")",
               first_sources);
  report.print("exact_parts", "The parts of it, and a further source (medians)", parts);
  if(HAS_THREADS)
    report.print("exact_threads",
                 "One source with everything included, and a further one, with " +
                     std::to_string(std::thread::hardware_concurrency()) + " threads (medians)",
                 threads);
  report.print("exact_memory",
               "Memory at its largest for one source, and how distances from " + rounds +
                   " differ from those of the exact class",
               memory);
  if(is_large)
    std::cout << "-: the exact class is not asked on meshes of more than " << LARGEST_FOR_CLASS
              << " vertices, where it takes gigabytes and minutes.\n\n";
}

// ----- growth

class Growth_benchmark
{
public:
  Growth_benchmark()
    : m_table({"surface", "vertices", "us/vertex", "sights/vertex", "ns/sight", "exact : edges",
               "exact : lazy 0.1", "at once : exact"})
  {
  }

  void run(const std::string& surface, const Mesh& mesh)
  {
    std::cerr << surface << ", " << mesh.number_of_vertices() << " vertices ...\n";
    const AG::Intrinsic_triangulation triangulation(mesh);
    const bool is_large = mesh.number_of_vertices() > 200000; // and one source takes long enough
    const auto sources = random_sources(mesh, 3);
    const std::size_t number_of_rounds = is_large ? 1 : sources.size();
    Contest contest, others;
    const auto add = [&](const auto& graph, Contest& to) {
      const auto search = std::make_shared<AG::Propagation<std::decay_t<decltype(graph)>>>(graph);
      to.add([&triangulation, &sources, search](const auto round) {
        search->run_from(triangulation.vertex(sources[round].idx()));
      });
      return search;
    };
    const AG::Saddle_vertex_graph exact(triangulation);
    const AG::Edge_graph edges(triangulation);
    const AG::Lazy_discrete_geodesic_graph lazy(triangulation, parameters::epsilon(COARSE));
    const auto exact_search = add(exact, contest);
    const auto search_at_once = std::make_shared<AG::Propagation<AG::Saddle_vertex_graph>>(exact);
    if(!is_large) // with a heuristic, no sight waits, and bounds are those along edges
      contest.add([&triangulation, &sources, search_at_once](const auto round) {
        search_at_once->run_toward({{triangulation.vertex(sources[round].idx())}}, {},
                                   [](auto) { return 0.; });
      });
    add(edges, others);
    add(lazy, others);
    contest.run(number_of_rounds);
    others.run(sources.size());

    const double vertices = double(mesh.number_of_vertices()), seconds = contest.mean_seconds(0);
    const double sights = mean_number_of_sights(
        *exact_search, {sources.begin(), sources.begin() + std::ptrdiff_t(number_of_rounds)});
    m_table.add_row()
        .add(surface)
        .add(vertices, 0)
        .add(seconds / vertices * 1e6, 2)
        .add(sights / vertices, 1)
        .add(seconds / sights * 1e9, 1)
        .add(seconds / others.mean_seconds(0), 1)
        .add(seconds / others.mean_seconds(1), 2)
        .add_if(!is_large, is_large ? 0 : contest.mean_seconds(1) / seconds, 2);
  }

  const Table& table() const { return m_table; }

private:
  using Index = AG::Intrinsic_triangulation::Index;

  // Runs again from the same sources, and must come to the same end.
  static double mean_number_of_sights(const AG::Propagation<AG::Saddle_vertex_graph>& expected,
                                      const std::vector<Vertex>& sources)
  {
    const AG::Intrinsic_triangulation& triangulation = expected.graph().triangulation();
    const Sight_counting_graph graph(triangulation);
    Sight_counting_graph::reset();
    AG::Propagation<Sight_counting_graph> search(graph);
    for(const Vertex source : sources)
      search.run_from(triangulation.vertex(source.idx()));
    for(Index node = 0; node < triangulation.number_of_vertices(); ++node)
    {
      // fused multiply-add may round lengths differently in the two searches
      const double difference = search.distance(node) - expected.distance(node);
      if(!(std::abs(difference) <= 1e-12 * expected.distance(node)))
        throw std::runtime_error("the search that counts sights finds other distances");
    }
    return double(graph.number_of_sights()) / double(sources.size());
  }

  Table m_table;
};

static void measure_growth(const Options& options, const Report& report)
{
  Growth_benchmark benchmark;
  using Numbers = std::vector<std::size_t>;
  const Numbers sides = options.is_quick ? Numbers{20, 50} : Numbers{100, 178, 317, 563, 1000};
  const Numbers steps = options.is_quick ? Numbers{0} : Numbers{1, 2, 3, 4};
  for(const std::size_t side : sides)
    benchmark.run("smooth", wavy_torus(side));
  for(const std::size_t side : sides)
    benchmark.run("terrain", terrain(side));
  for(const std::size_t side : sides)
    benchmark.run("rough", rough_terrain(side));
  for(const std::size_t side : options.is_quick ? sides : Numbers{100, 200, 400})
  {
    benchmark.run("wavy", wavy_lattice(side));
    benchmark.run("noisy", noisy_sphere(side));
    benchmark.run("heights", height_field(side));
  }
  for(const std::size_t step : steps)
    benchmark.run("subdivided", read_mesh("elephant+" + std::to_string(step)));
  report.print(
      "exact_growth",
      "Exact distances on a smooth torus, on terrain with irregular faces, on the same with "
      "rough ground, on a lattice with waves, on a sphere with the noise of a scanner, on heights "
      "in whole meters, and on a scan after steps of Loop subdivision: one source, with "
      "everything prepared, beside a search that follows all sights at once",
      benchmark.table());
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    compare_on_scans(options, report);
    measure_growth(options, report);
  };
  return run_benchmark(argc, argv, "bench_exact", {usual_meshes(), 5, ""}, measure);
}
