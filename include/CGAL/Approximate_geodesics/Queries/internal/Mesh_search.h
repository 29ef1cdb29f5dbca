// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/mesh_traits.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Vertex_predecessors.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_visitor.h>
#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>
#include <CGAL/Approximate_geodesics/Queries/internal/with_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * A search of a graph in words of a mesh: what the class and the free functions have in common.
 * Everything that is read from named parameters is read here. The mesh is known by its translation.
 */
template <typename Graph, typename PriorityQueue, typename Translation, typename VertexPointMap>
class Mesh_search
{
  using Triangle_mesh = typename Translation::Triangle_mesh;
  using vertex_descriptor = typename boost::graph_traits<Triangle_mesh>::vertex_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  using Surface_search = Approximate_geodesics::Surface_search<Graph, PriorityQueue>;
  using Node = typename Surface_search::Node;

  // The graph and the translation are referred to, not copied.
  Mesh_search(const Graph& graph, const Translation& translation, VertexPointMap point_map)
    : m_translation(translation), m_point_map(std::move(point_map)), m_search(graph)
  {
  }

  const Translation& translation() const { return m_translation; }
  const VertexPointMap& point_map() const { return m_point_map; }
  const Surface_search& search() const { return m_search; }
  Surface_search& search() { return m_search; }

  // Runs

  // From one point of the surface, or from a range of them.
  template <typename Sources, typename NamedParameters>
  void run_from(const Sources& sources, const NamedParameters& np)
  {
    std::vector<Source_point> points = source_points(sources);
    set_initial_distances(np, points);
    run(std::move(points), np);
  }

  template <typename NamedParameters>
  void run(std::vector<Source_point> sources, const NamedParameters& np)
  {
    run(std::move(sources), stop_rule(np), np);
  }

  // Until the distance of `target` is final. Straight lines lead the search there, unless a visitor
  // is given, who would not learn of nodes in the order of their distances.
  template <typename Sources, typename Target, typename NamedParameters>
  void run_to(const Sources& sources,
              const Target& target,
              const Vertex_positions& positions,
              const NamedParameters& np)
  {
    std::vector<Source_point> points = source_points(sources);
    const Intrinsic_point end = m_translation.intrinsic_point(target);
    auto stop = stop_rule(np);
    if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    {
      stop.targets.push_back(end);
      run(std::move(points), stop, np);
    }
    else
      m_search.run_to(end, std::move(points), positions, stop.maximum_distance);
  }

  // The positions of the vertices, if they are those of a kernel.
  Vertex_positions positions() const
  {
    if constexpr(is_point_of_kernel<Point>)
      return Vertex_positions(m_search.graph().triangulation(),
                              m_translation.position_of_vertex(m_point_map));
    else
      return Vertex_positions();
  }

  // Results

  // From `point` to its nearest source.
  template <typename NamedParameters>
  Path find_path(const Intrinsic_point& point, const NamedParameters& np) const
  {
    Path result = m_search.find_path(point);
    straighten_if_wanted(m_search.graph().triangulation(), np, result);
    return result;
  }

  template <typename NamedParameters>
  Point point(const Intrinsic_point& p, const NamedParameters& np) const
  {
    return internal::point(m_translation, p, m_point_map, np);
  }

  // Writes the distances, and what else the named parameters ask for. All memory for that is
  // allocated before anything is written.
  template <typename VertexDistanceMap, typename NamedParameters>
  void write_results(VertexDistanceMap distances, const NamedParameters& np) const
  {
    if constexpr(is_given<NamedParameters, internal_np::geodesic_predecessor_t>)
    {
      Vertex_predecessors<typename Surface_search::Search> predecessors(m_search.search());
      write_distances_and_sources(distances, np);
      write_predecessors(predecessors, np);
    }
    else
      write_distances_and_sources(distances, np);
  }

private:
  using Stop_rule = typename Surface_search::Stop_rule;

  template <typename Sources>
  std::vector<Source_point> source_points(const Sources& sources) const
  {
    std::vector<Source_point> result;
    if constexpr(is_surface_point<Triangle_mesh, Sources>)
      result.push_back({m_translation.intrinsic_point(sources)});
    else
      for(const auto& source : sources)
        result.push_back({m_translation.intrinsic_point(source)});
    return result;
  }

  template <typename NamedParameters>
  Stop_rule stop_rule(const NamedParameters& np) const
  {
    return internal::stop_rule<Stop_rule>(m_translation, np);
  }

  // Under the visitor that the named parameters give, if any.
  template <typename NamedParameters>
  void run(std::vector<Source_point> sources,
           const Stop_rule& stop,
           [[maybe_unused]] const NamedParameters& np)
  {
    if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    {
      auto visitor = parameters::get_parameter(np, internal_np::visitor);
      m_search.run(std::move(sources), stop, make_vertex_visitor(visitor, m_translation));
    }
    else
      m_search.run(std::move(sources), stop);
  }

  template <typename NamedParameters>
  static void set_initial_distances([[maybe_unused]] const NamedParameters& np,
                                    [[maybe_unused]] std::vector<Source_point>& sources)
  {
    if constexpr(is_given<NamedParameters, internal_np::initial_distances_t>)
    {
      std::size_t number = 0;
      for(const auto& distance : parameters::get_parameter(np, internal_np::initial_distances))
      {
        if(number < sources.size())
          sources[number].distance = CGAL::to_double(distance);
        ++number;
      }
      if(number != sources.size())
        reject("there are " + std::to_string(number) + " initial distances, and " +
               std::to_string(sources.size()) + " sources");
    }
  }

  template <typename VertexDistanceMap, typename NamedParameters>
  void write_distances_and_sources(VertexDistanceMap distances,
                                   [[maybe_unused]] const NamedParameters& np) const
  {
    const auto& search = m_search.search();
    constexpr bool with_sources = is_given<NamedParameters, internal_np::nearest_source_t>;
    if constexpr(with_sources)
      allocate_sources();
    for(const vertex_descriptor v : vertices(m_translation.mesh()))
      put(distances, v, search.distance(m_translation.node(v)));
    if constexpr(with_sources)
    {
      const auto sources = parameters::get_parameter(np, internal_np::nearest_source);
      using Value = typename boost::property_traits<std::decay_t<decltype(sources)>>::value_type;
      for(const vertex_descriptor v : vertices(m_translation.mesh()))
        put(sources, v, static_cast<Value>(search.source(m_translation.node(v))));
    }
  }

  // What the first question for a source allocates is enough for all.
  void allocate_sources() const
  {
    const auto& search = m_search.search();
    for(const Node node : search.reached_nodes())
      if(search.source(node) != Surface_search::null_source)
        return;
  }

  template <typename Predecessors, typename NamedParameters>
  void write_predecessors(Predecessors& predecessors, const NamedParameters& np) const
  {
    const auto map = parameters::get_parameter(np, internal_np::geodesic_predecessor);
    for(const vertex_descriptor v : vertices(m_translation.mesh()))
      put(map, v, predecessor(v, predecessors));
  }

  template <typename Predecessors>
  vertex_descriptor predecessor(const vertex_descriptor v, Predecessors& predecessors) const
  {
    const Node node = m_translation.node(v);
    if(!m_search.search().is_reached(node))
      return boost::graph_traits<Triangle_mesh>::null_vertex();
    const Node before = predecessors(node);
    return before == Surface_search::Search::null_node ? v : m_translation.vertex(before);
  }

  const Translation& m_translation;
  VertexPointMap m_point_map;
  Surface_search m_search;
};

// Where arcs are edges, finding positions takes as long as the whole search.
template <typename MeshSearch, typename NamedParameters>
Vertex_positions positions_for_one_run(const MeshSearch& search, const NamedParameters& /* np */)
{
  if constexpr(has_crossing_arcs<typename MeshSearch::Surface_search::Graph> &&
               !is_any_given<NamedParameters, internal_np::edge_length_t, internal_np::visitor_t>)
    return search.positions();
  else
    return Vertex_positions();
}

// Reads a mesh, builds the graph that the named parameters ask for, and calls `f` with a search of
// it: for a run on a mesh that is not seen again.
template <typename TriangleMesh, typename NamedParameters, typename F>
auto search_once(const TriangleMesh& tmesh, const NamedParameters& np, const bool finds_path, F f)
{
  return with_graph<Lazy_discrete_geodesic_graph>(tmesh, np, [&](const auto& graph) {
    Mesh_translation translation(tmesh, vertex_index_map(tmesh, np), graph.triangulation());
    if(finds_path ||
       is_any_given<NamedParameters, internal_np::visitor_t, internal_np::geodesic_predecessor_t>)
      translation.list_vertices();
    auto point_map = vertex_point_map(tmesh, np);
    Mesh_search<std::decay_t<decltype(graph)>, Adaptive_bucket_queue, decltype(translation),
                decltype(point_map)>
        search(graph, translation, std::move(point_map));
    return f(search);
  });
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
