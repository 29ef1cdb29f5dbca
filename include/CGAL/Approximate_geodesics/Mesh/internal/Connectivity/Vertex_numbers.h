// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_VERTEX_NUMBERS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_VERTEX_NUMBERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The vertices of a mesh by their indices. Unlike `Mesh_translation`, this class requires no
 * triangulation, and maps invalid vertices to `null_index` instead of throwing.
 */
template <typename TriangleMesh, typename VertexIndexMap>
class Vertex_numbers
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using Triangle_mesh = TriangleMesh;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using Index = std::uint32_t;

  static constexpr Index null_index = (std::numeric_limits<Index>::max)();

  // Precondition: `number_of_vertices` is `num_vertices(tmesh)`, and smaller than `null_index`.
  Vertex_numbers(const TriangleMesh& tmesh,
                 VertexIndexMap vertex_index_map,
                 const std::size_t number_of_vertices)
    : m_mesh(tmesh),
      m_vertex_index_map(std::move(vertex_index_map)),
      m_vertices(number_of_vertices, Graph_traits::null_vertex())
  {
  }

  // Lists the vertices. Returns whether the index map is a bijection.
  bool list_vertices()
  {
    std::size_t number = 0;
    for(const vertex_descriptor v : vertices(m_mesh))
    {
      const Index i = node(v);
      if(i == null_index || m_vertices[i] != Graph_traits::null_vertex())
        return false;
      m_vertices[i] = v;
      ++number;
    }
    return number == m_vertices.size();
  }

  const TriangleMesh& mesh() const { return m_mesh; }

  // By index; filled by list_vertices().
  const std::vector<vertex_descriptor>& list() const { return m_vertices; }
  vertex_descriptor vertex(const Index node) const { return m_vertices[node]; }
  static bool is_vertex(const Index /* node */) { return true; }

  Index node(const vertex_descriptor v) const
  {
    if(v == Graph_traits::null_vertex())
      return null_index;
    const auto result = static_cast<std::size_t>(get(m_vertex_index_map, v));
    return result < m_vertices.size() ? static_cast<Index>(result) : null_index;
  }

private:
  const TriangleMesh& m_mesh;
  VertexIndexMap m_vertex_index_map;
  std::vector<vertex_descriptor> m_vertices;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_VERTEX_NUMBERS_H
