// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_PAIRED_SIDES_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_PAIRED_SIDES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Surface/internal/triangulation_arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Border halfedges are at most as many as sides.
inline void check_size_of_mesh(const std::size_t number_of_vertices,
                               const std::size_t number_of_faces)
{
  constexpr std::size_t most = null_index / 6;
  if(number_of_vertices >= null_index || number_of_faces > most)
    throw std::length_error("Approximate_geodesics: the mesh has " +
                            std::to_string(number_of_vertices) + " vertices and " +
                            std::to_string(number_of_faces) +
                            " faces, too many for 32-bit halfedge indices");
}

template <typename Corners>
void check_corners_exist(const std::size_t face,
                         const Corners& corners,
                         const std::size_t number_of_vertices)
{
  for(std::size_t i = 0; i < 3; ++i)
    if(static_cast<std::uint64_t>(corners[i]) >= number_of_vertices) // or negative
      reject("face " + std::to_string(face) + " has vertex " + std::to_string(corners[i]) +
             "; the vertices are numbered from 0, and there are " +
             std::to_string(number_of_vertices));
}

/*
 * The halfedges of a triangle mesh that is given by the corners of its faces. Side `i` of face `f`,
 * from corner `i` to the next one, is halfedge `3 f + i`; border halfedges follow the sides. It
 * takes 28 bytes per vertex.
 */
class Paired_sides
{
public:
  // `corners(f)[i]` is a vertex. Throws if the faces do not form a manifold, and names the element.
  template <typename CornersOfFace>
  Paired_sides(std::size_t number_of_vertices,
               std::size_t number_of_faces,
               const CornersOfFace& corners);

  std::size_t number_of_vertices() const { return m_halfedge.size(); }
  std::size_t number_of_sides() const { return m_opposite.size(); }
  std::size_t number_of_halfedges() const { return m_opposite.size() + m_across_border.size(); }

  bool is_border(const Index h) const { return h >= m_opposite.size(); }

  Index opposite(const Index h) const
  {
    return is_border(h) ? m_across_border[h - m_opposite.size()] : m_opposite[h];
  }

  // A halfedge that ends at `v`: the border halfedge, if there is one, or that of the last face; or
  // `null_index` if `v` is isolated.
  Index halfedge(const Index v) const { return m_halfedge[v]; }

  static Index side_after(const Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index side_before(const Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  // Run time is linear in the degree of the target if `h` is at the border.
  Index next(const Index h) const
  {
    if(!is_border(h))
      return side_after(h);
    Index result = opposite(h);
    while(!is_border(result))
      result = opposite(side_before(result));
    return result;
  }

  std::size_t memory() const { return memory_of(m_opposite, m_across_border, m_halfedge); }

private:
  template <typename CornersOfFace>
  friend class Pairing_of_sides;

  std::vector<Index> m_opposite;      // of each side
  std::vector<Index> m_across_border; // the opposite sides of border halfedges
  std::vector<Index> m_halfedge;      // per vertex
};

/*
 * Pairs sides. They are grouped by their sources with a counting sort. All sides that may belong
 * together then meet around each of their ends, so that neither sorting nor hashing is needed.
 */
template <typename CornersOfFace>
class Pairing_of_sides
{
public:
  Pairing_of_sides(const std::size_t number_of_vertices,
                   const std::size_t number_of_faces,
                   const CornersOfFace& corners,
                   Paired_sides& result)
    : m_number_of_vertices(number_of_vertices),
      m_number_of_faces(number_of_faces),
      m_corners(corners),
      m_result(result)
  {
    check_size_of_mesh(number_of_vertices, number_of_faces);
  }

  void run()
  {
    group_sides();
    resize_in_huge_pages(m_result.m_opposite, m_side.size());
    resize_in_huge_pages(m_result.m_halfedge, m_number_of_vertices);
    reserve_huge_pages(m_side_to, m_number_of_vertices);
    m_side_to.assign(m_number_of_vertices, null_index);
    Index first = 0;
    for(std::size_t v = 0; v < m_number_of_vertices; ++v)
    {
      check_for_interruption_at(v);
      if(!pair_around(static_cast<Index>(v), first, m_beyond[v]))
        reject_around(first, m_beyond[v], static_cast<Index>(v));
      first = m_beyond[v];
    }
    m_result.m_across_border.shrink_to_fit();
    for(std::size_t b = 0; b < m_result.m_across_border.size(); ++b)
      m_result.m_halfedge[source(m_result.m_across_border[b])] =
          static_cast<Index>(m_side.size() + b);
  }

private:
  Index source(const Index side) const { return static_cast<Index>(m_corners(side / 3)[side % 3]); }

  Index target(const Index side) const { return source(Paired_sides::side_after(side)); }

  void check_corners(const std::size_t face) const
  {
    const auto& corners = m_corners(face);
    check_corners_exist(face, corners, m_number_of_vertices);
    for(std::size_t i = 0; i < 3; ++i)
      if(corners[i] == corners[(i + 1) % 3])
        reject("face " + std::to_string(face) + " has vertex " + std::to_string(corners[i]) +
               " twice");
  }

  void group_sides()
  {
    reserve_huge_pages(m_beyond, m_number_of_vertices);
    m_beyond.assign(m_number_of_vertices, 0);
    for(std::size_t f = 0; f < m_number_of_faces; ++f)
    {
      check_for_interruption_at(f);
      check_corners(f);
      for(std::size_t i = 0; i < 3; ++i)
        ++m_beyond[static_cast<Index>(m_corners(f)[i])];
    }
    Index number = 0;
    for(Index& entry : m_beyond)
    {
      const Index degree = entry;
      entry = number;
      number += degree;
    }
    resize_in_huge_pages(m_side, 3 * m_number_of_faces);
    for(std::size_t f = 0; f < m_number_of_faces; ++f)
    {
      check_for_interruption_at(f);
      for(std::size_t i = 0; i < 3; ++i)
        m_side[m_beyond[static_cast<Index>(m_corners(f)[i])]++] = static_cast<Index>(3 * f + i);
    }
  }

  // Finds the opposites of the sides that end at `v`, given the range of those that start there.
  // Returns whether its faces form a single cycle or a single chain.
  bool pair_around(const Index v, const Index first, const Index beyond)
  {
    const Index degree = beyond - first;
    m_result.m_halfedge[v] = null_index;
    if(degree == 0)
      return true;
    for(Index i = first; i < beyond; ++i)
    {
      Index& known = m_side_to[target(m_side[i])];
      if(first <= known && known < beyond)
        return false;
      known = i;
    }
    m_next.resize(degree);
    Index number_of_ends = 0, start = 0; // the sum of all minus that of all but the first
    for(Index i = 0; i < degree; ++i)
    {
      const Index before = Paired_sides::side_before(m_side[first + i]);
      const Index across = m_side_to[source(before)];
      const bool is_paired = first <= across && across < beyond;
      m_next[i] = is_paired ? across - first : degree;
      m_result.m_opposite[before] = is_paired ? m_side[across] : add_border(before);
      start += i - (is_paired ? m_next[i] : 0);
      number_of_ends += is_paired ? 0 : 1;
    }
    m_result.m_halfedge[v] = Paired_sides::side_before(m_side[beyond - 1]);
    return number_of_ends <= 1 && start < degree && is_complete_from(start);
  }

  Index add_border(const Index side)
  {
    m_result.m_across_border.push_back(side);
    return static_cast<Index>(m_side.size() + m_result.m_across_border.size() - 1);
  }

  // Whether all faces around a vertex follow each other counterclockwise.
  bool is_complete_from(const Index start) const
  {
    const std::size_t degree = m_next.size();
    std::size_t number = 1;
    Index i = m_next[start];
    for(; i != start && i < degree && number < degree; ++number)
      i = m_next[i];
    return number == degree && (i == start || i == degree);
  }

  // ----- diagnosis

  struct Side_at_vertex
  {
    Index other_end, face;
    bool starts_here;
    Index third; // vertex of the face
  };

  [[noreturn]] void reject_around(const Index first, const Index beyond, const Index v) const
  {
    std::vector<Side_at_vertex> sides;
    for(Index i = first; i < beyond; ++i)
    {
      const Index side = m_side[i], to = target(side);
      const Index from = source(Paired_sides::side_before(side));
      sides.push_back({to, side / 3, true, from});
      sides.push_back({from, side / 3, false, to});
    }
    reject_equal_faces(sides);
    std::sort(sides.begin(), sides.end(), [](const Side_at_vertex& a, const Side_at_vertex& b) {
      return std::tie(a.other_end, a.face) < std::tie(b.other_end, b.face);
    });
    for(std::size_t i = 1; i < sides.size(); ++i)
      if(sides[i].other_end == sides[i - 1].other_end)
        check_edge(sides, i - 1, v);
    reject("vertex " + std::to_string(v) +
           " is not manifold: its faces form several groups that share no edge");
  }

  // Changes the order of `sides`.
  static void reject_equal_faces(std::vector<Side_at_vertex>& sides)
  {
    const auto corners = [](const Side_at_vertex& s) {
      return std::tie(s.other_end, s.third, s.starts_here);
    };
    std::sort(sides.begin(), sides.end(), [&](const Side_at_vertex& a, const Side_at_vertex& b) {
      return std::tuple_cat(corners(a), std::tie(a.face)) <
             std::tuple_cat(corners(b), std::tie(b.face));
    });
    const auto equal = std::adjacent_find(
        sides.begin(), sides.end(),
        [&](const Side_at_vertex& a, const Side_at_vertex& b) { return corners(a) == corners(b); });
    if(equal != sides.end())
      reject("face " + std::to_string(equal->face) + " and face " + std::to_string(equal[1].face) +
             " have the same vertices in the same order");
  }

  // Checks the sides of an edge, of which there are two or more.
  static void
  check_edge(const std::vector<Side_at_vertex>& sides, const std::size_t i, const Index v)
  {
    const Side_at_vertex &a = sides[i], &b = sides[i + 1];
    const std::string face_a = "face " + std::to_string(a.face),
                      face_b = "face " + std::to_string(b.face);
    const std::string edge = "the edge between vertices " +
                             std::to_string((std::min)(v, a.other_end)) + " and " +
                             std::to_string((std::max)(v, a.other_end));
    if(i + 2 < sides.size() && sides[i + 2].other_end == a.other_end)
      reject(edge + " is not manifold: " + face_a + ", " + face_b + " and face " +
             std::to_string(sides[i + 2].face) + " share it");
    if(a.starts_here == b.starts_here)
      reject(face_a + " and " + face_b + " traverse " + edge +
             " in the same direction; adjacent faces must have the same orientation");
  }

  const std::size_t m_number_of_vertices, m_number_of_faces;
  const CornersOfFace& m_corners;
  Paired_sides& m_result;
  std::vector<Index> m_side;    // all sides, grouped by their sources
  std::vector<Index> m_beyond;  // per vertex, the end of its group
  std::vector<Index> m_side_to; // per vertex, where a side from the current vertex is in `m_side`
  std::vector<Index> m_next;    // per face around a vertex, the next one counterclockwise
};

template <typename CornersOfFace>
Paired_sides::Paired_sides(const std::size_t number_of_vertices,
                           const std::size_t number_of_faces,
                           const CornersOfFace& corners)
{
  Pairing_of_sides<CornersOfFace>(number_of_vertices, number_of_faces, corners, *this).run();
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_PAIRED_SIDES_H
