// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What points on edges cost, and what they are good for: sizes, times and errors of Steiner graphs
// without weights and with, and of selective refinement. See --help.

#include "Dense_reference.h"
#include "Errors.h"
#include "Exact_case.h"
#include "Mesh.h"
#include "Options.h"
#include "Table.h"
#include "Terrain.h"
#include "measure.h"
#include "peers.h"
#include "terrain_weights.h"

#include <CGAL/Approximate_geodesics/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Equally_spaced_points.h>
#include <CGAL/Approximate_geodesics/Geometric_points.h>
#include <CGAL/Approximate_geodesics/Propagation.h>
#include <CGAL/Approximate_geodesics/Published_geometric_points.h>
#include <CGAL/Approximate_geodesics/Steiner_graph.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/iterator.h>
#include <CGAL/refined_geodesic_path.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

// One placement on one mesh.
class Trial
{
public:
  template <typename Placement>
  Trial(std::string name,
        const double parameter,
        const AG::Intrinsic_triangulation& triangulation,
        const Placement& placement)
    : m_name(std::move(name)), m_parameter(parameter)
  {
    using Graph = AG::Steiner_graph<Placement>;
    const std::shared_ptr<const Graph> graph = build<Graph>(triangulation, placement);
    const auto search = std::make_shared<AG::Propagation<Graph>>(*graph);
    const auto node = [graph](const Vertex v) { return graph->triangulation().vertex(v.idx()); };
    m_run = [=](const Vertex source) { search->run(node(source)); };
    m_distance = [=](const Vertex v) { return search->distance(node(v)); };
    m_bytes_of_graph = graph->memory() - graph->triangulation().memory();
    m_bytes_of_workspace = [=] { return search->memory(); };
    m_number_of_vertices = triangulation.number_of_vertices();
    m_number_of_edges = triangulation.number_of_edges();
    m_number_of_points = graph->number_of_points();
    m_number_of_nodes = graph->number_of_nodes();
    m_bound = graph->epsilon();
  }

  const std::string& name() const { return m_name; }
  double parameter() const { return m_parameter; }
  const Errors& errors() const { return m_errors; }

  double points_per_edge() const { return double(m_number_of_points) / m_number_of_edges; }
  double nodes_per_vertex() const { return double(m_number_of_nodes) / m_number_of_vertices; }
  double build_seconds() const { return m_build_seconds; }

  bool has_bound() const { return std::isfinite(m_bound); }
  double bound() const { return m_bound; }

  // without the triangulation
  double bytes_per_vertex() const { return double(m_bytes_of_graph) / m_number_of_vertices; }

  // after the runs
  double bytes_per_vertex_with_workspace() const
  {
    return double(m_bytes_of_graph + m_bytes_of_workspace()) / m_number_of_vertices;
  }

  void run(const Vertex source) const { m_run(source); }

  // Expected costs come from an `Exact_case` or the like.
  template <typename Expected>
  void find_errors(const Expected& expected)
  {
    for(std::size_t i = 0; i < expected.sources().size(); ++i)
    {
      run(expected.sources()[i]);
      for(const Vertex v : expected.mesh().vertices())
        if(!(std::isinf(expected.distance(i, v)) && std::isinf(m_distance(v))))
          m_errors.add(m_distance(v), expected.distance(i, v));
    }
  }

private:
  template <typename Graph, typename Placement>
  std::shared_ptr<const Graph> build(const AG::Intrinsic_triangulation& triangulation,
                                     const Placement& placement)
  {
    constexpr std::size_t number_of_builds = 3;
    std::shared_ptr<const Graph> result;
    std::vector<double> seconds;
    while(seconds.size() < number_of_builds)
    {
      result.reset();
      AG::Intrinsic_triangulation copy = triangulation; // takes time that does not count
      seconds.push_back(
          seconds_of([&] { result = std::make_shared<const Graph>(std::move(copy), placement); }));
    }
    m_build_seconds = median(seconds);
    return result;
  }

  std::string m_name;
  double m_parameter; // of the placement
  std::function<void(Vertex)> m_run;
  std::function<double(Vertex)> m_distance; // in the last run
  std::function<std::size_t()> m_bytes_of_workspace;
  std::size_t m_bytes_of_graph = 0;
  double m_number_of_vertices = 0;
  double m_number_of_edges = 0;
  std::size_t m_number_of_points = 0;
  std::size_t m_number_of_nodes = 0;
  double m_build_seconds = 0;
  double m_bound = 0;
  Errors m_errors;
};

static const std::string SPACED = "equally spaced";
static const std::string GEOMETRIC = "geometric";

static std::vector<Trial> make_trials(const AG::Intrinsic_triangulation& triangulation,
                                      const std::vector<std::size_t>& numbers_of_points,
                                      const std::vector<double>& epsilons)
{
  std::vector<Trial> result;
  for(const std::size_t m : numbers_of_points)
    result.emplace_back(SPACED, double(m), triangulation, AG::Equally_spaced_points(m));
  for(const double epsilon : epsilons)
    result.emplace_back(GEOMETRIC, epsilon, triangulation, AG::Geometric_points(epsilon));
  return result;
}

// How long searches take, and how far off they are, on one mesh.
class Search_benchmark
{
public:
  Search_benchmark(std::string name, const AG::Intrinsic_triangulation& triangulation)
    : m_name(std::move(name)),
      m_triangulation(triangulation),
      m_priority_queue(triangulation),
      m_trials(make_trials(triangulation, {0, 1, 2, 3, 5, 8, 16}, {0.5, 0.2, 0.1, 0.05, 0.02}))
  {
  }

  void measure_times(const std::vector<Vertex>& sources)
  {
    for(const Trial& trial : m_trials)
    {
      trial.run(sources.front()); // which makes room in the workspace
      m_contest.add([&](const auto round) { trial.run(sources[round]); });
    }
    m_contest.add([&](const auto round) {
      m_priority_queue.run(m_triangulation.vertex(sources[round].idx()));
    });
    m_contest.run(sources.size(), 5);
  }

  template <typename Expected>
  void find_errors(const Expected& expected)
  {
    for(Trial& trial : m_trials)
      trial.find_errors(expected);
  }

  static Table empty_table()
  {
    return Table({"mesh", "points", "parameter", "points/edge", "nodes/vertex", "bytes/vertex",
                  "with workspace", "build s", "search ms", "search : std::priority_queue",
                  "mean %", "largest %", "least", "bound", "largest : bound"});
  }

  void add_to(Table& table) const
  {
    for(std::size_t i = 0; i < m_trials.size(); ++i)
      add_trial(table, m_trials[i], i);
  }

private:
  void add_trial(Table& table, const Trial& trial, const std::size_t contestant) const
  {
    const Errors& errors = trial.errors();
    table.add_row()
        .add(m_name)
        .add(trial.name())
        .add(trial.parameter(), trial.name() == SPACED ? 0 : 2)
        .add(trial.points_per_edge(), 2)
        .add(trial.nodes_per_vertex(), 2)
        .add(trial.bytes_per_vertex(), 1)
        .add(trial.bytes_per_vertex_with_workspace(), 1)
        .add(trial.build_seconds(), 3)
        .add(m_contest.median_seconds(contestant) * 1e3, 3)
        .add(m_contest.ratio(contestant, m_trials.size()), 2)
        .add(errors.mean() * 100, 4)
        .add(errors.largest() * 100, 3)
        .add(Table::scientific(errors.least()))
        .add_if(trial.has_bound(), trial.bound(), 3)
        .add_if(trial.has_bound(), errors.largest() / trial.bound(), 3);
  }

  std::string m_name;
  const AG::Intrinsic_triangulation& m_triangulation;
  Priority_queue_dijkstra m_priority_queue;
  std::vector<Trial> m_trials;
  Contest m_contest;
};

static constexpr std::size_t SOURCES_OF_ERRORS = 3;

// The first vertex, and random ones.
static std::vector<Vertex> first_and_random(std::vector<Vertex> sources)
{
  sources.resize((std::min)(sources.size(), SOURCES_OF_ERRORS));
  sources.front() = Vertex(0);
  return sources;
}

static Exact_case exact_case(const std::string& name)
{
  const Mesh mesh = read_mesh(name);
  return Exact_case(name, mesh, first_and_random(random_sources(mesh, SOURCES_OF_ERRORS)),
                    Limits());
}

static void add_unweighted(Table& table, const Exact_case& expected, const std::size_t rounds)
{
  const AG::Intrinsic_triangulation triangulation(expected.mesh());
  const std::vector<Vertex> sources = random_sources(expected.mesh(), rounds);
  Search_benchmark benchmark(expected.name(), triangulation);
  benchmark.measure_times(sources);
  benchmark.find_errors(expected);
  benchmark.add_to(table);
}

// A queue that counts the nodes of the graphs that it is made for.
class Node_counting_queue : public AG::Adaptive_bucket_queue
{
public:
  Node_counting_queue(const std::size_t number_of_nodes, const AG::Arc_lengths& arc_lengths)
    : AG::Adaptive_bucket_queue(number_of_nodes, arc_lengths)
  {
    s_sum += number_of_nodes;
    ++s_count;
  }

  static std::size_t count() { return s_count; }
  static std::size_t sum() { return s_sum; }

private:
  static inline std::size_t s_count = 0;
  static inline std::size_t s_sum = 0;
};

// Paths between pairs of vertices, each by one call with everything included.
class Path_benchmark
{
public:
  Path_benchmark(const Exact_case& expected, const std::size_t number_of_pairs)
    : m_expected(expected), m_targets(random_targets(number_of_pairs))
  {
    for(const double tolerance : {1e-3, 1e-5, 1e-6})
      add_refinement(tolerance);
    for(const std::size_t m : {3, 8, 16, 32})
      add_full_graph(m);
    for(Method& method : m_methods)
      m_contest.add([this, &method](const auto round) { run(method, round); });
    m_contest.run(number_of_pairs);
  }

  static Table empty_table()
  {
    return Table({"mesh", "paths", "parameter", "graphs", "nodes/vertex", "ms", "refined : this",
                  "mean %", "largest %", "least"});
  }

  void add_to(Table& table) const
  {
    const double calls = double(m_targets.size());
    const double vertices = double(m_expected.mesh().number_of_vertices());
    for(std::size_t i = 0; i < m_methods.size(); ++i)
      table.add_row()
          .add(m_expected.name())
          .add(m_methods[i].name)
          .add(m_methods[i].parameter)
          .add(double(m_methods[i].number_of_graphs) / calls, 1)
          .add(double(m_methods[i].number_of_nodes) / calls / vertices, 2)
          .add(m_contest.median_seconds(i) * 1e3, 1)
          .add(m_contest.ratio(DEFAULT, i), 3)
          .add(Table::scientific(m_methods[i].errors.mean() * 100))
          .add(Table::scientific(m_methods[i].errors.largest() * 100))
          .add(Table::scientific(m_methods[i].errors.least()));
  }

private:
  static constexpr std::size_t DEFAULT = 1; // the position of the default tolerance

  struct Method
  {
    std::string name;
    std::string parameter;
    std::function<double(Vertex, Vertex)> length;
    std::size_t number_of_graphs = 0; // of all calls together, as the next two
    std::size_t number_of_nodes = 0;
    Errors errors = {};
  };

  void add_refinement(const double tolerance)
  {
    m_methods.push_back({"refined", Table::scientific(tolerance),
                         [this, tolerance](const Vertex source, const Vertex target) {
                           return CGAL::refined_geodesic_path<Node_counting_queue>(
                               m_expected.mesh(), source, target, CGAL::Emptyset_iterator(),
                               CGAL::parameters::relative_tolerance(tolerance));
                         }});
  }

  void add_full_graph(const std::size_t m)
  {
    m_methods.push_back(
        {SPACED, std::to_string(m), [this, m](const Vertex source, const Vertex target) {
           return CGAL::approximate_geodesic_path<Node_counting_queue>(
               m_expected.mesh(), source, target, CGAL::Emptyset_iterator(),
               CGAL::parameters::number_of_points_per_edge(m));
         }});
  }

  void run(Method& method, const std::size_t round) const
  {
    const std::size_t source = round % m_expected.sources().size();
    const std::size_t count = Node_counting_queue::count(), sum = Node_counting_queue::sum();
    const double length = method.length(m_expected.sources()[source], m_targets[round]);
    method.number_of_graphs += Node_counting_queue::count() - count;
    method.number_of_nodes += Node_counting_queue::sum() - sum;
    method.errors.add(length, m_expected.distance(source, m_targets[round]));
  }

  // other random numbers than those of the sources
  std::vector<Vertex> random_targets(const std::size_t count) const
  {
    std::mt19937_64 random(2);
    std::vector<Vertex> result;
    while(result.size() < count)
      result.push_back(
          Vertex(static_cast<Mesh::size_type>(random() % m_expected.mesh().number_of_vertices())));
    return result;
  }

  const Exact_case& m_expected;
  std::vector<Vertex> m_targets;
  std::vector<Method> m_methods;
  Contest m_contest;
};

// A terrain with weights.
class Weighted_terrain
{
public:
  explicit Weighted_terrain(const std::size_t side)
    : m_mesh(terrain(side, 1, LARGEST_SHIFT)),
      m_weights(terrain_weights(m_mesh, double(side))),
      m_triangulation(m_mesh, CGAL::parameters::face_weight_map(m_weights))
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  const AG::Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  // random vertices that are not in the lake
  std::vector<Vertex> sources(const std::size_t count) const
  {
    std::vector<Vertex> result;
    for(std::size_t candidates = count; result.size() < count; candidates *= 2)
    {
      result = random_sources(m_mesh, candidates);
      const auto is_in_lake = [this](const Vertex v) { return this->is_in_lake(v); };
      result.erase(std::remove_if(result.begin(), result.end(), is_in_lake), result.end());
    }
    result.resize(count);
    return result;
  }

private:
  bool is_in_lake(const Vertex v) const
  {
    const auto faces = m_mesh.faces_around_target(m_mesh.halfedge(v));
    return std::all_of(faces.begin(), faces.end(), [this](const auto f) {
      return f == Mesh::null_face() || std::isinf(m_weights[f]);
    });
  }

  // Needles would be without a bound.
  static constexpr double LARGEST_SHIFT = 0.2;

  Mesh m_mesh;
  Face_weights m_weights;
  AG::Intrinsic_triangulation m_triangulation;
};

static Table weighted_table(const Weighted_terrain& terrain, const std::size_t rounds)
{
  const std::vector<Vertex> sources = terrain.sources(rounds);
  Search_benchmark benchmark("terrain", terrain.triangulation());
  benchmark.measure_times(sources);
  benchmark.find_errors(
      Dense_reference(terrain.mesh(), terrain.triangulation(), first_and_random(sources)));
  Table result = Search_benchmark::empty_table();
  benchmark.add_to(result);
  return result;
}

// How many points a placement has on the edges of a mesh.
struct Count
{
  template <typename Placement>
  Count(const AG::Intrinsic_triangulation& triangulation, Placement placement)
  {
    placement.prepare(triangulation);
    std::size_t sum = 0;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(h < triangulation.opposite(h))
      {
        const std::size_t n = placement.number_of_points(triangulation, h);
        sum += n;
        largest = (std::max)(largest, n);
      }
    mean = double(sum) / double(triangulation.number_of_edges());
  }

  double mean = 0;
  std::size_t largest = 0;
};

static void add_placements(Table& table,
                           const std::string& name,
                           const AG::Intrinsic_triangulation& triangulation)
{
  for(const double epsilon : {0.5, 0.2, 0.1, 0.05})
  {
    const Count ours(triangulation, AG::Geometric_points(epsilon));
    const Count published(triangulation, AG::Published_geometric_points(epsilon));
    table.add_row()
        .add(name)
        .add(epsilon, 2)
        .add(ours.mean, 2)
        .add(double(ours.largest), 0)
        .add(published.mean, 2)
        .add(double(published.largest), 0)
        .add(published.mean / ours.mean, 1);
  }
}

static Table placements_table(const std::vector<std::string>& meshes,
                              const Weighted_terrain& terrain)
{
  Table result({"mesh", "epsilon", "points/edge", "at most", "published points/edge",
                "published at most", "published : ours"});
  for(const std::string& name : meshes)
    add_placements(result, short_name(name), AG::Intrinsic_triangulation(read_mesh(name)));
  add_placements(result, "terrain", terrain.triangulation());
  return result;
}

// The exponent of the power law that fits best, from the number `first` on.
static double
fitted_slope(const std::vector<double>& x, const std::vector<double>& y, const std::size_t first)
{
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for(std::size_t i = first; i < x.size(); ++i)
  {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sum_x += u;
    sum_y += v;
    sum_xx += u * u;
    sum_xy += u * v;
  }
  const double n = double(x.size() - first);
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

// How errors fall as points get more.
class Convergence_benchmark
{
public:
  explicit Convergence_benchmark(const std::string& name)
  {
    const Exact_case expected = exact_case(name);
    m_name = expected.name();
    m_trials = make_trials(AG::Intrinsic_triangulation(expected.mesh()),
                           {1, 2, 3, 5, 8, 16, 32, 64}, {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005});
    for(Trial& trial : m_trials)
      trial.find_errors(expected);
  }

  static Table empty_table_of_errors()
  {
    return Table({"mesh", "points", "parameter", "nodes/vertex", "mean %", "largest %"});
  }

  static Table empty_table_of_slopes()
  {
    return Table({"mesh", "points", "against", "mean", "mean of finer half", "largest",
                  "largest of finer half"});
  }

  void add_errors_to(Table& table) const
  {
    for(const Trial& trial : m_trials)
      table.add_row()
          .add(m_name)
          .add(trial.name())
          .add(trial.parameter(), trial.name() == SPACED ? 0 : 3)
          .add(trial.nodes_per_vertex(), 2)
          .add(trial.errors().mean() * 100, 5)
          .add(trial.errors().largest() * 100, 4);
  }

  void add_slopes_to(Table& table) const
  {
    const auto parameter = [](const Trial& trial) { return trial.parameter(); };
    const auto number_of_parts = [](const Trial& trial) { return trial.parameter() + 1; };
    const auto nodes = [](const Trial& trial) { return trial.nodes_per_vertex(); };
    add_slope(table, SPACED, "m", parameter);
    add_slope(table, SPACED, "m + 1", number_of_parts);
    add_slope(table, GEOMETRIC, "epsilon", parameter);
    add_slope(table, SPACED, "nodes/vertex", nodes);
    add_slope(table, GEOMETRIC, "nodes/vertex", nodes);
  }

private:
  template <typename F>
  void add_slope(Table& table, const std::string& name, const std::string& against, F f) const
  {
    std::vector<double> x, mean, largest;
    for(const Trial& trial : m_trials)
      if(trial.name() == name)
      {
        x.push_back(f(trial));
        mean.push_back(trial.errors().mean());
        largest.push_back(trial.errors().largest());
      }
    Table::Row row = table.add_row();
    row.add(m_name).add(name).add(against);
    for(const std::vector<double>& errors : {mean, largest})
      for(const std::size_t first : {std::size_t(0), x.size() / 2})
        row.add(fitted_slope(x, errors, first), 2);
  }

  std::string m_name;
  std::vector<Trial> m_trials;
};

static std::string description_of_rounds(const Options& options)
{
  return "medians of " + std::to_string(options.number_of_rounds) + " sources, errors of " +
         std::to_string(SOURCES_OF_ERRORS) + "; bytes without the triangulation";
}

static void measure_scans(const Options& options, const Report& report)
{
  const std::size_t number_of_pairs = options.is_quick ? options.number_of_rounds : 20;
  Table searches = Search_benchmark::empty_table(), paths = Path_benchmark::empty_table();
  for(const std::string& name : options.meshes)
  {
    const Exact_case expected = exact_case(name);
    add_unweighted(searches, expected, options.number_of_rounds);
    Path_benchmark(expected, number_of_pairs).add_to(paths);
  }
  report.print("steiner",
               "Points on edges and CGAL's exact class (" + description_of_rounds(options) + ")",
               searches);
  report.print("steiner_paths",
               "One path by one call: selective refinement, and graphs with points on all edges "
               "(medians and errors of " +
                   std::to_string(number_of_pairs) + " pairs of vertices)",
               paths);
}

static void measure_terrain(const Options& options, const Report& report)
{
  const Weighted_terrain terrain(options.is_quick ? 40 : 224);
  report.print("steiner_weighted",
               "Points on edges of a weighted terrain and " + Dense_reference::description() +
                   " (" + description_of_rounds(options) + ")",
               weighted_table(terrain, options.number_of_rounds));
  report.print("steiner_placements", "Points per edge for the same bound",
               placements_table(options.meshes, terrain));
}

static void measure_convergence(const Report& report)
{
  Table errors = Convergence_benchmark::empty_table_of_errors();
  Table slopes = Convergence_benchmark::empty_table_of_slopes();
  for(const std::string name : {"elephant", "anchor"}) // the latter has needles among its faces
  {
    const Convergence_benchmark benchmark(name);
    benchmark.add_errors_to(errors);
    benchmark.add_slopes_to(slopes);
  }
  report.print("steiner_convergence", "How errors fall as points get more", errors);
  report.print("steiner_slopes", "Exponents of the power laws that fit these errors", slopes);
}

static void measure(const Options& options, const Report& report)
{
  measure_scans(options, report);
  measure_terrain(options, report);
  measure_convergence(report);
}

int main(int argc, char* argv[])
{
  return run_benchmark(argc, argv, "bench_steiner", {{"bunny00"}, 11, ""}, measure);
}
