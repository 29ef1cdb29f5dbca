// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINT_ROW_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINT_ROW_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Steiner/Points_on_edges.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Corner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The points of an edge, ranked by their distance from the end that is at a corner of a face.
 */
class Point_row
{
public:
  using Index = Intrinsic_triangulation::Index;

  // Points are nodes from `first_node` on. Their positions are as in `Points_on_edges`, or missing
  // if they divide the edge into equal parts. The corner is at the first end of the edge or at the
  // second one.
  Point_row(const Index first_node,
            const Index size,
            const float* const positions,
            const double length,
            const bool starts_at_first_end)
    : m_first_node(first_node),
      m_size(size),
      m_positions(positions),
      m_length(length),
      m_is_reversed(starts_at_first_end ? 0 : 1)
  {
  }

  Index size() const { return m_size; }

  // the length of the edge
  double length() const { return m_length; }

  double distance_from_corner(const Index rank) const
  {
    const Index i = m_is_reversed == 0 ? rank : m_size - 1 - rank;
    return m_positions == nullptr ? equal_parts()(i) : stored_positions()(i);
  }

  // Calls `f(node, costs, number)` for consecutive points with ranks from `first` to before
  // `beyond`, with their distances from the point of the corner's other side that is at the
  // distance `x` from it, times `weight`.
  template <typename F>
  void for_each_block(const Index first,
                      const Index beyond,
                      const Corner& corner,
                      const double x,
                      const double weight,
                      F f) const
  {
    const Index begin = first + m_is_reversed * (m_size - beyond - first);
    const Index end = begin + (beyond - first);
    if(m_positions == nullptr)
      measure(begin, end, corner, x, weight, equal_parts(), f);
    else
      measure(begin, end, corner, x, weight, stored_positions(), f);
  }

private:
  static constexpr Index SIZE_OF_BLOCK = 8;

  // Distances from the corner, by the order on the edge.
  struct Equal_parts
  {
    double operator()(const Index i) const { return start + step * number(i); }

    double start, step;
  };

  struct Stored_positions
  {
    double operator()(const Index i) const
    {
      const double position = positions[i];
      return (position < 0 ? start_of_second_half : start) + step * position;
    }

    const float* positions;
    double start, start_of_second_half, step;
  };

  // Without branches, as what direction an edge has cannot be predicted.
  Equal_parts equal_parts() const
  {
    const double part = m_length / number(m_size + 1);
    return {part * number(1 + m_is_reversed * (m_size - 1)), direction() * part};
  }

  Stored_positions stored_positions() const
  {
    return {m_positions, number(m_is_reversed) * m_length, number(1 - m_is_reversed) * m_length,
            direction() * m_length};
  }

  double direction() const { return number(1) - 2 * number(m_is_reversed); }

  // which is faster for signed integers
  static double number(const Index i) { return static_cast<double>(std::int32_t(i)); }

  template <typename Distance_from_corner, typename F>
  void measure(Index begin,
               const Index end,
               const Corner& corner,
               const double x,
               const double weight,
               const Distance_from_corner& distance_from_corner,
               F& f) const
  {
    const auto cost = [&](const Index i) {
      return weight * corner.distance(x, distance_from_corner(i));
    };
    std::array<double, SIZE_OF_BLOCK> costs;
    for(; end - begin >= SIZE_OF_BLOCK; begin += SIZE_OF_BLOCK)
    {
      for(Index i = 0; i < SIZE_OF_BLOCK; ++i) // in vector instructions
        costs[i] = cost(begin + i);
      f(m_first_node + begin, costs.data(), SIZE_OF_BLOCK);
    }
    for(Index i = 0; begin + i < end; ++i)
      costs[i] = cost(begin + i);
    f(m_first_node + begin, costs.data(), end - begin);
  }

  Index m_first_node;
  Index m_size;
  const float* m_positions;
  double m_length;
  Index m_is_reversed; // 0 or 1
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_POINT_ROW_H
