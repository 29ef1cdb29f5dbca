// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_CORNER_NODES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_CORNER_NODES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Sectors.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Steiner_nodes.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Which nodes of a Steiner graph stand for the corners of faces: the vertices, unless barriers
 * divide their surroundings.
 */
class Corner_nodes
{
  using Index = Intrinsic_triangulation::Index;
  using Node = Steiner_nodes::Node;

public:
  Corner_nodes(const Intrinsic_triangulation& triangulation, const Steiner_nodes& nodes)
    : m_triangulation(triangulation), m_nodes(nodes), m_sectors(nodes.sectors())
  {
  }

  bool is_divided(const Node v) const
  {
    return !m_sectors.is_empty() && m_sectors.first_sector(v) != m_sectors.beyond_sector(v);
  }

  // Calls `f(node)` for the sectors of a divided vertex.
  template <typename F>
  void for_each_sector(const Node v, F f) const
  {
    for(Index s = m_sectors.first_sector(v); s < m_sectors.beyond_sector(v); ++s)
      f(m_nodes.node_of_sector(s));
  }

  // The node at the vertex `v` in the face to the left of `h`, which starts there.
  Node at_corner(const Node v, const Index h) const
  {
    if(m_sectors.is_empty())
      return v;
    const Index sector = m_sectors.sector(v, h);
    return sector == Sectors::null_index ? v : m_nodes.node_of_sector(sector);
  }

  // The nodes at the ends of the edge of `h`, or of its left side.
  Node at_source(const Index h) const
  {
    const Index opposite = m_triangulation.opposite(h);
    const Node v = m_triangulation.target(opposite);
    if(m_sectors.is_empty() ||
       (m_triangulation.is_border(h) && m_triangulation.is_border(opposite)))
      return v;
    return at_corner(v, m_triangulation.is_border(h) ? m_triangulation.next(opposite) : h);
  }
  Node at_target(const Index h) const
  {
    const Node v = m_triangulation.target(h);
    if(m_sectors.is_empty())
      return v;
    return m_triangulation.is_border(h) ? at_source(m_triangulation.opposite(h))
                                        : at_corner(v, m_triangulation.next(h));
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  const Steiner_nodes& m_nodes;
  const Sectors& m_sectors;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_CORNER_NODES_H
