// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_EUCLIDEAN_HEURISTIC_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_EUCLIDEAN_HEURISTIC_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A consistent heuristic for A*: from a node to the goal, it is at least as far as along the
 * straight line through space.
 */
template <typename SurfaceGraph>
class Euclidean_heuristic
{
  using Node = typename SurfaceGraph::Node;

public:
  Euclidean_heuristic(const SurfaceGraph& graph,
                      const Vertex_positions& positions,
                      const Intrinsic_point& goal)
    : m_graph(graph), m_positions(positions), m_goal(positions(graph.triangulation(), goal))
  {
  }

  double operator()(const Node node) const
  {
    if constexpr(has_positions<SurfaceGraph>)
      if(node >= m_graph.triangulation().number_of_vertices())
        return distance(m_positions(m_graph.triangulation(), m_graph.position(node)), m_goal);
    return distance(m_positions[node], m_goal);
  }

private:
  const SurfaceGraph& m_graph;
  const Vertex_positions& m_positions;
  Vertex_positions::Position m_goal;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_EUCLIDEAN_HEURISTIC_H
