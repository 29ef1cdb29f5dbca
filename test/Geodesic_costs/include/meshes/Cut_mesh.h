// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_CUT_MESH_H
#define APPROXIMATE_GEODESICS_TEST_CUT_MESH_H

#include "meshes/test_weights.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace geodesics_test {

/*
 * Cuts a mesh along its barriers: an edge gets a second one beside it, both at the border, and a
 * vertex one copy for every fan of faces that is left of its surroundings. Faces stay.
 */
class Cut_mesh
{
public:
  Cut_mesh(const Mesh& mesh, const Barriers& barriers) : m_mesh(mesh), m_copies(mesh.num_vertices())
  {
    for(const Edge e : mesh.edges())
      if(barriers[e.idx()] && !mesh.is_border(e))
        open(mesh.halfedge(e));
    link_border(m_mesh);
    split_vertices();
  }

  const Mesh& mesh() const { return m_mesh; }
  const std::vector<Vertex>& copies(const Vertex v) const { return m_copies[v.idx()]; }

  // by the vertices of the mesh as it was: that of the nearest copy
  std::vector<double> nearest(const std::vector<double>& distances) const
  {
    std::vector<double> result;
    for(const std::vector<Vertex>& copies : m_copies)
    {
      result.push_back(infinity);
      for(const Vertex v : copies)
        result.back() = (std::min)(result.back(), distances[v.idx()]);
    }
    return result;
  }

private:
  // gives the face of `h` an edge of its own
  void open(const Halfedge h)
  {
    const Halfedge g = m_mesh.add_edge(m_mesh.source(h), m_mesh.target(h));
    const Face f = m_mesh.face(h);
    m_mesh.set_next(m_mesh.prev(h), g);
    m_mesh.set_next(g, m_mesh.next(h));
    m_mesh.set_face(g, f);
    m_mesh.set_halfedge(f, g);
    m_mesh.set_face(h, Mesh::null_face());
    m_mesh.set_face(m_mesh.opposite(g), Mesh::null_face());
  }

  void split_vertices()
  {
    std::vector<bool> is_done(m_mesh.num_halfedges());
    for(const Halfedge first : m_mesh.halfedges())
    {
      if(is_done[first.idx()])
        continue;
      const Vertex v = m_mesh.target(first);
      const Point p = m_mesh.point(v);
      std::vector<Vertex>& copies = m_copies[v.idx()];
      copies.push_back(copies.empty() ? v : m_mesh.add_vertex(p));
      Halfedge h = first;
      do
      {
        is_done[h.idx()] = true;
        m_mesh.set_target(h, copies.back());
        m_mesh.set_halfedge(copies.back(), h);
        h = m_mesh.opposite(m_mesh.next(h));
      } while(h != first);
    }
    for(std::size_t i = 0; i < m_copies.size(); ++i)
      if(m_copies[i].empty()) // isolated
        m_copies[i].push_back(Vertex(static_cast<Mesh::size_type>(i)));
  }

  Mesh m_mesh;
  std::vector<std::vector<Vertex>> m_copies;
};

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_CUT_MESH_H
