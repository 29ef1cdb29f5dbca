// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What labels at portals take, how far their intervals are from the distances in the graph, and how
// long pairs take, in processor time, beside searches that end at the target, and those that
// landmarks lead there. See --help.

#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Landmarks.h>
#include <CGAL/Geodesic_queries/Portal_labels.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

// Another program that runs at the same time does not count.
template <typename F>
static double processor_seconds_of(F f)
{
  const std::clock_t start = std::clock();
  f();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

// How much larger upper ends are than distances, relatively. Far pairs are those at 0.3 times the
// largest distance from a vertex or more.
struct Portal_errors
{
  void add(const double error, const bool is_far)
  {
    sum += error;
    ++number;
    far_sum += is_far ? error : 0;
    number_far += is_far ? 1 : 0;
    largest = (std::max)(largest, error);
  }

  double sum = 0, far_sum = 0, largest = 0;
  std::size_t number = 0, number_far = 0, number_outside = 0;
};

template <typename Graph>
class Portal_benchmark
{
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  static constexpr std::size_t NUMBER_OF_QUERIES = 100000;

public:
  Portal_benchmark(const Graph& graph, const std::size_t number_of_pairs)
    : m_graph(graph), m_ending(graph), m_led(graph)
  {
    std::mt19937_64 random(1);
    const auto vertex = [&] {
      return static_cast<std::uint32_t>(random() % graph.triangulation().number_of_vertices());
    };
    while(m_queries.size() < NUMBER_OF_QUERIES)
    {
      const std::uint32_t source = vertex();
      m_queries.emplace_back(source, vertex());
    }
    m_pairs.assign(m_queries.begin(), m_queries.begin() + static_cast<std::ptrdiff_t>((std::min)(
                                                              number_of_pairs, m_queries.size())));
    m_seconds_of_landmarks = processor_seconds_of([&] { m_landmarks.emplace(graph); });
    m_led.use_landmarks(*m_landmarks);
    m_ending_seconds = seconds_of_pairs(m_ending);
    m_led_seconds = seconds_of_pairs(m_led);
  }

  void run(const std::string& mesh_name,
           const std::string& graph_name,
           const double epsilon,
           Table& table)
  {
    std::optional<AG::Portal_labels<Graph>> labels;
    const double preparation =
        processor_seconds_of([&] { labels.emplace(m_graph, CGAL::parameters::epsilon(epsilon)); });
    double sum = 0;
    const double query = processor_seconds_of([&] {
                           for(const Pair& pair : m_queries)
                             sum += labels->distance_interval(pair.first, pair.second).second;
                         }) /
                         double(m_queries.size());
    const Portal_errors errors = find_errors(*labels);
    const auto vertices = double(m_graph.triangulation().number_of_vertices());
    table.add_row()
        .add(mesh_name)
        .add(graph_name)
        .add(100 * epsilon, 1)
        .add(double(labels->memory()) / vertices, 0)
        .add(double(labels->number_of_labels()) / vertices, 0)
        .add(preparation, 1)
        .add(preparation / m_seconds_of_landmarks, 0)
        .add(query * 1e6 + 0 * sum, 2)
        .add(m_ending_seconds / query, 0)
        .add(m_led_seconds / query, 0)
        .add(100 * errors.sum / double(errors.number), 3)
        .add(100 * errors.far_sum / double(errors.number_far), 3)
        .add(100 * errors.largest, 2)
        .add(std::to_string(errors.number_outside));
  }

  static Table empty_table()
  {
    return Table({"mesh", "graph", "bound %", "B/vertex", "labels/vertex", "prepared s",
                  ": 16 landmarks", "us", "search : labels", "led : labels", "mean error %", "far",
                  "largest", "outside"});
  }

private:
  template <typename SurfaceSearch>
  double seconds_of_pairs(SurfaceSearch& search) const
  {
    return processor_seconds_of([&] {
             for(const Pair& pair : m_pairs)
               search.run_to(AG::Intrinsic_point::at_vertex(pair.second),
                             {{AG::Intrinsic_point::at_vertex(pair.first)}});
           }) /
           double(m_pairs.size());
  }

  // From some vertices to all, beside distances in the graph whose arcs all lead back.
  Portal_errors find_errors(const AG::Portal_labels<Graph>& labels) const
  {
    constexpr std::size_t number_of_sources = 20;
    const AG::internal::Two_way_arcs arcs(m_graph);
    AG::internal::Two_way_search search(arcs);
    Portal_errors result;
    for(std::size_t i = 0; i < number_of_sources; ++i)
    {
      const std::uint32_t source = m_queries[i].first;
      search.run_from(source);
      const double largest = search.distance(search.reached_nodes().back());
      for(std::uint32_t v = 0; v < m_graph.triangulation().number_of_vertices(); ++v)
        if(v != source && search.is_reached(v))
        {
          const double distance = search.distance(v);
          const auto [lower, upper] = labels.distance_interval(source, v);
          result.add(upper / distance - 1, distance >= 0.3 * largest);
          result.number_outside += lower <= distance && distance <= upper ? 0 : 1;
        }
    }
    return result;
  }

  const Graph& m_graph;
  AG::Surface_search<Graph> m_ending;
  AG::Guided_search<Graph> m_led;
  std::optional<AG::Landmarks<Graph>> m_landmarks;
  std::vector<Pair> m_queries, m_pairs;
  double m_seconds_of_landmarks = 0, m_ending_seconds = 0, m_led_seconds = 0;
};

static void measure_portals(const Options& options, const Report& report)
{
  Table table = Portal_benchmark<AG::Edge_graph>::empty_table();
  for(const std::string& name : options.meshes)
  {
    const AG::Intrinsic_triangulation t(read_mesh(name));
    const auto measure = [&](const auto& graph, const std::string& graph_name) {
      Portal_benchmark<std::decay_t<decltype(graph)>> benchmark(graph, options.number_of_rounds);
      const std::vector<double> bounds =
          options.is_quick ? std::vector<double>{0.02} : std::vector<double>{0.04, 0.02, 0.01};
      for(const double epsilon : bounds)
        benchmark.run(short_name(name), graph_name, epsilon, table);
    };
    measure(AG::Edge_graph(t), "edges");
    measure(AG::Discrete_geodesic_graph(t, CGAL::parameters::epsilon(0.1)), "epsilon 0.1");
  }
  report.print("portals",
               "Intervals of the distances of random pairs of vertices, from labels at portals, "
               "beside searches that end at the target, and those that 16 landmarks lead there (" +
                   std::to_string(options.number_of_rounds) + " pairs; processor times)",
               table);
}

int main(int argc, char* argv[])
{
  return run_benchmark(argc, argv, "bench_portals",
                       {{"armadillo", "bunny00", "refined_elephant"}, 200, ""}, measure_portals);
}
