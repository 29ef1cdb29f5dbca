// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How long searches from one vertex to another take: complete ones, those that end when the
// distance is certain, and those that are led to their goal besides. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_costs/equal_parts.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

// Which pairs are meant: those whose distance is so large a part of the largest one.
struct Kind_of_pair
{
  const char* name;
  double least, most;
};
static constexpr Kind_of_pair KINDS[] = {{"near", 0, 0.1}, {"middle", 0.4, 0.6}, {"far", 0.85, 1}};

// One graph, searched in three ways.
template <typename Graph>
class Pair_benchmark
{
  using Search = AG::Propagation<Graph>;
  using Node = typename Graph::Node;

public:
  Pair_benchmark(std::string mesh_name,
                 std::string graph_name,
                 const Mesh& mesh,
                 const Graph& graph)
    : m_mesh_name(std::move(mesh_name)),
      m_graph_name(std::move(graph_name)),
      m_mesh(mesh),
      m_graph(graph),
      m_positions(positions(mesh, graph.triangulation())),
      m_complete(graph),
      m_ending(graph),
      m_led(graph)
  {
  }

  void run(const std::size_t number_of_pairs, Table& table)
  {
    for(const Kind_of_pair& kind : KINDS)
    {
      find_pairs(kind, number_of_pairs);
      Contest contest;
      Counts counts;
      contest.add([&](const auto round) { search_all(round, counts); });
      contest.add([&](const auto round) { search_to_end(round, counts); });
      contest.add([&](const auto round) { search_toward(round, counts); });
      contest.run(number_of_pairs);
      add_row(kind, contest, counts, table);
    }
  }

  static Table empty_table()
  {
    return Table({"mesh", "graph", "pairs", "all ms", "to target ms", "toward target ms",
                  "all : to", "all : toward", "nodes to %", "nodes toward %"});
  }

private:
  static AG::Vertex_positions positions(const Mesh& mesh,
                                        const AG::Intrinsic_triangulation& triangulation)
  {
    AG::Mesh_translation translation(mesh, get(boost::vertex_index, mesh), triangulation);
    translation.list_vertices();
    const auto points = mesh.points();
    return {triangulation, translation.position_of_vertex(points)};
  }

  struct Counts // of expanded nodes
  {
    std::size_t all = 0, to = 0, toward = 0;
  };

  Node node(const Vertex v) const { return m_graph.triangulation().vertex(v.idx()); }

  void find_pairs(const Kind_of_pair& kind, const std::size_t count)
  {
    m_pairs.clear();
    const std::vector<Vertex> sources = random_sources(m_mesh, count);
    const std::vector<Vertex> candidates = random_vertices(m_mesh, 100000, 2);
    std::size_t next = 0;
    for(const Vertex source : sources)
    {
      m_complete.run_from(node(source));
      double largest = 0;
      for(const Vertex v : m_mesh.vertices())
        if(m_complete.is_reached(node(v)))
          largest = (std::max)(largest, m_complete.distance(node(v)));
      const auto fits = [&](const Node target) {
        const double part = m_complete.distance(target) / largest;
        return part > kind.least && part <= kind.most;
      };
      while(!fits(node(candidates[next % candidates.size()])))
        ++next;
      m_pairs.emplace_back(node(source), node(candidates[next++ % candidates.size()]));
    }
  }

  void search_all(const std::size_t round, Counts& counts)
  {
    m_complete.run_from(m_pairs[round].first);
    counts.all += m_complete.reached_nodes().size();
  }

  void search_to_end(const std::size_t round, Counts& counts)
  {
    const auto [source, target] = m_pairs[round];
    m_ending.run({{source}}, stop_at(target));
    counts.to += m_ending.reached_nodes().size();
  }

  void search_toward(const std::size_t round, Counts& counts)
  {
    const auto [source, target] = m_pairs[round];
    const AG::internal::Euclidean_heuristic<Graph> estimate(m_graph, m_positions,
                                                            AG::Intrinsic_point::at_vertex(target));
    m_led.run_toward({{source}}, stop_at(target), estimate);
    counts.toward += m_led.reached_nodes().size();
  }

  static typename Search::Stop_rule stop_at(const Node target)
  {
    typename Search::Stop_rule result;
    result.targets.push_back(target);
    return result;
  }

  void add_row(const Kind_of_pair& kind,
               const Contest& contest,
               const Counts& counts,
               Table& table) const
  {
    table.add_row()
        .add(m_mesh_name)
        .add(m_graph_name)
        .add(kind.name)
        .add(contest.median_seconds(0) * 1e3, 3)
        .add(contest.median_seconds(1) * 1e3, 3)
        .add(contest.median_seconds(2) * 1e3, 3)
        .add(contest.ratio(0, 1), 2)
        .add(contest.ratio(0, 2), 2)
        .add(100. * double(counts.to) / double(counts.all), 1)
        .add(100. * double(counts.toward) / double(counts.all), 1);
  }

  std::string m_mesh_name, m_graph_name;
  const Mesh& m_mesh;
  const Graph& m_graph;
  AG::Vertex_positions m_positions;
  Search m_complete, m_ending, m_led;
  std::vector<std::pair<Node, Node>> m_pairs;
};

template <typename Graph>
static void add_graph(Table& table,
                      const Options& options,
                      const Mesh& mesh,
                      const std::string& mesh_name,
                      const std::string& graph_name,
                      const Graph& graph)
{
  Pair_benchmark<Graph>(mesh_name, graph_name, mesh, graph).run(options.number_of_rounds, table);
}

int main(int argc, char* argv[])
{
  const auto measure_pairs = [](const Options& options, const Report& report) {
    Table table = Pair_benchmark<AG::Edge_graph>::empty_table();
    const auto epsilon = CGAL::parameters::epsilon(0.1);
    for(const std::string& name : options.meshes)
    {
      const Mesh mesh = read_mesh(name);
      const AG::Intrinsic_triangulation triangulation(mesh);
      const std::string mesh_name = short_name(name);
      add_graph(table, options, mesh, mesh_name, "edges", AG::Edge_graph(triangulation));
      add_graph(table, options, mesh, mesh_name, "epsilon 0.1, built",
                AG::Discrete_geodesic_graph(triangulation, epsilon));
      add_graph(table, options, mesh, mesh_name, "epsilon 0.1, lazy",
                AG::Lazy_discrete_geodesic_graph(triangulation, epsilon));
      add_graph(table, options, mesh, mesh_name, "3 points per edge",
                AG::Steiner_graph<AG::Fixed_number_of_points>(triangulation,
                                                              AG::Fixed_number_of_points(3)));
    }
    report.print("pairs",
                 "Single pairs of vertices: complete searches, those that end at the target, and "
                 "those that are led to it (medians of " +
                     std::to_string(options.number_of_rounds) + " pairs)",
                 table);
  };
  return run_benchmark(argc, argv, "bench_pairs", {{"bunny00"}, 21, ""}, measure_pairs);
}
