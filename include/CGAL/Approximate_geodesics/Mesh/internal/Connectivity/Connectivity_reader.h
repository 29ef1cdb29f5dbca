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
 * Reads how a mesh hangs together into an `Intrinsic_triangulation`, and checks it, with the help
 * of the header on links of faces. Named parameters are no business of this class, so that it is
 * compiled once for a mesh type and its index maps, whatever else is given.
 *
 * Where the mesh is right in every respect, and nothing was removed from it, its links are read in
 * the order of its memory. If not, the mesh is traversed step by step, to find out what is wrong,
 * or that it can be used as it is; this comes to the same, and takes more time.
 *
 * One traversal numbers the vertices and writes the halfedge groups at the same time: the group of
 * a vertex is read when its turn comes, and numbers its new neighbors. Numbers follow
 * a breadth-first order; on large meshes, one patch of the surface after the other, so that
 * vertices that are close to each other have close numbers in all directions, and a search from any
 * source finds more of what it needs in the cache lines and pages that it used last.
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

  // `needs_halfedges` says whether something is to be read from halfedges afterwards.
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
    m_frontier = std::vector<vertex_descriptor>(); // lengths would add to what it takes
    m_number_of_halfedge = std::vector<Index>();
    if(!needs_halfedges)
      m_halfedges = std::vector<halfedge_descriptor>();
  }

  // In the order of their numbers.
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
                              " halfedges, more than 32-bit numbers can tell apart");
  }

  // Returns whether the mesh is as usual; else there is no result.
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
    if(static_cast<std::size_t>(i) >= size) // so is a negative one
      reject(std::string(kind) + " index " + std::to_string(i) +
             " is out of range: the mesh has room for " + std::to_string(size));
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
               " is given to more than one vertex");
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

  // Copies the vertices around `center`; those beyond the patch go to the frontier.
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

  // Targets are indices of the mesh at first, as some get their numbers later.
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

  // Every halfedge was copied once, from the group of its source.
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

  // Whether every halfedge of the mesh was found around a vertex; no index is given twice then. If
  // not, there are removed ones, or something is wrong.
  bool are_halfedges_complete() const { return m_halfedges.size() == m_number_of_halfedges; }

  // The halfedges of a face have to be those that were found to have one, no fewer and no more.
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
          reject(name_of_face(number_of_face) + " is not one of those around " +
                 name(checked_index(source(h, m_mesh))));
      ++number_of_face;
    }
  }

  // Names a halfedge that has a face, but is not one of those that go round it.
  [[noreturn]] void reject_false_side() const
  {
    for(Index h = 0; h < m_halfedges.size(); ++h)
      if(!m_result.m_is_border[h] && !is_on_cycle_of_face(m_halfedges[h], m_mesh))
        reject("the halfedge from " + name(checked_index(source(m_halfedges[h], m_mesh))) + " to " +
               name(checked_index(target(m_halfedges[h], m_mesh))) +
               " has a face, but is not one of those that go round it");
    reject("there are halfedges with a face that is not one of faces()");
  }

  Intrinsic_triangulation& m_result;
  const TriangleMesh& m_mesh;
  const std::size_t m_number_of_vertices; // kept, as some meshes count them at every call
  const std::size_t m_number_of_halfedges;
  const VertexIndexMap m_vertex_index_map;
  const HalfedgeIndexMap m_halfedge_index_map;
  std::vector<vertex_descriptor> m_vertices; // in the order of their numbers
  std::vector<vertex_descriptor> m_frontier; // where further patches of the component may start
  std::vector<halfedge_descriptor> m_halfedges;
  std::vector<Index> m_number_of_halfedge; // by index
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_CONNECTIVITY_READER_H
