// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Distance matrices in memory: what a distance costs beside a loop over the class, what threads do,
// and what rows cost that end at a radius, or with the nearest vertices. See --help.

#include "measuring/measure.h"
#include "measuring/threads.h"
#include "meshes/Mesh.h"
#include "meshes/Sphere.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

static constexpr double EPSILON = 0.1;

using Numbers = std::vector<std::size_t>; // of vertices

static Numbers numbers_of(const std::vector<Vertex>& vertices)
{
  return {vertices.begin(), vertices.end()};
}

// ----- all distances of some rows

// Counts the threads that compute rows.
class Thread_counter : public AG::Distance_matrix_visitor_base
{
public:
  bool go_further()
  {
    const std::lock_guard lock(m_mutex);
    m_threads.insert(std::this_thread::get_id());
    return true;
  }

  std::size_t number() const { return m_threads.size(); }

private:
  std::mutex m_mutex;
  std::set<std::thread::id> m_threads;
};

// The same rows by one thread, by two, and by a loop over the class.
template <typename Graph>
class Dense_benchmark
{
public:
  template <typename NamedParameters>
  Dense_benchmark(Mesh& mesh, const std::size_t number_of_sources, const NamedParameters& np)
    : m_sources(random_sources(mesh, number_of_sources)),
      m_graph(AG::Intrinsic_triangulation(mesh), np),
      m_paths(mesh, Graph(m_graph)),
      m_distances(mesh.add_property_map<Vertex, double>("v:distance").first)
  {
    check();
  }

  void run(const std::size_t number_of_rounds)
  {
    m_contest.add([this](auto) { compute(1); });
    m_contest.add([this](auto) {
      for(const Vertex source : m_sources)
        ask_class(source);
    });
    if(HAS_THREADS)
      m_contest.add([this](auto) { compute(2); });
    m_contest.run(number_of_rounds);
  }

  static Table empty_table()
  {
    return Table({"surface", "vertices", "graph", "rows", "us/distance", "class us/distance",
                  "matrix : class", "two threads us/distance", "one : two", "same bits",
                  "most threads"});
  }

  void add_to(Table& table, const std::string& surface, const std::string& graph) const
  {
    const double vertices = double(m_graph.triangulation().number_of_vertices());
    const auto microseconds = [&](const std::size_t number) {
      return m_contest.median_seconds(number) / double(m_sources.size()) / vertices * 1e6;
    };
    Table::Row row = table.add_row();
    row.add(surface).add(vertices, 0).add(graph).add(double(m_sources.size()), 0);
    row.add(microseconds(ONE_THREAD), 4)
        .add(microseconds(CLASS), 4)
        .add(m_contest.ratio(ONE_THREAD, CLASS), 3);
    if(HAS_THREADS)
      add_threads(row, microseconds(TWO_THREADS));
    else
      row.add("-").add("-").add("-").add("-");
  }

private:
  using Matrix = AG::Dense_rows<float>;

  static constexpr std::size_t ONE_THREAD = 0, CLASS = 1, TWO_THREADS = 2; // contestants

  void add_threads(Table::Row& row, const double microseconds) const
  {
    Thread_counter most;
    row.add(microseconds, 4)
        .add(m_contest.ratio(ONE_THREAD, TWO_THREADS), 2)
        .add(are_bits_equal(most) ? "yes" : "no")
        .add(double(most.number()), 0);
  }

  template <typename Visitor>
  Matrix compute(const std::size_t number_of_threads, Visitor& visitor) const
  {
    Matrix result;
    with_threads(number_of_threads, [&](auto tag) {
      CGAL::approximate_geodesic_distance_matrix(
          m_graph, result, numbers_of(m_sources),
          parameters::concurrency_tag(tag).visitor(std::ref(visitor)));
    });
    return result;
  }

  Matrix compute(const std::size_t number_of_threads) const
  {
    AG::Distance_matrix_visitor_base visitor;
    return compute(number_of_threads, visitor);
  }

  void ask_class(const Vertex source)
  {
    m_paths.remove_all_source_points();
    m_paths.add_source_point(source);
    m_paths.shortest_distances_to_source_points(m_distances);
  }

  // Whether 1, 2, 3 and 7 threads find the same; `last` counts those of the last time.
  bool are_bits_equal(Thread_counter& last) const
  {
    const auto is_same = [expected = compute(1)](const Matrix& m) {
      const std::size_t size = m.number_of_rows() * m.number_of_columns();
      return size == expected.number_of_rows() * expected.number_of_columns() &&
             std::memcmp(m.data(), expected.data(), size * sizeof(float)) == 0;
    };
    return is_same(compute(2)) && is_same(compute(3)) && is_same(compute(7, last));
  }

  // Who compares times of different results compares nothing.
  void check()
  {
    const Matrix matrix = compute(1);
    for(std::size_t row = 0; row < m_sources.size(); ++row)
    {
      ask_class(m_sources[row]);
      for(std::size_t v = 0; v < matrix.number_of_columns(); ++v)
        if(matrix(row, v) != static_cast<float>(m_distances[Vertex(Mesh::size_type(v))]))
          throw std::runtime_error("the class finds another distance than the matrix");
    }
  }

  std::vector<Vertex> m_sources;
  Graph m_graph;
  AG::Surface_mesh_shortest_path<Mesh, Graph> m_paths;
  Mesh::Property_map<Vertex, double> m_distances;
  Contest m_contest;
};

struct Numbers_of_rows
{
  std::size_t approximate, exact;
};

static void measure_dense_rows(const std::string& surface,
                               Mesh mesh,
                               const Numbers_of_rows& rows,
                               const std::size_t number_of_rounds,
                               Table& table)
{
  std::cerr << "Rows of all distances on " << surface << " ...\n";
  const auto run = [&](auto benchmark, const std::string& graph, const std::size_t rounds) {
    benchmark->run(rounds);
    benchmark->add_to(table, surface, graph);
  };
  run(std::make_unique<Dense_benchmark<AG::Edge_graph>>(mesh, rows.approximate,
                                                        parameters::default_values()),
      "edges", number_of_rounds);
  run(std::make_unique<Dense_benchmark<AG::Discrete_geodesic_graph>>(mesh, rows.approximate,
                                                                     parameters::epsilon(EPSILON)),
      "epsilon 0.1", number_of_rounds);
  run(std::make_unique<Dense_benchmark<AG::Saddle_vertex_graph>>(mesh, rows.exact,
                                                                 parameters::epsilon(0)),
      "exact", number_of_rounds);
}

// ----- rows that end early

// Rows with few entries and with many, each so often that there are about as many entries of each.
class Reach_benchmark
{
public:
  Reach_benchmark(const Mesh& mesh, const std::size_t number_of_entries)
    : m_mesh(mesh),
      m_number_of_entries(number_of_entries),
      m_graph(AG::Intrinsic_triangulation(mesh), parameters::epsilon(EPSILON))
  {
    AG::Dense_rows<double> row;
    CGAL::approximate_geodesic_distance_matrix(m_graph, row, Numbers{0});
    m_largest = *std::max_element(row.row(0).begin(), row.row(0).end());
  }

  void add_radius(const std::size_t part)
  {
    add(
        "1/" + std::to_string(part), [] { return AG::Radius_rows<float>(); },
        parameters::maximum_distance(m_largest / double(part)));
  }

  void add_nearest(const std::size_t number)
  {
    add(
        std::to_string(number), [number] { return AG::Nearest_rows<float>(number); },
        parameters::default_values());
  }

  Table table(const std::string& limit, const std::size_t number_of_rounds)
  {
    m_contest.run(number_of_rounds);
    Table result({limit, "rows", "entries/row", "us/row", "ns/entry"});
    for(std::size_t i = 0; i < m_cases.size(); ++i)
    {
      const double seconds = m_contest.median_seconds(i), rows = double(m_cases[i].number_of_rows);
      result.add_row()
          .add(m_cases[i].limit)
          .add(rows, 0)
          .add(m_cases[i].entries_per_row, 1)
          .add(seconds / rows * 1e6, 2)
          .add(seconds / rows / m_cases[i].entries_per_row * 1e9, 1);
    }
    return result;
  }

private:
  struct Case
  {
    std::string limit;
    std::size_t number_of_rows;
    double entries_per_row;
  };

  template <typename MakeRows, typename NamedParameters>
  void add(const std::string& limit, const MakeRows make_rows, const NamedParameters& np)
  {
    const auto number_of_entries = [=, this_ = this](const Numbers& sources) {
      auto rows = make_rows();
      CGAL::approximate_geodesic_distance_matrix(this_->m_graph, rows, sources, np);
      return double(rows.number_of_entries());
    };
    const Numbers some = numbers_of(random_sources(m_mesh, 10));
    const double guess = number_of_entries(some) / double(some.size());
    const auto number_of_rows = static_cast<std::size_t>(
        (std::min)(double(m_mesh.number_of_vertices()), double(m_number_of_entries) / guess + 1));
    const Numbers sources = numbers_of(random_sources(m_mesh, number_of_rows));
    m_cases.push_back({limit, number_of_rows, number_of_entries(sources) / double(number_of_rows)});
    m_contest.add([=](auto) { number_of_entries(sources); });
  }

  const Mesh& m_mesh;
  std::size_t m_number_of_entries;
  AG::Discrete_geodesic_graph m_graph;
  double m_largest;
  std::vector<Case> m_cases;
  Contest m_contest;
};

static void measure_reach(const Mesh& mesh, const Options& options, const Report& report)
{
  std::cerr << "Rows that end early ...\n";
  const std::size_t number_of_entries = options.is_quick ? 10000 : 20000000;
  Reach_benchmark by_radius(mesh, number_of_entries), by_number(mesh, number_of_entries);
  for(const unsigned part : {64u, 32u, 16u, 8u, 4u, 2u, 1u})
    by_radius.add_radius(part);
  for(const unsigned number : {10u, 100u, 1000u, 10000u})
    by_number.add_nearest(number);
  const std::string where =
      " on a sphere of " + std::to_string(mesh.number_of_vertices()) + " vertices, epsilon 0.1";
  report.print("matrix_radius",
               "Rows up to a radius, as a part of the largest distance," + where + " (one thread)",
               by_radius.table("radius", options.number_of_rounds));
  report.print("matrix_nearest", "Rows of the nearest vertices," + where + " (one thread)",
               by_number.table("nearest", options.number_of_rounds));
}

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    const Mesh ball = sphere(options.is_quick ? 10 : 57);
    const Numbers_of_rows rows =
        options.is_quick ? Numbers_of_rows{10, 2} : Numbers_of_rows{500, 20};
    Table table = Dense_benchmark<AG::Edge_graph>::empty_table();
    for(const std::string& name : options.meshes)
      measure_dense_rows(short_name(name), read_mesh(name), rows, options.number_of_rounds, table);
    measure_dense_rows("sphere", ball, rows, options.number_of_rounds, table);
    report.print(
        "matrix_dense",
        "Rows of all distances from random sources in memory, as float, beside a loop over "
        "the class; the same bits are those by 1, 2, 3 and 7 threads (medians of " +
            std::to_string(options.number_of_rounds) + " rounds)",
        table);
    measure_reach(ball, options, report);
  };
  return run_benchmark(argc, argv, "bench_distance_matrix", {{"bunny00"}, 5, ""}, measure);
}
