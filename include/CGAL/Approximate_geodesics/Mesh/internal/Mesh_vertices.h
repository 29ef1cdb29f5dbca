// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_VERTICES_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_VERTICES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Translates between the vertices of a mesh and the nodes that stand for them.
 */
template <typename TriangleMesh, typename VertexIndexMap>
class Mesh_vertices
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Node = Intrinsic_triangulation::Index;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  Mesh_vertices(const TriangleMesh& tmesh,
                VertexIndexMap vertex_index_map,
                const Intrinsic_triangulation& triangulation)
    : m_mesh(&tmesh),
      m_vertex_index_map(std::move(vertex_index_map)),
      m_triangulation(&triangulation)
  {
  }

  const VertexIndexMap& index_map() const { return m_vertex_index_map; }

  Node node(const vertex_descriptor v) const
  {
    Node result = Intrinsic_triangulation::null_index;
    if(v != Graph_traits::null_vertex())
      result = m_triangulation->vertex(static_cast<std::size_t>(get(m_vertex_index_map, v)));
    if(result == Intrinsic_triangulation::null_index)
      throw std::invalid_argument("Approximate_geodesics: the vertex is not one of the mesh");
    return result;
  }

  vertex_descriptor vertex(const Node node) const
  {
    if(m_vertices.empty())
      list_vertices();
    return m_vertices[node];
  }

  // whether a node is a vertex, and not a point that a graph has added
  bool is_vertex(const Node node) const { return node < m_triangulation->number_of_vertices(); }

  const TriangleMesh& mesh() const { return *m_mesh; }

protected:
  const Intrinsic_triangulation& triangulation() const { return *m_triangulation; }

private:
  void list_vertices() const
  {
    m_vertices.resize(m_triangulation->number_of_vertices(), Graph_traits::null_vertex());
    for(const vertex_descriptor v : vertices(*m_mesh))
      m_vertices[node(v)] = v;
  }

  const TriangleMesh* m_mesh;
  VertexIndexMap m_vertex_index_map;
  const Intrinsic_triangulation* m_triangulation;
  mutable std::vector<vertex_descriptor> m_vertices; // by node, made when first needed
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_MESH_VERTICES_H
