// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINTS_ON_EDGES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINTS_ON_EDGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/prefetch.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// How many points there may be on all edges of a graph together. They are counted before there is
// any memory for them, in time that depends on the number of edges only.

// The limit that was given, or by default, if it is 0: as many as small bounds take on large
// meshes, and on small meshes what a search takes some seconds for. A point takes about 50 bytes of
// a graph and a search.
inline std::size_t maximum_number_of_points(const Intrinsic_triangulation& triangulation,
                                            const std::size_t given)
{
  constexpr double smallest = 1e6, per_edge = 1000, largest = 1e8;
  const double by_default =
      (std::clamp)(per_edge * (triangulation.number_of_halfedges() / 2), smallest, largest);
  return given > 0 ? given : static_cast<std::size_t>(by_default);
}

// A sum of numbers of points that does not overflow.
class Number_of_points
{
public:
  static constexpr double FAR_TOO_MANY = 1e12;

  void add(const std::size_t number) { m_sum += double(number); }
  bool is_above(const std::size_t limit) const { return m_sum > double(limit); }

  friend std::string to_string(const Number_of_points& number)
  {
    return number.m_sum < FAR_TOO_MANY ? std::to_string(static_cast<long long>(number.m_sum))
                                       : std::string("more than 10^12");
  }

private:
  double m_sum = 0; // exact as far as it is told
};

// Whether there are more points than the limit on the edges that paths may cross.
template <typename Placement>
bool has_more_points(const Intrinsic_triangulation& triangulation,
                     const Placement& placement,
                     const std::size_t limit)
{
  using Index = Intrinsic_triangulation::Index;
  Number_of_points sum;
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(h < triangulation.opposite(h) && triangulation.is_crossable(h) &&
       triangulation.length(h) > 0)
      sum.add(placement.number_of_points(triangulation, h));
  return sum.is_above(limit);
}

// What makes a placement take fewer points, for a message; nothing if it has no bound, or has
// accepted a weaker one.
template <typename Placement>
auto advice_on_points(const Placement& placement, int)
    -> decltype(placement.accepts_weaker_bound(), std::string())
{
  return placement.accepts_weaker_bound()
             ? ""
             : "; fewer are enough for a larger epsilon, or with accept_weaker_bound(true)";
}
template <typename Placement>
std::string advice_on_points(const Placement& /* placement */, long)
{
  return "";
}

// Says how many points there would be, and on which edge most of them.
[[noreturn]] inline void refuse_points(const Intrinsic_triangulation& triangulation,
                                       const Number_of_points& number,
                                       const Intrinsic_triangulation::Index halfedge_with_most,
                                       const std::size_t number_there,
                                       const std::size_t limit,
                                       const std::string& advice)
{
  Number_of_points on_edge;
  on_edge.add(number_there);
  const auto index = [&](const Intrinsic_triangulation::Index h) {
    return std::to_string(triangulation.index(triangulation.target(h)));
  };
  throw std::length_error("Approximate_geodesics: the graph takes " + to_string(number) +
                          " points on edges, " + to_string(on_edge) + " of them between vertices " +
                          index(triangulation.opposite(halfedge_with_most)) + " and " +
                          index(halfedge_with_most) + ", and maximum_number_of_points is " +
                          std::to_string(limit) + advice);
}

/*
 * The points that a placement puts on the edges of a triangulation. They are numbered from 0: those
 * of an edge follow each other, from the source of one of its halfedges, called the first one, to
 * its target.
 *
 * A barrier is two edges here, one for either side, each with points of its own. So edges have a
 * number that only this class knows.
 *
 * A position is a part of the edge, measured from the nearer end, which keeps points apart that are
 * very close to an end: from 0 to 1/2, the part between the first end and the point; below 0, minus
 * the part between the point and the second end. Positions that follow from the number of points
 * are not stored.
 */
class Points_on_edges
{
public:
  using Index = Intrinsic_triangulation::Index;
  static constexpr Index null_index = Intrinsic_triangulation::null_index;

  Points_on_edges() = default;

  // Throws std::length_error if there are more points than `limit` says, or than `largest_number`,
  // which is what numbers can tell apart.
  template <typename Placement>
  Points_on_edges(const Intrinsic_triangulation& triangulation,
                  const Placement& placement,
                  const std::size_t limit,
                  const std::size_t largest_number)
  {
    number_edges(triangulation);
    count_points(triangulation, placement, limit, largest_number);
    m_halfedge.resize(number_of_points());
    for_each_first_halfedge([&](const Index h, const Index e) {
      std::fill(m_halfedge.begin() + first_point(e), m_halfedge.begin() + beyond_point(e), h);
    });
    if constexpr(!Placement::makes_equal_parts)
    {
      m_position.resize(number_of_points());
      for_each_first_halfedge([&](const Index h, const Index e) {
        if(number_of_points(e) > 0)
          placement.place(triangulation, h, m_position.data() + first_point(e),
                          number_of_points(e));
      });
    }
  }

  // ----- edges

  Index number_of_edges() const { return static_cast<Index>(m_first_point.size() - 1); }

  // the edge of a halfedge of the triangulation, the one on its left side if it is a barrier
  Index edge(const Index h) const { return m_edge[h] / 2; }

  // whether `h` is the first halfedge of its edge; there is a face to the left of that, if any
  bool is_first(const Index h) const { return m_edge[h] % 2 == 0; }

  // Calls `f(h, e)` for every edge `e` and its first halfedge `h`.
  template <typename F>
  void for_each_first_halfedge(F f) const
  {
    for(Index h = 0; h < m_edge.size(); ++h)
      if(is_first(h))
        f(h, edge(h));
  }

  // ----- points

  Index number_of_points() const { return m_first_point.back(); }
  Index first_point(const Index e) const { return m_first_point[e]; }
  Index beyond_point(const Index e) const { return m_first_point[e + 1]; }
  Index number_of_points(const Index e) const { return beyond_point(e) - first_point(e); }

  // the first halfedge of the edge of a point
  Index halfedge(const Index p) const { return m_halfedge[p]; }

  // the part of the edge `e` between its first end and its point `p`, and the rest of it
  double part_before(const Index e, const Index p) const
  {
    if(m_position.empty())
      return double(p - first_point(e) + 1) / double(number_of_points(e) + 1);
    return m_position[p] < 0 ? 1 + double(m_position[p]) : double(m_position[p]);
  }
  double part_behind(const Index e, const Index p) const
  {
    if(m_position.empty())
      return double(beyond_point(e) - p) / double(number_of_points(e) + 1);
    return m_position[p] < 0 ? -double(m_position[p]) : 1 - double(m_position[p]);
  }

  // the part of the edge `e` between its point `p` and the next one
  double part_between(const Index e, const Index p) const
  {
    if(m_position.empty())
      return 1 / double(number_of_points(e) + 1);
    const double difference = double(m_position[p + 1]) - double(m_position[p]);
    return m_position[p] >= 0 && m_position[p + 1] < 0 ? 1 + difference : difference;
  }

  // The positions from that of `p` on, or a null pointer if points divide edges into equal parts.
  const float* positions(const Index p) const
  {
    return m_position.empty() ? nullptr : m_position.data() + p;
  }

  void prefetch(const Index p) const
  {
    internal::prefetch(m_halfedge.data(), p);
    if(!m_position.empty())
      internal::prefetch(m_position.data(), p);
  }

  std::size_t memory() const
  {
    return sizeof(Index) * (m_edge.capacity() + m_first_point.capacity() + m_halfedge.capacity()) +
           sizeof(float) * m_position.capacity();
  }

private:
  void number_edges(const Intrinsic_triangulation& triangulation)
  {
    m_edge.assign(triangulation.number_of_halfedges(), null_index);
    Index number = 0;
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    {
      const Index opposite = triangulation.opposite(h);
      const bool comes_second = m_edge[h] != null_index;
      if(comes_second || (triangulation.is_border(h) && !triangulation.is_border(opposite)))
        continue;
      m_edge[h] = 2 * number;
      if(!triangulation.is_barrier(h))
        m_edge[opposite] = 2 * number + 1;
      ++number;
    }
    m_first_point.assign(number + std::size_t(1), 0);
  }

  template <typename Placement>
  void count_points(const Intrinsic_triangulation& triangulation,
                    const Placement& placement,
                    const std::size_t limit,
                    const std::size_t largest_number)
  {
    Number_of_points number;
    Index halfedge_with_most = 0;
    std::size_t largest = 0;
    for_each_first_halfedge([&](const Index h, const Index e) {
      const std::size_t number_on_edge =
          triangulation.length(h) > 0 ? placement.number_of_points(triangulation, h) : 0;
      number.add(number_on_edge);
      if(number_on_edge > largest)
      {
        largest = number_on_edge;
        halfedge_with_most = h;
      }
      m_first_point[e + 1] = m_first_point[e] + static_cast<Index>(number_on_edge); // if it fits
    });
    if(number.is_above(limit))
      refuse_points(triangulation, number, halfedge_with_most, largest, limit,
                    advice_on_points(placement, 0));
    if(number.is_above(largest_number))
      throw std::length_error("Approximate_geodesics: the graph would have more than " +
                              std::to_string(largest_number) +
                              " points on edges, which is what 32-bit numbers can tell apart");
  }

  std::vector<Index> m_edge;              // per halfedge: twice the edge, plus one if not first
  std::vector<Index> m_first_point = {0}; // per edge, and one beyond
  std::vector<Index> m_halfedge;          // per point
  std::vector<float> m_position;          // likewise, or empty
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINTS_ON_EDGES_H
