// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Refined_needles.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// A direction at a point of a mesh: to the left of `halfedge` by `angle`. If the point is a vertex,
// the halfedge starts there; if not, the point is in the face to the left of the halfedge.
struct Direction_in_mesh
{
  Index halfedge;
  double angle;
};

/*
 * Another triangulation of the surface of a mesh, in which straight lines cross fewer faces: with
 * refined needles, balanced fans, or both. Its first vertices are those of the mesh.
 */
class Retriangulation
{
public:
  // Returns the retriangulation of `mesh`, if its faces need one.
  static std::optional<Retriangulation> make(const Intrinsic_triangulation& mesh,
                                             const Loop& loop = Loop())
  {
    const bool has_needles = Refined_needles::are_useful(mesh, loop);
    if(has_needles || Balanced_fans::are_useful(mesh))
    {
      // more flips than strips and fans of needles need, which is about one per halfedge
      constexpr std::size_t flips_per_halfedge = 32;
      return Retriangulation(mesh, has_needles, flips_per_halfedge * mesh.number_of_halfedges());
    }
    return std::nullopt;
  }

  // Refines needles on request. Throws if a face of `mesh` breaks the triangle inequality.
  Retriangulation(const Intrinsic_triangulation& mesh,
                  const bool refines_needles,
                  const std::size_t most_flips)
    : m_number_of_vertices(mesh.number_of_vertices())
  {
    Edge_flips flips(mesh);
    if(refines_needles)
      m_positions = Refined_needles::refine(flips, most_flips);
    m_has_balanced_fans = Balanced_fans::balance(flips);
    copy_halfedges(flips);
    copy(mesh, flips);
    copy_thin_faces(mesh, flips);
    m_signposts.reserve(flips.signposts().size());
    for(const auto& signpost : flips.signposts())
      m_signposts.push_back({number(signpost.halfedge), signpost.angle});
  }

  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  // Returns whether a halfedge of the mesh was flipped.
  bool is_lost(const Index h) const { return m_triangulation.is_flipped(m_number[h]); }

  // Convert the numbers of halfedges that are in both triangulations.
  Index number(const Index h) const { return m_number[h]; }
  Index number_in_mesh(const Index h) const { return m_number_in_mesh[h]; }

  bool has_balanced_fans() const { return m_has_balanced_fans; }
  bool has_refined_needles() const { return !m_positions.empty(); }

  // Returns the position of a vertex in the mesh.
  Intrinsic_point position(const Index v) const
  {
    return v < m_number_of_vertices ? Intrinsic_point::at_vertex(v)
                                    : m_positions[v - m_number_of_vertices];
  }

  // The direction of `h`, which starts from `v`, in the mesh; none if all edges of a vertex of the
  // mesh were flipped.
  std::optional<Direction_in_mesh> direction(const Index v, Index h) const
  {
    const Intrinsic_triangulation& t = triangulation();
    const bool is_added = v >= m_number_of_vertices;
    double angle = 0;
    for(Index n = t.degree(v); n > 0; --n)
    {
      if(is_added && h == m_signposts[v - m_number_of_vertices].halfedge)
        return Direction_in_mesh{position(v).halfedge,
                                 angle + m_signposts[v - m_number_of_vertices].angle};
      if(!is_added && !t.is_flipped(h))
        return Direction_in_mesh{number_in_mesh(h), angle};
      h = t.clockwise(v, h);
      angle += angle_of(corner_angle(t, h));
    }
    return std::nullopt;
  }

  std::size_t memory() const
  {
    return memory_of(m_triangulation, m_number, m_number_in_mesh, m_positions, m_signposts);
  }

private:
  // Visits each halfedge once, as the arrays are larger than a cache.
  void copy_halfedges(const Edge_flips& flips)
  {
    Intrinsic_triangulation& t = m_triangulation;
    m_number.resize(flips.number_of_halfedges());
    m_number_in_mesh.reserve(m_number.size());
    t.m_target.reserve(m_number.size());
    t.m_length.reserve(m_number.size());
    t.m_first_halfedge.clear();
    t.m_first_halfedge.reserve(flips.number_of_vertices() + 1);
    for(const Index first : flips.first_halfedges())
    {
      t.m_first_halfedge.push_back(static_cast<Index>(m_number_in_mesh.size()));
      if(first == null_index)
        continue; // an isolated vertex
      flips.for_each_around(first, [&](const Index h) {
        const Edge_flips::Halfedge& halfedge = flips[h];
        m_number[h] = static_cast<Index>(m_number_in_mesh.size());
        m_number_in_mesh.push_back(h);
        t.m_target.push_back(halfedge.target);
        t.m_length.push_back(halfedge.length);
        t.m_is_border.push_back(halfedge.is_border);
        t.m_is_flipped.push_back(halfedge.is_new);
      });
    }
    t.m_first_halfedge.push_back(static_cast<Index>(m_number_in_mesh.size()));
  }

  void copy(const Intrinsic_triangulation& mesh, const Edge_flips& flips)
  {
    Intrinsic_triangulation& t = m_triangulation;
    t.m_opposite_rank.resize(m_number.size());
    for(Index h = 0; h < m_number.size(); ++h)
      t.m_opposite_rank.set(m_number[h],
                            m_number[flips[h].opposite] - t.first_halfedge(flips[h].target));
    t.m_vertex_of_index = mesh.m_vertex_of_index;
    t.m_index_of_vertex = mesh.m_index_of_vertex;
    for(Index v = mesh.number_of_vertices(); v < flips.number_of_vertices(); ++v)
    {
      t.m_index_of_vertex.push_back(static_cast<Index>(t.m_vertex_of_index.size()));
      t.m_vertex_of_index.push_back(v);
    }
    t.m_number_of_faces =
        mesh.m_number_of_faces + 2 * (flips.number_of_vertices() - mesh.number_of_vertices());
    t.m_unit = mesh.m_unit;
    t.m_lines_may_return = mesh.m_lines_may_return;
  }

  // The shapes of new faces are known, even if those of the mesh are not.
  void copy_thin_faces(const Intrinsic_triangulation& mesh, const Edge_flips& flips)
  {
    const Intrinsic_triangulation& t = m_triangulation;
    Thin_faces result;
    for(Index i = 0; i < t.number_of_halfedges(); ++i)
    {
      if(t.is_border(i))
        continue;
      const Thin_faces::Halfedges sides = t.halfedges_of_face(i);
      if(i > sides[1] || i > sides[2] ||
         !Thin_faces::is_thin(t.length(i), t.length(sides[1]), t.length(sides[2])))
        continue;
      const Thin_faces::Halfedges in_mesh{m_number_in_mesh[i], m_number_in_mesh[sides[1]],
                                          m_number_in_mesh[sides[2]]};
      const Edge_flips::Halfedge& h = flips[in_mesh[0]];
      if(t.is_in_new_face(i))
        result.add(sides, {{h.corner, flips[in_mesh[1]].corner, flips[in_mesh[2]].corner},
                           h.doubled_area});
      else if(const std::optional<Thin_face> face = mesh.thin_faces().find(in_mesh))
        result.add(sides, *face);
    }
    result.shrink_to_fit();
    m_triangulation.m_thin_faces = std::move(result);
  }

  Intrinsic_triangulation m_triangulation;
  std::vector<Index> m_number;                   // per halfedge of the mesh
  std::vector<Index> m_number_in_mesh;           // per halfedge of the triangulation
  Index m_number_of_vertices;                    // of the mesh
  std::vector<Intrinsic_point> m_positions;      // of added vertices
  std::vector<Edge_flips::Signpost> m_signposts; // of added vertices
  bool m_has_balanced_fans = false;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_H
