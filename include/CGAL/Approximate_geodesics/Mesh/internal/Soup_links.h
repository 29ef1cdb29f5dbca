// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_SOUP_LINKS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_SOUP_LINKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/internal/Mesh_links.h>

#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics {

template <typename PointRange, typename TriangleRange>
class Triangle_soup_mesh;

namespace internal {

template <typename Key>
struct Element_index_map;

/*
 * The connectivity of a mesh whose links are valid by construction, and are arrays: rotates around
 * its vertices without a copy of the links.
 */
template <typename PointRange, typename TriangleRange>
class Mesh_links<
    Triangle_soup_mesh<PointRange, TriangleRange>,
    Element_index_map<typename Triangle_soup_mesh<PointRange, TriangleRange>::Vertex_index>,
    Element_index_map<typename Triangle_soup_mesh<PointRange, TriangleRange>::Halfedge_index>>
{
  using Mesh = Triangle_soup_mesh<PointRange, TriangleRange>;
  using Vertex_index = typename Mesh::Vertex_index;
  using Halfedge_index = typename Mesh::Halfedge_index;

public:
  using vertex_descriptor = Vertex_index;

  template <typename... IndexMaps>
  explicit Mesh_links(const Mesh& mesh, const IndexMaps&... /* maps */) : m_mesh(mesh)
  {
  }

  bool read()
  {
    const auto all = vertices(m_mesh);
    reserve_huge_pages(m_vertices, m_mesh.number_of_vertices());
    m_vertices.assign(all.begin(), all.end());
    return true;
  }

  std::vector<Vertex_index>& vertex_list() { return m_vertices; }

  bool has_removed_vertices() const { return false; }

  Index index(const Vertex_index v) const { return v; }

  bool write_adjacency(Vertex_adjacency& result)
  {
    resize_in_huge_pages(result.target_of_halfedge, m_mesh.number_of_halfedges());
    reserve_huge_pages(result.first_of_vertex, m_mesh.number_of_vertices() + 1);
    Index number = 0;
    for(const Vertex_index v : vertices(m_mesh))
    {
      result.first_of_vertex.push_back(number);
      rotate(v, [&](const Halfedge_index h) {
        result.target_of_halfedge[number++] = target(h, m_mesh);
      });
    }
    result.first_of_vertex.push_back(number);
    return true;
  }

  bool write(Connectivity& result)
  {
    write_adjacency(result);
    result.number_of_faces = m_mesh.number_of_faces();
    result.opposite_rank.resize(result.number_of_halfedges());
    std::vector<Index> ranks;
    resize_in_huge_pages(ranks, result.number_of_halfedges());
    for(const Vertex_index v : vertices(m_mesh))
    {
      Index rank = 0;
      rotate(v, [&](const Halfedge_index h) { ranks[h] = rank++; });
    }
    Index number = 0;
    for(const Vertex_index v : vertices(m_mesh))
      rotate(v, [&](const Halfedge_index h) {
        result.opposite_rank.set(number++, ranks[opposite(h, m_mesh)]);
        if(is_border(h, m_mesh))
          result.border.push_back({v, ranks[h]});
      });
    return true;
  }

  [[noreturn]] void reject_mesh() { reject("the triangles were changed while they were read"); }

private:
  // Calls `f` for the halfedges from `v`, in the order of all meshes.
  template <typename F>
  void rotate(const Vertex_index v, const F& f) const
  {
    const Halfedge_index first = first_halfedge_from(v, m_mesh);
    if(first == Halfedge_index())
      return;
    Halfedge_index h = first;
    do
    {
      f(h);
      h = counterclockwise(h, m_mesh);
    } while(h != first);
  }

  const Mesh& m_mesh;
  std::vector<Vertex_index> m_vertices;
};

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_SOUP_LINKS_H
