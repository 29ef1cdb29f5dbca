// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_MESH_CHECK_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_MESH_CHECK_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/halfedge_groups.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/face_links.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Diagnoses a mesh that `Mesh_links` has refused: throws an exception that names the first invalid
 * element. It reads the mesh step by step, and follows no link before it is checked.
 */
template <typename TriangleMesh, typename VertexIndexMap, typename HalfedgeIndexMap>
class Mesh_check
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  Mesh_check(const TriangleMesh& tmesh,
             VertexIndexMap vertex_index_map,
             HalfedgeIndexMap halfedge_index_map)
    : m_mesh(tmesh),
      m_vertex_index_map(std::move(vertex_index_map)),
      m_halfedge_index_map(std::move(halfedge_index_map)),
      m_vertex(num_vertices(tmesh), Graph_traits::null_vertex()),
      m_halfedge(num_halfedges(tmesh), Graph_traits::null_halfedge())
  {
  }

  [[noreturn]] void reject_mesh()
  {
    number_of_triangles(m_mesh,
                        [this](const vertex_descriptor v) { return ", at " + name(v) + ','; });
    for(const vertex_descriptor v : vertices(m_mesh))
      list(v);
    for(const vertex_descriptor v : vertices(m_mesh))
      check_cycle(v);
    for(const halfedge_descriptor h : m_halfedge)
      if(h != Graph_traits::null_halfedge())
        check_opposite(h);
    check_that_vertices_know_faces();
    for(const halfedge_descriptor h : halfedges(m_mesh))
      check_side(h);
    reject("there are halfedges with a face that is not in faces()");
  }

private:
  std::size_t index(const vertex_descriptor v) const
  {
    if(v == Graph_traits::null_vertex())
      reject("a halfedge of the mesh has no vertex");
    return checked_index(get(m_vertex_index_map, v), m_vertex.size(), "vertex");
  }

  std::size_t index(const halfedge_descriptor h) const
  {
    return checked_index(get(m_halfedge_index_map, h), m_halfedge.size(), "halfedge");
  }

  template <typename I>
  static std::size_t checked_index(const I i, const std::size_t size, const char* kind)
  {
    if(static_cast<std::size_t>(i) >= size) // also negative ones
      reject(std::string(kind) + " index " + std::to_string(i) +
             " is out of range: it must be less than " + std::to_string(size));
    return static_cast<std::size_t>(i);
  }

  std::string name(const vertex_descriptor v) const { return "vertex " + std::to_string(index(v)); }

  std::string name(const halfedge_descriptor h) const
  {
    return "the halfedge from " + name(source(h, m_mesh)) + " to " + name(target(h, m_mesh));
  }

  void list(const vertex_descriptor v)
  {
    vertex_descriptor& listed = m_vertex[index(v)];
    if(listed != Graph_traits::null_vertex())
      reject("vertex index " + std::to_string(index(v)) + " is assigned to more than one vertex");
    listed = v;
  }

  // Lists the halfedges from `v`, which must form a single cycle.
  void check_cycle(const vertex_descriptor v)
  {
    const halfedge_descriptor first = first_halfedge_from(v, m_mesh);
    halfedge_descriptor h = first;
    if(h != Graph_traits::null_halfedge())
      do
      {
        if(h == Graph_traits::null_halfedge() || source(h, m_mesh) != v)
          reject_halfedges_around(v);
        halfedge_descriptor& listed = m_halfedge[index(h)];
        if(listed != Graph_traits::null_halfedge())
          reject_halfedges_around(v);
        listed = h;
        if(m_vertex[index(target(h, m_mesh))] != target(h, m_mesh))
          reject(name(h) + " leads to a vertex that is not in vertices()");
        h = counterclockwise(h, m_mesh);
      } while(h != first);
  }

  // Every opposite halfedge must be found around its source.
  void check_opposite(const halfedge_descriptor h) const
  {
    const halfedge_descriptor across = opposite(h, m_mesh);
    if(m_halfedge[index(across)] != across || opposite(across, m_mesh) != h)
      reject_halfedges_around(target(h, m_mesh));
  }

  [[noreturn]] void reject_halfedges_around(const vertex_descriptor v) const
  {
    reject("the halfedges around " + name(v) +
           " do not form one cycle, or their indices are not unique");
  }

  void check_that_vertices_know_faces() const
  {
    std::size_t number_of_face = 0;
    for(const face_descriptor f : faces(m_mesh))
    {
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        if(m_halfedge[index(h)] == Graph_traits::null_halfedge())
          reject(name_of_face(number_of_face) + " is not found around " + name(source(h, m_mesh)));
      ++number_of_face;
    }
  }

  // Checks that halfedges with a face are on the cycle of that face, and the others on a border.
  void check_side(const halfedge_descriptor h) const
  {
    if(m_halfedge[index(h)] != h)
      reject(name(h) + " is not found around the former, or its index is not unique");
    if(is_border(h, m_mesh) && !follows_its_predecessor(h, m_mesh))
      reject(name(h) + " is on the border, but does not follow the halfedge before it");
    if(!is_border(h, m_mesh) && !is_on_cycle_of_face(h, m_mesh))
      reject(name(h) + " has a face, but is not on the cycle of that face");
  }

  const TriangleMesh& m_mesh;
  const VertexIndexMap m_vertex_index_map;
  const HalfedgeIndexMap m_halfedge_index_map;
  std::vector<vertex_descriptor> m_vertex;     // by index
  std::vector<halfedge_descriptor> m_halfedge; // by index, once found around a vertex
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_MESH_CHECK_H
