// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_WAY_ALONG_EDGES_H
#define CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_WAY_ALONG_EDGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/vector_3.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/edge_lengths.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/face_links.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_part.h>
#include <CGAL/Approximate_geodesics/Parts/internal/Mesh_place.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Finds an upper bound on the distance to a target on a mesh that has not been read: the length of
 * a shortest path along edges, by A* search with straight-line distances. The search only visits
 * vertices that paths of that length can reach.
 */
template <typename TriangleMesh, typename Positions>
class Way_along_edges
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Place = Mesh_place<TriangleMesh>;
  using Index = typename Descriptor_table<vertex_descriptor>::Index;

public:
  Way_along_edges(const TriangleMesh& tmesh,
                  const Positions& positions,
                  const Place& target,
                  const std::size_t largest_number_of_vertices)
    : m_mesh(tmesh),
      m_positions(positions),
      m_target(target),
      m_position_of_target(positions(target)),
      m_largest_number_of_vertices(largest_number_of_vertices),
      m_steps_left(8 * largest_number_of_vertices)
  {
  }

  void start_at(const Place& place)
  {
    const Space_vector p = m_positions(place);
    if(place.number_of_corners == 3 && place.halfedge == m_target.halfedge)
      m_straight = (std::min)(m_straight, length(p, m_position_of_target));
    for(std::size_t i = 0; i < place.number_of_corners; ++i)
      reach(place.corner[i], 0, p);
  }

  // Returns the length of the shortest path along edges, but at most `limit`, or infinity if there
  // is none. Returns nothing if the mesh is invalid or the budget is exceeded.
  std::optional<double> run(const double limit)
  {
    while(!m_queue.empty())
    {
      const Entry entry = m_queue.top();
      m_queue.pop();
      if(entry.estimate >= (std::min)(m_straight, limit))
        return (std::min)(m_straight, limit);
      const Vertex v = m_vertices[entry.number];
      if(entry.distance > v.distance)
        continue;
      if(is_corner_of_target(v.descriptor))
        return entry.estimate;
      if(!reach_neighbors(v))
        return std::nullopt;
    }
    return m_overflows ? std::nullopt : std::make_optional(m_straight);
  }

private:
  struct Vertex
  {
    vertex_descriptor descriptor;
    Space_vector position;
    double distance;
  };

  struct Entry
  {
    double estimate; // lower bound on the path length to the target
    double distance;
    Index number;

    friend bool operator<(const Entry& a, const Entry& b) { return a.estimate > b.estimate; }
  };

  static double length(const Space_vector& p, const Space_vector& q)
  {
    return accurate_length(difference(p, q));
  }

  bool is_corner_of_target(const vertex_descriptor v) const
  {
    const auto end = m_target.corner.begin() + m_target.number_of_corners;
    return std::find(m_target.corner.begin(), end, v) != end;
  }

  // Relaxes the straight segment from `p` to `v`.
  void reach(const vertex_descriptor v, const double distance_of_p, const Space_vector& p)
  {
    const Index next = static_cast<Index>(m_vertices.size());
    const Index number = m_numbers.find_or_insert(v, next);
    if(number == next)
      m_vertices.push_back({v, m_positions(v), std::numeric_limits<double>::infinity()});
    Vertex& reached = m_vertices[number];
    const double distance = distance_of_p + length(p, reached.position);
    if(distance < reached.distance)
    {
      reached.distance = distance;
      m_queue.push({distance + length(reached.position, m_position_of_target), distance, number});
    }
    m_overflows |= !std::isfinite(distance);
  }

  // Returns false if links are invalid or the budget is exceeded.
  bool reach_neighbors(const Vertex& v)
  {
    const halfedge_descriptor first = first_halfedge_from(v.descriptor, m_mesh);
    halfedge_descriptor h = first;
    if(h != Graph_traits::null_halfedge())
      do
      {
        if(m_steps_left-- == 0 || source(h, m_mesh) != v.descriptor ||
           target(h, m_mesh) == Graph_traits::null_vertex())
          return false;
        reach(target(h, m_mesh), v.distance, v.position);
        h = counterclockwise(h, m_mesh);
        if(h == Graph_traits::null_halfedge())
          return false;
      } while(h != first);
    return m_vertices.size() <= m_largest_number_of_vertices;
  }

  const TriangleMesh& m_mesh;
  const Positions& m_positions;
  const Place& m_target;
  const Space_vector m_position_of_target;
  const std::size_t m_largest_number_of_vertices;
  std::size_t m_steps_left;
  bool m_overflows = false;                                    // so paths may have been missed
  double m_straight = std::numeric_limits<double>::infinity(); // distance within a face
  Descriptor_table<vertex_descriptor> m_numbers;
  std::vector<Vertex> m_vertices;
  std::priority_queue<Entry> m_queue;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PARTS_INTERNAL_WAY_ALONG_EDGES_H
