// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STEINER_POINT_ROW_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STEINER_POINT_ROW_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Surface/internal/face_geometry.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

// A range of ranks of points in a row.
struct Ranks
{
  Index first, beyond;
};

// Returns the first rank of a range for which `f` is false, and its end if there is none, in
// logarithmic time of the distance from the start.
template <typename F>
Index first_rank_without(const Ranks& ranks, const F& f)
{
  Index low = ranks.first, step = 1;
  while(low + step <= ranks.beyond && f(low + step - 1))
  {
    low += step;
    step *= 2;
  }
  using Rank = boost::counting_iterator<Index>;
  const Rank end((std::max)((std::min)(low + step - 1, ranks.beyond), low));
  return *std::partition_point(Rank(low), end, f);
}

/*
 * The points of an edge, which are nodes from `first_node` on, ranked by their distance from the
 * end that is at a corner of a face, which has this weight.
 */
struct Point_row
{
  Index first_node, size;
  const float* positions; // as in `Points_on_edges`, or null if points divide the edge equally
  double length;          // of the edge
  Index is_reversed;      // 0 if the corner is at the first end of the edge, and else 1
  Corner corner;
  double weight;

  double distance_from_corner(const Index rank) const
  {
    const Index i = is_reversed == 0 ? rank : size - 1 - rank;
    return positions == nullptr ? equal_parts()(i) : stored_positions()(i);
  }

  // Returns the same for a point, for the corner, which has rank -1, or for the other end.
  double distance_of_node(const Index rank) const
  {
    return rank < size ? distance_from_corner(rank) : rank == size ? length : 0;
  }

  // Returns the rank of a node of the row.
  Index rank(const Index node) const
  {
    const Index i = node - first_node;
    return is_reversed == 0 ? i : size - 1 - i;
  }

  // Calls `f(node, costs, number)` for blocks of consecutive points, which have these ranks. Costs
  // are those from the point on the other side of the corner, at the distance `x` from the corner.
  template <typename F>
  void for_each_block(const Ranks& ranks, const double x, F f) const
  {
    const Index number_of_points = ranks.beyond - ranks.first;
    const Index begin = ranks.first + is_reversed * (size - ranks.beyond - ranks.first);
    const Index end = begin + number_of_points;
    if(positions == nullptr)
      measure(begin, end, x, equal_parts(), f);
    else
      measure(begin, end, x, stored_positions(), f);
  }

private:
  static constexpr Index SIZE_OF_BLOCK = 8;

  // Function objects for the distances of points from the corner, by their order on the edge.
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

  // Without branches, since the direction of an edge is unpredictable.
  Equal_parts equal_parts() const
  {
    const double part = length / number(size + 1);
    return {part * number(1 + is_reversed * (size - 1)), direction() * part};
  }

  Stored_positions stored_positions() const
  {
    return {positions, number(is_reversed) * length, number(1 - is_reversed) * length,
            direction() * length};
  }

  double direction() const { return number(1) - 2 * number(is_reversed); }

  // faster for signed integers
  static double number(const Index i) { return static_cast<double>(std::int32_t(i)); }

  template <typename Distance_from_corner, typename F>
  void measure(Index begin,
               const Index end,
               const double x,
               const Distance_from_corner& distance_from_corner,
               F& f) const
  {
    const Corner c = corner; // `f` cannot change these two
    const double w = weight;
    const auto cost = [&](const Index i) { return w * c.distance(x, distance_from_corner(i)); };
    std::array<double, SIZE_OF_BLOCK> costs;
    for(; end - begin >= SIZE_OF_BLOCK; begin += SIZE_OF_BLOCK)
    {
      for(Index i = 0; i < SIZE_OF_BLOCK; ++i) // in vector instructions
        costs[i] = cost(begin + i);
      f(first_node + begin, costs.data(), SIZE_OF_BLOCK);
    }
    for(Index i = 0; begin + i < end; ++i)
      costs[i] = cost(begin + i);
    f(first_node + begin, costs.data(), end - begin);
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STEINER_POINT_ROW_H
