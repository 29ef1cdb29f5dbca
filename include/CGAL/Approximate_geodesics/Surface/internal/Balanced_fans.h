// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_BALANCED_FANS_H
#define CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_BALANCED_FANS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Edge_flips.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Flips every other edge of a hub, a vertex with very many neighbors, in rounds, until the hub has
 * few neighbors. Its fan of faces becomes a balanced tree, of which a straight line crosses few
 * faces.
 *
 * Edges to reflex neighbors stay, as these have no other visible vertex.
 */
class Balanced_fans
{
public:
  // Vertices with more neighbors than this are hubs.
  static constexpr Index LARGEST_DEGREE = 128;

  static bool are_useful(const Intrinsic_triangulation& mesh)
  {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(mesh.degree(v) > LARGEST_DEGREE)
        return true;
    return false;
  }

  // Balances the fans of all hubs. Returns whether there are any.
  static bool balance(Edge_flips& flips) { return Balanced_fans(flips).balance(); }

private:
  explicit Balanced_fans(Edge_flips& flips)
    : m_flips(flips), m_gained(flips.number_of_vertices(), 0), m_left(flips.number_of_vertices(), 0)
  {
    for(Index h = 0; h < flips.number_of_halfedges(); ++h)
      ++m_left[flips[h].target];
  }

  bool balance()
  {
    std::vector<Index> hubs;
    for(Index v = 0; v < m_left.size(); ++v)
      if(m_left[v] > LARGEST_DEGREE)
        hubs.push_back(v);
    if(hubs.empty())
      return false;
    m_has_changed.resize(m_flips.number_of_halfedges(), false);
    const std::vector<Index> first = m_flips.first_halfedges();
    std::vector<std::vector<Index>> spokes;
    for(const Index hub : hubs)
    {
      spokes.emplace_back();
      m_flips.for_each_around(first[hub], [&](const Index h) { spokes.back().push_back(h); });
    }
    for(std::size_t i = 0; i < hubs.size(); ++i)
      balance(hubs[i], std::move(spokes[i]));
    return true;
  }

  // Flips edges of `hub`, those next to each other in different rounds; in each of them, only those
  // whose faces have changed in the one before.
  void balance(const Index hub, std::vector<Index> edges)
  {
    const auto is_taken = [&](const Index h) { return m_flips.is_taken(h); };
    edges.erase(std::remove_if(edges.begin(), edges.end(), is_taken), edges.end());
    std::vector<Index> changed;
    while(!edges.empty())
    {
      for(const Index h : edges)
        if(!m_has_changed[h] && try_flip(hub, h))
          for(const Index side : {m_flips.next(m_flips.next(h)), m_flips.next(h)})
          {
            const Index edge = m_flips[side].target == hub ? m_flips[side].opposite : side;
            if(m_flips.is_taken(edge) || m_has_changed[edge])
              continue;
            m_has_changed[edge] = true;
            changed.push_back(edge);
          }
      for(const Index h : changed)
        m_has_changed[h] = false;
      edges.swap(changed);
      changed.clear();
    }
  }

  bool try_flip(const Index hub, const Index h)
  {
    if(!m_flips.can_flip(hub, h))
      return false;
    const Index v = m_flips[h].target, left = m_flips[m_flips.next(h)].target,
                right = m_flips[m_flips.next(m_flips[h].opposite)].target;
    constexpr Index most = LARGEST_DEGREE / 2; // so that no vertex becomes a hub
    if(m_gained[left] >= most || m_gained[right] >= most || m_left[v] < 2)
      return false;
    ++m_gained[left];
    ++m_gained[right];
    --m_left[v];
    --m_left[hub];
    m_flips.flip(hub, h);
    return true;
  }

  Edge_flips& m_flips;
  std::vector<Index> m_gained, m_left; // per vertex: edges gained by flips, and edges left
  std::vector<bool> m_has_changed;     // per halfedge
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SURFACE_INTERNAL_BALANCED_FANS_H
