// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The adaptive bucket queue against all other queues on the same graph, against Boost's Dijkstra on
// the mesh, and against Dijkstra with std::priority_queue and breadth-first search on the same
// arrays. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Boost_dijkstra.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"
#include "peers/searches_of_arrays.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

class Queue_benchmark
{
public:
  Queue_benchmark(const std::string& name, const std::size_t number_of_rounds)
    : m_name(short_name(name)),
      m_mesh(read_mesh(name)),
      m_sources(random_sources(m_mesh, number_of_rounds)),
      m_graph(AG::Intrinsic_triangulation(m_mesh)),
      m_boost(m_mesh)
  {
  }

  void run()
  {
    Breadth_first_search breadth_first(m_graph.triangulation());
    Priority_queue_dijkstra priority_queue(m_graph.triangulation());
    AG::Propagation<AG::Edge_graph> search(m_graph);
    add("adaptive buckets", search);
    add("breadth first", breadth_first);
    add("std::priority_queue", priority_queue);
    add<AG::Published_bucket_queue>("published buckets");
    add<AG::Radix_heap_queue>("radix heap");
    add<AG::D_ary_heap_queue<4>>("4-ary heap");
    add<AG::Binary_heap_queue>("binary heap");
    add<AG::Pairing_heap_queue>("pairing heap");
    add<AG::Fibonacci_heap_queue>("Fibonacci heap");
    if(m_mesh.number_of_vertices() < LARGEST_FOR_ARRAY)
      add<AG::Array_queue>("array");
    m_names.push_back("Boost on the mesh");
    m_contest.add([&](const auto round) { m_boost.run(m_sources[round]); });
    m_contest.run(m_sources.size(), 5);

    // the last runs of all contestants had the same source
    check_distances(m_mesh, search, m_boost.distances());
    for(const auto& check : m_checks)
      check(search, priority_queue);
    m_memory = m_graph.memory() + search.memory();

    search.collect_statistics(true);
    search.run_from(node(0));
    const AG::Propagation_statistics& s = search.statistics();
    m_expansions = double(s.pops - s.stale_pops) / double(s.settled_nodes);
  }

  static std::vector<std::string> header_of_times()
  {
    return {"mesh",
            "vertices",
            "adaptive buckets",
            "breadth first",
            "published buckets",
            "radix heap",
            "4-ary heap",
            "binary heap",
            "pairing heap",
            "Fibonacci heap",
            "array",
            "std::priority_queue",
            "Boost on the mesh"};
  }

  void add_times(Table& table) const
  {
    Table::Row row = table.add_row();
    row.add(m_name).add(double(m_mesh.number_of_vertices()), 0);
    const auto header = header_of_times();
    for(auto name = header.begin() + 2; name != header.end(); ++name)
      if(std::count(m_names.begin(), m_names.end(), *name) > 0)
        row.add(seconds(*name) * 1e3, 3);
      else
        row.add("-");
  }

  static std::vector<std::string> header_of_ratios()
  {
    return {"mesh",
            "Fibonacci heap : ours",
            "fastest heap",
            "fastest heap : ours",
            "Boost : ours",
            "ours : breadth first",
            "published : ours",
            "Fibonacci heap : published",
            "expansions/vertex",
            "bytes/vertex"};
  }

  void add_ratios(Table& table) const
  {
    std::string fastest = "std::priority_queue";
    for(const std::string& name : m_names)
      if(name.find("heap") != std::string::npos && seconds(name) < seconds(fastest))
        fastest = name;
    const std::string ours = "adaptive buckets";
    table.add_row()
        .add(m_name)
        .add(seconds("Fibonacci heap") / seconds(ours), 2)
        .add(fastest)
        .add(seconds(fastest) / seconds(ours), 2)
        .add(seconds("Boost on the mesh") / seconds(ours), 2)
        .add(seconds(ours) / seconds("breadth first"), 2)
        .add(seconds("published buckets") / seconds(ours), 2)
        .add(seconds("Fibonacci heap") / seconds("published buckets"), 2)
        .add(m_expansions, 4)
        .add(double(m_memory) / double(m_mesh.number_of_vertices()), 1);
  }

private:
  static constexpr std::size_t LARGEST_FOR_ARRAY = 200000; // it would take minutes

  AG::Edge_graph::Node node(const std::size_t round) const
  {
    return m_graph.triangulation().vertex(m_sources[round]);
  }

  template <typename Search>
  void add(const std::string& name, Search& search)
  {
    m_names.push_back(name);
    m_contest.add([this, &search](const auto round) { search.run_from(node(round)); });
  }

  template <typename Queue>
  void add(const std::string& name)
  {
    m_names.push_back(name);
    const auto search = std::make_shared<AG::Propagation<AG::Edge_graph, Queue>>(m_graph);
    m_contest.add([this, search](const auto round) { search->run_from(node(round)); });
    m_checks.push_back([this, name, search](const auto& ours, const auto& priority_queue) {
      for(AG::Edge_graph::Node n = 0; n < m_graph.number_of_nodes(); ++n)
        if(search->distance(n) != ours.distance(n) ||
           priority_queue.distance(n) * m_graph.triangulation().unit() != ours.distance(n))
          throw std::runtime_error("the distances of node " + std::to_string(n) +
                                   " differ: " + name);
    });
  }

  double seconds(const std::string& name) const
  {
    const auto position = std::find(m_names.begin(), m_names.end(), name);
    return m_contest.median_seconds(std::size_t(position - m_names.begin()));
  }

  std::string m_name;
  Mesh m_mesh;
  std::vector<Vertex> m_sources;
  AG::Edge_graph m_graph;
  Boost_dijkstra m_boost;
  std::size_t m_memory = 0;
  double m_expansions = 0;
  using Check =
      std::function<void(const AG::Propagation<AG::Edge_graph>&, const Priority_queue_dijkstra&)>;
  std::vector<Check> m_checks;      // that distances are the same, to the last bit
  std::vector<std::string> m_names; // of the contestants
  Contest m_contest;
};

int main(int argc, char* argv[])
{
  const auto compare_queues = [](const Options& options, const Report& report) {
    Table times(Queue_benchmark::header_of_times());
    Table ratios(Queue_benchmark::header_of_ratios());
    for(const std::string& name : options.meshes)
    {
      Queue_benchmark benchmark(name, options.number_of_rounds);
      benchmark.run();
      benchmark.add_times(times);
      benchmark.add_ratios(ratios);
    }
    report.print("queues",
                 "Milliseconds for one source, graph and workspace built before (medians of " +
                     std::to_string(options.number_of_rounds) + " sources)",
                 times);
    report.print("ratios", "Ratios of these", ratios);
  };
  return run_benchmark(argc, argv, "bench_queues", {usual_meshes(), 31, ""}, compare_queues);
}
