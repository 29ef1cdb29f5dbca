// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_GEOMETRIC_PROGRESSIONS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_GEOMETRIC_PROGRESSIONS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The points of an edge of length 1 in two geometric progressions, one from either end, which start
 * at a given distance from the end and meet where their spacings are equal.
 */
class Geometric_progressions
{
public:
  // What is known of an end: where its progression starts, how close the other edges of the faces
  // are (see `Face_shape`), and the logarithm of the largest ratio between neighbors.
  struct End
  {
    double start;
    double sine;
    double log_of_ratio;
  };

  // \pre `first.start + second.start < 1`
  Geometric_progressions(const End& first, const End& second)
    : m_first_start(first.start), m_second_start(second.start)
  {
    m_meeting_point =
        (std::clamp)(second.sine / (first.sine + second.sine), first.start, 1 - second.start);
    m_first_number = number_of_steps(m_meeting_point, first);
    m_second_number = number_of_steps(1 - m_meeting_point, second);
  }

  std::size_t number_of_points() const
  {
    return static_cast<std::size_t>(m_first_number + m_second_number) + 1;
  }

  // Writes the positions of the points; for positions, see `Points_on_edges`.
  void place(float* positions) const
  {
    const auto first = static_cast<std::size_t>(m_first_number);
    const auto second = static_cast<std::size_t>(m_second_number);
    for(std::size_t i = 0; i < first; ++i)
      positions[i] = position(term(m_first_start, m_meeting_point, i, first));
    positions[first] = position(m_meeting_point);
    for(std::size_t i = 0; i < second; ++i)
    {
      const double part = term(m_second_start, 1 - m_meeting_point, i, second);
      positions[first + second - i] =
          part < 0.5 ? static_cast<float>(-part) : static_cast<float>(1 - part);
    }
  }

private:
  static double number_of_steps(const double end, const End& e)
  {
    constexpr double tolerance = 1e-9;
    constexpr double too_many = 1e18; // and yet an integer
    return (std::clamp)(std::ceil(std::log(end / e.start) / e.log_of_ratio - tolerance), 0.,
                        too_many);
  }

  static double
  term(const double start, const double end, const std::size_t i, const std::size_t number)
  {
    return start * std::pow(end / start, double(i) / double(number));
  }

  static float position(const double part_from_first)
  {
    return static_cast<float>(part_from_first <= 0.5 ? part_from_first : part_from_first - 1);
  }

  double m_first_start, m_second_start;
  double m_meeting_point;
  double m_first_number, m_second_number; // of steps
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_STEINER_GEOMETRIC_PROGRESSIONS_H
