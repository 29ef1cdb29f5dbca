// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How long exact pairs take once they are prepared, beside searches that are guided by straight
// lines, and searches that only end at the target; and what preparing takes. See --help.

#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_queries/Exact_landmarks.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;

// Which pairs are meant: those whose distance is so large a part of the largest one; of vertices,
// or of points in faces next to such vertices.
struct Kind_of_pair
{
  const char* name;
  double least, most;
  bool is_in_faces;
};
static constexpr Kind_of_pair KINDS[] = {{"near", 0, 0.1, false},
                                         {"middle", 0.4, 0.6, false},
                                         {"far", 0.85, 1, false},
                                         {"far, in faces", 0.85, 1, true}};

class Far_pair_benchmark
{
  using Graph = AG::Saddle_vertex_graph;
  using Search = AG::Surface_search<Graph>;

public:
  Far_pair_benchmark(std::string mesh_name, const Mesh& mesh)
    : m_mesh_name(std::move(mesh_name)),
      m_mesh(mesh),
      m_graph(AG::Intrinsic_triangulation(mesh)),
      m_ending(m_graph),
      m_guided(m_graph),
      m_prepared(m_graph)
  {
    AG::Mesh_translation translation(mesh, get(boost::vertex_index, mesh), m_graph.triangulation());
    translation.list_vertices();
    const auto points = mesh.points();
    m_positions = {m_graph.triangulation(), translation.position_of_vertex(points)};
    m_seconds_of_preparation = seconds_of([this] { m_landmarks.emplace(m_graph); });
    m_prepared.use_landmarks(*m_landmarks);
    for(Search* search : std::initializer_list<Search*>{&m_ending, &m_guided, &m_prepared})
      search->collect_statistics(true);
  }

  void run(const std::size_t number_of_pairs, Table& table)
  {
    for(const Kind_of_pair& kind : KINDS)
      run(kind, number_of_pairs, table);
  }

  void add_preparation(Table& table) const
  {
    const auto vertices = double(m_mesh.number_of_vertices());
    table.add_row()
        .add(m_mesh_name)
        .add(std::to_string(m_mesh.number_of_vertices()))
        .add(m_seconds_of_preparation, 2)
        .add(double(m_landmarks->approximation().memory()) / vertices, 0)
        .add(double(m_landmarks->landmarks().memory()) / vertices, 0)
        .add(double(m_graph.memory()) / vertices, 0);
  }

  static Table empty_table()
  {
    return Table({"mesh", "pairs", "to ms", "guided ms", "p95", "prepared ms", "p95",
                  "to : prepared", "guided : prepared", "nodes to", "guided", "prepared",
                  "other bits"});
  }

  static Table empty_table_of_preparation()
  {
    return Table({"mesh", "vertices", "prepared in s", "graph B/vertex", "landmarks B/vertex",
                  "exact graph B/vertex"});
  }

private:
  // The times and the expanded nodes of one kind of search.
  struct Times
  {
    template <typename F>
    void add(const Search& search, F run)
    {
      seconds.push_back(seconds_of(run));
      nodes.push_back(double(search.search().statistics().settled_nodes));
    }

    double percentile(const std::size_t percent) const
    {
      std::vector<double> sorted = seconds;
      std::sort(sorted.begin(), sorted.end());
      return sorted[(std::min)(sorted.size() * percent / 100, sorted.size() - 1)];
    }

    std::vector<double> seconds, nodes;
  };

  void run(const Kind_of_pair& kind, const std::size_t number_of_pairs, Table& table)
  {
    find_pairs(kind, number_of_pairs);
    Times ending, guided, prepared;
    std::size_t number_different = 0;
    for(const auto& [source, target] : m_pairs)
    {
      const std::vector<AG::Source_point> from = {{source}};
      const auto to = target;
      ending.add(m_ending, [&] {
        m_ending.run(from, {std::numeric_limits<double>::infinity(), {to}});
      });
      guided.add(m_guided, [&] { m_guided.run_to(to, from, m_positions); });
      prepared.add(m_prepared, [&] { m_prepared.run_to(to, from); });
      number_different += m_prepared.distance(to) != m_ending.distance(to) ? 1 : 0;
    }
    table.add_row()
        .add(m_mesh_name)
        .add(kind.name)
        .add(ending.percentile(50) * 1e3, 2)
        .add(guided.percentile(50) * 1e3, 2)
        .add(guided.percentile(95) * 1e3, 2)
        .add(prepared.percentile(50) * 1e3, 2)
        .add(prepared.percentile(95) * 1e3, 2)
        .add(ending.percentile(50) / prepared.percentile(50), 1)
        .add(guided.percentile(50) / prepared.percentile(50), 1)
        .add(median(ending.nodes), 0)
        .add(median(guided.nodes), 0)
        .add(median(prepared.nodes), 0)
        .add(std::to_string(number_different));
  }

  AG::Intrinsic_point point(const Vertex v, const bool is_in_face = false) const
  {
    const AG::Intrinsic_triangulation& t = m_graph.triangulation();
    auto h = t.first_halfedge(t.vertex(v.idx()));
    if(!is_in_face)
      return AG::Intrinsic_point::at_vertex(t.vertex(v.idx()));
    while(t.is_border(h))
      ++h;
    return AG::Intrinsic_point::in_face(h, 0.3, 0.3);
  }

  // By distances in the graph with a bound.
  void find_pairs(const Kind_of_pair& kind, const std::size_t count)
  {
    m_pairs.clear();
    AG::Propagation<AG::Discrete_geodesic_graph> search(m_landmarks->approximation());
    const std::vector<Vertex> candidates = random_vertices(m_mesh, 100000, 2);
    std::size_t next = 0;
    for(const Vertex source : random_sources(m_mesh, count))
    {
      search.run_from(point(source).vertex);
      double largest = 0;
      for(const auto node : search.reached_nodes())
        largest = (std::max)(largest, search.distance(node));
      const auto fits = [&](const Vertex target) {
        const double part = search.distance(point(target).vertex) / largest;
        return part > kind.least && part <= kind.most;
      };
      while(!fits(candidates[next % candidates.size()]))
        ++next;
      m_pairs.emplace_back(point(source, kind.is_in_faces),
                           point(candidates[next++ % candidates.size()], kind.is_in_faces));
    }
  }

  std::string m_mesh_name;
  const Mesh& m_mesh;
  Graph m_graph;
  AG::Vertex_positions m_positions;
  std::optional<AG::Exact_landmarks<Graph>> m_landmarks;
  double m_seconds_of_preparation = 0;
  Search m_ending, m_guided;
  AG::Guided_search<Graph> m_prepared;
  std::vector<AG::Point_pair> m_pairs;
};

int main(int argc, char* argv[])
{
  const auto measure_pairs = [](const Options& options, const Report& report) {
    Table table = Far_pair_benchmark::empty_table(),
          preparation = Far_pair_benchmark::empty_table_of_preparation();
    for(const std::string& name : options.meshes)
    {
      const Mesh mesh = read_mesh(name);
      Far_pair_benchmark benchmark(short_name(name), mesh);
      benchmark.run(options.number_of_rounds, table);
      benchmark.add_preparation(preparation);
    }
    report.print("far_pairs",
                 "Exact pairs: searches that end at the target, those that straight "
                 "lines guide there, and prepared ones (medians of " +
                     std::to_string(options.number_of_rounds) + " pairs, and 95th percentiles)",
                 table);
    report.print("far_pairs_preparation", "What preparing takes", preparation);
  };
  return run_benchmark(argc, argv, "bench_far_pairs", {{"bunny00"}, 41, ""}, measure_pairs);
}
