// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGULATION_BUILDER_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGULATION_BUILDER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Mesh_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

namespace internal {
/*
 * Numbers the vertices of a mesh so that nearby vertices have close numbers, which makes searches
 * cache-friendly: breadth first, on large meshes by patches of the surface. The arrays of the
 * connectivity are permuted from the order of the mesh. The halfedge group of a vertex is
 * contiguous in memory, and is prefetched.
 */
class Vertex_order
{
public:
  // `before` has the order of the mesh; it is referred to, not copied.
  explicit Vertex_order(const Connectivity& before) : m_before(before)
  {
    const std::size_t v = before.number_of_vertices(), h = before.number_of_halfedges();
    reserve_huge_pages(m_vertex_of_index, v);
    m_vertex_of_index.assign(v, null_index);
    resize_in_huge_pages(m_index_of_vertex, v + 1); // copy_targets() may write one more
    reserve_huge_pages(m_result.first_of_vertex, v + 1);
    m_result.first_of_vertex.assign(1, 0);
    resize_in_huge_pages(m_result.target_of_halfedge, h);
    m_result.opposite_rank.resize(h);
    m_is_border.resize(h);
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
    for(const auto [i, rank] : m_before.border)
      m_is_border[m_result.first_halfedge(m_vertex_of_index[i]) + rank] = true;
  }

  Connectivity& result() { return m_result; }
  std::vector<bool>& is_border() { return m_is_border; } // per halfedge
  std::vector<Index>& vertex_of_index() { return m_vertex_of_index; }
  std::vector<Index>& index_of_vertex() { return m_index_of_vertex; }

private:
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
      if(v + 2 * distance < m_number)
        prefetch(m_before.first_of_vertex.data(), m_index_of_vertex[v + 2 * distance]);
      if(v + distance < m_number)
      {
        const Index h = m_before.first_halfedge(m_index_of_vertex[v + distance]);
        prefetch(m_before.target_of_halfedge.data(), h);
        m_before.opposite_rank.prefetch(h);
      }
      copy_group(m_index_of_vertex[v], end_of_patch);
    }
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
  std::vector<bool> m_is_border;
  std::vector<Index> m_vertex_of_index, m_index_of_vertex;
  Index m_number = 0;          // of numbered vertices
  std::vector<Index> m_beyond; // halfedges that leave a patch, where further patches may start
};

/*
 * Builds an `Intrinsic_triangulation` from a mesh: reads and validates connectivity and lengths,
 * and has costs read.
 */
template <typename TriangleMesh, typename NamedParameters>
class Triangulation_builder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

  static constexpr bool needs_halfedges =
      has_costs<NamedParameters> || is_given<NamedParameters, internal_np::edge_length_t>;

public:
  Triangulation_builder(Intrinsic_triangulation& triangulation,
                        const TriangleMesh& tmesh,
                        const NamedParameters& np)
    : m_result(triangulation), m_mesh(tmesh), m_np(np)
  {
  }

  void build()
  {
    if(!try_to_build())
      mesh_links().reject_mesh();
  }

  // Returns false if the connectivity is invalid. Throws if other data are.
  bool try_to_build()
  {
    if(!read())
      return false;
    if(needs_halfedges)
      m_halfedges = halfedges_in_groups(m_vertices, m_result, m_mesh);
    check_for_interruption();
    copy_lengths();
    check_for_interruption();
    copy_costs();
    free_memory();
    CGAL_expensive_postcondition(m_result.is_valid());
    return true;
  }

  // Builds what a single search along edges between vertices requires. Such a search is not worth
  // the time to number the vertices and to link opposite halfedges. Vertices keep the order of the
  // mesh. Returns false if the connectivity is invalid, or vertices were removed.
  bool try_to_build_edges()
  {
    static_assert(!has_costs<NamedParameters>);
    Vertex_adjacency adjacency;
    if(!read(adjacency))
      return false;
    if constexpr(is_given<NamedParameters, internal_np::edge_length_t>)
      m_halfedges = halfedges_in_groups(m_vertices, adjacency, m_mesh);
    Edge_lengths lengths = read_edge_lengths(
        m_mesh, read_points(m_mesh, m_vertices, adjacency, m_np), m_halfedges, m_np, adjacency);
    m_result.m_length = std::move(lengths.of_halfedge);
    m_result.m_unit = lengths.unit;
    m_result.m_first_halfedge = std::move(adjacency.first_of_vertex);
    m_result.m_target = std::move(adjacency.target_of_halfedge);
    free_memory();
    return true;
  }

private:
  auto mesh_links() const
  {
    return Mesh_links(m_mesh, vertex_index_map(m_mesh, m_np), halfedge_index_map(m_mesh, m_np));
  }

  // The builder may outlive the search.
  void free_memory()
  {
    m_vertices = decltype(m_vertices)(); // unlike {}, which keeps the memory
    m_halfedges = decltype(m_halfedges)();
  }

  // Reads the adjacency of vertices, in the order of the mesh. Returns false if the mesh is
  // invalid, or vertices were removed. The memory of `links` is free before lengths are computed.
  bool read(Vertex_adjacency& result)
  {
    auto links = mesh_links();
    if(!links.read() || links.has_removed_vertices() || !links.write_adjacency(result))
      return false;
    m_vertices = std::move(links.vertex_list());
    return true;
  }

  // Reads the connectivity, and numbers the vertices. Returns false if the mesh is invalid.
  bool read()
  {
    auto links = mesh_links();
    Connectivity connectivity;
    if(!links.read() || !links.write(connectivity))
      return false;
    Vertex_order order(connectivity);
    read_points_and_number(links, connectivity, order);
    m_result.m_vertex_of_index = std::move(order.vertex_of_index());
    m_result.m_index_of_vertex = std::move(order.index_of_vertex());
    Connectivity& ordered = order.result();
    m_result.m_first_halfedge = std::move(ordered.first_of_vertex);
    m_result.m_target = std::move(ordered.target_of_halfedge);
    m_result.m_is_border = std::move(order.is_border());
    m_result.m_opposite_rank = std::move(ordered.opposite_rank);
    m_result.m_number_of_faces = static_cast<Index>(ordered.number_of_faces);
    if constexpr(needs_halfedges)
    {
      m_vertices.reserve(m_result.m_index_of_vertex.size());
      for(const Index i : m_result.m_index_of_vertex)
        m_vertices.push_back(links.vertex_list()[i]);
    }
    return true;
  }

  // One thread numbers the vertices, another one reads their points meanwhile: only one reads the
  // mesh.
  template <typename Links>
  void read_points_and_number(Links& links, const Connectivity& connectivity, Vertex_order& order)
  {
    std::vector<Index> roots;
    reserve_huge_pages(roots, links.vertex_list().size());
    for(const auto v : vertices(m_mesh))
      roots.push_back(links.index(v));
    m_loop.for_size(roots.size()).run(2, [&](const std::size_t task, std::size_t /* thread */) {
      if(task == 1)
        m_points = read_points(m_mesh, links.vertex_list(), connectivity, m_np);
      else
      {
        for(const Index root : roots)
          order.add_component(root);
        order.finish();
      }
    });
  }

  void copy_lengths()
  {
    Edge_lengths lengths =
        read_edge_lengths(m_mesh, std::move(m_points), m_halfedges, m_np, m_result);
    m_result.m_length = std::move(lengths.of_halfedge);
    m_result.m_unit = lengths.unit;
    m_result.m_lines_may_return = is_given<NamedParameters, internal_np::edge_length_t>;
    if(!lengths.points.empty())
      m_result.m_thin_faces = thin_faces(lengths.sharp_corners, lengths.points, m_result, m_loop);
  }

  void copy_costs()
  {
    if constexpr(has_costs<NamedParameters>)
    {
      using Reader = Cost_reader<TriangleMesh, NamedParameters>;
      check_costs<NamedParameters, is_defined<Reader>>();
      if constexpr(is_defined<Reader>)
        Reader(m_result, m_mesh, m_halfedges, m_np).read();
    }
  }

  Intrinsic_triangulation& m_result;
  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  const Loop m_loop = Loop::with_tag<Concurrency_tag<NamedParameters>>();
  Mesh_points m_points;
  std::vector<typename Graph_traits::vertex_descriptor> m_vertices;    // as in the triangulation
  std::vector<typename Graph_traits::halfedge_descriptor> m_halfedges; // likewise, if needed
};

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGULATION_BUILDER_H
