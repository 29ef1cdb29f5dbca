// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Paired_sides.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

using Array_mesh = Surface_mesh<Simple_cartesian<double>::Point_3>;

/*
 * Builds a mesh from arrays of coordinates and face indices, keeping the numbering and the first
 * corner of each face, to which barycentric coordinates refer. Non-manifold elements are rejected
 * with a message that names them; `PMP::polygon_soup_to_polygon_mesh()` names none.
 */
class Array_mesh_builder
{
  using Vertex = Array_mesh::Vertex_index;
  using Halfedge = Array_mesh::Halfedge_index;
  using Face = Array_mesh::Face_index;

public:
  explicit Array_mesh_builder(Array_mesh& mesh) : m_mesh(mesh) {}

  template <typename Integer>
  void build(const double* const coordinates,
             const std::size_t number_of_vertices,
             const Integer* const corners,
             const std::size_t number_of_faces)
  {
    const auto corners_of_face = [=](const std::size_t f) { return corners + 3 * f; };
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      check_vertex(v, coordinates + 3 * v);
    const Paired_sides sides(number_of_vertices, number_of_faces, corners_of_face);
    m_mesh.reserve(static_cast<Array_mesh::size_type>(number_of_vertices),
                   static_cast<Array_mesh::size_type>(sides.number_of_halfedges() / 2),
                   static_cast<Array_mesh::size_type>(number_of_faces));
    for(const double* p = coordinates; p != coordinates + 3 * number_of_vertices; p += 3)
      m_mesh.add_vertex({p[0], p[1], p[2]});
    add_edges(sides, corners_of_face);
    for(std::size_t f = 0; f < number_of_faces; ++f)
      add_face(static_cast<Index>(3 * f));
    link_border(sides);
  }

private:
  static void check_vertex(const std::size_t v, const double* const p)
  {
    if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      reject("vertex " + std::to_string(v) + " is not finite: (" + text_of(p[0]) + ", " +
             text_of(p[1]) + ", " + text_of(p[2]) + ")");
    check_for_interruption_at(v);
  }

  template <typename CornersOfFace>
  void add_edges(const Paired_sides& sides, const CornersOfFace& corners)
  {
    const auto source = [&](const Index side) {
      return Vertex(static_cast<Array_mesh::size_type>(corners(side / 3)[side % 3]));
    };
    m_halfedges.resize(sides.number_of_halfedges());
    for(Index side = 0; side < sides.number_of_sides(); ++side)
    {
      check_for_interruption_at(side);
      const Index across = sides.opposite(side);
      if(across < side)
        continue;
      m_halfedges[side] = m_mesh.add_edge(source(side), source(Paired_sides::side_after(side)));
      m_halfedges[across] = m_mesh.opposite(m_halfedges[side]);
    }
  }

  void add_face(const Index first_side)
  {
    check_for_interruption_at(first_side);
    const Face face = m_mesh.add_face();
    m_mesh.set_halfedge(face, m_halfedges[first_side]);
    for(Index side = first_side; side < first_side + 3; ++side)
    {
      const Halfedge h = m_halfedges[side];
      m_mesh.set_face(h, face);
      m_mesh.set_next(h, m_halfedges[Paired_sides::side_after(side)]);
      m_mesh.set_halfedge(m_mesh.target(h), h);
    }
  }

  void link_border(const Paired_sides& sides)
  {
    for(Index b = static_cast<Index>(sides.number_of_sides()); b < m_halfedges.size(); ++b)
    {
      check_for_interruption_at(b);
      m_mesh.set_next(m_halfedges[b], m_halfedges[sides.next(b)]);
      m_mesh.set_halfedge(m_mesh.target(m_halfedges[b]), m_halfedges[b]);
    }
  }

  Array_mesh& m_mesh;
  std::vector<Halfedge> m_halfedges; // of the mesh, by those of `Paired_sides`
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_MESH_H
