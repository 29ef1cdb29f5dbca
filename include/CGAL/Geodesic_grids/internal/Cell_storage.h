// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_CELL_STORAGE_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_CELL_STORAGE_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/internal/Grid_lines.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Where the values of cells are kept, row by row, so that a line finds them at the same offsets
 * from any cell. On a periodic grid, rows have margins as wide as lines reach, with copies of the
 * cells at the other end.
 */
class Cell_storage
{
public:
  // A line to a column half a turn away could be taken for the one round the other side.
  static constexpr std::size_t LEAST_COLUMNS_OF_PERIODIC_GRID =
      2 * static_cast<std::size_t>(Grid_lines::LARGEST_REACH) + 1;

  Cell_storage() = default;

  explicit Cell_storage(const Grid_shape& shape)
    : m_columns(shape.columns),
      m_margin(shape.is_periodic ? static_cast<std::size_t>(Grid_lines::LARGEST_REACH) : 0)
  {
  }

  // Returns the number of values from row to row.
  std::size_t stride() const { return m_columns + 2 * m_margin; }

  std::size_t place(const Grid_cell& cell) const
  {
    return cell.row * stride() + m_margin + cell.column;
  }

  // Returns the cell whose value, or a copy of it, is kept at a place.
  Grid_cell cell(const std::size_t place) const
  {
    const std::size_t column = place % stride() + m_columns - m_margin;
    return {column % m_columns, place / stride()};
  }

  // Returns values of cells as they are kept.
  std::vector<double> kept(std::vector<double> values) const
  {
    if(m_margin == 0)
      return values;
    std::vector<double> result;
    const std::size_t rows = values.size() / m_columns;
    result.reserve(rows * stride());
    for(std::size_t i = 0; i < rows * stride(); ++i)
    {
      const Grid_cell cell = this->cell(i);
      result.push_back(values[cell.row * m_columns + cell.column]);
    }
    return result;
  }

private:
  std::size_t m_columns = 0, m_margin = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_CELL_STORAGE_H
