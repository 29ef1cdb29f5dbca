// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What selective refinement makes of single paths, beside graphs with points on all edges. See
// --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/iterator.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

static constexpr std::size_t NUMBER_OF_SOURCES = 3; // with exact distances, which take seconds

// A queue that counts the nodes of the graphs that it is made for.
class Node_counting_queue : public AG::Adaptive_bucket_queue
{
public:
  Node_counting_queue(const std::size_t number_of_nodes, const AG::Arc_lengths& arc_lengths)
    : AG::Adaptive_bucket_queue(number_of_nodes, arc_lengths)
  {
    add(number_of_nodes);
  }

  static void add(const std::size_t number_of_nodes)
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
    : m_expected(expected),
      m_targets(random_vertices(expected.mesh(), number_of_pairs, SEED_OF_TARGETS))
  {
    for(const double tolerance : {1e-3, 1e-5, 1e-6})
      add_refinement(tolerance);
    for(const std::size_t m : {3u, 8u, 16u, 32u})
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
  static constexpr unsigned SEED_OF_TARGETS = 2;           // not that of the sources
  static constexpr std::size_t DEFAULT = 1;                // the position of the default tolerance
  static constexpr std::size_t NUMBER_OF_FIRST_POINTS = 3; // per edge, the default of the function

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
                           return refined_length(source, target, tolerance);
                         }});
  }

  // As `AG::refined_path()` does it, but with the queue that counts.
  double refined_length(const Vertex source, const Vertex target, const double tolerance) const
  {
    const AG::Intrinsic_triangulation triangulation(m_expected.mesh());
    return AG::internal::selective_refinement<Node_counting_queue>(
               triangulation, triangulation.vertex(source.idx()),
               triangulation.vertex(target.idx()),
               AG::Fixed_number_of_points(NUMBER_OF_FIRST_POINTS), 0, tolerance)
        .first.length;
  }

  void add_full_graph(const std::size_t m)
  {
    const AG::Steiner_graph<AG::Fixed_number_of_points> graph(
        AG::Intrinsic_triangulation(m_expected.mesh()), AG::Fixed_number_of_points(m));
    m_methods.push_back({"equally spaced", std::to_string(m),
                         [this, m, number_of_nodes = graph.number_of_nodes()](const Vertex source,
                                                                              const Vertex target) {
                           Node_counting_queue::add(number_of_nodes);
                           return CGAL::approximate_geodesic_path(
                               m_expected.mesh(), CGAL::Emptyset_iterator(), source, target,
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

  const Exact_case& m_expected;
  std::vector<Vertex> m_targets;
  std::vector<Method> m_methods;
  Contest m_contest;
};

int main(int argc, char* argv[])
{
  const auto measure_paths = [](const Options& options, const Report& report) {
    Table paths = Path_benchmark::empty_table();
    for(const std::string& name : options.meshes)
    {
      const Exact_case expected = first_and_random_case(name, NUMBER_OF_SOURCES);
      Path_benchmark(expected, options.number_of_rounds).add_to(paths);
    }
    report.print("steiner_paths",
                 "One path by one call: selective refinement, and graphs with points on all edges "
                 "(medians and errors of " +
                     std::to_string(options.number_of_rounds) + " pairs of vertices)",
                 paths);
  };
  return run_benchmark(argc, argv, "bench_refinement", {{"bunny00"}, 20, ""}, measure_paths);
}
