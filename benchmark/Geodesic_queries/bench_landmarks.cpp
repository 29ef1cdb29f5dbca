// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How long pairs take that landmarks lead to their targets, on meshes with weights and without,
// beside searches that only end there. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "meshes/Weighted_terrain.h"
#include "meshes/navigation_mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_queries/Exact_landmarks.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Landmarks.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

// The times of all pairs by one kind of search, and how many nodes it expanded.
struct Pair_times
{
  double percentile(const std::size_t percent) const
  {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[(std::min)(sorted.size() * percent / 100, sorted.size() - 1)];
  }

  std::vector<double> seconds, distances;
  std::size_t number_of_nodes = 0;
};

static std::vector<AG::Point_pair> random_pairs(const AG::Intrinsic_triangulation& triangulation,
                                                const std::size_t number)
{
  std::mt19937_64 random(1);
  const auto vertex = [&] {
    return AG::Intrinsic_point::at_vertex(
        static_cast<std::uint32_t>(random() % triangulation.number_of_vertices()));
  };
  std::vector<AG::Point_pair> result;
  while(result.size() < number)
  {
    const AG::Intrinsic_point source = vertex();
    result.emplace_back(source, vertex());
  }
  return result;
}

template <typename Graph>
class Landmark_benchmark
{
public:
  Landmark_benchmark(const Graph& graph, const std::size_t number_of_pairs)
    : m_graph(graph), m_pairs(random_pairs(graph.triangulation(), number_of_pairs))
  {
  }

  void run(const std::string& mesh_name,
           const std::string& graph_name,
           const std::vector<std::size_t>& numbers_of_landmarks,
           Table& table) const
  {
    const Pair_times all = find_all(nullptr);
    for(const std::size_t number : numbers_of_landmarks)
    {
      const auto start = std::chrono::steady_clock::now();
      const AG::Landmarks<Graph> landmarks(m_graph, number);
      const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
      const Pair_times led = find_all(&landmarks);
      double largest_difference = 0;
      for(std::size_t i = 0; i < m_pairs.size(); ++i)
        if(all.distances[i] > 0 && all.distances[i] != led.distances[i])
          largest_difference =
              (std::max)(largest_difference, std::abs(led.distances[i] / all.distances[i] - 1));
      table.add_row()
          .add(mesh_name)
          .add(std::to_string(m_graph.triangulation().number_of_faces()))
          .add(graph_name)
          .add(std::to_string(m_graph.number_of_nodes()))
          .add(std::to_string(number))
          .add(duration.count(), 2)
          .add(all.percentile(50) * 1e3, 3)
          .add(led.percentile(50) * 1e3, 3)
          .add(led.percentile(95) * 1e3, 3)
          .add(all.percentile(50) / led.percentile(50), 1)
          .add(all.percentile(95) / led.percentile(95), 1)
          .add(100. * double(led.number_of_nodes) / double(all.number_of_nodes), 2)
          .add(largest_difference * 1e15, 1);
    }
  }

  static Table empty_table()
  {
    return Table({"mesh", "faces", "graph", "nodes", "landmarks", "prepared in s", "pair ms",
                  "led ms, median", "p95", "pair : led, median", "p95", "nodes %",
                  "difference 1e-15"});
  }

private:
  Pair_times find_all(const AG::Landmarks<Graph>* const landmarks) const
  {
    AG::Guided_search<Graph> search(m_graph);
    if(landmarks != nullptr)
      search.use_landmarks(*landmarks);
    search.collect_statistics(true);
    Pair_times result;
    for(const auto& pair : m_pairs)
    {
      result.seconds.push_back(seconds_of([&] { search.run_to(pair.second, {{pair.first}}); }));
      result.distances.push_back(search.distance(pair.second));
      result.number_of_nodes += search.search().statistics().settled_nodes;
    }
    return result;
  }

  const Graph& m_graph;
  std::vector<AG::Point_pair> m_pairs;
};

// Exact pairs, which straight-line distances lead to their targets, and which are prepared.
static void
measure_exact_pairs(const Mesh& mesh, const std::size_t number_of_pairs, const Report& report)
{
  const AG::Saddle_vertex_graph graph{AG::Intrinsic_triangulation(mesh)};
  AG::Mesh_translation translation(mesh, get(boost::vertex_index, mesh), graph.triangulation());
  translation.list_vertices();
  const auto points = mesh.points();
  const AG::Vertex_positions positions(graph.triangulation(),
                                       translation.position_of_vertex(points));
  const AG::Exact_landmarks<AG::Saddle_vertex_graph> landmarks(graph);
  AG::Guided_search<AG::Saddle_vertex_graph> search(graph), prepared(graph);
  prepared.use_landmarks(landmarks);
  Pair_times times, times_if_prepared;
  for(const auto& [source, target] : random_pairs(graph.triangulation(), number_of_pairs))
  {
    const auto run = [&, from = source, to = target](auto& any) {
      return seconds_of([&] { any.run_to(to, {{from}}, positions); });
    };
    times.seconds.push_back(run(search));
    times_if_prepared.seconds.push_back(run(prepared));
  }
  Table table({"mesh", "faces", "exact pair ms, median", "p95", "prepared, median", "p95"});
  table.add_row()
      .add("navigation")
      .add(std::to_string(mesh.number_of_faces()))
      .add(times.percentile(50) * 1e3, 3)
      .add(times.percentile(95) * 1e3, 3)
      .add(times_if_prepared.percentile(50) * 1e3, 3)
      .add(times_if_prepared.percentile(95) * 1e3, 3);
  report.print("exact_pairs",
               "Exact distances of random pairs of vertices on a mesh without weights (" +
                   std::to_string(number_of_pairs) + " pairs)",
               table);
}

static void measure_landmarks(const Options& options, const Report& report)
{
  Table table = Landmark_benchmark<AG::Edge_graph>::empty_table();
  const std::size_t number = options.number_of_rounds;
  const auto add_weighted = [&](const std::string& name, const AG::Intrinsic_triangulation& t) {
    const AG::Steiner_graph<> graph(t, AG::Geometric_points(0.1));
    Landmark_benchmark<AG::Steiner_graph<>>(graph, number)
        .run(name, "epsilon 0.1", {4, 16, 32}, table);
  };
  Mesh mesh = navigation_mesh(options.is_quick ? 8 : 26);
  add_weighted(
      "navigation, 4 weights",
      AG::Intrinsic_triangulation(mesh, CGAL::parameters::face_weight_map(region_weights(mesh))));
  add_weighted("terrain with weights",
               Weighted_terrain(options.is_quick ? 20 : 80).triangulation());
  for(const std::string& name : options.meshes)
  {
    const AG::Intrinsic_triangulation t(read_mesh(name));
    const AG::Edge_graph edges(t);
    Landmark_benchmark<AG::Edge_graph>(edges, number)
        .run(short_name(name), "edges", {4, 16}, table);
    const AG::Discrete_geodesic_graph built(t, CGAL::parameters::epsilon(0.1));
    Landmark_benchmark<AG::Discrete_geodesic_graph>(built, number)
        .run(short_name(name), "epsilon 0.1, built", {4, 16}, table);
  }
  report.print("landmarks",
               "Pairs of random vertices, by searches that end at the target, and by those that "
               "landmarks lead there (" +
                   std::to_string(number) + " pairs)",
               table);
  measure_exact_pairs(mesh, number, report);
}

int main(int argc, char* argv[])
{
  return run_benchmark(argc, argv, "bench_landmarks", {{"bunny00"}, 200, ""}, measure_landmarks);
}
