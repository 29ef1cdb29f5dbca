// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
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

// Writes `value(v, node)` for each vertex of a mesh and its node. If a part of the mesh was
// searched, vertices outside the part have the null node.
template <typename Translation, typename VertexMap, typename F>
void put_for_all(const Translation& translation, VertexMap map, const F& value)
{
  using Triangle_mesh = typename Translation::Triangle_mesh;
  for(const auto v : vertices(whole(translation.mesh())))
  {
    bool has_node = true;
    if constexpr(is_part<Triangle_mesh>)
      has_node = translation.mesh().number(v) != Triangle_mesh::null_index;
    put(map, v, value(v, has_node ? translation.node(v) : Intrinsic_triangulation::null_index));
  }
}

template <typename Search,
          typename Translation,
          typename VertexDistanceMap,
          typename NamedParameters>
void write_distances_and_sources(const Search& search,
                                 const Translation& translation,
                                 VertexDistanceMap distances,
                                 [[maybe_unused]] const NamedParameters& np)
{
  constexpr bool with_sources = is_given<NamedParameters, internal_np::nearest_source_t>;
  if constexpr(with_sources)
    for(const auto node : search.reached_nodes())
      if(search.source(node) != Search::null_source)
        break; // the first source that is found allocates memory for all
  put_for_all(translation, distances, [&](auto /* vertex */, const auto node) {
    return node == Search::null_node ? std::numeric_limits<double>::infinity()
                                     : search.distance(node);
  });
  if constexpr(with_sources)
  {
    const auto map = parameters::get_parameter(np, internal_np::nearest_source);
    using Value = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
    put_for_all(translation, map, [&](auto /* vertex */, const auto node) {
      return static_cast<Value>(node == Search::null_node ? Search::null_source
                                                          : search.source(node));
    });
  }
}

// Writes the distances of a search, and the other results requested by named parameters, to
// property maps. All memory is allocated before the first write.
template <typename Search,
          typename Translation,
          typename VertexDistanceMap,
          typename NamedParameters>
void write_results(const Search& search,
                   const Translation& translation,
                   VertexDistanceMap distances,
                   const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::geodesic_predecessor_t>)
  {
    using Graph_traits = boost::graph_traits<typename Translation::Triangle_mesh>;
    using vertex_descriptor = typename Graph_traits::vertex_descriptor;
    Vertex_predecessors<Search> predecessors(search);
    write_distances_and_sources(search, translation, distances, np);
    put_for_all(translation, parameters::get_parameter(np, internal_np::geodesic_predecessor),
                [&](const vertex_descriptor v, const auto node) -> vertex_descriptor {
                  if(node == Search::null_node || !search.is_reached(node))
                    return Graph_traits::null_vertex();
                  const auto before = predecessors(node);
                  return before == Search::null_node ? v : translation.vertex(before);
                });
  }
  else
    write_distances_and_sources(search, translation, distances, np);
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
    internal::write_results(m_search.search(), m_translation, distances, np);
  }

private:
  using Stop_rule = typename Surface_search::Stop_rule;

  // Reads the named parameters that limit a run.
  template <typename NamedParameters>
  Stop_rule stop_rule(const NamedParameters& np) const
  {
    Stop_rule result{maximum_distance(np)};
    if constexpr(is_given<NamedParameters, internal_np::targets_t>)
      result.targets = intrinsic_points(
          m_translation, parameters::get_parameter(np, internal_np::targets), "target");
    return result;
  }

  // Runs with the visitor of the named parameters, if any.
  template <typename NamedParameters>
  void run(std::vector<Source_point> sources, const Stop_rule& stop, const NamedParameters& np)
  {
    if constexpr(is_given<NamedParameters, internal_np::visitor_t>)
    {
      auto visitor = parameters::get_parameter(np, internal_np::visitor);
      m_search.run(std::move(sources), stop,
                   Vertex_visitor(std::ref(visitor).get(), m_translation));
    }
    else
    {
      Geodesic_visitor_base visitor; // as in the compiled searches
      m_search.run(std::move(sources), stop, visitor);
    }
  }

  const Translation& m_translation;
  VertexPointMap m_point_map;
  Surface_search m_search;
};

/*
 * Point-to-point searches with a separate workspace, which is allocated on first use.
 */
template <typename MeshSearch>
class Pair_search
{
public:
  // Uses the graph and the mesh of `other`. Returns -1 if there is no path.
  template <typename Source, typename Target, typename NamedParameters>
  double distance(const MeshSearch& other,
                  const Source& source,
                  const Target& target,
                  const NamedParameters& np)
  {
    if constexpr(is_given<NamedParameters, internal_np::straighten_t>)
      return for_each_point(other, source, target, np, [](const Intrinsic_point&) {});
    else
    {
      const Intrinsic_point end = run(other, source, target, np);
      const auto answer = m_parts->search.search().nearest(end);
      return answer.is_reached() ? answer.distance : -1;
    }
  }

  // Calls `f(point)` for the points of the path. Returns its length, or -1 if there is no path.
  template <typename Source, typename Target, typename NamedParameters, typename F>
  double for_each_point(const MeshSearch& other,
                        const Source& source,
                        const Target& target,
                        const NamedParameters& np,
                        F f)
  {
    const Intrinsic_point end = run(other, source, target, np);
    const Path path = m_parts->search.find_path(end, np);
    if(leads_to_sources(other.search().graph()))
      std::for_each(path.points.begin(), path.points.end(), f);
    else
      std::for_each(path.points.rbegin(), path.points.rend(), f);
    return path.points.empty() ? -1 : path.length;
  }

  // Must be called after the weights of the graph have changed.
  void reset() { m_parts.reset(); }

private:
  // Returns where the search ends: in a reversed graph, it runs from the target to the source.
  template <typename Source, typename Target, typename NamedParameters>
  Intrinsic_point run(const MeshSearch& other,
                      const Source& source,
                      const Target& target,
                      const NamedParameters& np)
  {
    static_assert(!ignores_any<NamedParameters, internal_np::straighten_t,
                               internal_np::maximum_distance_t, internal_np::visitor_t>,
                  "single pairs read straighten, maximum_distance and visitor");
    if(!m_parts)
      m_parts = std::make_unique<Parts>(
          Parts{MeshSearch(other.search().graph(), other.translation(), other.point_map()),
                other.positions()});
    const auto run_between = [&](const auto& from, const auto& to) {
      m_parts->search.run_to(from, to, m_parts->positions, np);
      return other.translation().intrinsic_point(to);
    };
    return leads_to_sources(other.search().graph()) ? run_between(target, source)
                                                    : run_between(source, target);
  }

  struct Parts
  {
    MeshSearch search;
    Vertex_positions positions;
  };

  std::unique_ptr<Parts> m_parts;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MESH_SEARCH_H
