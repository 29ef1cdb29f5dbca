// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Golden_results.h"
#include "golden_graphs.h"
#include "golden_names.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Trees of shortest paths, by all queues, and what it took to find them.

namespace geodesics_test {
namespace golden {

// Not by number, where nodes are vertices, which would depend on their order in the triangulation.
template <typename GeodesicGraph>
std::uint64_t number_in_mesh(const GeodesicGraph& graph, const typename GeodesicGraph::Node node)
{
  return node < graph.triangulation().number_of_vertices() ? graph.triangulation().index(node)
                                                           : node;
}

template <typename Search>
void add_node(const Search& search, const typename Search::Node node, Hash& hash)
{
  hash.add(search.distance(node));
  hash.add(std::uint64_t(search.source(node)));
  hash.add(number_in_mesh(search.graph(), search.predecessor(node)));
}

template <typename Search>
void add_tree(const Search& search, Hash& hash)
{
  const Triangulation& triangulation = search.graph().triangulation();
  const auto n = triangulation.number_of_vertices();
  for(typename Search::Node i = 0; i < n; ++i)
    add_node(search, triangulation.vertex(i), hash);
  for(typename Search::Node i = n; i < search.graph().number_of_nodes(); ++i)
    add_node(search, i, hash);
}

template <typename Queue>
auto add_figures_of_queue(const Queue& queue, Hash& hash, int)
    -> decltype(queue.statistics(), void())
{
  const auto figures = queue.statistics();
  hash.add(figures.width);
  for(const std::size_t number : {figures.visited_buckets, figures.used_buckets, figures.entries,
                                  figures.late_entries, figures.comparisons})
    hash.add(std::uint64_t(number));
  hash.add(figures.sum_of_squared_occupancies);
}

// Other queues have no figures of their own.
template <typename Queue>
void add_figures_of_queue(const Queue& /* queue */, Hash& /* hash */, long)
{
}

template <typename Search>
void add_figures(const Search& search, Hash& hash)
{
  const auto& figures = search.statistics();
  for(const std::size_t number :
      {figures.settled_nodes, figures.pops, figures.stale_pops, figures.relaxations,
       figures.improvements, figures.queue_comparisons})
    hash.add(std::uint64_t(number));
  for(const auto node : search.reached_nodes())
    hash.add(number_in_mesh(search.graph(), node));
  add_figures_of_queue(search.queue(), hash, 0);
}

// Runs one after the other, as each leaves things behind that the next one starts with.
template <typename Queue, typename GeodesicGraph>
void add_runs(const std::string& subject, const GeodesicGraph& graph, Golden_results& results)
{
  using Search = golden::Search<GeodesicGraph, Queue>;
  Search search(graph);
  Hash trees, figures;
  const auto add = [&] {
    add_tree(search, trees);
    add_figures(search, figures);
  };
  const Triangulation& triangulation = graph.triangulation();
  const std::size_t n = triangulation.number_of_vertices();
  const auto node = [&](const std::size_t i) {
    return triangulation.vertex(static_cast<typename Search::Node>(i % n));
  };
  const double unit = graph.unit() * graph.arc_lengths().mean;

  search.run_from(node(n / 2));
  add();
  search.collect_statistics(true);
  search.run({{node(0), 0, 0}, {node(n / 3), unit, 1}, {node(2 * n / 3), 2.5 * unit, 2}});
  add();
  search.run_further({{node(n / 5), 0, 3}});
  add();
  typename Search::Stop_rule rule;
  rule.maximum_distance = 7 * unit;
  search.run({{node(n / 7)}}, rule);
  add();
  results.add(subject, trees, figures);
}

template <typename GeodesicGraph>
void add_all_queues(const std::string& name, const GeodesicGraph& graph, Golden_results& results)
{
  const std::string prefix = name + ", ";
  add_runs<Buckets>(prefix + "adaptive buckets", graph, results);
  add_runs<Published_buckets>(prefix + "published buckets", graph, results);
  add_runs<Radix_heap>(prefix + "radix heap", graph, results);
  add_runs<Binary_heap>(prefix + "binary heap", graph, results);
  add_runs<Four_ary_heap>(prefix + "4-ary heap", graph, results);
  add_runs<Fibonacci_heap>(prefix + "Fibonacci heap", graph, results);
  add_runs<Pairing_heap>(prefix + "pairing heap", graph, results);
  if(graph.number_of_nodes() <= 500) // it looks at all entries to find the nearest
    add_runs<Array>(prefix + "array", graph, results);
}

} // namespace golden

void add_propagations(const Mesh& mesh, Golden_results& results)
{
  golden::for_each_golden_graph(mesh, [&](const std::string& name, const auto& graph) {
    golden::add_all_queues(name, graph, results);
  });
}

} // namespace geodesics_test
