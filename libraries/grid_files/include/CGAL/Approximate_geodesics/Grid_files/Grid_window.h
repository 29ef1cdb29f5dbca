// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_GRID_WINDOW_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_GRID_WINDOW_H

#include <CGAL/license/Approximate_geodesics.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesGridFiles
 *
 * A rectangular part of the cells of a grid.
 */
struct Grid_window
{
  /// the first column.
  std::size_t first_column = 0;
  /// the first row.
  std::size_t first_row = 0;
  /// the number of columns.
  std::size_t columns = 0;
  /// the number of rows.
  std::size_t rows = 0;
};

/*!
 * \ingroup PkgGeodesicLibrariesGridFiles
 *
 * A node of the graph of a grid: its column and row, which can be one more than those of cells, and
 * its number there: `0` for the center of the cell.
 */
struct Grid_place
{
  /// the column.
  std::size_t column = 0;
  /// the row.
  std::size_t row = 0;
  /// the number of the node there.
  std::size_t slot = 0;

  /// compares all three.
  friend bool operator==(const Grid_place& a, const Grid_place& b)
  {
    return a.column == b.column && a.row == b.row && a.slot == b.slot;
  }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_GRID_WINDOW_H
