// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What it is worth to leave out arcs of the discrete geodesic graph that a detour replaces: see the
// manual. The detour may take a share of epsilon: with 0, all vertices in sight have arcs. See
// --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_search.h"

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/stored_arcs.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <cstddef>
#include <string>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
using AG::Intrinsic_triangulation;
using AG::internal::Cone_rules;
using AG::internal::Unfolding;
using Expansion = AG::internal::Cone_expansion<Unfolding>;

static constexpr double EPSILON = 0.1;

// A discrete geodesic graph with another share of detours than usual.
class Graph
{
public:
  using Node = Intrinsic_triangulation::Index;

  Graph(const Intrinsic_triangulation& triangulation, const double share)
    : m_triangulation(triangulation), m_rows(AG::internal::unit_of_arcs(triangulation))
  {
    const Unfolding unfolding(triangulation);
    const Expansion expansion(triangulation, unfolding, Cone_rules(EPSILON, share));
    std::vector<AG::internal::Stored_arc> arcs;
    for(Node node = 0; node < number_of_nodes(); ++node)
    {
      AG::internal::find_stored_arcs(node, m_rows.unit(), arcs, [&](const auto f) {
        expansion.expand(node,
                         [&](const AG::internal::Straight_arc& arc) { f(arc.target, arc.length); });
      });
      m_rows.append_row(arcs);
    }
  }

  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }
  std::size_t number_of_nodes() const { return m_triangulation.number_of_vertices(); }
  std::size_t number_of_arcs() const { return m_rows.number_of_arcs(); }
  std::size_t maximum_degree() const { return m_rows.maximum_degree(); }
  double unit() const { return m_triangulation.unit(); }
  AG::Arc_lengths arc_lengths() const { return m_rows.arc_lengths(); }
  void prefetch(const Node node) const { m_rows.prefetch(node); }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels&, F f) const
  {
    m_rows.for_each_arc(node, f);
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  AG::internal::Compressed_arcs m_rows;
};

// Does what usual expansions do, and counts the windows that they look through.
struct Window_counter : AG::internal::Leave_out_detours
{
  bool prune(const AG::internal::Window&) const
  {
    ++windows;
    return false;
  }
  std::size_t& windows;
};

std::size_t number_of_windows(const Intrinsic_triangulation& triangulation, const double share)
{
  const Unfolding unfolding(triangulation);
  const Expansion expansion(triangulation, unfolding, Cone_rules(EPSILON, share));
  std::size_t result = 0;
  for(Graph::Node node = 0; node < triangulation.number_of_vertices(); ++node)
    expansion.expand(
        node, [](const AG::internal::Straight_arc&) {}, Window_counter{{}, result});
  return result;
}

void compare(const std::string& name, const std::size_t rounds, Table& table)
{
  const Mesh mesh = read_mesh(name);
  const Intrinsic_triangulation triangulation(mesh);
  const auto sources = random_sources(mesh, rounds);
  Exact_search exact(mesh);
  exact.run(sources.front());
  const double n = double(mesh.number_of_vertices());

  for(const double share :
      {0., 0.02, 0.05, Cone_rules::SHARE_OF_DETOURS, 0.2, 0.4, Cone_rules::SHARE_OF_ENDS})
  {
    const Graph graph(triangulation, share);
    AG::Propagation<Graph> search(graph);
    std::vector<double> seconds;
    for(const Vertex source : sources)
      seconds.push_back(seconds_of([&] { search.run_from(triangulation.vertex(source.idx())); }));

    search.run_from(triangulation.vertex(sources.front().idx()));
    Errors errors;
    for(const Vertex v : mesh.vertices())
      errors.add(search.distance(triangulation.vertex(v.idx())), exact.distance(v));
    table.add_row()
        .add(short_name(name))
        .add(share, 2)
        .add(double(number_of_windows(triangulation, share)) / n, 1)
        .add(double(graph.number_of_arcs()) / n, 1)
        .add(median(seconds) * 1e3, 3)
        .add(100 * errors.mean(), 4)
        .add(100 * errors.largest(), 2);
  }
}

int main(int argc, char* argv[])
{
  const auto compare_all = [](const Options& options, const Report& report) {
    Table table(
        {"mesh", "share", "windows/vertex", "arcs/vertex", "search ms", "mean %", "largest %"});
    for(const std::string& name : options.meshes)
      compare(name, options.number_of_rounds, table);
    report.print("detours",
                 "Arcs left out of the graph for epsilon = 0.1 (errors for one source, times as "
                 "medians of " +
                     std::to_string(options.number_of_rounds) + ")",
                 table);
  };
  return run_benchmark(argc, argv, "bench_detours", {usual_meshes(), 31, ""}, compare_all);
}
