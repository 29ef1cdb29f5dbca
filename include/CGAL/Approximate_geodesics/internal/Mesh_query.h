// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_MESH_QUERY_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_MESH_QUERY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Propagation.h>
#include <CGAL/Approximate_geodesics/internal/Mesh_vertices.h>
#include <CGAL/Approximate_geodesics/internal/Path.h>
#include <CGAL/Approximate_geodesics/internal/Vertices_before.h>
#include <CGAL/Approximate_geodesics/internal/graph_for_one_run.h>
#include <CGAL/Approximate_geodesics/internal/index_maps.h>
#include <CGAL/Approximate_geodesics/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/internal/run_parameters.h>
#include <CGAL/Approximate_geodesics/internal/write_points.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * One run on a mesh that is not seen again: what the free functions have in common.
 */
template <typename PriorityQueue, typename TriangleMesh, typename NamedParameters>
class Mesh_query
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Vertex_index_map = decltype(vertex_index_map(std::declval<const TriangleMesh&>(),
                                                     std::declval<const NamedParameters&>()));
  using Vertices = Mesh_vertices<TriangleMesh, Vertex_index_map>;
  using Graph = decltype(graph_for_one_run(std::declval<const TriangleMesh&>(),
                                           std::declval<const NamedParameters&>()));
  using Search = Propagation<Graph, PriorityQueue>;
  using Node = typename Search::Node;

public:
  Mesh_query(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_mesh(tmesh),
      m_np(np),
      m_graph(graph_for_one_run(tmesh, np)),
      m_vertices(tmesh, vertex_index_map(tmesh, np), m_graph.triangulation()),
      m_search(m_graph)
  {
  }

  // from one vertex or from a range of them
  template <typename Sources>
  void run(const Sources& sources)
  {
    run(sources, stop_rule<Search>(m_vertices, m_np));
  }

  // ... until `target` is settled
  template <typename Sources>
  void run(const Sources& sources, const vertex_descriptor target)
  {
    auto stop = stop_rule<Search>(m_vertices, m_np);
    stop.targets.assign(1, m_vertices.node(target));
    run(sources, stop);
  }

  double distance(const vertex_descriptor v) const { return m_search.distance(m_vertices.node(v)); }

  // Writes the points of the path from the source to `v`, if `v` was reached. Returns its length,
  // or infinity.
  template <typename OutputIterator>
  double write_path(const vertex_descriptor v, OutputIterator points) const
  {
    const Path path = find_path(m_search, m_vertices.node(v));
    write_points<Graph>(path, m_vertices, m_mesh, points, m_np);
    return has_crossing_arcs<Graph> && !path.points.empty() ? path.length * m_graph.unit()
                                                            : distance(v);
  }

  template <typename VertexDistanceMap>
  void write_distances(VertexDistanceMap distances) const
  {
    for(const vertex_descriptor v : vertices(m_mesh))
      put(distances, v, m_search.distance(m_vertices.node(v)));
  }

  template <typename NearestSourceMap>
  void write_nearest_sources(NearestSourceMap sources) const
  {
    using Value = typename boost::property_traits<NearestSourceMap>::value_type;
    for(const vertex_descriptor v : vertices(m_mesh))
      put(sources, v, static_cast<Value>(m_search.source(m_vertices.node(v))));
  }

  template <typename PredecessorMap>
  void write_predecessors(PredecessorMap predecessors) const
  {
    Vertices_before<Search> before(m_search);
    for(const vertex_descriptor v : vertices(m_mesh))
      put(predecessors, v, predecessor(v, before));
  }

private:
  template <typename Sources>
  void run(const Sources& sources, const typename Search::Stop_rule& stop)
  {
    std::vector<typename Search::Seed> seeds;
    if constexpr(std::is_convertible_v<Sources, vertex_descriptor>)
      seeds.push_back({m_vertices.node(sources)});
    else
      for(const vertex_descriptor v : sources)
        seeds.push_back({m_vertices.node(v), 0, seeds.size()});
    internal::run(m_search, seeds, stop, m_vertices, m_np);
  }

  vertex_descriptor predecessor(const vertex_descriptor v,
                                Vertices_before<Search>& vertices_before) const
  {
    const Node node = m_vertices.node(v);
    if(!m_search.is_reached(node))
      return boost::graph_traits<TriangleMesh>::null_vertex();
    const Node before = vertices_before(node);
    return before == Search::null_node ? v : m_vertices.vertex(before);
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  Graph m_graph;
  Vertices m_vertices;
  Search m_search;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_MESH_QUERY_H
