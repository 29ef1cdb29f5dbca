// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINTS_ON_EDGES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINTS_ON_EDGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/prefetch.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Returns the maximum number of points on all edges together: `given`, or the default if that is 0.
// The default is enough for small bounds on large meshes, and on small meshes it limits a search to
// some seconds. A point takes about 50 bytes of a graph and a search.
inline std::size_t maximum_number_of_points(const Intrinsic_triangulation& triangulation,
                                            const std::size_t given)
{
  constexpr double smallest = 1e6, per_edge = 1000, largest = 1e8;
  const double by_default =
      (std::clamp)(per_edge * (triangulation.number_of_halfedges() / 2), smallest, largest);
  return given > 0 ? given : static_cast<std::size_t>(by_default);
}

// Returns a number of points for a message. Sums of these are doubles, which do not overflow.
inline std::string text_of_points(const double number)
{
  constexpr double far_too_many = 1e12;
  return number < far_too_many ? std::to_string(static_cast<long long>(number))
                               : std::string("more than 10^12");
}

// Returns whether there are more than `limit` points on the edges that paths may cross. They are
// only counted, which takes time proportional to the number of edges.
template <typename Placement>
bool has_more_points(const Intrinsic_triangulation& triangulation,
                     const Placement& placement,
                     const std::size_t limit)
{
  using Index = Intrinsic_triangulation::Index;
  double sum = 0;
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(h < triangulation.opposite(h) && triangulation.is_crossable(h) &&
       triangulation.length(h) > 0)
      sum += double(placement.number_of_points(triangulation, h));
  return sum > double(limit);
}

template <typename Placement>
using Accepts_weaker_bound = decltype(std::declval<const Placement&>().accepts_weaker_bound());

/*
 * The points that a placement puts on the edges of a triangulation, numbered from 0. Those of an
 * edge have consecutive numbers, from the source of one of its halfedges, called the first one, to
 * its target.
 *
 * A barrier counts as two edges, one for each side, with points of their own. Therefore edges have
 * numbers that are private to this class.
 *
 * A position is a part of the edge, measured from the nearer end, so that points very close to an
 * end can be told apart: from 0 to 1/2, it is the part between the first end and the point; below
 * 0, minus the part between the point and the second end. Positions of equal parts are not stored.
 */
class Points_on_edges
{
public:
  using Index = Intrinsic_triangulation::Index;
  static constexpr Index null_index = Intrinsic_triangulation::null_index;

  Points_on_edges() = default;

  // Throws std::length_error if there are more points than `limit`, or than `largest_number`, so
  // that a graph would have more than 2^32 - 1 nodes. Points are counted before memory is
  // allocated.
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

  // Returns the edge of a halfedge; of a barrier, the one on the left side of `h`.
  Index edge(const Index h) const { return m_edge[h] / 2; }

  // Returns whether `h` is the first halfedge of its edge. It is not at the border, unless both
  // are.
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

  // Returns the first halfedge of the edge of a point.
  Index halfedge(const Index p) const { return m_halfedge[p]; }

  // Return the part of the edge `e` between its first end and its point `p`, and the rest of it.
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

  // Returns the part of the edge `e` between its point `p` and the next one.
  double part_between(const Index e, const Index p) const
  {
    if(m_position.empty())
      return 1 / double(number_of_points(e) + 1);
    const double difference = double(m_position[p + 1]) - double(m_position[p]);
    return m_position[p] >= 0 && m_position[p + 1] < 0 ? 1 + difference : difference;
  }

  // Returns the positions from that of `p` on, or a null pointer if they are not stored.
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
    double number = 0;
    Index halfedge_with_most = 0;
    std::size_t most = 0;
    for_each_first_halfedge([&](const Index h, const Index e) {
      const std::size_t number_on_edge =
          triangulation.length(h) > 0 ? placement.number_of_points(triangulation, h) : 0;
      number += double(number_on_edge);
      if(number_on_edge > most)
      {
        most = number_on_edge;
        halfedge_with_most = h;
      }
      m_first_point[e + 1] = m_first_point[e] + static_cast<Index>(number_on_edge); // checked below
    });
    if(number > double((std::min)(limit, largest_number)))
      refuse_points(triangulation, placement, number, halfedge_with_most, most, limit);
  }

  template <typename Placement>
  [[noreturn]] static void refuse_points(const Intrinsic_triangulation& triangulation,
                                         const Placement& placement,
                                         const double number,
                                         const Index halfedge_with_most,
                                         const std::size_t most,
                                         const std::size_t limit)
  {
    std::string reason = "can have at most 2^32 - 1 nodes";
    if(number > double(limit))
    {
      reason = "maximum_number_of_points is " + std::to_string(limit);
      if constexpr(boost::is_detected_v<Accepts_weaker_bound, Placement>)
        if(!placement.accepts_weaker_bound())
          reason += "; fewer are enough for a larger epsilon, or with accept_weaker_bound(true)";
    }
    const auto index = [&](const Index h) {
      return std::to_string(triangulation.index(triangulation.target(h)));
    };
    throw std::length_error("Approximate_geodesics: the graph needs " + text_of_points(number) +
                            " points on edges, " + text_of_points(double(most)) +
                            " of them between vertices " +
                            index(triangulation.opposite(halfedge_with_most)) + " and " +
                            index(halfedge_with_most) + ", and " + reason);
  }

  std::vector<Index> m_edge;              // per halfedge: twice the edge, plus one if not first
  std::vector<Index> m_first_point = {0}; // per edge, and one beyond
  std::vector<Index> m_halfedge;          // per point
  std::vector<float> m_position;          // likewise, or empty
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINTS_ON_EDGES_H
