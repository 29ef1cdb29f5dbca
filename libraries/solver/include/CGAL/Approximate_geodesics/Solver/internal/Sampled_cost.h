// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SAMPLED_COST_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SAMPLED_COST_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A cost function that was sampled in the same number of directions in each face. Between two
 * neighboring directions, it is linear, as the largest convex gauge with these values is there.
 *
 * The numbers of a face are two orthogonal unit vectors in its plane, and, for each direction, its
 * angle from the first vector to the second one, and its cost. Angles increase from -pi to pi.
 */
class Sampled_cost
{
  static constexpr std::size_t AXES = 6;
  static constexpr double PI = 3.14159265358979323846;

  // Angles that differ by rounding, which must not mix a finite and an infinite cost.
  static constexpr double SAME = 1e-9;

public:
  static constexpr std::size_t numbers_per_face(const std::size_t number_of_directions)
  {
    return AXES + 2 * number_of_directions;
  }

  // Returns the number of directions, which is the only parameter.
  static std::size_t number_of_directions(const Solver_cost& cost)
  {
    constexpr double most = 1e6;
    const double number = cost.parameters.empty() ? 0 : cost.parameters[0];
    if(!(number >= 3 && number <= most && number == std::floor(number)))
      reject("costs are sampled in " + text_of(number) +
             " directions; there must be an integer number from 3 to " + text_of(most));
    return static_cast<std::size_t>(number);
  }

  // The cost is referred to, not copied.
  explicit Sampled_cost(const Solver_cost& cost)
    : m_numbers(cost.of_faces.data()), m_number_of_directions(number_of_directions(cost))
  {
    const std::size_t width = numbers_per_face(m_number_of_directions);
    for(std::size_t f = 0; f < cost.of_faces.size() / width; ++f)
      check(f);
  }

  template <typename Vector_3>
  double operator()(const std::size_t face, const Vector_3& direction) const
  {
    const double* const axes = numbers(face);
    const auto along = [&](const double* const axis) {
      return axis[0] * direction[0] + axis[1] * direction[1] + axis[2] * direction[2];
    };
    return cost_at(axes + AXES, std::atan2(along(axes + 3), along(axes)));
  }

private:
  const double* numbers(const std::size_t face) const
  {
    return m_numbers + face * numbers_per_face(m_number_of_directions);
  }

  void check(const std::size_t face) const
  {
    check_numbers(face);
    check_axes(face);
    check_angles(face);
  }

  void check_numbers(const std::size_t face) const
  {
    const double* const numbers_of_face = numbers(face);
    for(std::size_t i = 0; i < AXES + 2 * m_number_of_directions; ++i)
    {
      const bool is_cost = i >= AXES && (i - AXES) % 2 == 1;
      const double x = numbers_of_face[i];
      if(is_cost ? !(x >= 0) : !std::isfinite(x))
        reject("face " + std::to_string(face) + " has the number " + text_of(x) +
               " in its sampled cost; costs must be numbers that are not negative, or infinity, "
               "and other numbers must be finite");
    }
  }

  void check_axes(const std::size_t face) const
  {
    constexpr double rounding = 1e-6; // of `float`
    const double *const a = numbers(face), *const b = a + 3;
    const double length_of_a = std::hypot(a[0], a[1], a[2]);
    const double length_of_b = std::hypot(b[0], b[1], b[2]);
    const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    if(!(std::abs(length_of_a - 1) <= rounding && std::abs(length_of_b - 1) <= rounding &&
         std::abs(product) <= rounding))
      reject("face " + std::to_string(face) + " has, in its sampled cost, axes of the lengths " +
             text_of(length_of_a) + " and " + text_of(length_of_b) + ", and the scalar product " +
             text_of(product) + "; they must be orthogonal unit vectors");
  }

  void check_angles(const std::size_t face) const
  {
    const double* const samples = numbers(face) + AXES;
    const auto angle = [&](const std::size_t i) { return samples[2 * i]; };
    for(std::size_t i = 0; i < m_number_of_directions; ++i)
    {
      if(std::abs(angle(i)) > PI + SAME)
        reject("face " + std::to_string(face) + " has the angle " + text_of(angle(i)) +
               " in its sampled cost; angles must be from -pi to pi");
      const bool is_last = i + 1 == m_number_of_directions;
      const double gap = is_last ? angle(0) - angle(i) + 2 * PI : angle(i + 1) - angle(i);
      if(!(gap >= -SAME && gap < PI - SAME))
        reject("face " + std::to_string(face) +
               " has sampled directions that are not in the order of their angles, or half a "
               "circle apart");
    }
  }

  // `samples` are pairs of an angle and a cost.
  double cost_at(const double* const samples, const double angle) const
  {
    std::size_t low = 0, high = m_number_of_directions;
    while(low < high) // the first sample beyond the angle
    {
      const std::size_t middle = (low + high) / 2;
      if(samples[2 * middle] <= angle)
        low = middle + 1;
      else
        high = middle;
    }
    const double* const before = samples + 2 * ((low == 0 ? m_number_of_directions : low) - 1);
    const double* const behind = samples + 2 * (low == m_number_of_directions ? 0 : low);
    const double from = angle - before[0] + (low == 0 ? 2 * PI : 0);
    const double to = behind[0] - angle + (low == m_number_of_directions ? 2 * PI : 0);
    if(from <= SAME)
      return before[1];
    if(to <= SAME)
      return behind[1];
    return (before[1] * std::sin(to) + behind[1] * std::sin(from)) / std::sin(from + to);
  }

  const double* m_numbers;
  std::size_t m_number_of_directions;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SAMPLED_COST_H
