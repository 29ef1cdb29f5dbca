// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What accuracy costs: errors, times and memory of the discrete geodesic graphs for several
// epsilons, beside those of the edge graph, of the one of exact distances, and of CGAL's heat
// method and exact class. Errors are those against the package's exact distances. See --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "measuring/resident_memory.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"
#include "peers/Exact_search.h"
#include "peers/searches_of_arrays.h"

#ifdef CGAL_EIGEN3_ENABLED
#include "peers/Heat_search.h"
#endif

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

static constexpr std::array<double, 6> EPSILONS = {0.5, 0.2, 0.1, 0.05, 0.02, 0.01};
static constexpr std::size_t SHOWN = 2;      // the position of the default
static constexpr std::size_t FEW_ROUNDS = 3; // of what takes seconds

// CGAL's exact class is asked for meshes of up to so many vertices; others take it minutes.
static constexpr std::size_t LARGEST_FOR_CLASS = 60000;

static constexpr bool HAS_THREADS =
    std::is_same_v<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>;

#ifdef CGAL_EIGEN3_ENABLED
static constexpr bool HAS_HEAT = true;
#else
static constexpr bool HAS_HEAT = false;
#endif

static std::string text_of(const double epsilon) { return Table::text_of(epsilon, 2); }

// The two contests of what is done once per mesh.
class Preparation_benchmark
{
public:
  Preparation_benchmark(Mesh& mesh, const std::vector<Vertex>& sources)
    : m_mesh(mesh),
      m_triangulation(mesh),
      m_distances(mesh.add_property_map<Vertex, double>("v:ours").first)
  {
    measure_builds((std::min)(FEW_ROUNDS, sources.size()));
    measure_first_answers(sources, (std::min)(FEW_ROUNDS, sources.size()));
  }

  double build_seconds(const std::size_t i) const { return m_builds.median_seconds(2 * i); }

  double parallel_build_seconds(const std::size_t i) const
  {
    return m_builds.median_seconds(2 * i + 1);
  }

  double lazy_seconds() const { return m_first_answers.median_seconds(0); }
  double exact_seconds() const { return m_first_answers.median_seconds(1); }
  double priority_queue_seconds() const { return m_first_answers.median_seconds(2); }
  double heat_seconds() const { return HAS_HEAT ? m_first_answers.median_seconds(3) : 0; }

private:
  // The triangulation is copied, which takes no time to speak of.
  template <typename Tag>
  void build(const double epsilon) const
  {
    const AG::Discrete_geodesic_graph graph(
        m_triangulation, CGAL::parameters::epsilon(epsilon).concurrency_tag(Tag()));
  }

  void measure_builds(const std::size_t number_of_rounds)
  {
    for(const double epsilon : EPSILONS)
    {
      m_builds.add([=](auto) { build<CGAL::Sequential_tag>(epsilon); });
      m_builds.add([=](auto) { build<CGAL::Parallel_if_available_tag>(epsilon); });
    }
    m_builds.run(number_of_rounds);
  }

  // The distances from one source, with everything included that they take; and those along edges,
  // with everything prepared.
  void measure_first_answers(const std::vector<Vertex>& sources, const std::size_t number_of_rounds)
  {
    for(const double epsilon : {EPSILONS[SHOWN], 0.})
      m_first_answers.add([&, epsilon](const auto round) {
        CGAL::approximate_geodesic_distances(m_mesh, m_distances, sources[round],
                                             CGAL::parameters::epsilon(epsilon));
      });
    Priority_queue_dijkstra along_edges(m_triangulation);
    m_first_answers.add([&](const auto round) {
      along_edges.run_from(m_triangulation.vertex(sources[round].idx()));
    });
#ifdef CGAL_EIGEN3_ENABLED
    m_first_answers.add([&](const auto round) { Heat_search(m_mesh).run(sources[round]); });
#endif
    m_first_answers.run(number_of_rounds);
  }

  Mesh& m_mesh;
  AG::Intrinsic_triangulation m_triangulation;
  Mesh::Property_map<Vertex, double> m_distances;
  Contest m_builds;
  Contest m_first_answers;
};

// What finds distances, once everything is prepared that sources share.
struct Method
{
  std::string name;
  std::string epsilon;
  std::function<void(Vertex)> run;
  std::function<double(Vertex)> distance; // in the last run
  Errors errors = {};
};

// The contest of what is done once per source.
class Source_benchmark
{
public:
  Source_benchmark(Mesh& mesh, const std::vector<Vertex>& sources)
    : m_mesh(mesh),
      m_sources(sources),
      m_triangulation(mesh),
      m_priority_queue(m_triangulation),
      m_has_class(mesh.number_of_vertices() <= LARGEST_FOR_CLASS)
  {
    add_methods();
    for(const Method& method : m_methods)
      m_contest.add([&](const auto round) { method.run(m_sources[round]); });
    m_contest.add([&](const auto round) { m_priority_queue.run_from(node(m_sources[round])); });
    if(m_has_class)
      m_contest.add([&](const auto round) { ask_class(m_sources[round]); });
    m_contest.run(m_sources.size(), 5);
    find_errors();
  }

  const Method& method(const std::string& name, const std::string& epsilon = "-") const
  {
    return m_methods[position(name, epsilon)];
  }

  double seconds(const std::string& name, const std::string& epsilon = "-") const
  {
    return m_contest.median_seconds(position(name, epsilon));
  }

  const std::vector<Method>& methods() const { return m_methods; }
  double priority_queue_seconds() const { return m_contest.median_seconds(m_methods.size()); }
  bool has_class() const { return m_has_class; }

  double class_seconds() const
  {
    return m_has_class ? m_contest.median_seconds(m_methods.size() + 1) : 0;
  }

  // of the built graphs
  double arcs_per_vertex(const std::size_t i) const
  {
    return double(m_built[i]->number_of_arcs()) / double(m_built[i]->number_of_nodes());
  }

  double bytes_per_vertex(const std::size_t i) const
  {
    const std::size_t bytes = m_built[i]->memory() - m_built[i]->triangulation().memory();
    return double(bytes) / double(m_built[i]->number_of_nodes());
  }

  // the most memory that building takes, by what the graph takes with its triangulation
  double peak_memory_ratio(const std::size_t i) const
  {
    constexpr unsigned seconds = 600;
    return peak_memory_of(seconds,
                          [&] {
                            const AG::Discrete_geodesic_graph graph(
                                m_triangulation, CGAL::parameters::epsilon(EPSILONS[i]));
                          }) /
           double(m_built[i]->memory());
  }

private:
  Index node(const Vertex v) const { return m_triangulation.vertex(v.idx()); }

  std::size_t position(const std::string& name, const std::string& epsilon) const
  {
    const auto found = std::find_if(m_methods.begin(), m_methods.end(), [&](const Method& m) {
      return m.name == name && m.epsilon == epsilon;
    });
    return std::size_t(found - m_methods.begin());
  }

  void add_methods()
  {
    add_graph("edges", "-", std::make_shared<AG::Edge_graph>(m_triangulation));
    for(const double epsilon : EPSILONS)
    {
      const auto np = CGAL::parameters::epsilon(epsilon);
      m_built.push_back(std::make_shared<AG::Discrete_geodesic_graph>(m_triangulation, np));
      add_graph("built", text_of(epsilon), m_built.back());
    }
    for(const double epsilon : EPSILONS)
      add_graph("lazy", text_of(epsilon),
                std::make_shared<AG::Lazy_discrete_geodesic_graph>(
                    m_triangulation, CGAL::parameters::epsilon(epsilon)));
    add_graph("exact graph", "-", std::make_shared<AG::Saddle_vertex_graph>(m_triangulation));
#ifdef CGAL_EIGEN3_ENABLED
    const auto heat = std::make_shared<Heat_search>(m_mesh);
    m_methods.push_back({"heat", "-", [heat](const Vertex source) { heat->run(source); },
                         [heat](const Vertex v) { return heat->distance(v); }});
#endif
  }

  template <typename Graph>
  void
  add_graph(const std::string& name, const std::string& epsilon, const std::shared_ptr<Graph> graph)
  {
    const auto search = std::make_shared<AG::Propagation<Graph>>(*graph);
    m_methods.push_back(
        {name, epsilon,
         [this, graph, search](const Vertex source) { search->run_from(node(source)); },
         [this, search](const Vertex v) { return search->distance(node(v)); }});
  }

  void ask_class(const Vertex source) const
  {
    Exact_search search(m_mesh);
    search.run(source);
    for(const Vertex v : m_mesh.vertices())
      search.distance(v);
  }

  void find_errors()
  {
    const Exact_case expected("", m_mesh, m_sources);
    for(Method& method : m_methods)
      for(std::size_t i = 0; i < m_sources.size(); ++i)
      {
        method.run(m_sources[i]);
        for(const Vertex v : m_mesh.vertices())
          method.errors.add(method.distance(v), expected.distance(i, v));
      }
  }

  Mesh& m_mesh;
  const std::vector<Vertex>& m_sources;
  AG::Intrinsic_triangulation m_triangulation;
  Priority_queue_dijkstra m_priority_queue;
  bool m_has_class;
  std::vector<std::shared_ptr<AG::Discrete_geodesic_graph>> m_built; // one per epsilon
  std::vector<Method> m_methods;
  Contest m_contest;
};

// All figures of a mesh, as rows of tables.
class Accuracy_benchmark
{
public:
  struct Tables
  {
    Table epsilon = Table({"mesh", "epsilon", "mean %", "largest %", "arcs/vertex", "bytes/vertex",
                           "peak : graph", "build us/vertex", "build : parallel", "search ms",
                           "lazy search ms"});
    Table targets = Table({"mesh", "vertices", "search ms", "std::priority_queue ms",
                           "search : std::priority_queue", "build us/vertex",
                           "parallel build us/vertex", "build : parallel"});
    Table first_answers = Table(
        {"mesh", "lazy ms", "lazy : std::priority_queue", "heat ms", "lazy : heat", "lazy mean %",
         "heat mean %", "heat error : lazy error", "exact class ms", "exact class : lazy",
         "exact graph ms", "exact graph : lazy", "exact class : exact graph"});
    Table accuracy = Table({"mesh", "method", "epsilon", "ms", "mean %", "largest %"});
  };

  Accuracy_benchmark(const std::string& name, const std::size_t number_of_rounds)
    : m_name(short_name(name)),
      m_mesh(read_mesh(name)),
      m_sources(random_sources(m_mesh, number_of_rounds)),
      m_preparation(m_mesh, m_sources),
      m_source(m_mesh, m_sources)
  {
  }

  void add_to(Tables& tables) const
  {
    for(std::size_t i = 0; i < EPSILONS.size(); ++i)
      add_epsilon(tables.epsilon, i);
    add_targets(tables.targets);
    add_first_answer(tables.first_answers);
    add_methods(tables.accuracy);
  }

private:
  // of the time
  double per_vertex(const double seconds) const
  {
    return seconds * 1e6 / double(m_mesh.number_of_vertices());
  }

  double build_ratio(const std::size_t i) const
  {
    return m_preparation.build_seconds(i) / m_preparation.parallel_build_seconds(i);
  }

  void add_epsilon(Table& table, const std::size_t i) const
  {
    const std::string epsilon = text_of(EPSILONS[i]);
    const Errors& errors = m_source.method("built", epsilon).errors;
    table.add_row()
        .add(m_name)
        .add(epsilon)
        .add(errors.mean() * 100, 4)
        .add(errors.largest() * 100, 2)
        .add(m_source.arcs_per_vertex(i), 1)
        .add(m_source.bytes_per_vertex(i), 1)
        .add(m_source.peak_memory_ratio(i), 2)
        .add(per_vertex(m_preparation.build_seconds(i)), 2)
        .add_if(HAS_THREADS, build_ratio(i), 2)
        .add(m_source.seconds("built", epsilon) * 1e3, 3)
        .add(m_source.seconds("lazy", epsilon) * 1e3, 3);
  }

  void add_targets(Table& table) const
  {
    const double ours = m_source.seconds("built", text_of(EPSILONS[SHOWN]));
    const double theirs = m_source.priority_queue_seconds();
    table.add_row()
        .add(m_name)
        .add(double(m_mesh.number_of_vertices()), 0)
        .add(ours * 1e3, 3)
        .add(theirs * 1e3, 3)
        .add(ours / theirs, 2)
        .add(per_vertex(m_preparation.build_seconds(SHOWN)), 2)
        .add_if(HAS_THREADS, per_vertex(m_preparation.parallel_build_seconds(SHOWN)), 2)
        .add_if(HAS_THREADS, build_ratio(SHOWN), 2);
  }

  void add_first_answer(Table& table) const
  {
    const double ours = m_preparation.lazy_seconds();
    const double heat = m_preparation.heat_seconds();
    const double our_error = m_source.method("lazy", text_of(EPSILONS[SHOWN])).errors.mean();
    const double error_of_heat = HAS_HEAT ? m_source.method("heat").errors.mean() : 0;
    const double exact = m_preparation.exact_seconds();
    const bool has_class = m_source.has_class();
    table.add_row()
        .add(m_name)
        .add(ours * 1e3, 1)
        .add(ours / m_preparation.priority_queue_seconds(), 2)
        .add_if(HAS_HEAT, heat * 1e3, 1)
        .add_if(HAS_HEAT, ours / heat, 3)
        .add(our_error * 100, 4)
        .add_if(HAS_HEAT, error_of_heat * 100, 4)
        .add_if(HAS_HEAT, error_of_heat / our_error, 1)
        .add_if(has_class, m_source.class_seconds() * 1e3, 0)
        .add_if(has_class, m_source.class_seconds() / ours, 1)
        .add(exact * 1e3, 1)
        .add(exact / ours, 2)
        .add_if(has_class, m_source.class_seconds() / exact, 1);
  }

  void add_methods(Table& table) const
  {
    for(const Method& method : m_source.methods())
      table.add_row()
          .add(m_name)
          .add(method.name)
          .add(method.epsilon)
          .add(m_source.seconds(method.name, method.epsilon) * 1e3, 3)
          .add(method.errors.mean() * 100, 4)
          .add(method.errors.largest() * 100, 2);
    if(m_source.has_class())
      table.add_row()
          .add(m_name)
          .add("exact class")
          .add("-")
          .add(m_source.class_seconds() * 1e3, 3)
          .add("-")
          .add("-");
  }

  std::string m_name;
  Mesh m_mesh;
  std::vector<Vertex> m_sources;
  Preparation_benchmark m_preparation;
  Source_benchmark m_source;
};

int main(int argc, char* argv[])
{
  const auto measure_accuracy = [](const Options& options, const Report& report) {
    Accuracy_benchmark::Tables tables;
    for(const std::string& name : options.meshes)
      Accuracy_benchmark(name, options.number_of_rounds).add_to(tables);
    const std::string medians =
        " (medians of " + std::to_string(options.number_of_rounds) + " sources)";
    const std::string epsilon = "epsilon = " + text_of(EPSILONS[SHOWN]);
    report.print("epsilon", "The discrete geodesic graph" + medians, tables.epsilon);
    report.print("targets", "The graph for " + epsilon + " and Dijkstra along edges" + medians,
                 tables.targets);
    report.print("first_answers",
                 "One source with everything included, " + epsilon +
                     ", CGAL's heat method and exact class, and the package's exact graph",
                 tables.first_answers);
    report.print("accuracy", "Time for one source, with everything prepared that sources share",
                 tables.accuracy);
  };
  return run_benchmark(argc, argv, "bench_accuracy", {usual_meshes(), 11, ""}, measure_accuracy);
}
