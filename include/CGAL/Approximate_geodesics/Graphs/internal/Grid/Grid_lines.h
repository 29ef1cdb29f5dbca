// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRID_GRID_LINES_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRID_GRID_LINES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Graphs/Grid_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Straight lines from the center of a cell to those of other cells, the same for all cells.
 *
 * Lines to the next cells of a row and of a column are halved by the lines to the sum of both
 * vectors, again and again, until the angle between neighbors is small. (This is the Stern-Brocot
 * tree.) Two neighboring vectors `u` and `v` have the determinant 1, so every vector between them
 * is a sum `i u + j v` with integers that are not negative. Its length as a path along lines is at
 * most 1 / cos(a / 2) times its own, where `a` is the angle of `u` and `v`. All three are in one
 * quadrant, so the path stays in the rectangle that its ends span.
 */
class Grid_lines
{
public:
  // the largest error on a grid of equal cells, unless cells are far longer than wide
  static constexpr double LARGEST_ERROR = 0.003;

  // lines to cells that are farther away, in columns or rows, are not used
  static constexpr std::ptrdiff_t LARGEST_REACH = 15;

  // a part of a line: the place of a cell relative to the first one, and the length within it
  struct Part
  {
    std::ptrdiff_t offset;
    double length;
  };

  struct Line
  {
    std::ptrdiff_t columns, rows; // to the last cell
    double length;
    std::size_t first_part, beyond_part;
    bool passes_corner;                    // of four cells, between its two middle parts
    std::array<std::ptrdiff_t, 2> offsets; // of the two cells beside this corner
  };

  Grid_lines() = default;

  explicit Grid_lines(const Grid_shape& shape)
    : m_width(shape.cell_width),
      m_height(shape.cell_height),
      m_stride(static_cast<std::ptrdiff_t>(shape.columns))
  {
    const Vector along_row{1, 0}, along_column{0, 1};
    add_to_quadrants(along_row);
    add_between(along_row, along_column);
    add_to_quadrants(along_column);
  }

  const std::vector<Line>& lines() const { return m_lines; }

  // Returns the cost of a line from `cell`, a pointer to its friction; infinity if it is blocked.
  double cost(const Line& line, const double* const cell) const
  {
    if(line.passes_corner && (std::min)(cell[line.offsets[0]], cell[line.offsets[1]]) == infinity)
      return infinity;
    double result = 0;
    for(std::size_t i = line.first_part; i < line.beyond_part; ++i)
      result += m_parts[i].length * cell[m_parts[i].offset];
    return result;
  }

  // Returns the largest relative error on a grid of equal cells.
  double error_on_equal_cells() const { return m_error; }

  std::size_t memory() const { return memory_of(m_lines, m_parts); }

private:
  struct Vector
  {
    std::ptrdiff_t columns, rows;
  };

  double angle(const Vector& v) const
  {
    return std::atan2(static_cast<double>(v.rows) * m_height,
                      static_cast<double>(v.columns) * m_width);
  }

  // Adds lines between two neighbors.
  void add_between(const Vector& first, const Vector& last)
  {
    const double error = 1 / std::cos((angle(last) - angle(first)) / 2) - 1;
    const Vector middle{first.columns + last.columns, first.rows + last.rows};
    if(error <= LARGEST_ERROR || (std::max)(middle.columns, middle.rows) > LARGEST_REACH)
    {
      m_error = (std::max)(m_error, error);
      return;
    }
    add_between(first, middle);
    add_to_quadrants(middle);
    add_between(middle, last);
  }

  void add_to_quadrants(const Vector& v)
  {
    add(v, 1, 1);
    add(v, -1, -1);
    if(v.columns != 0 && v.rows != 0)
    {
      add(v, -1, 1);
      add(v, 1, -1);
    }
  }

  // Adds the line of `v` with these signs. It enters another column at `(i + 1/2) / v.columns` of
  // its length, and another row at `(j + 1/2) / v.rows`.
  void add(const Vector& v, const std::ptrdiff_t x_sign, const std::ptrdiff_t y_sign)
  {
    const double length = std::hypot(static_cast<double>(v.columns) * m_width,
                                     static_cast<double>(v.rows) * m_height);
    Line line{x_sign * v.columns, y_sign * v.rows, length, m_parts.size(), 0, false, {0, 0}};
    double last = 0;
    const auto offset = [&](const std::ptrdiff_t i, const std::ptrdiff_t j) {
      return y_sign * j * m_stride + x_sign * i;
    };
    const auto end_part = [&](const std::ptrdiff_t i, const std::ptrdiff_t j, const double at) {
      m_parts.push_back({offset(i, j), (at - last) * length});
      last = at;
    };
    std::ptrdiff_t i = 0, j = 0;
    while(i < v.columns || j < v.rows)
    {
      const std::ptrdiff_t lead = (2 * i + 1) * v.rows - (2 * j + 1) * v.columns;
      end_part(i, j,
               lead <= 0 ? (static_cast<double>(i) + 0.5) / static_cast<double>(v.columns)
                         : (static_cast<double>(j) + 0.5) / static_cast<double>(v.rows));
      if(lead == 0)
      {
        line.passes_corner = true;
        line.offsets = {offset(i + 1, j), offset(i, j + 1)};
      }
      i += lead <= 0 ? 1 : 0;
      j += lead >= 0 ? 1 : 0;
    }
    end_part(i, j, 1);
    line.beyond_part = m_parts.size();
    m_lines.push_back(line);
  }

  double m_width = 1, m_height = 1;
  std::ptrdiff_t m_stride = 0; // from row to row
  std::vector<Line> m_lines;
  std::vector<Part> m_parts;
  double m_error = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_GRID_GRID_LINES_H
