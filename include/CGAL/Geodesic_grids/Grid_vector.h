// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_GRID_VECTOR_H
#define CGAL_GEODESIC_GRIDS_GRID_VECTOR_H

#include <CGAL/license/Geodesic_grids.h>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicGridsGrids
 *
 * A vector in the space of a grid: a direction that a cost function is called with, or a wind. It
 * has those operations of a `%Vector_3` that cost functions need.
 */
class Grid_vector
{
public:
  /// constructs the zero vector.
  Grid_vector() = default;

  /// constructs a vector.
  Grid_vector(const double x, const double y, const double z = 0) : m_x(x), m_y(y), m_z(z) {}

  /// returns the extent along rows: toward the next column.
  double x() const { return m_x; }
  /// returns the extent along columns: toward the next row.
  double y() const { return m_y; }
  /// returns the extent upward.
  double z() const { return m_z; }

  /// returns the opposite vector.
  Grid_vector operator-() const { return {-m_x, -m_y, -m_z}; }

  /// returns the scalar product.
  friend double operator*(const Grid_vector& a, const Grid_vector& b)
  {
    return a.m_x * b.m_x + a.m_y * b.m_y + a.m_z * b.m_z;
  }

private:
  double m_x = 0, m_y = 0, m_z = 0;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_GRIDS_GRID_VECTOR_H
