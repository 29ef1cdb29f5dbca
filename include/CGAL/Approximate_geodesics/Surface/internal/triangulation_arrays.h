// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_TRIANGULATION_ARRAYS_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_TRIANGULATION_ARRAYS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// The number of a vertex, a halfedge or a face.
using Index = std::uint32_t;

// The null index.
constexpr Index null_index = (std::numeric_limits<Index>::max)();

/*
 * For every halfedge, the rank of its opposite among the halfedges that start from its target.
 *
 * Almost all ranks fit one byte: that is 6 bytes per vertex, where the numbers of opposite
 * halfedges would take 24. Larger ranks, at vertices of high degree, are in a hash table.
 */
class Opposite_ranks
{
public:
  void resize(const std::size_t number_of_halfedges)
  {
    resize_in_huge_pages(m_rank, number_of_halfedges + SIZE_OF_COPY - 1);
  }

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
  // `h`. What is behind these may be lost.
  void copy(const Opposite_ranks& other, const Index first, const Index number, const Index h)
  {
    if(!other.m_large_rank.empty())
      for(Index i = 0; i < number; ++i)
        set(h + i, other.rank_of_opposite(first + i));
    else
      for(Index i = 0; i < number; i += SIZE_OF_COPY)
        std::memcpy(m_rank.data() + h + i, other.m_rank.data() + first + i, SIZE_OF_COPY);
  }

  void prefetch(const Index h) const { internal::prefetch(m_rank.data(), h); }

  std::size_t memory() const
  {
    constexpr std::size_t bytes_per_node = sizeof(void*) + 2 * sizeof(Index) + 2 * sizeof(void*);
    return m_rank.capacity() + m_large_rank.size() * bytes_per_node;
  }

private:
  static constexpr std::uint8_t LARGE = 255;
  static constexpr std::size_t SIZE_OF_COPY = 8; // at once

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
  // Around its source.
  struct Border_halfedge
  {
    Index source, rank;
  };

  Opposite_ranks opposite_rank;
  std::vector<Border_halfedge> border;
  std::size_t number_of_faces = 0;
};

/*
 * The shape of a face that rounded lengths do not determine. Divided by the lengths of two sides,
 * the numbers are the cosines of the angles, and a sine.
 */
struct Thin_face
{
  // for each corner, the scalar product of the two sides, as vectors that start there
  std::array<double, 3> at_corner;
  double doubled_area;
};

/*
 * The shapes of a mesh's thin faces. A cap, whose corners are nearly in line, has a height that is
 * as small as the rounding errors of its sides, or smaller; and at the short edge of a needle, the
 * angles depend on the difference of the two long ones.
 *
 * A face takes 36 bytes. If there is any, an index takes 4 bytes per 128 halfedges.
 */
class Thin_faces
{
public:
  using Halfedges = std::array<Index, 3>; // of a face, one after the other

  bool is_empty() const { return m_halfedge.empty(); }

  // Returns whether sides of these lengths, with relative errors of about 3 * 2^-53, do not
  // determine the shape of a triangle. If they do, the relative errors of the height, and of the
  // position of a corner seen from another one, are below 1e-12.
  static bool is_thin(const double a, const double b, const double c)
  {
    constexpr double worst = 4096;        // times the error of a side
    constexpr double smallest = 0x1p-900; // below, products may have lost bits to underflow
    const double smaller = (std::min)(a, b), larger = (std::max)(a, b);
    const double x = (std::max)(larger, c), z = (std::min)(smaller, c);
    const double y = (std::max)(smaller, (std::min)(larger, c));
    const double size = z * (x + (y + z));
    // Heron's formula multiplies these differences, whose errors are those of the sides
    return 2 * size > worst * ((z - (x - y)) * (z + (x - y))) && size > smallest;
  }

  // Adds the shape of the face with these halfedges, whose corners are their sources.
  // \pre The first one has the smallest number, and a larger one than those of the faces before.
  void add(const Halfedges& halfedges, const Thin_face& face)
  {
    const std::size_t block = halfedges[0] / SIZE_OF_BLOCK;
    while(m_first_of_block.size() <= block)
      m_first_of_block.push_back(static_cast<Index>(m_halfedge.size()));
    m_halfedge.push_back(halfedges[0]);
    m_face.push_back(face);
    m_has_extreme_needles = m_has_extreme_needles || is_extreme_needle(face);
  }

  // Returns whether there are needles so long that the direction of a short side is lost to
  // rounding when its ends are laid out far from the origin.
  bool has_extreme_needles() const { return m_has_extreme_needles; }

  void shrink_to_fit()
  {
    m_first_of_block.shrink_to_fit();
    m_halfedge.shrink_to_fit();
    m_face.shrink_to_fit();
  }

  // Returns the shape of the face with these halfedges, whose corners are their sources, if stored.
  std::optional<Thin_face> find(const Halfedges& halfedges) const
  {
    const auto first = std::min_element(halfedges.begin(), halfedges.end());
    const std::size_t block = *first / SIZE_OF_BLOCK;
    if(block >= m_first_of_block.size())
      return std::nullopt;
    const auto beyond = block + 1 < m_first_of_block.size()
                            ? m_halfedge.begin() + m_first_of_block[block + 1]
                            : m_halfedge.end();
    const auto found =
        std::lower_bound(m_halfedge.begin() + m_first_of_block[block], beyond, *first);
    if(found == beyond || *found != *first)
      return std::nullopt;
    Thin_face result = m_face[static_cast<std::size_t>(found - m_halfedge.begin())];
    std::rotate(result.at_corner.begin(),
                result.at_corner.begin() + (halfedges.begin() - first + 3) % 3,
                result.at_corner.end());
    return result;
  }

  std::size_t number_of_faces() const { return m_face.size(); }

  std::size_t memory() const { return memory_of(m_first_of_block, m_halfedge, m_face); }

private:
  static constexpr Index SIZE_OF_BLOCK = 128; // in halfedges

  static bool is_extreme_needle(const Thin_face& face)
  {
    // Rounding moves the ends of a short side by 2^-53 of their distance, and so turns it by that
    // times the aspect. What is seen behind it is off by as much: below 1e-11 of the distance.
    constexpr double largest_aspect = 0x1p14; // of a needle, squared sides of which are these sums
    const auto [a, b, c] = face.at_corner;
    const auto [shortest, longest] = std::minmax({a + b, b + c, c + a});
    return longest > largest_aspect * largest_aspect * shortest;
  }

  std::vector<Index> m_first_of_block; // the number of its first face
  std::vector<Index> m_halfedge;       // of each face, the one with the smallest number
  std::vector<Thin_face> m_face;       // the corner of that halfedge comes first
  bool m_has_extreme_needles = false;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_TRIANGULATION_ARRAYS_H
