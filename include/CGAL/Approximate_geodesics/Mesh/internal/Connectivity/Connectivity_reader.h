// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_CONNECTIVITY_READER_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_CONNECTIVITY_READER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/Adjacency_reader.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/Breadth_first_order.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/Vertex_numbers.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/halfedge_groups.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/face_links.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Copies the connectivity of a mesh to an `Intrinsic_triangulation`, and validates it. The class
 * does not depend on named parameters, so it is instantiated once per mesh type and index maps.
 *
 * If the mesh is valid and has no removed elements, links are read in memory order. Otherwise the
 * mesh is traversed step by step, which is slower, but yields the same result or diagnoses the
 * error.
 *
 * A single traversal numbers the vertices and writes the halfedge groups: the group of each vertex
 * is read in turn, and numbers its new neighbors. The order is breadth first; on large meshes, it
 * proceeds by patches of the surface, so that nearby vertices have close numbers, which makes
 * searches cache-friendly.
 */
template <typename TriangleMesh, typename VertexIndexMap, typename HalfedgeIndexMap>
class Connectivity_reader
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Index = Intrinsic_triangulation::Index;
  using Numbers = Vertex_numbers<TriangleMesh, VertexIndexMap>;

  static constexpr Index null_index = Intrinsic_triangulation::null_index;

public:
  Connectivity_reader(Intrinsic_triangulation& triangulation,
                      const TriangleMesh& tmesh,
                      VertexIndexMap vertex_index_map,
                      HalfedgeIndexMap halfedge_index_map)
    : m_result(triangulation),
      m_mesh(tmesh),
      m_number_of_vertices(num_vertices(tmesh)),
      m_number_of_halfedges(num_halfedges(tmesh)),
      m_vertex_index_map(std::move(vertex_index_map)),
      m_halfedge_index_map(std::move(halfedge_index_map))
  {
  }

  // `needs_halfedges` tells whether halfedge_list() will be used.
  void read(const bool needs_halfedges)
  {
    check_size();
    if(read_links())
    {
      if(needs_halfedges)
        m_halfedges = halfedges_in_groups(m_vertices, m_result, m_mesh);
      return;
    }
    check_faces();
    copy_connectivity();
    link_opposites();
    check_sides();
    m_frontier = std::vector<vertex_descriptor>(); // reduces peak memory while lengths are read
    m_number_of_halfedge = std::vector<Index>();
    if(!needs_halfedges)
      m_halfedges = std::vector<halfedge_descriptor>();
  }

  // In the order of the triangulation.
  const std::vector<vertex_descriptor>& vertex_list() const { return m_vertices; }
  const std::vector<halfedge_descriptor>& halfedge_list() const { return m_halfedges; }

private:
  static std::string name(const Index i) { return "vertex " + std::to_string(i); }

  void check_size() const
  {
    if(m_number_of_halfedges >= null_index || m_number_of_vertices >= null_index)
      throw std::length_error("Approximate_geodesics: the mesh has " +
                              std::to_string(m_number_of_vertices) + " vertices and " +
                              std::to_string(m_number_of_halfedges) +
                              " halfedges, too many for 32-bit indices");
  }

  // Returns whether the fast path succeeded; otherwise there is no result.
  bool read_links()
  {
    Numbers numbers(m_mesh, m_vertex_index_map, m_number_of_vertices);
    if(!numbers.list_vertices())
      return false;
    Adjacency_reader<Numbers, HalfedgeIndexMap> reader(numbers, m_halfedge_index_map);
    if(!reader.read_with_faces())
      return false;
    Breadth_first_order order(reader.adjacency());
    for(const vertex_descriptor root : vertices(m_mesh))
      order.add_component(numbers.node(root));
    order.finish();
    m_result.m_vertex_of_index = std::move(order.vertex_of_index());
    m_result.m_index_of_vertex = std::move(order.index_of_vertex());
    take(order.result());
    m_vertices.reserve(m_number_of_vertices);
    for(const Index i : m_result.m_index_of_vertex)
      m_vertices.push_back(numbers.vertex(i));
    return true;
  }

  void take(Connectivity& connectivity)
  {
    m_result.m_first_halfedge = std::move(connectivity.first_of_vertex);
    m_result.m_target = std::move(connectivity.target_of_halfedge);
    m_result.m_is_border = std::move(connectivity.is_border);
    m_result.m_opposite_rank = std::move(connectivity.opposite_rank);
    m_result.m_number_of_faces = static_cast<Index>(connectivity.number_of_faces);
  }

  void check_faces()
  {
    m_result.m_number_of_faces =
        static_cast<Index>(number_of_triangles(m_mesh, [this](const vertex_descriptor v) {
          return ", at " + name(checked_index(v)) + ',';
        }));
  }

  Index checked_index(const vertex_descriptor v) const
  {
    if(v == Graph_traits::null_vertex())
      reject("a halfedge of the mesh has no vertex");
    return checked_index(get(m_vertex_index_map, v), m_number_of_vertices, "vertex");
  }

  Index checked_index(const halfedge_descriptor h) const
  {
    return checked_index(get(m_halfedge_index_map, h), m_number_of_halfedges, "halfedge");
  }

  template <typename I>
  static Index checked_index(const I i, const std::size_t size, const char* kind)
  {
    if(static_cast<std::size_t>(i) >= size) // also negative ones
      reject(std::string(kind) + " index " + std::to_string(i) +
             " is out of range: it must be less than " + std::to_string(size));
    return static_cast<Index>(i);
  }

  void copy_connectivity()
  {
    m_result.m_vertex_of_index.assign(m_number_of_vertices, null_index);
    m_result.m_index_of_vertex.reserve(m_number_of_vertices);
    m_vertices.reserve(m_number_of_vertices);
    m_number_of_halfedge.assign(m_number_of_halfedges, null_index);
    m_halfedges.reserve(m_number_of_halfedges);
    m_result.m_first_halfedge.reserve(m_number_of_vertices + 1);
    m_result.m_target.reserve(m_number_of_halfedges);
    m_result.m_is_border.reserve(m_number_of_halfedges);

    for(const vertex_descriptor root : vertices(m_mesh))
    {
      copy_component(root);
      if(m_vertices[number(root)] != root)
        reject("vertex index " + std::to_string(checked_index(root)) +
               " is assigned to more than one vertex");
    }
    for(Index& target : m_result.m_target)
      target = m_result.m_vertex_of_index[target];
  }

  void copy_component(const vertex_descriptor root)
  {
    m_frontier.assign(1, root);
    for(std::size_t i = 0; i < m_frontier.size(); ++i)
      copy_patch(m_frontier[i]);
  }

  // Copies a patch of vertices around `center`, and adds vertices beyond it to the frontier.
  void copy_patch(const vertex_descriptor center)
  {
    if(is_numbered(center))
      return;
    const std::size_t first = m_vertices.size();
    number(center);
    for(std::size_t v = first; v < m_vertices.size(); ++v)
      copy_halfedges_around(static_cast<Index>(v), first + SIZE_OF_PATCH);
  }

  bool is_numbered(const vertex_descriptor v) const
  {
    return m_result.m_vertex_of_index[checked_index(v)] != null_index;
  }

  Index number(const vertex_descriptor v)
  {
    const Index i = checked_index(v);
    Index& result = m_result.m_vertex_of_index[i];
    if(result == null_index)
    {
      result = static_cast<Index>(m_vertices.size());
      m_vertices.push_back(v);
      m_result.m_index_of_vertex.push_back(i);
    }
    return result;
  }

  // Targets are mesh indices at first, because some vertices are numbered later.
  void copy_halfedges_around(const Index v, const std::size_t end_of_patch)
  {
    const halfedge_descriptor first = first_halfedge_from(m_vertices[v], m_mesh);
    if(first != Graph_traits::null_halfedge())
    {
      halfedge_descriptor h = first;
      do
      {
        if(h == Graph_traits::null_halfedge())
          reject_halfedges_around(m_vertices[v]);
        Index& number_of_h = m_number_of_halfedge[checked_index(h)];
        if(number_of_h != null_index)
          reject_halfedges_around(m_vertices[v]);
        number_of_h = static_cast<Index>(m_result.m_target.size());
        m_halfedges.push_back(h);
        m_result.m_target.push_back(reach(target(h, m_mesh), end_of_patch));
        m_result.m_is_border.push_back(is_border(h, m_mesh));
        h = counterclockwise(h, m_mesh);
      } while(h != first);
    }
    m_result.m_first_halfedge.push_back(static_cast<Index>(m_result.m_target.size()));
  }

  [[noreturn]] void reject_halfedges_around(const vertex_descriptor v) const
  {
    reject("the halfedges around " + name(checked_index(v)) +
           " do not form one cycle, or their indices are not unique");
  }

  Index reach(const vertex_descriptor v, const std::size_t end_of_patch)
  {
    const Index i = checked_index(v);
    if(m_result.m_vertex_of_index[i] == null_index)
    {
      if(m_vertices.size() < end_of_patch)
        number(v);
      else
        m_frontier.push_back(v);
    }
    return i;
  }

  // Precondition: every halfedge was copied once, in the group of its source.
  void link_opposites()
  {
    const bool are_complete = are_halfedges_complete();
    m_result.m_opposite_rank.resize(m_result.m_target.size());
    for(Index v = 0; v < m_result.number_of_vertices(); ++v)
      for(Index h = m_result.first_halfedge(v); h < m_result.beyond_halfedge(v); ++h)
      {
        const halfedge_descriptor opposite_of_h = opposite(m_halfedges[h], m_mesh);
        const Index opposite = m_number_of_halfedge[checked_index(opposite_of_h)];
        if(opposite == null_index || m_result.target(opposite) != v ||
           !(are_complete || m_halfedges[opposite] == opposite_of_h))
          reject_halfedges_around(m_vertices[m_result.target(h)]);
        m_result.m_opposite_rank.set(h, opposite - m_result.first_halfedge(m_result.target(h)));
      }
  }

  // Whether every halfedge of the mesh was found around a vertex, which implies that indices are
  // unique. Otherwise there are removed halfedges, or the mesh is invalid.
  bool are_halfedges_complete() const { return m_halfedges.size() == m_number_of_halfedges; }

  // Checks that the halfedges on the cycles of faces are exactly those with a face.
  void check_sides() const
  {
    if(!are_halfedges_complete())
      check_that_vertices_know_faces();
    const auto number_of_sides =
        std::count(m_result.m_is_border.begin(), m_result.m_is_border.end(), false);
    if(static_cast<std::size_t>(number_of_sides) != 3 * std::size_t(m_result.m_number_of_faces))
      reject_false_side();
  }

  void check_that_vertices_know_faces() const
  {
    Index number_of_face = 0;
    for(const face_descriptor f : faces(m_mesh))
    {
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        if(m_number_of_halfedge[checked_index(h)] == null_index)
          reject(name_of_face(number_of_face) + " is not found around " +
                 name(checked_index(source(h, m_mesh))));
      ++number_of_face;
    }
  }

  // Names a halfedge that has a face, but is not on the cycle of that face.
  [[noreturn]] void reject_false_side() const
  {
    for(Index h = 0; h < m_halfedges.size(); ++h)
      if(!m_result.m_is_border[h] && !is_on_cycle_of_face(m_halfedges[h], m_mesh))
        reject("the halfedge from " + name(checked_index(source(m_halfedges[h], m_mesh))) + " to " +
               name(checked_index(target(m_halfedges[h], m_mesh))) +
               " has a face, but is not on the cycle of that face");
    reject("there are halfedges with a face that is not in faces()");
  }

  Intrinsic_triangulation& m_result;
  const TriangleMesh& m_mesh;
  const std::size_t m_number_of_vertices; // cached: num_vertices() may be linear
  const std::size_t m_number_of_halfedges;
  const VertexIndexMap m_vertex_index_map;
  const HalfedgeIndexMap m_halfedge_index_map;
  std::vector<vertex_descriptor> m_vertices; // in the order of the triangulation
  std::vector<vertex_descriptor> m_frontier; // possible starts of further patches
  std::vector<halfedge_descriptor> m_halfedges;
  std::vector<Index> m_number_of_halfedge; // by mesh index
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_CONNECTIVITY_READER_H
