// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_ADJACENCY_READER_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_ADJACENCY_READER_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/Halfedge_links.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Connectivity/halfedge_groups.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Connectivity.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Reads the vertex adjacency of a mesh for a single search: it keeps the order of the mesh's own
 * indices, and skips data that only faces require. It performs the checks of `Connectivity_reader`,
 * but only reports success or failure; `Connectivity_reader` diagnoses the error.
 */
template <typename Numbers, typename HalfedgeIndexMap>
class Adjacency_reader
{
  using Triangle_mesh = typename Numbers::Triangle_mesh;
  using halfedge_descriptor = typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor;
  using Links = Halfedge_links<Numbers, HalfedgeIndexMap>;
  using Link = typename Links::Link;
  using Index = typename Numbers::Index;

public:
  // Precondition: there are fewer than `null_index` halfedges.
  Adjacency_reader(const Numbers& numbers, HalfedgeIndexMap halfedge_index_map)
    : m_numbers(numbers), m_halfedge_index_map(std::move(halfedge_index_map))
  {
  }

  // Returns whether the mesh is valid and has no removed elements. Precondition: vertices are
  // listed. May be called only once, because it consumes the index map, which can be large.
  bool read()
  {
    Links links(m_numbers, std::move(m_halfedge_index_map));
    return links.read() && copy_halfedges<false>(links);
  }

  // Also reads the data that faces require.
  bool read_with_faces()
  {
    Links links(m_numbers, std::move(m_halfedge_index_map));
    if(!links.read())
      return false;
    m_result.number_of_faces = links.number_of_faces();
    if(!copy_halfedges<true>(links))
      return false;
    copy_sides(links);
    return true;
  }

  const Connectivity& adjacency() const { return m_result; }
  Connectivity& adjacency() { return m_result; }

  // Throws like the constructor of `Intrinsic_triangulation` if a coordinate or a length is
  // invalid.
  template <typename NamedParameters>
  Edge_lengths lengths(const NamedParameters& np) const
  {
    std::vector<halfedge_descriptor> halfedges;
    if constexpr(is_given<NamedParameters, internal_np::edge_length_t>)
      halfedges = halfedges_in_groups(m_numbers.list(), m_result, m_numbers.mesh());
    No_corners corners;
    return read_edge_lengths(m_numbers.mesh(), m_numbers.list(), halfedges, np, m_result, corners);
  }

private:
  // If `keeps_ranks`, replaces each counterclockwise link by the rank of the halfedge around its
  // source.
  template <bool keeps_ranks>
  bool copy_halfedges(Links& links)
  {
    m_result.first_of_vertex = std::move(links.first_of_vertex());
    m_result.target_of_halfedge.resize(m_result.number_of_halfedges());
    for(Index v = 0; v < m_result.number_of_vertices(); ++v)
    {
      const Index first = links.first_halfedge_from(v);
      if((first == Links::null_index) != (m_result.degree(v) == 0) ||
         !copy_cycle<keeps_ranks>(links.links().data(), first, v))
        return false;
    }
    return true;
  }

  // Returns whether all halfedges from `v` form a single cycle. The halfedges of a cycle share
  // their source.
  template <bool keeps_ranks>
  bool copy_cycle(Link* const links, const Index first, const Index v)
  {
    Index* const target = m_result.target_of_halfedge.data(); // stays in a register
    const Index begin = m_result.first_halfedge(v), degree = m_result.degree(v);
    Index h = first;
    for(Index rank = 0; rank < degree; ++rank)
    {
      Link& link = links[h];
      target[begin + rank] = link.target;
      h = link.counterclockwise;
      if constexpr(keeps_ranks)
        link.counterclockwise = rank;
      if((h == first) != (rank + 1 == degree))
        return false;
    }
    return true;
  }

  void copy_sides(Links& links)
  {
    const Link* const ranks = links.links().data();
    m_result.opposite_rank.resize(m_result.number_of_halfedges());
    if(m_result.has_border())
      m_result.is_border.resize(m_result.number_of_halfedges());
    links.for_each_halfedge(
        [&](const std::size_t i, const std::size_t opposite, const bool is_border) {
          const Index source = ranks[opposite].target;
          const Index h = m_result.first_halfedge(source) + ranks[i].counterclockwise;
          m_result.opposite_rank.set(h, ranks[opposite].counterclockwise);
          if(is_border)
            m_result.is_border[h] = true;
        });
  }

  const Numbers& m_numbers;
  HalfedgeIndexMap m_halfedge_index_map;
  Connectivity m_result;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_CONNECTIVITY_ADJACENCY_READER_H
