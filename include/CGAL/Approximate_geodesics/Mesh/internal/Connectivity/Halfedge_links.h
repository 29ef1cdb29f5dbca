// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_HALFEDGE_LINKS_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_HALFEDGE_LINKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/internal/face_links.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * How the halfedges of a mesh hang together, for those who go round its vertices: on the mesh
 * itself, the processor would wait for the memory at every step. So the links are copied to a small
 * array first, in the order of the mesh, which it can foresee. Faces are checked in their order,
 * for the same reason.
 *
 * Nothing is rejected: what is wrong, or unusual, is for `Connectivity_reader` to find out.
 */
template <typename Numbers, typename HalfedgeIndexMap>
class Halfedge_links
{
  using Triangle_mesh = typename Numbers::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  using Index = typename Numbers::Index;

  static constexpr Index null_index = Numbers::null_index;

  // The vertex that a halfedge ends at, and the index of the next one around that it starts from.
  struct Link
  {
    Index target;
    Index counterclockwise;
  };

  // There are fewer than `null_index` halfedges, and vertices are listed.
  Halfedge_links(const Numbers& numbers, HalfedgeIndexMap halfedge_index_map)
    : m_numbers(numbers),
      m_mesh(numbers.mesh()),
      m_number_of_halfedges(num_halfedges(m_mesh)),
      m_halfedge_index_map(std::move(halfedge_index_map))
  {
  }

  // Returns whether all links are right and all faces triangles, each index stands for exactly one
  // halfedge, and nothing was removed from the mesh.
  bool read()
  {
    m_links.assign(m_number_of_halfedges, {null_index, null_index});
    m_first_of_vertex.assign(m_numbers.list().size() + 1, 0);
    if(!link_halfedges() || !are_faces_right())
      return false;
    std::partial_sum(m_first_of_vertex.begin(), m_first_of_vertex.end(), m_first_of_vertex.begin());
    return true;
  }

  std::size_t number_of_faces() const { return m_number_of_faces; }

  // By index. What is counterclockwise may be overwritten.
  std::vector<Link>& links() { return m_links; }

  // How many halfedges start from the vertices before each one, and from all of them.
  std::vector<Index>& first_of_vertex() { return m_first_of_vertex; }

  // The first halfedge from a vertex, by its index; `null_index` if there is none, or it is not one
  // of the vertex.
  Index first_halfedge_from(const Index v) const
  {
    const halfedge_descriptor toward = halfedge(m_numbers.vertex(v), m_mesh);
    if(toward == Graph_traits::null_halfedge())
      return null_index;
    const std::size_t i = index(toward), result = index(opposite(toward, m_mesh));
    const bool is_right = i < m_links.size() && result < m_links.size() && m_links[i].target == v;
    return is_right ? static_cast<Index>(result) : null_index;
  }

  // Calls `f(index, index of the opposite one, whether it is at a border)`, in the order of the
  // mesh.
  template <typename F>
  void for_each_halfedge(F f) const
  {
    for(const halfedge_descriptor h : halfedges(m_mesh))
      f(index(h), index(opposite(h, m_mesh)), is_border(h, m_mesh));
  }

private:
  std::size_t index(const halfedge_descriptor h) const // as large as it may be
  {
    return static_cast<std::size_t>(get(m_halfedge_index_map, h));
  }

  bool link_halfedges()
  {
    std::size_t number = 0, number_of_sides = 0;
    for(const halfedge_descriptor h : halfedges(m_mesh))
    {
      if(!link(h) || (is_border(h, m_mesh) && !follows_its_predecessor(h)))
        return false;
      ++number;
      number_of_sides += is_border(h, m_mesh) ? 0 : 1;
    }
    m_number_of_sides = number_of_sides;
    return number == m_number_of_halfedges;
  }

  // The index must not have been met before: its link has no target until then.
  bool link(const halfedge_descriptor h)
  {
    const halfedge_descriptor before = prev(h, m_mesh);
    if(before == Graph_traits::null_halfedge())
      return false;
    const std::size_t i = index(h), counterclockwise = index(opposite(before, m_mesh));
    const Index v = m_numbers.node(target(h, m_mesh));
    if(i >= m_number_of_halfedges || counterclockwise >= m_number_of_halfedges || v == null_index ||
       opposite(opposite(h, m_mesh), m_mesh) != h || m_links[i].target != null_index)
      return false;
    m_links[i] = {v, static_cast<Index>(counterclockwise)};
    ++m_first_of_vertex[std::size_t(v) + 1]; // as many start from there as end there
    return true;
  }

  // Whether faces are triangles, and have all halfedges that say they have a face.
  bool are_faces_right()
  {
    for(const face_descriptor f : faces(m_mesh))
    {
      const halfedge_descriptor h = halfedge(f, m_mesh);
      if(h == Graph_traits::null_halfedge() || !is_linked_triangle(f, m_mesh))
        return false;
      const halfedge_descriptor g = next(h, m_mesh), k = next(g, m_mesh);
      if(target(h, m_mesh) != source(g, m_mesh) || target(g, m_mesh) != source(k, m_mesh) ||
         target(k, m_mesh) != source(h, m_mesh))
        return false;
      ++m_number_of_faces;
    }
    return 3 * m_number_of_faces == m_number_of_sides;
  }

  bool follows_its_predecessor(const halfedge_descriptor h) const
  {
    const halfedge_descriptor before = prev(h, m_mesh);
    return next(before, m_mesh) == h && target(before, m_mesh) == source(h, m_mesh);
  }

  const Numbers& m_numbers;
  const Triangle_mesh& m_mesh;
  const std::size_t m_number_of_halfedges; // kept, as some meshes count them at every call
  const HalfedgeIndexMap m_halfedge_index_map;
  std::vector<Link> m_links;
  std::vector<Index> m_first_of_vertex;
  std::size_t m_number_of_faces = 0;
  std::size_t m_number_of_sides = 0; // halfedges that say they have a face
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_HALFEDGE_LINKS_H
