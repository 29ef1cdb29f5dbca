// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_VERTEX_ORDER_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_VERTEX_ORDER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/prefetch.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Connectivity.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Numbers the vertices of a mesh so that nearby vertices have close numbers, which makes searches
 * cache-friendly: breadth first, on large meshes by patches of the surface. The arrays of the
 * connectivity are permuted from the order of the mesh. The halfedge group of a vertex is
 * contiguous in memory, and is prefetched.
 */
class Vertex_order
{
public:
  using Index = Connectivity::Index;

  // `before` has the order of the mesh; it is referred to, not copied.
  explicit Vertex_order(const Connectivity& before) : m_before(before)
  {
    const std::size_t v = before.number_of_vertices(), h = before.number_of_halfedges();
    m_vertex_of_index.assign(v, null_index);
    m_index_of_vertex.resize(v + 1); // copy_targets() may write one more
    m_result.first_of_vertex.reserve(v + 1);
    m_result.first_of_vertex.assign(1, 0);
    m_result.target_of_halfedge.resize(h);
    m_result.opposite_rank.resize(h);
    m_result.is_border.assign(h, false);
    m_result.number_of_faces = before.number_of_faces;
  }

  // Numbers the connected component of the vertex with index `root`, unless it is numbered.
  void add_component(const Index root)
  {
    std::size_t next = m_beyond.size();
    add_patch(root);
    for(; next < m_beyond.size(); ++next)
      add_patch(m_result.target_of_halfedge[m_beyond[next]]);
  }

  // Must be called after all components were added. Indices of removed vertices remain without a
  // number.
  void finish()
  {
    m_index_of_vertex.resize(m_number);
    m_index_of_vertex.shrink_to_fit();
    for(const Index h : m_beyond)
    {
      Index& target = m_result.target_of_halfedge[h];
      target = m_vertex_of_index[target];
    }
  }

  Connectivity& result() { return m_result; }
  std::vector<Index>& vertex_of_index() { return m_vertex_of_index; }
  std::vector<Index>& index_of_vertex() { return m_index_of_vertex; }

private:
  static constexpr Index null_index = (std::numeric_limits<Index>::max)();

  // Smaller patches slow down searches on small meshes.
  static constexpr std::size_t SIZE_OF_PATCH = 32768; // vertices

  // Numbers a patch of vertices around `center`.
  void add_patch(const Index center)
  {
    if(m_vertex_of_index[center] != null_index)
      return;
    const std::size_t first = m_number, end_of_patch = first + SIZE_OF_PATCH;
    number(center);
    for(std::size_t v = first; v < m_number; ++v)
    {
      constexpr std::size_t distance = 16;
      if(v + distance < m_number)
        prefetch_group(m_index_of_vertex[v + distance]);
      copy_group(m_index_of_vertex[v], end_of_patch);
    }
  }

  void prefetch_group(const Index i) const
  {
    const Index h = m_before.first_halfedge(i);
    prefetch(m_before.target_of_halfedge.data(), h);
    m_before.opposite_rank.prefetch(h);
  }

  void number(const Index i)
  {
    m_vertex_of_index[i] = m_number;
    m_index_of_vertex[m_number++] = i;
  }

  // Copies the halfedge group of the vertex with index `i`.
  void copy_group(const Index i, const std::size_t end_of_patch)
  {
    const Index degree = m_before.degree(i), old = m_before.first_halfedge(i);
    const Index h = m_result.first_of_vertex.back();
    if(m_number + degree <= end_of_patch)
      copy_targets(old, degree, h);
    else
      copy_targets_near_end(old, degree, h, end_of_patch);
    m_result.opposite_rank.copy(m_before.opposite_rank, old, degree, h);
    if(m_before.has_border())
      for(Index rank = 0; rank < degree; ++rank)
        m_result.is_border[h + rank] = m_before.is_border[old + rank];
    m_result.first_of_vertex.push_back(h + degree);
  }

  // Branch-free, because a branch on new vertices would be unpredictable.
  void copy_targets(const Index old, const Index degree, const Index h)
  {
    const Index* const before = m_before.target_of_halfedge.data() + old; // these stay in registers
    Index* const result = m_result.target_of_halfedge.data() + h;
    Index* const vertex_of_index = m_vertex_of_index.data();
    Index* const index_of_vertex = m_index_of_vertex.data();
    Index next = m_number;
    for(Index rank = 0; rank < degree; ++rank)
    {
      const Index i = before[rank], known = vertex_of_index[i];
      const bool is_new = known == null_index;
      index_of_vertex[next] = i;
      result[rank] = vertex_of_index[i] = is_new ? next : known;
      next += is_new ? 1 : 0;
    }
    m_number = next;
  }

  // Targets beyond the patch remain mesh indices until they are numbered.
  void copy_targets_near_end(const Index old,
                             const Index degree,
                             const Index h,
                             const std::size_t end_of_patch)
  {
    for(Index rank = 0; rank < degree; ++rank)
    {
      const Index i = m_before.target(old + rank);
      if(m_vertex_of_index[i] == null_index && m_number < end_of_patch)
        number(i);
      const bool has_number = m_vertex_of_index[i] != null_index;
      m_result.target_of_halfedge[h + rank] = has_number ? m_vertex_of_index[i] : i;
      if(!has_number)
        m_beyond.push_back(h + rank);
    }
  }

  const Connectivity& m_before;
  Connectivity m_result;
  std::vector<Index> m_vertex_of_index, m_index_of_vertex;
  Index m_number = 0;          // of numbered vertices
  std::vector<Index> m_beyond; // halfedges that leave a patch, where further patches may start
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_VERTEX_ORDER_H
