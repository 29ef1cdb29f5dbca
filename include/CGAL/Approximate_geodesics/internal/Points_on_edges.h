// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_POINTS_ON_EDGES_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_POINTS_ON_EDGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/internal/prefetch.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// A position on an edge is a part of it, measured from the nearer end, which keeps points apart
// that are very close to an end: from 0 to 1/2, the part between the first end and the point; below
// 0, minus the part between the point and the second end.

inline double part_from_first_end(const float position)
{
  return position < 0 ? 1 + double(position) : double(position);
}

inline double part_from_second_end(const float position)
{
  return position < 0 ? -double(position) : 1 - double(position);
}

// The part of the edge between two positions, of which the second is not before the first.
inline double part_between(const float first, const float second)
{
  const double difference = double(second) - double(first);
  return first >= 0 && second < 0 ? 1 + difference : difference;
}

/*
 * The points that a placement puts on the edges of a triangulation. They are numbered from 0: those
 * of an edge follow each other, from the source of the edge's halfedge to its target.
 *
 * A barrier is two edges here, one for either side, each with points of its own. So edges have a
 * number that only this class knows.
 */
class Points_on_edges
{
public:
  using Index = Intrinsic_triangulation::Index;

  Points_on_edges() = default;

  // Throws std::length_error if there are more than `largest_number` points.
  template <typename Placement>
  Points_on_edges(const Intrinsic_triangulation& triangulation,
                  const Placement& placement,
                  const std::size_t largest_number)
  {
    number_edges(triangulation);
    count_points(triangulation, placement, largest_number);
    m_edge_of_point.resize(number_of_points());
    m_position.resize(number_of_points());
    for(Index e = 0; e < number_of_edges(); ++e)
    {
      placement.place(triangulation, m_halfedge[e], m_position.data() + first_point(e),
                      number_of_points(e));
      for(Index p = first_point(e); p < beyond_point(e); ++p)
        m_edge_of_point[p] = e;
    }
  }

  Index number_of_edges() const { return static_cast<Index>(m_halfedge.size()); }
  Index number_of_points() const { return m_first_point.back(); }

  // the edge of a halfedge of the triangulation, on its left side if it is a barrier
  Index edge(const Index h) const { return m_edge[h]; }

  // ... and the other way round: the one that a face is to the left of, if there is any
  Index halfedge(const Index e) const { return m_halfedge[e]; }

  const std::vector<Index>& halfedges() const { return m_halfedge; }

  Index first_point(const Index e) const { return m_first_point[e]; }
  Index beyond_point(const Index e) const { return m_first_point[e + 1]; }
  Index number_of_points(const Index e) const { return beyond_point(e) - first_point(e); }

  Index edge_of_point(const Index p) const { return m_edge_of_point[p]; }
  float position(const Index p) const { return m_position[p]; }
  const float* positions() const { return m_position.data(); }

  void prefetch(const Index p) const
  {
    internal::prefetch(m_edge_of_point.data() + p);
    internal::prefetch(m_position.data() + p);
  }

  std::size_t memory() const
  {
    return sizeof(Index) * (m_halfedge.capacity() + m_first_point.capacity() + m_edge.capacity() +
                            m_edge_of_point.capacity()) +
           sizeof(float) * m_position.capacity();
  }

private:
  void number_edges(const Intrinsic_triangulation& triangulation)
  {
    m_edge.assign(triangulation.number_of_halfedges(), Intrinsic_triangulation::null_index);
    m_halfedge.reserve(triangulation.number_of_edges());
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    {
      const Index twin = triangulation.opposite(h);
      const bool comes_second = m_edge[h] != Intrinsic_triangulation::null_index;
      if(comes_second || (triangulation.is_border(h) && !triangulation.is_border(twin)))
        continue;
      m_edge[h] = number_of_edges();
      if(!triangulation.is_barrier(h))
        m_edge[twin] = m_edge[h];
      m_halfedge.push_back(h);
    }
  }

  template <typename Placement>
  void count_points(const Intrinsic_triangulation& triangulation,
                    const Placement& placement,
                    const std::size_t largest_number)
  {
    m_first_point.clear();
    m_first_point.reserve(m_halfedge.size() + 1);
    std::size_t number = 0;
    for(const Index h : m_halfedge)
    {
      m_first_point.push_back(static_cast<Index>(number));
      const std::size_t number_on_edge =
          triangulation.length(h) > 0 ? placement.number_of_points(triangulation, h) : 0;
      if(number_on_edge > largest_number - number)
        throw std::length_error("Approximate_geodesics: the graph would have more than " +
                                std::to_string(largest_number) +
                                " points on edges, which is what 32-bit numbers can tell apart");
      number += number_on_edge;
    }
    m_first_point.push_back(static_cast<Index>(number));
  }

  std::vector<Index> m_halfedge;          // per edge
  std::vector<Index> m_first_point = {0}; // per edge, and one beyond
  std::vector<Index> m_edge;              // per halfedge
  std::vector<Index> m_edge_of_point;     // per point, as the next
  std::vector<float> m_position;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_POINTS_ON_EDGES_H
