// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_OPTIONAL_POINTS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_OPTIONAL_POINTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A point placement that may be empty, so that graphs with a bound and graphs along edges share one
 * type and one instantiation. Placement can be interrupted.
 */
template <typename Placement>
class Optional_points
{
public:
  using Index = Intrinsic_triangulation::Index;

  static constexpr bool makes_equal_parts = false;

  explicit Optional_points(std::optional<Placement> points) : m_points(std::move(points)) {}

  void prepare(const Intrinsic_triangulation& triangulation,
               const std::size_t maximum_number_of_points)
  {
    if(m_points)
      m_points->prepare(triangulation, maximum_number_of_points);
  }

  std::size_t number_of_points(const Intrinsic_triangulation& triangulation, const Index h) const
  {
    check_for_interruption_at(h);
    return m_points ? m_points->number_of_points(triangulation, h) : 0;
  }

  void place(const Intrinsic_triangulation& triangulation,
             const Index h,
             float* const positions,
             const std::size_t number_of_points) const
  {
    check_for_interruption_at(h);
    if(m_points)
      m_points->place(triangulation, h, positions, number_of_points);
  }

  double epsilon(const Intrinsic_triangulation& triangulation) const
  {
    return m_points ? m_points->epsilon(triangulation) : std::numeric_limits<double>::infinity();
  }

  std::size_t memory() const { return m_points ? m_points->memory() : 0; }

private:
  std::optional<Placement> m_points;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_OPTIONAL_POINTS_H
