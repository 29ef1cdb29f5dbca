// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One call of the free function, with everything included, against Boost's Dijkstra on the mesh,
// including the computation of the edges' lengths; and what each step of a call takes. See --help.

#include "measuring/measure.h"
#include "measuring/threads.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Boost_dijkstra.h"
#include "peers/searches_of_arrays.h"

#include <CGAL/approximate_geodesic_distances.h>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using Distances = Mesh::Property_map<Vertex, double>;

// ----- one call

// A source of this type may be any point, and makes the function build a triangulation.
using Any_point = AG::Surface_point<Mesh>;

void compare(Mesh& mesh, const std::string& name, const std::size_t rounds, Table& table)
{
  const auto sources = random_sources(mesh, rounds);
  Boost_dijkstra boost(mesh);
  const auto distances = mesh.add_property_map<Vertex, double>("v:ours").first;
  Contest contest;
  const auto ours = contest.add([&](const auto round) {
    CGAL::approximate_geodesic_distances(mesh, distances, sources[round]);
  });
  const auto with_triangulation = contest.add([&](const auto round) {
    CGAL::approximate_geodesic_distances(mesh, distances, Any_point(sources[round]));
  });
  const auto theirs = contest.add([&](const auto round) {
    boost.compute_lengths();
    boost.run(sources[round]);
  });
  contest.run(rounds);

  table.add_row()
      .add(name)
      .add(double(mesh.number_of_vertices()), 0)
      .add(contest.median_seconds(ours) * 1e3, 3)
      .add(contest.median_seconds(with_triangulation) * 1e3, 3)
      .add(contest.median_seconds(theirs) * 1e3, 3)
      .add(contest.ratio(ours, theirs), 2)
      .add(contest.ratio(with_triangulation, theirs), 2);
}

// ----- its steps

// Takes the times of steps that follow each other, round by round.
class Steps
{
public:
  explicit Steps(const std::size_t number) : m_seconds(number) {}

  void start() { m_next = 0; }

  template <typename F>
  double time(F f)
  {
    return add(seconds_of(f));
  }

  double add(const double seconds)
  {
    m_seconds[m_next++].push_back(seconds);
    return seconds;
  }

  Table::Row add_to(Table& table, const std::string& name) const
  {
    auto row = table.add_row();
    row.add(name);
    double sum = 0;
    for(const std::vector<double>& seconds : m_seconds)
    {
      sum += median(seconds);
      row.add(median(seconds) * 1e3, 3);
    }
    row.add(sum * 1e3, 3);
    return row;
  }

private:
  std::vector<std::vector<double>> m_seconds;
  std::size_t m_next = 0;
};

// `read` returns a triangulation, or only its edges.
template <typename Read>
void take_steps(
    const Mesh& mesh, const Vertex source, Distances distances, const Read& read, Steps& steps)
{
  std::unique_ptr<AG::Intrinsic_triangulation> triangulation;
  std::unique_ptr<AG::Edge_graph> graph;
  std::unique_ptr<AG::Propagation<AG::Edge_graph>> search;
  const auto node = [&](const Vertex v) { return graph->triangulation().vertex(v); };
  steps.start();
  steps.time([&] { triangulation = std::make_unique<AG::Intrinsic_triangulation>(read()); });
  steps.time([&] { graph = std::make_unique<AG::Edge_graph>(std::move(*triangulation)); });
  steps.time([&] { search = std::make_unique<AG::Propagation<AG::Edge_graph>>(*graph); });
  steps.time([&] { search->run_from(node(source)); });
  steps.time([&] {
    for(const Vertex v : mesh.vertices())
      distances[v] = search->distance(node(v));
  });
}

AG::Intrinsic_triangulation edges_of(const Mesh& mesh)
{
  const auto np = CGAL::parameters::default_values();
  AG::Intrinsic_triangulation result;
  AG::internal::Triangulation_builder<Mesh, std::decay_t<decltype(np)>>(result, mesh, np)
      .try_to_build_edges();
  return result;
}

// What the constructor does one after the other, and what it takes as a whole: the rest is for
// lengths and thin faces.
void take_steps_of_triangulation(const Mesh& mesh, Steps& steps)
{
  using namespace AG::internal;
  const auto np = CGAL::parameters::default_values();
  Mesh_links links(mesh, vertex_index_map(mesh, np), halfedge_index_map(mesh, np));
  Connectivity connectivity;
  steps.start();
  double rest = -steps.time([&] {
    links.read();
    links.write(connectivity);
  });
  rest -= steps.time([&] {
    Vertex_order order(connectivity);
    for(const Vertex root : mesh.vertices())
      order.add_component(links.index(root));
    order.finish();
  });
  std::unique_ptr<AG::Intrinsic_triangulation> triangulation;
  rest += seconds_of([&] { triangulation = std::make_unique<AG::Intrinsic_triangulation>(mesh); });
  steps.add(rest);
}

void measure_steps_of_triangulation(const Mesh& mesh,
                                    const std::string& name,
                                    const std::size_t rounds,
                                    Table& table)
{
  Steps steps(3);
  for(std::size_t round = 0; round < rounds; ++round)
    take_steps_of_triangulation(mesh, steps);
  steps.add_to(table, name);
}

// The first answer across faces, by so many threads; and what a search along edges takes with
// `std::priority_queue`, once the triangulation is there.
void measure_steps_across_faces(const Mesh& mesh,
                                const std::string& name,
                                const std::size_t rounds,
                                const double epsilon,
                                const std::size_t number_of_threads,
                                Table& table)
{
  using Graph = AG::Lazy_discrete_geodesic_graph;
  Steps steps(4);
  std::vector<double> calls, peers;
  with_threads(number_of_threads, [&](const auto tag) {
    const auto np = CGAL::parameters::epsilon(epsilon).concurrency_tag(tag);
    for(const Vertex source : random_sources(mesh, rounds))
    {
      std::unique_ptr<AG::Intrinsic_triangulation> triangulation;
      std::unique_ptr<Graph> graph;
      std::unique_ptr<AG::Propagation<Graph>> search;
      steps.start();
      double call = 0;
      call += steps.time(
          [&] { triangulation = std::make_unique<AG::Intrinsic_triangulation>(mesh, np); });
      call += steps.time([&] { graph = std::make_unique<Graph>(std::move(*triangulation), np); });
      call += steps.time([&] { search = std::make_unique<AG::Propagation<Graph>>(*graph); });
      const auto node = graph->triangulation().vertex(source.idx());
      call += steps.time([&] { search->run_from(node); });
      calls.push_back(call);
      Priority_queue_dijkstra peer(graph->triangulation());
      peers.push_back(seconds_of([&] { peer.run_from(node); }));
    }
  });
  steps
      .add_to(table,
              name + ", " + Table::text_of(epsilon, 1) + ", " + std::to_string(number_of_threads))
      .add(median(peers) * 1e3, 3)
      .add(median(calls) / median(peers), 2);
}

void measure_steps(
    Mesh& mesh, const std::string& name, const std::size_t rounds, Table& table, Table& before)
{
  const auto distances = mesh.add_property_map<Vertex, double>("v:steps").first;
  Steps steps(5), steps_before(5);
  for(const Vertex source : random_sources(mesh, rounds))
  {
    take_steps(
        mesh, source, distances, [&] { return edges_of(mesh); }, steps);
    take_steps(
        mesh, source, distances, [&] { return AG::Intrinsic_triangulation(mesh); }, steps_before);
  }
  steps.add_to(table, name);
  steps_before.add_to(before, name);
}

int main(int argc, char* argv[])
{
  const auto compare_all = [](const Options& options, const Report& report) {
    const std::size_t rounds = options.number_of_rounds;
    Table calls({"mesh", "vertices", "free function ms", "with triangulation ms", "Boost ms",
                 "ours : Boost", "with triangulation : Boost"});
    Table steps({"mesh", "edges", "graph", "workspace", "search", "results", "sum"});
    Table before({"mesh", "triangulation", "graph", "workspace", "search", "results", "sum"});
    Table building({"mesh", "links", "order", "lengths", "sum"});
    Table across({"mesh, epsilon, threads", "triangulation", "unfolding", "workspace", "search",
                  "sum", "std::priority_queue", "sum : that"});
    for(const std::string& name : options.meshes)
    {
      Mesh mesh = read_mesh(name);
      compare(mesh, short_name(name), rounds, calls);
      measure_steps(mesh, short_name(name), rounds, steps, before);
      measure_steps_of_triangulation(mesh, short_name(name), rounds, building);
      for(const double epsilon : {0.5, 0.2, 0.1})
        measure_steps_across_faces(mesh, short_name(name), rounds, epsilon, 1, across);
      if(HAS_THREADS)
        measure_steps_across_faces(mesh, short_name(name), rounds, 0.1, 2, across);
    }
    const std::string medians = "medians of " + std::to_string(rounds) + " sources";
    report.print("single_call", "One call with everything included (" + medians + ")", calls);
    report.print("single_call_steps", "Its steps, in milliseconds (" + medians + ")", steps);
    report.print("single_call_steps_with_triangulation",
                 "The steps of a call that builds a triangulation, as is needed for points that "
                 "are not vertices (" +
                     medians + ")",
                 before);
    report.print("single_call_triangulation",
                 "The steps of building that triangulation (" + medians + ")", building);
    report.print("single_call_across_faces",
                 "The steps of a call across faces, beside a search along edges of a triangulation "
                 "that is there (" +
                     medians + ")",
                 across);
  };
  return run_benchmark(argc, argv, "bench_single_call", {usual_meshes(), 31, ""}, compare_all);
}
