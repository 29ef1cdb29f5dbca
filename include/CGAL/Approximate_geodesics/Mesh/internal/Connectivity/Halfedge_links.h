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
 * The halfedge connectivity of a mesh, copied to a compact array in the order of the mesh. Rotating
 * around vertices on the mesh itself would cause a cache miss per step; sequential copying is
 * prefetched by the hardware. Faces are checked in memory order for the same reason.
 *
 * Invalid or unusual meshes make read() fail; `Connectivity_reader` diagnoses them.
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

  // The target of a halfedge, and the next halfedge counterclockwise around its source.
  struct Link
  {
    Index target;
    Index counterclockwise;
  };

  // Precondition: there are fewer than `null_index` halfedges, and vertices are listed.
  Halfedge_links(const Numbers& numbers, HalfedgeIndexMap halfedge_index_map)
    : m_numbers(numbers),
      m_mesh(numbers.mesh()),
      m_number_of_halfedges(num_halfedges(m_mesh)),
      m_halfedge_index_map(std::move(halfedge_index_map))
  {
  }

  // Returns whether all links are valid, all faces are triangles, indices are unique, and the mesh
  // has no removed elements.
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

  // By mesh index. The caller may overwrite `counterclockwise`.
  std::vector<Link>& links() { return m_links; }

  // The prefix sums of the degrees of the vertices.
  std::vector<Index>& first_of_vertex() { return m_first_of_vertex; }

  // Returns the index of the first halfedge from a vertex, or `null_index` if there is none or it
  // is invalid.
  Index first_halfedge_from(const Index v) const
  {
    const halfedge_descriptor toward = halfedge(m_numbers.vertex(v), m_mesh);
    if(toward == Graph_traits::null_halfedge())
      return null_index;
    const std::size_t i = index(toward), result = index(opposite(toward, m_mesh));
    const bool is_right = i < m_links.size() && result < m_links.size() && m_links[i].target == v;
    return is_right ? static_cast<Index>(result) : null_index;
  }

  // Calls `f(index, opposite_index, is_border)` for all halfedges, in the order of the mesh.
  template <typename F>
  void for_each_halfedge(F f) const
  {
    for(const halfedge_descriptor h : halfedges(m_mesh))
      f(index(h), index(opposite(h, m_mesh)), is_border(h, m_mesh));
  }

private:
  std::size_t index(const halfedge_descriptor h) const // unchecked
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

  // Returns false if the index is a duplicate, that is, its link already has a target.
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
    ++m_first_of_vertex[std::size_t(v) + 1]; // in-degree equals out-degree
    return true;
  }

  // Whether all faces are triangles, and include all halfedges that refer to a face.
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
  const std::size_t m_number_of_halfedges; // cached: num_halfedges() may be linear
  const HalfedgeIndexMap m_halfedge_index_map;
  std::vector<Link> m_links;
  std::vector<Index> m_first_of_vertex;
  std::size_t m_number_of_faces = 0;
  std::size_t m_number_of_sides = 0; // halfedges that refer to a face
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_HALFEDGE_LINKS_H
