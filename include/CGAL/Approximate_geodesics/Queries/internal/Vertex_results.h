// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_RESULTS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_RESULTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Vertex_predecessors.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <limits>
#include <type_traits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Writes the results of a search to property maps of the vertices of a mesh. All memory is
 * allocated before the first write. `Vertices` maps vertices to nodes and, for predecessors, nodes
 * to vertices; vertices without a node count as not reached.
 */
template <typename Search, typename Vertices>
class Vertex_results
{
  using Triangle_mesh = typename Vertices::Triangle_mesh;
  using vertex_descriptor = typename boost::graph_traits<Triangle_mesh>::vertex_descriptor;
  using Node = typename Search::Node;

public:
  Vertex_results(const Search& search, const Vertices& vertices)
    : m_search(search), m_vertices(vertices)
  {
  }

  // Writes the distances and the other results requested by named parameters.
  template <typename VertexDistanceMap, typename NamedParameters>
  void write(VertexDistanceMap distances, const NamedParameters& np) const
  {
    if constexpr(is_given<NamedParameters, internal_np::geodesic_predecessor_t>)
    {
      Vertex_predecessors<Search> predecessors(m_search);
      write_distances_and_sources(distances, np);
      write_predecessors(predecessors, np);
    }
    else
      write_distances_and_sources(distances, np);
  }

private:
  double distance(const Node node) const
  {
    return node == Search::null_node ? std::numeric_limits<double>::infinity()
                                     : m_search.distance(node);
  }

  auto source(const Node node) const
  {
    return node == Search::null_node ? Search::null_source : m_search.source(node);
  }

  template <typename VertexDistanceMap, typename NamedParameters>
  void write_distances_and_sources(VertexDistanceMap distances,
                                   [[maybe_unused]] const NamedParameters& np) const
  {
    constexpr bool with_sources = is_given<NamedParameters, internal_np::nearest_source_t>;
    if constexpr(with_sources)
      allocate_sources();
    for(const vertex_descriptor v : vertices(m_vertices.mesh()))
      put(distances, v, distance(m_vertices.node(v)));
    if constexpr(with_sources)
    {
      const auto sources = parameters::get_parameter(np, internal_np::nearest_source);
      using Value = typename boost::property_traits<std::decay_t<decltype(sources)>>::value_type;
      for(const vertex_descriptor v : vertices(m_vertices.mesh()))
        put(sources, v, static_cast<Value>(source(m_vertices.node(v))));
    }
  }

  // The first query for a source allocates all memory for sources.
  void allocate_sources() const
  {
    for(const Node node : m_search.reached_nodes())
      if(m_search.source(node) != Search::null_source)
        return;
  }

  template <typename Predecessors, typename NamedParameters>
  void write_predecessors(Predecessors& predecessors, const NamedParameters& np) const
  {
    const auto map = parameters::get_parameter(np, internal_np::geodesic_predecessor);
    for(const vertex_descriptor v : vertices(m_vertices.mesh()))
      put(map, v, predecessor(v, predecessors));
  }

  template <typename Predecessors>
  vertex_descriptor predecessor(const vertex_descriptor v, Predecessors& predecessors) const
  {
    const Node node = m_vertices.node(v);
    if(node == Search::null_node || !m_search.is_reached(node))
      return boost::graph_traits<Triangle_mesh>::null_vertex();
    const Node before = predecessors(node);
    return before == Search::null_node ? v : m_vertices.vertex(before);
  }

  const Search& m_search;
  const Vertices& m_vertices;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_VERTEX_RESULTS_H
