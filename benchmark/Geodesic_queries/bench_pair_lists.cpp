// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists of pairs of vertices, against a call for each pair. See --help.

#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

using Pairs = std::vector<std::pair<Vertex, Vertex>>;

// Up to which part of the largest distance along edges from its source a target is.
struct Kind_of_pair
{
  const char* name;
  double most;
};
static constexpr Kind_of_pair KINDS[] = {{"near", 0.05}, {"any", 1}};

// Several targets for each source.
static Pairs pairs_of(const Mesh& mesh,
                      const Kind_of_pair& kind,
                      const std::size_t number_of_sources,
                      const std::size_t targets_per_source)
{
  const AG::Edge_graph graph{AG::Intrinsic_triangulation(mesh)};
  const auto node = [&](const Vertex v) { return graph.triangulation().vertex(v.idx()); };
  AG::Propagation<AG::Edge_graph> search(graph);
  Pairs result;
  for(const Vertex source : random_sources(mesh, number_of_sources))
  {
    search.run_from(node(source));
    double largest = 0;
    for(const Vertex v : mesh.vertices())
      if(search.is_reached(node(v)))
        largest = (std::max)(largest, search.distance(node(v)));
    std::vector<Vertex> near;
    for(const Vertex v : mesh.vertices())
      if(search.distance(node(v)) <= kind.most * largest)
        near.push_back(v);
    for(const Vertex v : random_vertices(mesh, targets_per_source, source.idx()))
      result.emplace_back(source, near[v.idx() % near.size()]);
  }
  return result;
}

// Of all threads, so that other programs do not matter.
template <typename F>
static double processor_seconds_of(F f)
{
  const std::clock_t start = std::clock();
  f();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

// The least of a few repetitions, for one pair.
template <typename F>
static double seconds_per_pair(const std::size_t number_of_pairs, F f)
{
  double result = processor_seconds_of(f);
  for(int i = 0; i < 4 && result < 1; ++i)
    result = (std::min)(result, processor_seconds_of(f));
  return result / double(number_of_pairs);
}

template <typename Paths>
static double seconds_of_single_calls(Paths& paths, const Pairs& pairs)
{
  constexpr std::size_t most = 40; // spread over the list
  Pairs some;
  for(std::size_t i = 0; i < pairs.size(); i += (pairs.size() + most - 1) / most)
    some.push_back(pairs[i]);
  return seconds_per_pair(some.size(), [&] {
    for(const auto& [source, target] : some)
      paths.shortest_distance(source, target);
  });
}

// The functions of a class whose graph is there.
template <typename Graph, typename NamedParameters>
static void add_graph(const Mesh& mesh,
                      const std::string& mesh_name,
                      const std::string& graph_name,
                      const NamedParameters& np,
                      const std::size_t number_of_sources,
                      Table& table)
{
  AG::Surface_mesh_shortest_path<Mesh, Graph> paths(mesh, np);
  const AG::Pair_queries queries(paths);
  paths.shortest_distance(Vertex(0), Vertex(0)); // makes its workspace
  for(const Kind_of_pair& kind : KINDS)
    for(const std::size_t targets : {1u, 10u, 100u})
    {
      const Pairs pairs = pairs_of(mesh, kind, number_of_sources, targets);
      const double calls = seconds_of_single_calls(paths, pairs);
      const double list = seconds_per_pair(pairs.size(), [&] { queries.distances(pairs); });
      table.add_row()
          .add(mesh_name)
          .add(graph_name)
          .add(kind.name)
          .add(double(targets), 0)
          .add(calls * 1e3, 4)
          .add(list * 1e3, 4)
          .add(calls / list, 2);
    }
}

int main(int argc, char* argv[])
{
  const auto measure_lists = [](const Options& options, const Report& report) {
    const std::size_t sources = options.number_of_rounds;
    Table lists(
        {"mesh", "graph", "pairs", "targets per source", "call ms", "list ms", "call : list"});
    for(const std::string& name : options.meshes)
    {
      const Mesh mesh = read_mesh(name);
      const std::string mesh_name = short_name(name);
      const auto epsilon = CGAL::parameters::epsilon(0.1);
      add_graph<AG::Edge_graph>(mesh, mesh_name, "edges", CGAL::parameters::default_values(),
                                sources, lists);
      add_graph<AG::Discrete_geodesic_graph>(mesh, mesh_name, "epsilon 0.1, built", epsilon,
                                             sources, lists);
      if(mesh.number_of_vertices() < 100000) // others take minutes
        add_graph<AG::Saddle_vertex_graph>(mesh, mesh_name, "exact",
                                           CGAL::parameters::default_values(), sources, lists);
    }
    report.print(
        "pair_lists",
        "Distances between pairs of vertices: a call for each pair, led to its target, and "
        "a list of " +
            std::to_string(sources) + " sources with some targets each; processor time of one pair",
        lists);
  };
  return run_benchmark(argc, argv, "bench_pair_lists", {{"bunny00"}, 20, ""}, measure_lists);
}
