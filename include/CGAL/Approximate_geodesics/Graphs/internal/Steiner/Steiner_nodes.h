// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_NODES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_NODES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Points_on_edges.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Sectors.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The nodes of a Steiner graph: the vertices, then the points on edges, then the sectors of divided
 * vertices.
 */
class Steiner_nodes
{
public:
  using Node = Intrinsic_triangulation::Index;

  Steiner_nodes() = default;

  // Throws std::length_error if there are more points than `limit` says, or more nodes than 32-bit
  // numbers can tell apart.
  template <typename Placement>
  Steiner_nodes(const Intrinsic_triangulation& triangulation,
                const Placement& placement,
                const std::size_t limit)
    : m_sectors(triangulation),
      m_points(triangulation,
               placement,
               limit,
               Intrinsic_triangulation::null_index - std::size_t(m_sectors.number_of_sectors()) -
                   triangulation.number_of_vertices()),
      m_first_point(triangulation.number_of_vertices()),
      m_first_sector(m_first_point + m_points.number_of_points())
  {
  }

  const Points_on_edges& points() const { return m_points; }
  const Sectors& sectors() const { return m_sectors; }

  std::size_t size() const { return std::size_t(m_first_sector) + m_sectors.number_of_sectors(); }

  // False for numbers that no node has, such as `null_index`.
  bool is_vertex(const Node node) const { return node < m_first_point; }
  bool is_point(const Node node) const { return node - m_first_point < number_of_points(); }
  bool is_sector(const Node node) const { return node - m_first_sector < number_of_sectors(); }

  // between nodes and the numbers of points and sectors
  Node point(const Node node) const { return node - m_first_point; }
  Node sector(const Node node) const { return node - m_first_sector; }
  Node node_of_point(const Node p) const { return m_first_point + p; }
  Node node_of_sector(const Node s) const { return m_first_sector + s; }

  Intrinsic_point position(const Node node) const
  {
    if(is_sector(node))
      return Intrinsic_point::at_vertex(m_sectors.vertex(sector(node)));
    if(is_vertex(node))
      return Intrinsic_point::at_vertex(node);
    const Node p = point(node), h = m_points.halfedge(p);
    return Intrinsic_point::on_edge(h, m_points.part_before(m_points.edge(h), p));
  }

  std::size_t memory() const { return m_points.memory() + m_sectors.memory(); }

private:
  Node number_of_points() const { return m_first_sector - m_first_point; }
  Node number_of_sectors() const { return m_sectors.number_of_sectors(); }

  Sectors m_sectors;
  Points_on_edges m_points;
  Node m_first_point = 0;
  Node m_first_sector = 0;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_STEINER_NODES_H
