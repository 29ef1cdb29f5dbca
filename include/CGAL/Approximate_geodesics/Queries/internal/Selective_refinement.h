// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SELECTIVE_REFINEMENT_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SELECTIVE_REFINEMENT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/Steiner_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/equal_parts.h>
#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/tree_path.h>
#include <CGAL/Approximate_geodesics/Queries/internal/smallest_distance.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A placement of equally spaced points on the edges near a path: edges of faces that the path
 * touches, and of `number_of_rings` rings of faces around them.
 */
class Points_near_path
{
public:
  using Index = Intrinsic_triangulation::Index;

  static constexpr bool makes_equal_parts = true;

  Points_near_path(const Intrinsic_triangulation& triangulation,
                   const Path& path,
                   const std::size_t number_of_rings,
                   const std::size_t number_of_points_per_edge)
    : m_number_of_points(number_of_points_per_edge),
      m_is_near(triangulation.number_of_vertices(), false)
  {
    for(const Intrinsic_point& p : path.points)
      mark_vertices_of_faces(triangulation, p);
    for(std::size_t ring = 0; ring < number_of_rings; ++ring)
      mark_neighbors(triangulation);
  }

  void prepare(const Intrinsic_triangulation& /* triangulation */,
               std::size_t /* maximum_number_of_points */)
  {
  }

  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    return m_is_near[triangulation.source(h)] && m_is_near[triangulation.target(h)]
               ? m_number_of_points
               : 0;
  }

  double epsilon(const Intrinsic_triangulation& /* triangulation */) const
  {
    return std::numeric_limits<double>::infinity();
  }

  std::size_t memory() const { return m_is_near.capacity() / 8; }

private:
  // Marks the vertices of the faces that contain a point of the path.
  void mark_vertices_of_faces(const Intrinsic_triangulation& triangulation,
                              const Intrinsic_point& p)
  {
    if(p.is_vertex())
    {
      m_is_near[p.vertex] = true;
      for(Index h = triangulation.first_halfedge(p.vertex);
          h < triangulation.beyond_halfedge(p.vertex); ++h)
        m_is_near[triangulation.target(h)] = true;
    }
    else
      for(const Index h : {p.halfedge, triangulation.opposite(p.halfedge)})
      {
        m_is_near[triangulation.target(h)] = true;
        if(!triangulation.is_border(h))
          m_is_near[triangulation.target(triangulation.next(h))] = true;
      }
  }

  void mark_neighbors(const Intrinsic_triangulation& triangulation)
  {
    const std::vector<bool> was_near = m_is_near;
    for(Index v = 0; v < triangulation.number_of_vertices(); ++v)
      if(was_near[v])
        for(Index h = triangulation.first_halfedge(v); h < triangulation.beyond_halfedge(v); ++h)
          m_is_near[triangulation.target(h)] = true;
  }

  std::size_t m_number_of_points;
  std::vector<bool> m_is_near; // per vertex
};

/*
 * Refines a path between two vertices by repeated searches: each graph has twice as many points per
 * edge as the previous one, in a narrowing corridor around the last path.
 */
template <typename PriorityQueue = Adaptive_bucket_queue>
class Selective_refinement
{
  using Index = Intrinsic_triangulation::Index;

public:
  Selective_refinement(const Intrinsic_triangulation& triangulation,
                       const Index source,
                       const Index target)
    : m_triangulation(triangulation), m_source(source), m_target(target)
  {
  }

  // Refines the path found with the first placement, with at most `maximum_number_of_points`
  // points; 0 selects the default. Stops when the relative gain in length does not exceed the
  // tolerance.
  template <typename Placement>
  Path run(Placement first_placement,
           const std::size_t maximum_number_of_points,
           const double relative_tolerance)
  {
    const Steiner_graph<Placement> graph(m_triangulation, std::move(first_placement),
                                         maximum_number_of_points);
    Path result = search(graph);
    m_lower_bound = result.points.empty() ? std::numeric_limits<double>::infinity()
                                          : smallest_distance(result.length, graph.epsilon());
    std::size_t number_of_points = mean_number_of_points(graph);
    std::size_t number_of_rings = LARGEST_NUMBER_OF_RINGS;
    while(!result.points.empty() && number_of_points < LARGEST_NUMBER_OF_POINTS)
    {
      number_of_points = 2 * number_of_points + 1; // equally spaced points stay points
      Path refined = search(Steiner_graph<Points_near_path>(
          m_triangulation,
          Points_near_path(m_triangulation, result, number_of_rings, number_of_points),
          (std::numeric_limits<std::size_t>::max)())); // no limit: few edges have points
      number_of_rings -= (std::min)(number_of_rings, std::size_t(1));
      const double gain = result.length - refined.length;
      if(gain > 0)
        result = std::move(refined);
      if(gain <= relative_tolerance * result.length)
        break;
    }
    return result;
  }

  // Returns a lower bound on the length of all paths from the error bound of the first graph; 0 if
  // it has none.
  double lower_bound() const { return m_lower_bound; }

private:
  static constexpr std::size_t LARGEST_NUMBER_OF_POINTS = 4096;
  static constexpr std::size_t LARGEST_NUMBER_OF_RINGS = 3; // around a coarse path

  // Returns an empty path if the target is not reached. The length is in the unit of the mesh.
  template <typename Placement>
  Path search(const Steiner_graph<Placement>& graph) const
  {
    Propagation<Steiner_graph<Placement>, PriorityQueue> search(graph);
    search.run({{m_source}}, {std::numeric_limits<double>::infinity(), {m_target}});
    return tree_path(search, m_target);
  }

  // The mean over all edges.
  template <typename Placement>
  static std::size_t mean_number_of_points(const Steiner_graph<Placement>& graph)
  {
    if constexpr(std::is_same_v<Placement, Fixed_number_of_points>)
      return graph.placement().number_of_points(graph.triangulation(), 0);
    const std::size_t number_of_edges = graph.triangulation().number_of_halfedges() / 2;
    return graph.number_of_points() / (std::max)(number_of_edges, std::size_t(1));
  }

  const Intrinsic_triangulation& m_triangulation;
  Index m_source, m_target;
  double m_lower_bound = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SELECTIVE_REFINEMENT_H
