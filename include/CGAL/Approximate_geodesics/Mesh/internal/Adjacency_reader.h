// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_ADJACENCY_READER_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_ADJACENCY_READER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/face_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/halfedge_groups.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/property_maps.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Vertex_adjacency.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Reads the edges of a mesh for a search that is the only one: everything stays in the order of the
 * mesh's own indices, and what only faces need is left out. The checks are those of
 * `Triangulation_builder`, but only tell whether anything is wrong, or unusual: it is for the
 * builder to find out what.
 *
 * Going round a vertex of the mesh, the processor would wait for the memory at every step. So the
 * halfedges around vertices are linked in a small array first, in the order of the mesh, which it
 * can foresee; and counted, so that it need not wait for the end of a cycle either.
 */
template <typename Numbers, typename NamedParameters>
class Adjacency_reader
{
  using Triangle_mesh = typename Numbers::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Index = typename Numbers::Index;
  using Halfedge_index_map = decltype(halfedge_index_map(std::declval<const Triangle_mesh&>(),
                                                         std::declval<const NamedParameters&>()));

  static constexpr Index null_index = Numbers::null_index;

public:
  // There are fewer than `null_index` halfedges.
  Adjacency_reader(const Numbers& numbers, const NamedParameters& np)
    : m_numbers(numbers),
      m_mesh(numbers.mesh()),
      m_np(np),
      m_number_of_halfedges(num_halfedges(m_mesh)),
      m_halfedge_index_map(halfedge_index_map(m_mesh, np))
  {
  }

  // Returns whether the mesh is right in every respect, and nothing was removed from it. Vertices
  // have to be listed before.
  bool read()
  {
    const bool result = link_halfedges() && copy_halfedges() && are_faces_right();
    m_links = std::vector<Link>(); // frees its memory
    return result;
  }

  const Vertex_adjacency& adjacency() const { return m_result; }
  Vertex_adjacency& adjacency() { return m_result; }

  // Throws as the constructor of a triangulation does if a coordinate or a length is none.
  Edge_lengths lengths() const
  {
    return read_edge_lengths(m_mesh, m_numbers.list(), m_halfedges, m_np, m_result);
  }

private:
  // The vertex that a halfedge ends at, and the index of the next one around that it starts from.
  struct Link
  {
    Index target;
    Index counterclockwise;
  };

  // as large as it may be
  std::size_t index(const halfedge_descriptor h) const
  {
    return static_cast<std::size_t>(get(m_halfedge_index_map, h));
  }

  // Each index has to be that of one halfedge: its link has no target until then.
  bool link_halfedges()
  {
    m_links.assign(m_number_of_halfedges, {null_index, null_index});
    m_result.first_of_vertex.assign(m_numbers.list().size() + 1, 0);
    std::size_t number = 0, number_of_sides = 0;
    for(const halfedge_descriptor h : halfedges(m_mesh))
    {
      const std::size_t i = index(h);
      if(i >= m_number_of_halfedges || m_links[i].target != null_index)
        return false;
      const Index v = m_numbers.node(target(h, m_mesh));
      const halfedge_descriptor before = prev(h, m_mesh);
      if(v == null_index || !is_linked(before, h))
        return false;
      const std::size_t counterclockwise = index(opposite(before, m_mesh));
      if(counterclockwise >= m_number_of_halfedges)
        return false;
      m_links[i] = {v, static_cast<Index>(counterclockwise)};
      ++m_result.first_of_vertex[v + 1]; // as many start from there as end there
      ++number;
      number_of_sides += is_border(h, m_mesh) ? 0 : 1;
    }
    m_number_of_sides = number_of_sides;
    return number == m_number_of_halfedges;
  }

  // Whether a halfedge and the one before it are linked in both directions, and share a vertex.
  bool is_linked(const halfedge_descriptor before, const halfedge_descriptor h) const
  {
    return before != Graph_traits::null_halfedge() && next(before, m_mesh) == h &&
           opposite(opposite(before, m_mesh), m_mesh) == before &&
           target(before, m_mesh) == source(h, m_mesh);
  }

  bool copy_halfedges()
  {
    std::vector<Index>& first = m_result.first_of_vertex;
    std::partial_sum(first.begin(), first.end(), first.begin());
    m_result.target_of_halfedge.resize(first.back());
    Index* end = m_result.target_of_halfedge.data(); // kept in a register
    for(Index v = 0; v < m_result.number_of_vertices(); ++v)
      if(!copy_halfedges_around(v, end))
        return false;
    return true;
  }

  // Returns whether there is one cycle of all halfedges from `v`. Those of a cycle have one source.
  bool copy_halfedges_around(const Index v, Index*& end)
  {
    const halfedge_descriptor toward = halfedge(m_numbers.vertex(v), m_mesh);
    if(toward == Graph_traits::null_halfedge())
      return m_result.degree(v) == 0;
    const halfedge_descriptor h = opposite(toward, m_mesh);
    const std::size_t i = index(toward), first = index(h);
    if(i >= m_number_of_halfedges || first >= m_number_of_halfedges || m_links[i].target != v ||
       m_result.degree(v) == 0)
      return false;
    list_halfedges_from(h, m_result.degree(v));
    std::size_t next = first;
    for(Index left = m_result.degree(v); left > 0; --left)
    {
      *end++ = m_links[next].target;
      next = m_links[next].counterclockwise;
      if((next == first) != (left == 1))
        return false;
    }
    return true;
  }

  void list_halfedges_from([[maybe_unused]] halfedge_descriptor h, [[maybe_unused]] Index number)
  {
    if constexpr(lists_halfedges)
      for(; number > 0; --number)
      {
        m_halfedges.push_back(h);
        h = counterclockwise(h, m_mesh);
      }
  }

  // Returns whether faces are triangles, and have all halfedges that say they have a face.
  bool are_faces_right() const
  {
    std::size_t number_of_sides = 0;
    for(const face_descriptor f : faces(m_mesh))
    {
      if(halfedge(f, m_mesh) == Graph_traits::null_halfedge() || !is_linked_triangle(f, m_mesh))
        return false;
      number_of_sides += 3;
    }
    return number_of_sides == m_number_of_sides;
  }

  static constexpr bool lists_halfedges = is_given<NamedParameters, internal_np::edge_length_t>;

  const Numbers& m_numbers;
  const Triangle_mesh& m_mesh;
  const NamedParameters& m_np;
  const std::size_t m_number_of_halfedges; // kept, as some meshes count them at every call
  const Halfedge_index_map m_halfedge_index_map;
  std::vector<Link> m_links;         // by index
  std::size_t m_number_of_sides = 0; // of faces
  Vertex_adjacency m_result;
  std::vector<halfedge_descriptor> m_halfedges; // only if they are asked for their lengths
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_ADJACENCY_READER_H
