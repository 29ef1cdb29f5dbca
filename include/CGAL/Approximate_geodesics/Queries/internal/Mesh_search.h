// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_results.h>
#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>
#include <CGAL/Approximate_geodesics/Queries/internal/with_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Adapts a visitor of vertices to a visitor of nodes.
 */
template <typename Visitor, typename Vertices>
class Vertex_visitor
{
public:
  Vertex_visitor(Visitor& visitor, const Vertices& vertices)
    : m_visitor(visitor), m_vertices(vertices)
  {
  }

  template <typename Node>
  void on_settled(const Node node, const double distance)
  {
    if(m_vertices.is_vertex(node))
      m_visitor.on_settled(m_vertices.vertex(node), distance);
  }

  void on_progress(const std::size_t number_of_settled_nodes, const std::size_t number_of_nodes)
  {
    m_visitor.on_progress(number_of_settled_nodes, number_of_nodes);
  }

  bool go_further() { return m_visitor.go_further(); }

private:
  Visitor& m_visitor;
  const Vertices& m_vertices;
};

template <typename Visitor, typename Vertices>
Vertex_visitor<Visitor, Vertices> make_vertex_visitor(Visitor& visitor, const Vertices& vertices)
{
  return {visitor, vertices};
}

// Overload for a visitor given by reference.
template <typename Visitor, typename Vertices>
Vertex_visitor<Visitor, Vertices> make_vertex_visitor(std::reference_wrapper<Visitor>& visitor,
                                                      const Vertices& vertices)
{
  return {visitor.get(), vertices};
}

// Calls `run` with the visitor of the named parameters, adapted to nodes, or with an idle visitor.
template <typename NamedParameters, typename Vertices, typename Run>
void run_with_visitor([[maybe_unused]] const NamedParameters& np,
                      [[maybe_unused]] const Vertices& vertices,
                      Run run)
{
  if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
  {
    auto visitor = parameters::get_parameter(np, internal_np::visitor);
    run(make_vertex_visitor(visitor, vertices));
  }
  else
    run(Geodesic_visitor_base());
}

/*
 * A search of a graph in terms of a mesh: the common implementation of the class and of the free
 * functions, which reads the named parameters of runs. The translation identifies the mesh.
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

  // Converts a point of the surface, or a range of points.
  template <typename Sources>
  std::vector<Source_point> source_points(const Sources& sources) const
  {
    std::vector<Source_point> result;
    for(const Intrinsic_point& point : intrinsic_points(m_translation, sources, "source"))
      result.push_back({point});
    return result;
  }

  // Searches from a point of the surface, or from a range of points.
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

  // Searches until the distance of `target` is final. Uses A* search with straight-line distances,
  // unless a visitor is given: visitors expect nodes in the order of their distances.
  template <typename Sources, typename Target, typename NamedParameters>
  void run_to(const Sources& sources,
              const Target& target,
              const Vertex_positions& positions,
              const NamedParameters& np)
  {
    std::vector<Source_point> points = source_points(sources);
    const Intrinsic_point end = intrinsic_point(m_translation, target, "target");
    auto stop = stop_rule(np);
    if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    {
      stop.targets.push_back(end);
      run(std::move(points), stop, np);
    }
    else
      m_search.run_to(end, std::move(points), positions, stop.maximum_distance);
  }

  // Returns the positions of the vertices, if the point type belongs to a kernel.
  Vertex_positions positions() const
  {
    if constexpr(is_point_of_kernel<Point>)
      return Vertex_positions(m_search.graph().triangulation(),
                              m_translation.position_of_vertex(m_point_map));
    else
      return Vertex_positions();
  }

  // Returns the path from `point` to its nearest source.
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

  // Writes the distances and the other results requested by named parameters.
  template <typename VertexDistanceMap, typename NamedParameters>
  void write_results(VertexDistanceMap distances, const NamedParameters& np) const
  {
    Vertex_results(m_search.search(), m_translation).write(distances, np);
  }

private:
  using Stop_rule = typename Surface_search::Stop_rule;

  template <typename NamedParameters>
  Stop_rule stop_rule(const NamedParameters& np) const
  {
    return internal::stop_rule<Stop_rule>(m_translation, np);
  }

  // Runs with the visitor of the named parameters, if any.
  template <typename NamedParameters>
  void run(std::vector<Source_point> sources, const Stop_rule& stop, const NamedParameters& np)
  {
    run_with_visitor(np, m_translation,
                     [&](auto&& visitor) { m_search.run(std::move(sources), stop, visitor); });
  }

  const Translation& m_translation;
  VertexPointMap m_point_map;
  Surface_search m_search;
};

// Returns no positions for the edge graph, where computing them takes as long as a search.
template <typename MeshSearch, typename NamedParameters>
Vertex_positions positions_for_one_run(const MeshSearch& search, const NamedParameters& /* np */)
{
  if constexpr(has_crossing_arcs<typename MeshSearch::Surface_search::Graph> &&
               !is_any_given<NamedParameters, internal_np::edge_length_t, internal_np::visitor_t>)
    return search.positions();
  else
    return Vertex_positions();
}

// Calls `f` with a search of a graph built on `tmesh`, for a single run.
template <typename Graph, typename TriangleMesh, typename NamedParameters, typename F>
auto search_graph(const Graph& graph,
                  const TriangleMesh& tmesh,
                  const NamedParameters& np,
                  const bool finds_path,
                  F f)
{
  Mesh_translation translation(tmesh, vertex_index_map(tmesh, np), graph.triangulation());
  if(finds_path ||
     is_any_given<NamedParameters, internal_np::visitor_t, internal_np::geodesic_predecessor_t>)
    translation.list_vertices();
  auto point_map = vertex_point_map(tmesh, np);
  Mesh_search<Graph, Adaptive_bucket_queue, decltype(translation), decltype(point_map)> search(
      graph, translation, std::move(point_map));
  return f(search);
}

// Whether a search runs along edges, and all `Points` and targets are given as vertices.
template <typename TriangleMesh, typename NamedParameters, typename... Points>
constexpr bool concerns_vertices_only()
{
  constexpr bool needs_faces =
      is_any_given<NamedParameters, internal_np::epsilon_t,
                   internal_np::number_of_points_per_edge_t, internal_np::face_weight_t,
                   internal_np::edge_is_constrained_t, internal_np::straighten_t>;
  if constexpr(needs_faces || !(are_vertices<TriangleMesh, Points> && ...))
    return false;
  else if constexpr(is_given<NamedParameters, internal_np::targets_t>)
  {
    using Targets = decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                       internal_np::targets));
    return are_vertices<TriangleMesh, std::decay_t<Targets>>;
  }
  else
    return true;
}

// Reads a mesh, builds the graph that the named parameters select, and calls `f` with a search of
// it, for a single run. Only edges are read if all `Points`, the types of sources and targets, are
// vertices.
template <typename... Points, typename TriangleMesh, typename NamedParameters, typename F>
auto search_once(const TriangleMesh& tmesh, const NamedParameters& np, const bool finds_path, F f)
{
  const auto search = [&](const auto& graph) {
    return search_graph(graph, tmesh, np, finds_path, f);
  };
  if constexpr(concerns_vertices_only<TriangleMesh, NamedParameters, Points...>())
  {
    Intrinsic_triangulation edges;
    Triangulation_builder<TriangleMesh, NamedParameters>(edges, tmesh, np).build_edges();
    return search(Edge_graph(std::move(edges), np));
  }
  else
    return with_graph<Lazy_discrete_geodesic_graph>(tmesh, np, search);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
