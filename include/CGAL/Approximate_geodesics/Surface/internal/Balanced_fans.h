// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_BALANCED_FANS_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_BALANCED_FANS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Edge_flips.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Thin_faces.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Another triangulation of the same surface, with the same vertices, in which a hub, a vertex with
 * very many neighbors, has few of them: its edges are flipped, every other one at a time. So its
 * faces, which were a fan, become a balanced tree, and a straight line crosses few of them.
 *
 * Edges stay where the hub's neighbors turn inwards, as those can be connected to nothing else.
 */
class Balanced_fans
{
public:
  using Index = Intrinsic_triangulation::Index;

  // Vertices with more neighbors than this are hubs.
  static constexpr Index LARGEST_DEGREE = 128;

  static bool are_useful(const Intrinsic_triangulation& mesh)
  {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(mesh.degree(v) > LARGEST_DEGREE)
        return true;
    return false;
  }

  // Throws if a face of `mesh` breaks the triangle inequality.
  explicit Balanced_fans(const Intrinsic_triangulation& mesh)
  {
    mesh.check_triangle_inequality();
    Edge_flips flips(mesh);
    Degrees degrees(mesh);
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(mesh.degree(v) > LARGEST_DEGREE)
        balance(mesh, v, flips, degrees);
    number_halfedges(mesh, flips);
    copy(mesh, flips);
    copy_thin_faces(mesh, flips);
  }

  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }

  // Whether a halfedge of the mesh is none of this triangulation.
  bool is_lost(const Index h) const { return m_triangulation.is_flipped(m_number[h]); }

  // The number here of a halfedge that is not lost, and that in the mesh of one that is not new.
  Index number(const Index h) const { return m_number[h]; }
  Index number_in_mesh(const Index h) const { return m_number_in_mesh[h]; }

  std::size_t memory() const
  {
    return m_triangulation.memory() +
           sizeof(Index) * (m_number.capacity() + m_number_in_mesh.capacity());
  }

private:
  // How many edges a vertex has got from others, and how many of its own are left.
  struct Degrees
  {
    explicit Degrees(const Intrinsic_triangulation& mesh) : gained(mesh.number_of_vertices(), 0)
    {
      left.reserve(mesh.number_of_vertices());
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        left.push_back(mesh.degree(v));
    }

    std::vector<Index> gained, left;
  };

  // Flips edges of `hub`, those next to each other in different rounds; in each of them, only those
  // whose faces have changed in the one before.
  static void
  balance(const Intrinsic_triangulation& mesh, const Index hub, Edge_flips& flips, Degrees& degrees)
  {
    std::vector<Index> edges, changed;
    for(Index h = mesh.first_halfedge(hub); h < mesh.beyond_halfedge(hub); ++h)
      if(!flips.is_flipped(h))
        edges.push_back(h);
    std::vector<bool> has_changed(mesh.degree(hub), false);
    const Index first = mesh.first_halfedge(hub);
    while(!edges.empty())
    {
      for(const Index h : edges)
        if(!has_changed[h - first] && try_flip(hub, h, flips, degrees))
          for(const Index side : {flips.next(flips.next(h)), flips.next(h)})
            note_change(hub, side, first, flips, has_changed, changed);
      for(const Index h : changed)
        has_changed[h - first] = false;
      edges.swap(changed);
      changed.clear();
    }
  }

  // The side of a new face at the hub has got another neighbor.
  static void note_change(const Index hub,
                          const Index side,
                          const Index first,
                          const Edge_flips& flips,
                          std::vector<bool>& has_changed,
                          std::vector<Index>& changed)
  {
    const Index h = flips[side].target == hub ? flips[side].opposite : side;
    if(flips.is_flipped(h) || has_changed[h - first])
      return;
    has_changed[h - first] = true;
    changed.push_back(h);
  }

  static bool try_flip(const Index hub, const Index h, Edge_flips& flips, Degrees& degrees)
  {
    if(!flips.can_flip(hub, h))
      return false;
    const Index v = flips[h].target, left = flips[flips.next(h)].target,
                right = flips[flips.next(flips[h].opposite)].target;
    constexpr Index most = LARGEST_DEGREE / 2; // so that no vertex becomes a hub
    if(degrees.gained[left] >= most || degrees.gained[right] >= most || degrees.left[v] < 2)
      return false;
    ++degrees.gained[left];
    ++degrees.gained[right];
    --degrees.left[v];
    --degrees.left[hub];
    flips.flip(hub, h);
    return true;
  }

  // Every vertex has a halfedge of its own left, which comes first.
  void number_halfedges(const Intrinsic_triangulation& mesh, const Edge_flips& flips)
  {
    m_number.resize(mesh.number_of_halfedges());
    m_number_in_mesh.reserve(mesh.number_of_halfedges());
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    {
      m_triangulation.m_first_halfedge.back() = static_cast<Index>(m_number_in_mesh.size());
      m_triangulation.m_first_halfedge.push_back(0);
      Index first = mesh.first_halfedge(v);
      while(first < mesh.beyond_halfedge(v) && flips.is_flipped(first))
        ++first;
      if(first == mesh.beyond_halfedge(v))
        continue; // an isolated vertex
      Index h = first;
      do
      {
        m_number[h] = static_cast<Index>(m_number_in_mesh.size());
        m_number_in_mesh.push_back(h);
        h = flips[h].counterclockwise;
      } while(h != first);
    }
    m_triangulation.m_first_halfedge.back() = static_cast<Index>(m_number_in_mesh.size());
  }

  void copy(const Intrinsic_triangulation& mesh, const Edge_flips& flips)
  {
    Intrinsic_triangulation& t = m_triangulation;
    t.m_opposite_rank.resize(m_number.size());
    for(Index i = 0; i < m_number_in_mesh.size(); ++i)
    {
      const Index h = m_number_in_mesh[i];
      t.m_target.push_back(flips[h].target);
      t.m_length.push_back(flips[h].length);
      t.m_is_border.push_back(mesh.is_border(h));
      t.m_is_flipped.push_back(flips.is_flipped(h));
      t.m_opposite_rank.set(i, m_number[flips[h].opposite] - t.first_halfedge(flips[h].target));
    }
    t.m_vertex_of_index = mesh.m_vertex_of_index;
    t.m_index_of_vertex = mesh.m_index_of_vertex;
    t.m_number_of_faces = mesh.m_number_of_faces;
    t.m_unit = mesh.m_unit;
  }

  // New faces have shapes, even where those of the mesh are not known.
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
  std::vector<Index> m_number;         // by that in the mesh
  std::vector<Index> m_number_in_mesh; // per halfedge of the triangulation
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_BALANCED_FANS_H
