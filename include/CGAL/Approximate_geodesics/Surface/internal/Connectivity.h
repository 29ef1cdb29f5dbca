// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The number of a vertex, a halfedge or a face.
using Index = std::uint32_t;

/*
 * For every halfedge, the rank of its opposite among the halfedges that start from its target.
 *
 * Almost all ranks fit one byte: that is 6 bytes per vertex, where the numbers of opposite
 * halfedges would take 24. Larger ranks, at vertices of high degree, are in a hash table.
 */
class Opposite_ranks
{
public:
  void resize(const std::size_t number_of_halfedges) { m_rank.resize(number_of_halfedges); }

  Index rank_of_opposite(const Index h) const
  {
    return m_rank[h] == LARGE ? m_large_rank.find(h)->second : m_rank[h];
  }

  void set(const Index h, const Index rank)
  {
    if(rank < LARGE)
      m_rank[h] = static_cast<std::uint8_t>(rank);
    else
    {
      m_rank[h] = LARGE;
      m_large_rank[h] = rank;
    }
  }

  // Copies the ranks of `number` halfedges of `other`, starting at `first`, to those starting at
  // `h`.
  void copy(const Opposite_ranks& other, const Index first, const Index number, const Index h)
  {
    if(other.m_large_rank.empty())
      std::copy_n(other.m_rank.data() + first, number, m_rank.data() + h);
    else
      for(Index i = 0; i < number; ++i)
        set(h + i, other.rank_of_opposite(first + i));
  }

  void prefetch(const Index h) const { internal::prefetch(m_rank.data(), h); }

  std::size_t memory() const
  {
    constexpr std::size_t bytes_per_node = sizeof(void*) + 2 * sizeof(Index) + 2 * sizeof(void*);
    return m_rank.capacity() + m_large_rank.size() * bytes_per_node;
  }

private:
  static constexpr std::uint8_t LARGE = 255;

  std::vector<std::uint8_t> m_rank;
  std::unordered_map<Index, Index> m_large_rank;
};

/*
 * The vertex adjacency of a mesh: what a search along edges requires of an
 * `Intrinsic_triangulation`, under the same names and with halfedges grouped in the same way.
 * Vertices have the indices of the mesh.
 */
struct Vertex_adjacency
{
  Index number_of_vertices() const { return static_cast<Index>(first_of_vertex.size() - 1); }
  Index number_of_halfedges() const { return first_of_vertex.back(); }

  Index first_halfedge(const Index v) const { return first_of_vertex[v]; }
  Index beyond_halfedge(const Index v) const { return first_of_vertex[v + 1]; }
  Index degree(const Index v) const { return beyond_halfedge(v) - first_halfedge(v); }

  Index target(const Index h) const { return target_of_halfedge[h]; }

  // Run time is logarithmic.
  Index source(const Index h) const
  {
    const auto beyond = std::upper_bound(first_of_vertex.begin(), first_of_vertex.end(), h);
    return static_cast<Index>(beyond - first_of_vertex.begin()) - 1;
  }

  // the index of a vertex in the mesh
  static Index index(const Index v) { return v; }

  std::vector<Index> first_of_vertex; // prefix sums of the degrees
  std::vector<Index> target_of_halfedge;
};

// The connectivity of a mesh: the same arrays as in an `Intrinsic_triangulation`.
struct Connectivity : Vertex_adjacency
{
  bool has_border() const { return 3 * number_of_faces < number_of_halfedges(); }

  Opposite_ranks opposite_rank;
  std::vector<bool> is_border; // per halfedge, or empty if there is no border
  std::size_t number_of_faces = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_CONNECTIVITY_H
