// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_VERTEX_POSITIONS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_VERTEX_POSITIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsSearch
 *
 * The positions in space of the vertices of a triangulation. Straight-line distances between them
 * guide a search to its target. They take 24 bytes per vertex.
 */
class Vertex_positions
{
public:
  /// the number of a vertex.
  using Index = Intrinsic_triangulation::Index;

  /// three coordinates.
  using Position = std::array<double, 3>;

  /// no positions: searches are not guided.
  Vertex_positions() = default;

  /// copies the position of each vertex, `position_of(v)`, in the unit of the mesh. Positions are
  /// dropped if the triangulation has weights, or edge lengths that are not the distances of these
  /// positions: shortest paths might then be shorter than straight lines.
  template <typename PositionOf>
  Vertex_positions(const Intrinsic_triangulation& triangulation, const PositionOf& position_of)
  {
    if(triangulation.has_weights() || triangulation.has_directional_costs())
      return;
    m_positions.reserve(triangulation.number_of_vertices());
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      const Position p = position_of(v);
      m_positions.push_back(
          {p[0] / triangulation.unit(), p[1] / triangulation.unit(), p[2] / triangulation.unit()});
    }
    if(!are_embedding(triangulation))
      m_positions.clear();
  }

  /// returns whether there are positions.
  bool are_known() const { return !m_positions.empty(); }

  /// returns the position of the vertex `v`, in units of the triangulation.
  const Position& operator[](const Index v) const { return m_positions[v]; }

  /// returns the position of a point of the surface relative to `origin`, in units of the
  /// triangulation. It is accurate if the mesh is far away from the origin of the coordinates, too.
  Position relative_to(const Position& origin,
                       const Intrinsic_triangulation& triangulation,
                       const Intrinsic_point& p) const
  {
    if(p.is_vertex())
      return internal::difference(m_positions[p.vertex], origin);
    const Index h = p.halfedge;
    const Position &a = m_positions[triangulation.source(h)],
                   &b = m_positions[triangulation.target(h)];
    const Position& c =
        p.is_in_face() ? m_positions[triangulation.target(triangulation.next(h))] : a;
    Position result = internal::difference(a, origin);
    for(std::size_t i = 0; i < 3; ++i)
      result[i] += p.t * (b[i] - a[i]) + p.s * (c[i] - a[i]);
    return result;
  }

  /// returns the number of bytes that the positions take.
  std::size_t memory() const { return internal::memory_of(m_positions); }

private:
  // Whether edges are as long as the straight lines between their ends. It is not enough that they
  // are not shorter: a face with longer sides can be flatter, and paths across it shorter.
  bool are_embedding(const Intrinsic_triangulation& triangulation) const
  {
    constexpr double rounding = 1e-14;
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      {
        const double length = triangulation.length(h);
        const double line =
            internal::distance(m_positions[v], m_positions[triangulation.target(h)]);
        if(!(std::abs(line - length) <= rounding * length))
          return false;
      }
    return true;
  }

  std::vector<Position> m_positions;
};

namespace internal {

// A consistent heuristic for A*: the straight-line distance from a node to the goal.
template <typename SurfaceGraph>
class Euclidean_heuristic
{
  using Node = typename SurfaceGraph::Node;

public:
  Euclidean_heuristic(const SurfaceGraph& graph,
                      const Vertex_positions& positions,
                      const Intrinsic_point& goal)
    : m_graph(graph),
      m_positions(positions),
      m_origin(
          positions[goal.is_vertex() ? goal.vertex : graph.triangulation().source(goal.halfedge)]),
      m_goal(positions.relative_to(m_origin, graph.triangulation(), goal))
  {
  }

  double operator()(const Node node) const
  {
    return distance(
        m_positions.relative_to(m_origin, m_graph.triangulation(), position(m_graph, node)),
        m_goal);
  }

private:
  const SurfaceGraph& m_graph;
  const Vertex_positions& m_positions;
  Vertex_positions::Position m_origin; // a vertex close to the goal: positions are relative to it
  Vertex_positions::Position m_goal;
};

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_VERTEX_POSITIONS_H
