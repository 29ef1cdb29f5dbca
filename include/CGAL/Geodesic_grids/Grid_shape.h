// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_GRID_SHAPE_H
#define CGAL_GEODESIC_GRIDS_GRID_SHAPE_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicGridsGrids
 *
 * A cell of a grid: its column and its row, counted from `0`.
 */
struct Grid_cell
{
  /// the column.
  std::size_t column = 0;
  /// the row.
  std::size_t row = 0;

  /// compares column and row.
  friend bool operator==(const Grid_cell& a, const Grid_cell& b)
  {
    return a.column == b.column && a.row == b.row;
  }
};

/*!
 * \ingroup PkgGeodesicGridsGrids
 *
 * A point of the plane of a grid. The cell `(0, 0)` has a corner at the origin, columns follow each
 * other along `x`, and rows along `y`.
 */
struct Grid_point
{
  /// the first coordinate.
  double x = 0;
  /// the second coordinate.
  double y = 0;
};

/*!
 * \ingroup PkgGeodesicGridsGrids
 *
 * The ellipsoid of revolution that latitudes of a geographic grid are of: WGS 84 by default.
 */
struct Grid_ellipsoid
{
  /// the radius of the equator, in the unit that lengths are to have.
  double equatorial_radius = 6378137;
  /// how much shorter the axis is, relatively: `0` for a sphere.
  double flattening = 1 / 298.257223563;
};

/*!
 * \ingroup PkgGeodesicGridsGrids
 *
 * The shape of a regular grid of rectangular cells. Values of cells are given row by row, the cells
 * of a row one after the other.
 */
struct Grid_shape
{
  /// the number of columns.
  std::size_t columns = 0;
  /// the number of rows.
  std::size_t rows = 0;
  /// the width of a cell: its extent along a row.
  double cell_width = 1;
  /// the height of a cell: its extent along a column.
  double cell_height = 1;
  /// the friction or height of cells that cannot be entered, besides an infinite friction; it can
  /// be NaN. It is rounded to the type of the values: -9999.9 stands for the nearest `float` if
  /// they are of this type.
  std::optional<double> no_data = {};
  /// the latitude, in degrees, of the side where the first row begins. If it is given, sizes of
  /// cells are in degrees of longitude and latitude, rows follow each other southward, and lengths
  /// are those on `ellipsoid`: in meters if it is the default.
  std::optional<double> first_latitude = {};
  /// the number of rows before the first one, if this is a part of a larger geographic grid.
  /// `first_latitude` is where that grid begins, and the graph has its arcs, to the last bit.
  std::size_t rows_before = 0;
  /// likewise the number of rows after the last one.
  std::size_t rows_after = 0;
  /// whether columns go round: the first one follows the last one, as on a raster of the whole
  /// Earth. There are at least 31 columns then, and no bound `epsilon`.
  bool is_periodic = false;
  /// what latitudes are of, if there are any.
  Grid_ellipsoid ellipsoid = {};

  /// returns the number of cells.
  std::size_t number_of_cells() const { return columns * rows; }

  /// returns where a cell is in the order of values.
  std::size_t index(const Grid_cell& cell) const { return cell.row * columns + cell.column; }

  /// returns the cell with this place in the order of values.
  Grid_cell cell(const std::size_t index) const { return {index % columns, index / columns}; }

  /// returns the extent of all columns: after it, those of a periodic grid begin again.
  double width() const { return static_cast<double>(columns) * cell_width; }

  /// returns the center of a cell.
  Grid_point center(const Grid_cell& cell) const
  {
    return {(static_cast<double>(cell.column) + 0.5) * cell_width,
            (static_cast<double>(cell.row) + 0.5) * cell_height};
  }
};

namespace internal {

inline void check_has_cells(const std::size_t columns, const std::size_t rows)
{
  if(columns == 0 || rows == 0)
    reject("the grid has no cells: " + std::to_string(columns) + " columns and " +
           std::to_string(rows) + " rows");
}

// Returns where the cell of a query is. Throws an error if it is not in the grid.
inline std::size_t checked_index(const Grid_shape& shape, const Grid_cell& cell, const char* role)
{
  if(cell.column >= shape.columns || cell.row >= shape.rows)
    reject(std::string(role) + " cell (" + std::to_string(cell.column) + ", " +
           std::to_string(cell.row) + ") does not exist: there are " +
           std::to_string(shape.columns) + " columns and " + std::to_string(shape.rows) + " rows");
  return shape.index(cell);
}

// Returns a value for no data as values of type `T` have it: 1e20 is no `float`.
template <typename T>
std::optional<double> no_data_of(const std::optional<double>& no_data)
{
  if constexpr(std::is_floating_point_v<T> && sizeof(T) < sizeof(double))
    if(no_data && std::isfinite(*no_data))
    {
      constexpr double largest = (std::numeric_limits<T>::max)(),
                       half_unit = largest * std::numeric_limits<T>::epsilon() / 4;
      if(std::abs(*no_data) >= largest + half_unit)
        return std::copysign(std::numeric_limits<double>::infinity(), *no_data);
      return static_cast<double>(static_cast<T>((std::clamp)(*no_data, -largest, largest)));
    }
  return no_data;
}

inline bool is_no_data(const std::optional<double>& no_data, const double value)
{
  return no_data && (value == *no_data || (std::isnan(value) && std::isnan(*no_data)));
}

// The value of a cell, in messages.
inline std::string
value_in_message(const char* const role, const double value, const Grid_cell cell)
{
  return std::string("the ") + role + " of cell (" + std::to_string(cell.column) + ", " +
         std::to_string(cell.row) + ") is " + text_of(value);
}

// Returns the friction of a cell, infinity if it cannot be entered. Throws an error if it is
// negative or not a number.
inline double checked_friction(const double friction, const Grid_cell cell)
{
  if(!(friction >= 0))
    reject(value_in_message("friction", friction, cell) +
           "; it must be a number that is not negative, infinity, or no_data");
  return friction;
}

} // namespace internal
} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_GRIDS_GRID_SHAPE_H
