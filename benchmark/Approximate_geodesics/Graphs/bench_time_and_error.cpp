// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors against time, for all graphs from that of edges to that of exact distances, beside CGAL's
// heat method and exact class. See --help.

#include "measuring/Errors.h"
#include "measuring/measure.h"
#include "meshes/Mesh.h"
#include "output/Options.h"
#include "output/Table.h"
#include "peers/Exact_case.h"
#include "peers/Exact_search.h"

#ifdef CGAL_EIGEN3_ENABLED
#include "peers/Heat_search.h"
#endif

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

// All methods take turns, with the same sources. A first source is one call of the function with
// everything included, or, where no function takes the graph, preparing and searching it.
class Error_benchmark
{
public:
  Error_benchmark(const std::string& name, const std::size_t number_of_rounds)
    : m_mesh(read_mesh(name)),
      m_expected(name, m_mesh, random_sources(m_mesh, number_of_rounds)),
      m_triangulation(m_mesh),
      m_distance(m_mesh.add_property_map<Vertex, double>("v:distance").first)
  {
    add_graphs();
    add_peers();
    m_first.run(number_of_rounds);
    m_prepare.run(number_of_rounds);
    m_further.run(number_of_rounds);
  }

  Table table() const
  {
    Table result({"method", "parameter", "first ms", "prepare ms", "further ms", "mean %",
                  "largest %", "bytes/vertex"});
    for(std::size_t i = 0; i < m_methods.size(); ++i)
    {
      const Errors errors = this->errors(m_methods[i]);
      result.add_row()
          .add(m_methods[i].name)
          .add(m_methods[i].parameter)
          .add(m_first.median_seconds(i) * 1e3, 2)
          .add(m_prepare.median_seconds(i) * 1e3, 2)
          .add(m_further.median_seconds(i) * 1e3, 2)
          .add(errors.mean() * 100, 5)
          .add((std::max)(errors.largest(), -errors.least()) * 100, 4)
          .add_if(m_methods[i].bytes > 0,
                  double(m_methods[i].bytes) / double(m_mesh.number_of_vertices()), 0);
    }
    return result;
  }

private:
  struct Method
  {
    std::string name, parameter;
    std::function<void(Vertex)> run;
    std::function<double(Vertex)> distance; // in the last run
    std::size_t bytes = 0;                  // of the graph, if there is one
  };

  template <typename Number>
  static std::string text_of(const Number number)
  {
    std::ostringstream text;
    text << number;
    return text.str();
  }

  void add_graphs()
  {
    add_graph<AG::Edge_graph>("edges", "-", parameters::default_values());
    for(const unsigned number : {1u, 2u, 3u, 5u, 8u})
      add_graph<AG::Steiner_graph<AG::Fixed_number_of_points>>(
          "points", text_of(number), parameters::number_of_points_per_edge(number));
    for(const double epsilon : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01})
      add_graph<AG::Discrete_geodesic_graph>("built", text_of(epsilon),
                                             parameters::epsilon(epsilon));
    for(const double epsilon : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001})
      add_graph<AG::Lazy_discrete_geodesic_graph>("lazy", text_of(epsilon),
                                                  parameters::epsilon(epsilon));
    add_graph<AG::Saddle_vertex_graph>("exact", "-", parameters::default_values());
  }

  void add_peers()
  {
#ifdef CGAL_EIGEN3_ENABLED
    add_peer<Heat_search>("heat");
#endif
    add_peer<Exact_search>("exact class");
  }

  template <typename Graph, typename NamedParameters>
  void add_graph(const std::string& name, const std::string& parameter, const NamedParameters& np)
  {
    const auto graph = std::make_shared<Graph>(m_triangulation, np);
    const auto search = std::make_shared<AG::Propagation<Graph>>(*graph);
    const auto node = [graph](const Vertex v) { return graph->triangulation().vertex(v.idx()); };
    m_first.add(
        [this, np](const auto round) { run_first<Graph>(m_expected.sources()[round], np); });
    m_prepare.add([this, np](auto) { Graph(AG::Intrinsic_triangulation(m_mesh), np); });
    add({name, parameter, [search, node](const Vertex source) { search->run_from(node(source)); },
         [search, node](const Vertex v) { return search->distance(node(v)); }, graph->memory()});
  }

  template <typename Graph, typename NamedParameters>
  void run_first(const Vertex source, const NamedParameters& np) const
  {
    if constexpr(std::is_same_v<Graph, AG::Discrete_geodesic_graph>)
    {
      const Graph graph(AG::Intrinsic_triangulation(m_mesh), np);
      AG::Propagation<Graph>(graph).run_from(graph.triangulation().vertex(source.idx()));
    }
    else if constexpr(std::is_same_v<Graph, AG::Saddle_vertex_graph>)
      CGAL::approximate_geodesic_distances(m_mesh, m_distance, source, parameters::epsilon(0));
    else
      CGAL::approximate_geodesic_distances(m_mesh, m_distance, source, np);
  }

  template <typename Search>
  void add_peer(const std::string& name)
  {
    const auto search = std::make_shared<Search>(m_mesh);
    m_first.add([this](const auto round) { Search(m_mesh).run(m_expected.sources()[round]); });
    m_prepare.add([this](auto) { Search{m_mesh}; });
    add({name, "-", [search](const Vertex source) { search->run(source); },
         [search](const Vertex v) { return search->distance(v); }});
  }

  void add(Method method)
  {
    m_further.add([this, run = method.run](const auto round) { run(m_expected.sources()[round]); });
    m_methods.push_back(std::move(method));
  }

  Errors errors(const Method& method) const
  {
    Errors result;
    for(std::size_t i = 0; i < m_expected.sources().size(); ++i)
    {
      method.run(m_expected.sources()[i]);
      for(const Vertex v : m_mesh.vertices())
        result.add(method.distance(v), m_expected.distance(i, v));
    }
    return result;
  }

  Mesh m_mesh;
  Exact_case m_expected;
  AG::Intrinsic_triangulation m_triangulation;
  Mesh::Property_map<Vertex, double> m_distance; // of calls of the function
  std::vector<Method> m_methods;
  Contest m_first, m_prepare, m_further;
};

int main(int argc, char* argv[])
{
  const auto measure = [](const Options& options, const Report& report) {
    const std::string& name = options.meshes.front();
    report.print("time_and_error",
                 "Errors against time on " + short_name(name) +
                     ": a first source with everything included; what is prepared once, and a "
                     "further source (medians of " +
                     std::to_string(options.number_of_rounds) + ")",
                 Error_benchmark(name, options.number_of_rounds).table());
  };
  return run_benchmark(argc, argv, "bench_time_and_error", {usual_meshes(), 5, ""}, measure);
}
