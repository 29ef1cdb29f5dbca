// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Searches where weights of faces differ by orders of magnitude: the default queue beside heaps, on
// a terrain; and how long a search of few faces can take. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Terrain.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Random = std::mt19937_64;
using Weights = Mesh::Property_map<Mesh::Face_index, double>;

static double between(Random& random, const double low, const double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Weights of the faces, by where they are in a square of side 1.
struct Pattern
{
  std::string name;
  std::function<double(double x, double y, Random&)> weight;
};

static std::vector<Pattern> patterns()
{
  const auto strips = [](const double x, const int number) {
    return std::pow(100., int(x * number) % 3);
  };
  return {
      {"1", [](double, double, Random&) { return 1.; }},
      {"1 to 4, random", [](double, double, Random& r) { return between(r, 1, 4); }},
      {"1 | 100 | 10^4", [=](double x, double, Random&) { return strips(x, 3); }},
      {"the same in 12 strips", [=](double x, double, Random&) { return strips(x, 12); }},
      {"the same, random", [=](double, double, Random& r) { return strips(between(r, 0, 1), 3); }},
      {"a road of 10^-6",
       [](double, double y, Random&) { return std::abs(y - 0.5) < 0.02 ? 1e-6 : 1.; }},
      {"0, or 1 to 10^4, random",
       [](double, double, Random& r) {
         return between(r, 0, 1) < 0.2 ? 0. : std::pow(10, between(r, 0, 4));
       }},
      {"1 to 10^12, random",
       [](double, double, Random& r) { return std::pow(10, between(r, 0, 12)); }},
      {"1 to 10^300, random",
       [](double, double, Random& r) { return std::pow(10, between(r, 0, 300)); }},
  };
}

static AG::Intrinsic_triangulation weighted(Mesh& mesh, const double side, const Pattern& pattern)
{
  Random random(1);
  const Weights weights = mesh.add_property_map<Mesh::Face_index, double>("f:weight", 1).first;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Kernel::Point_3 center =
        CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                       mesh.point(mesh.target(mesh.next(h))));
    const auto part = [side](const double x) { return (std::clamp)(x / side, 0., 0.9999); };
    weights[f] = pattern.weight(part(center.x()), part(center.y()), random);
  }
  return AG::Intrinsic_triangulation(mesh, CGAL::parameters::face_weight_map(weights));
}

// The queues on one graph.
template <typename Graph>
void add_queues(Table& table,
                const std::string& pattern,
                const std::string& points,
                const Graph& graph,
                const std::vector<Vertex>& sources)
{
  AG::Propagation<Graph> ours(graph);
  AG::Propagation<Graph, AG::Binary_heap_queue> binary(graph);
  AG::Propagation<Graph, AG::D_ary_heap_queue<4>> four(graph);
  AG::Propagation<Graph, AG::Radix_heap_queue> radix(graph);
  Contest contest;
  const auto add = [&](auto& search) {
    const auto run = [&](const Vertex source) {
      search.run_from(graph.triangulation().vertex(source.idx()));
    };
    run(sources.front()); // which makes room in the workspace, and adapts the buckets
    contest.add([&sources, run](const auto round) { run(sources[round]); });
  };
  add(ours);
  add(binary);
  add(four);
  add(radix);
  contest.run(sources.size());

  ours.collect_statistics(true);
  ours.run_from(graph.triangulation().vertex(sources.back().idx()));
  const auto& statistics = ours.statistics();
  Table::Row row = table.add_row();
  row.add(pattern).add(points).add(double(graph.number_of_nodes()), 0);
  double fastest = std::numeric_limits<double>::infinity();
  for(const std::size_t queue : {0u, 1u, 2u, 3u})
  {
    const double seconds = contest.median_seconds(queue);
    row.add(seconds * 1e3, 2);
    fastest = queue > 0 ? (std::min)(fastest, seconds) : fastest;
  }
  row.add(contest.ratio(0, 1), 2)
      .add(contest.median_seconds(0) / fastest, 2)
      .add(double(statistics.pops - statistics.stale_pops) / double(statistics.settled_nodes), 3);
}

static Table queues_table(const Options& options)
{
  Table result({"weights", "points", "nodes", "default ms", "binary heap", "4-ary heap",
                "radix heap", "default : binary", "default : fastest", "expansions/node"});
  const std::size_t side = options.is_quick ? 20 : 100;
  Mesh mesh = terrain(side, 1, 0.2);
  const std::vector<Vertex> sources = random_sources(mesh, options.number_of_rounds);
  for(const Pattern& pattern : patterns())
  {
    const AG::Intrinsic_triangulation triangulation = weighted(mesh, double(side), pattern);
    const auto add = [&](const std::string& points, const auto& placement) {
      using Graph = AG::Steiner_graph<std::decay_t<decltype(placement)>>;
      add_queues(result, pattern.name, points, Graph(triangulation, placement), sources);
    };
    add("3 on an edge", AG::Fixed_number_of_points(3));
    add("for epsilon 0.1", AG::Geometric_points(0.1));
  }
  return result;
}

// ----- few faces

static std::vector<Pattern> extreme_patterns()
{
  const auto share = [](Random& r) { return between(r, 0, 1); };
  return {
      {"1 to 10^300", [](double, double, Random& r) { return std::pow(10, between(r, 0, 300)); }},
      {"10^-300 to 10^300",
       [](double, double, Random& r) { return std::pow(10, between(r, -300, 300)); }},
      {"1 to 10^20", [](double, double, Random& r) { return std::pow(10, between(r, 0, 20)); }},
      {"1 or 10^200", [=](double, double, Random& r) { return share(r) < 0.5 ? 1. : 1e200; }},
      {"1 or 10^-200", [=](double, double, Random& r) { return share(r) < 0.9 ? 1. : 1e-200; }},
      {"0 or 1 to 10^40",
       [=](double, double, Random& r) {
         return share(r) < 0.3 ? 0. : std::pow(10, between(r, 0, 40));
       }},
      {"0, 10^100, or forbidden",
       [=](double, double, Random& r) {
         const double x = share(r);
         return x < 0.33 ? 0 : x < 0.67 ? 1e100 : std::numeric_limits<double>::infinity();
       }},
  };
}

// Builds a graph of a hundred faces and searches it.
struct Small_case
{
  Small_case(const Pattern& pattern, const unsigned number, const double epsilon)
  {
    constexpr std::size_t side = 8;
    Random random(number);
    Mesh mesh = terrain(side, 1, 0.2);
    for(const Vertex v : mesh.vertices())
      mesh.point(v) = mesh.point(v) + Kernel::Vector_3(0, 0, between(random, 0, 1));
    const Pattern own = {pattern.name, [&](const double x, const double y, Random&) {
                           return pattern.weight(x, y, random);
                         }};
    const AG::Intrinsic_triangulation triangulation = weighted(mesh, double(side), own);
    seconds = seconds_of([&] {
      const AG::Steiner_graph<> graph(triangulation,
                                      CGAL::parameters::epsilon(epsilon).accept_weaker_bound(true));
      AG::Propagation<AG::Steiner_graph<>> search(graph);
      search.run_from(graph.triangulation().vertex(number % (side * side)));
      number_of_nodes = graph.number_of_nodes();
    });
  }

  double seconds = 0;
  std::size_t number_of_nodes = 0;
};

static Table small_cases_table(const Options& options)
{
  Table result({"weights", "epsilon", "nodes", "mean ms", "largest ms", "us/node at most"});
  const unsigned number = options.is_quick ? 3 : 20;
  for(const Pattern& pattern : extreme_patterns())
    for(const double epsilon : {0.1, 0.01, 0.001, 0.0001})
    {
      double sum = 0, largest = 0, per_node = 0, nodes = 0;
      for(unsigned i = 0; i < number; ++i)
      {
        const Small_case one(pattern, i, epsilon);
        sum += one.seconds;
        largest = (std::max)(largest, one.seconds);
        nodes = (std::max)(nodes, double(one.number_of_nodes));
        per_node = (std::max)(per_node, one.seconds / double(one.number_of_nodes));
      }
      result.add_row()
          .add(pattern.name)
          .add(epsilon, 4)
          .add(nodes, 0)
          .add(sum / number * 1e3, 2)
          .add(largest * 1e3, 2)
          .add(per_node * 1e6, 2);
    }
  return result;
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    report.print("weights",
                 "Queues where weights differ by orders of magnitude (medians of " +
                     std::to_string(options.number_of_rounds) + " sources)",
                 queues_table(options));
    report.print("weights_of_few_faces",
                 "Building and searching graphs of 98 faces with extreme weights",
                 small_cases_table(options));
  };
  return run_benchmark(argc, argv, "bench_weights", {{}, 11, ""}, measure);
}
