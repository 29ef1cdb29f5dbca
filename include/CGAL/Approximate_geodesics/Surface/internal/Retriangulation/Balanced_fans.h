// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_BALANCED_FANS_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_BALANCED_FANS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Edge_flips.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation/Flipped_triangulation.h>

#include <cstddef>
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
    m_flipped = Flipped_triangulation(mesh, flips);
  }

  const Intrinsic_triangulation& triangulation() const { return m_flipped.triangulation(); }

  // Whether a halfedge of the mesh is none of this triangulation.
  bool is_lost(const Index h) const { return m_flipped.is_lost(h); }

  // The number here of a halfedge that is not lost, and that in the mesh of one that is not new.
  Index number(const Index h) const { return m_flipped.number(h); }
  Index number_in_mesh(const Index h) const { return m_flipped.number_in_mesh(h); }

  std::size_t memory() const { return m_flipped.memory(); }

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

  Flipped_triangulation m_flipped;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_RETRIANGULATION_BALANCED_FANS_H
