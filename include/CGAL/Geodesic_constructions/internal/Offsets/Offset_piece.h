// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_PIECE_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_PIECE_H

#include <CGAL/license/Geodesic_constructions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Returns the part of the way at which a function vanishes, up to `largest`, that is negative at
 * the start and positive at the end, by regula falsi (the Illinois method). Begins at `first`, by
 * default where it vanishes if it is linear.
 */
template <typename F>
double regula_falsi(double at_start, double at_end, const double largest, const F& f, double first)
{
  constexpr int most_steps = 16;
  double start = 0, end = 1, result = first, before = 0;
  for(int i = 0; i < most_steps; ++i)
  {
    const double here = f(result);
    if(!(std::abs(here) > largest))
      break;
    (here < 0 ? start : end) = result;
    (here < 0 ? at_start : at_end) = here;
    if(here * before > 0)
      (here < 0 ? at_end : at_start) /= 2;
    before = here;
    result = start + (end - start) * (-at_start / (at_end - at_start));
  }
  return result;
}

template <typename F>
double regula_falsi(const double at_start, const double at_end, const double largest, const F& f)
{
  return regula_falsi(at_start, at_end, largest, f, -at_start / (at_end - at_start));
}

/*
 * The part of an isoline that cuts off a corner of a triangle. Its chord is divided where it is too
 * far from the isoline: the distances of circles, and of corners where shortest paths meet.
 *
 * `Distance` returns the difference from that of the isoline, for weights of the corners.
 */
template <typename Distance>
class Offset_piece
{
public:
  using Weights = std::array<double, 3>;

  Offset_piece(const Distance& distance,
               const std::size_t corner,
               const bool is_corner_farther,
               const double largest_difference)
    : m_distance(distance),
      m_corner(corner),
      m_is_corner_farther(is_corner_farther),
      m_largest_difference(largest_difference)
  {
  }

  // Calls `f(weights)` for points between `p` and `q`, in order.
  template <typename F>
  void for_each_between(const Weights& p, const Weights& q, const F& f, const int depth = 0) const
  {
    constexpr int deepest = 5;
    const Weights middle = between(p, q, 0.5);
    const double difference = m_distance(middle);
    if(depth == deepest || !(std::abs(difference) > m_largest_difference)) // or not a number
      return;
    const Weights r = moved(middle, difference);
    if(!(std::abs(m_distance(r)) <= m_largest_difference))
      return;
    for_each_between(p, r, f, depth + 1);
    f(r);
    for_each_between(r, q, f, depth + 1);
  }

private:
  static Weights between(const Weights& p, const Weights& q, const double t)
  {
    Weights result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = (1 - t) * p[i] + t * q[i];
    return result;
  }

  // To the isoline, on the line through the corner, as far as it is in the triangle.
  Weights moved(const Weights& p, const double difference) const
  {
    constexpr double farthest = 0.999;
    const bool is_toward_corner = (difference < 0) == m_is_corner_farther;
    if(!(p[m_corner] < 1))
      return p;
    Weights end{};
    if(is_toward_corner)
      end[m_corner] = 1;
    else
      for(const std::size_t i : {(m_corner + 1) % 3, (m_corner + 2) % 3})
        end[i] = p[i] / (1 - p[m_corner]);
    const double sign = difference < 0 ? 1 : -1, at_end = sign * m_distance(end);
    if(!(at_end > 0))
      return between(p, end, farthest);
    const double t =
        regula_falsi(sign * difference, at_end, m_largest_difference / 4,
                     [&](const double part) { return sign * m_distance(between(p, end, part)); });
    return between(p, end, (std::min)(t, farthest));
  }

  const Distance& m_distance;
  const std::size_t m_corner;
  const bool m_is_corner_farther;
  const double m_largest_difference;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_OFFSETS_OFFSET_PIECE_H
