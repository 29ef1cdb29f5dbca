// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_EUCLIDEAN_HEURISTIC_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_EUCLIDEAN_HEURISTIC_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/Path.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The positions in space of the vertices of a triangulation, in units of its lengths; none if there
 * are lengths that these positions do not explain, or weights.
 */
class Vertex_positions
{
public:
  using Index = Intrinsic_triangulation::Index;
  using Position = std::array<double, 3>;

  Vertex_positions() = default;

  // `position_of(v)` is the position of the vertex `v`, in the unit of the mesh.
  template <typename PositionOf>
  Vertex_positions(const Intrinsic_triangulation& triangulation, const PositionOf& position_of)
  {
    if(triangulation.has_weights())
      return;
    m_positions.reserve(triangulation.number_of_vertices());
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
    {
      const Position p = position_of(v);
      m_positions.push_back(
          {p[0] / triangulation.unit(), p[1] / triangulation.unit(), p[2] / triangulation.unit()});
    }
    if(!explain_lengths(triangulation))
      m_positions.clear();
  }

  bool are_known() const { return !m_positions.empty(); }

  const Position& operator[](const Index v) const { return m_positions[v]; }

  Position operator()(const Intrinsic_triangulation& triangulation,
                      const Intrinsic_point& place) const
  {
    if(place.is_vertex())
      return m_positions[place.vertex];
    const Index h = place.halfedge;
    const Position &a = m_positions[triangulation.source(h)],
                   &b = m_positions[triangulation.target(h)];
    const Position& c =
        place.is_in_face() ? m_positions[triangulation.target(triangulation.next(h))] : a;
    Position result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = a[i] + place.t * (b[i] - a[i]) + place.s * (c[i] - a[i]);
    return result;
  }

  static double distance(const Position& p, const Position& q)
  {
    const double x = q[0] - p[0], y = q[1] - p[1], z = q[2] - p[2];
    return std::sqrt(x * x + y * y + z * z);
  }

  std::size_t memory() const { return m_positions.capacity() * sizeof(Position); }

private:
  // Whether edges are as long as the straight lines between their ends. It would not do if they
  // were longer: a face with longer sides can be flatter, and ways across it shorter.
  bool explain_lengths(const Intrinsic_triangulation& triangulation) const
  {
    constexpr double rounding = 1e-14;
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
      for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
      {
        const double length = triangulation.length(h);
        const double line = distance(m_positions[v], m_positions[triangulation.target(h)]);
        if(!(std::abs(line - length) <= rounding * length))
          return false;
      }
    return true;
  }

  std::vector<Position> m_positions;
};

/*
 * How far it is at least from the nodes of a graph to a goal: as long as the straight line through
 * space.
 */
template <typename GeodesicGraph>
class Euclidean_heuristic
{
  using Node = typename GeodesicGraph::Node;

public:
  Euclidean_heuristic(const GeodesicGraph& graph,
                      const Vertex_positions& positions,
                      const Intrinsic_point& goal)
    : m_graph(graph), m_positions(positions), m_goal(positions(graph.triangulation(), goal))
  {
  }

  double operator()(const Node node) const
  {
    if constexpr(has_places<GeodesicGraph>)
      return Vertex_positions::distance(m_positions(m_graph.triangulation(), place(m_graph, node)),
                                        m_goal);
    else
      return Vertex_positions::distance(m_positions[node], m_goal);
  }

private:
  const GeodesicGraph& m_graph;
  const Vertex_positions& m_positions;
  Vertex_positions::Position m_goal;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_EUCLIDEAN_HEURISTIC_H
