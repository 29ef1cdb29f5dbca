// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_GRID_METRIC_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_GRID_METRIC_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The lengths of the sides of cells. They are the same for all rows, unless the grid is geographic:
 * then a line has the metric of the latitude in the middle between the rows of its ends. So lengths
 * are symmetric, and their relative error is of second order in the extent of the line. Parts of a
 * geographic grid have the metric of the whole.
 */
class Grid_metric
{
public:
  struct Sides
  {
    double width, height;
  };

  Grid_metric() = default;

  explicit Grid_metric(const Grid_shape& shape) : m_smallest{shape.cell_width, shape.cell_height}
  {
    if(!shape.first_latitude)
    {
      m_sides.push_back(m_smallest);
      return;
    }
    check_latitudes(shape);
    check_ellipsoid(shape.ellipsoid);
    m_is_geographic = true;
    m_first_sum = 2 * shape.rows_before;
    for(std::size_t sum = 0; sum + 1 < 2 * all_rows(shape); ++sum)
      m_sides.push_back(sides_at(shape, static_cast<double>(sum + 1) / 2));
    m_smallest = m_sides.front();
    for(const Sides& sides : m_sides)
      m_smallest = {(std::min)(m_smallest.width, sides.width),
                    (std::min)(m_smallest.height, sides.height)};
  }

  bool is_geographic() const { return m_is_geographic; }

  // Returns the sides of cells for lines between two rows.
  const Sides& between(const std::size_t row, const std::size_t other) const
  {
    return m_is_geographic ? m_sides[m_first_sum + row + other] : m_sides.front();
  }

  // Returns the smallest width and the smallest height.
  const Sides& smallest() const { return m_smallest; }

  // Returns those in the middle of the whole grid.
  const Sides& middle() const { return m_sides[(m_sides.size() + 1) / 4 * 2]; }

  // Returns those of all rows of the whole grid.
  const std::vector<Sides>& all() const { return m_sides; }

  std::size_t memory() const { return memory_of(m_sides); }

private:
  static std::size_t all_rows(const Grid_shape& shape)
  {
    return shape.rows_before + shape.rows + shape.rows_after;
  }

  static void check_latitudes(const Grid_shape& shape)
  {
    constexpr double pole = 90, rounding = 1e-9;
    const double first = *shape.first_latitude;
    const double last = first - static_cast<double>(all_rows(shape)) * shape.cell_height;
    if(!(first <= pole + rounding && last >= -pole - rounding))
      reject("the grid extends from latitude " + text_of(first) + " to " + text_of(last) +
             "; latitudes must be from 90 to -90 degrees");
    constexpr double most = 360;
    if(!(shape.width() <= most * (1 + rounding)))
      reject("the grid extends over " + text_of(shape.width()) +
             " degrees of longitude; there must be at most 360");
    constexpr double tolerance = 0.01; // of a cell
    if(shape.is_periodic && !(shape.width() >= most - tolerance * shape.cell_width))
      reject("the grid is periodic, and extends over " + text_of(shape.width()) +
             " degrees of longitude; there must be 360");
  }

  static void check_ellipsoid(const Grid_ellipsoid& ellipsoid)
  {
    checked_positive(ellipsoid.equatorial_radius, "the equatorial radius");
    if(!(ellipsoid.flattening >= 0 && ellipsoid.flattening < 1))
      reject("the flattening is " + text_of(ellipsoid.flattening) +
             "; it must be from 0 to below 1");
  }

  // Returns the sides of a cell whose center is so many rows from where the first row begins: the
  // radii of curvature of the ellipsoid in both directions, times angles.
  static Sides sides_at(const Grid_shape& shape, const double rows)
  {
    const double flattening = shape.ellipsoid.flattening;
    const double eccentricity = flattening * (2 - flattening); // its square
    const double radians = std::acos(-1.) / 180;
    const double latitude = (*shape.first_latitude - rows * shape.cell_height) * radians;
    const double sine = std::sin(latitude);
    const double square = 1 - eccentricity * sine * sine;
    const double across = shape.ellipsoid.equatorial_radius / std::sqrt(square);
    return {shape.cell_width * radians * across * std::cos(latitude),
            shape.cell_height * radians * across * (1 - eccentricity) / square};
  }

  bool m_is_geographic = false;
  std::vector<Sides> m_sides; // by the sum of two rows of the whole grid, if they differ
  std::size_t m_first_sum = 0;
  Sides m_smallest{1, 1};
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_GRID_METRIC_H
