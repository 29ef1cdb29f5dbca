// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_GRID_LINES_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_GRID_LINES_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Geodesic_grids/internal/Grid_metric.h>

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
 *
 * On heights, lines have profiles. A line is cut where it crosses rows and columns of centers;
 * heights there are interpolated between two centers, and slopes between cuts are constant.
 */
class Grid_lines
{
public:
  // the largest error on a grid of equal cells, unless cells are far longer than wide
  static constexpr double LARGEST_ERROR = 0.003;
  // where costs depend on slopes, so that there are directions of about any slope
  static constexpr double LARGEST_ERROR_OF_PROFILES = 0.0015;

  // lines to cells that are farther away, in columns or rows, are not used
  static constexpr std::ptrdiff_t LARGEST_REACH = 15;

  // a part of a line: the place of a cell relative to the first one, and the length within it
  struct Part
  {
    std::ptrdiff_t offset;
    double length;
  };

  // a piece of a line whose slope is constant: where heights are interpolated for its end
  struct Piece
  {
    std::ptrdiff_t first, second; // places of cells
    double share;                 // of the second one
    double length, inverse;       // the length, and 1 / length
    std::size_t beyond_part;      // its parts begin where those of the piece before it end
  };

  struct Line
  {
    std::ptrdiff_t columns, rows; // to the last cell
    double length;
    std::size_t first_part, beyond_part;
    bool passes_corner;                    // of four cells, between its two middle parts
    std::array<std::ptrdiff_t, 2> offsets; // of the two cells beside this corner
    std::size_t first_piece, beyond_piece; // if there are profiles
  };

  Grid_lines() = default;

  // `stride` is the number of values from row to row.
  Grid_lines(const std::size_t stride, const Grid_metric& metric, const bool has_profiles)
    : m_has_profiles(has_profiles),
      m_largest_error(has_profiles ? LARGEST_ERROR_OF_PROFILES : LARGEST_ERROR),
      m_sides(metric.middle()),
      m_stride(static_cast<std::ptrdiff_t>(stride))
  {
    for(const Grid_metric::Sides& sides : metric.all())
    {
      const double ratio = sides.width / sides.height;
      m_smallest_ratio = (std::min)(m_smallest_ratio, ratio);
      m_largest_ratio = (std::max)(m_largest_ratio, ratio);
    }
    const Vector along_row{1, 0}, along_column{0, 1};
    add_to_quadrants(along_row);
    add_between(along_row, along_column);
    add_to_quadrants(along_column);
  }

  const std::vector<Line>& lines() const { return m_lines; }

  const std::vector<Part>& parts() const { return m_parts; }
  const std::vector<Piece>& pieces() const { return m_pieces; }

  // Whether a line passes between two cells that touch at a corner, both of which are blocked.
  static bool is_blocked_at_corner(const Line& line, const double* const cell)
  {
    return line.passes_corner &&
           (std::min)(cell[line.offsets[0]], cell[line.offsets[1]]) == infinity;
  }

  // Returns the length of a line between rows where cells have these sides, relative to its own
  // one.
  static double scale(const Line& line, const Grid_metric::Sides& sides)
  {
    const double x = static_cast<double>(line.columns) * sides.width,
                 y = static_cast<double>(line.rows) * sides.height;
    return std::sqrt(x * x + y * y) / line.length;
  }

  // Returns the cost of a line from `cell`, a pointer to its friction; infinity if it is blocked.
  double cost(const Line& line, const double* const cell) const
  {
    if(is_blocked_at_corner(line, cell))
      return infinity;
    double result = 0;
    for(std::size_t i = line.first_part; i < line.beyond_part; ++i)
      result += m_parts[i].length * cell[m_parts[i].offset];
    return result;
  }

  // Returns the largest relative error on a grid of equal cells.
  double error_on_equal_cells() const { return m_error; }

  std::size_t memory() const { return memory_of(m_lines, m_parts, m_pieces); }

private:
  struct Vector
  {
    std::ptrdiff_t columns, rows;
  };

  // Returns the largest angle between two neighbors. The tangent, r / (r^2 p p' + q q') for vectors
  // (p, q) and (p', q') and cells of the width r and the height 1, has one maximum.
  double angle(const Vector& first, const Vector& last) const
  {
    const auto rows = static_cast<double>(first.rows * last.rows),
               columns = static_cast<double>(first.columns * last.columns);
    const double ratio = columns > 0 ? (std::clamp)(std::sqrt(rows / columns), m_smallest_ratio,
                                                    m_largest_ratio)
                                     : m_largest_ratio; // or any, if the angle is right
    const auto from_row = [&](const Vector& v) {
      return std::atan2(static_cast<double>(v.rows), static_cast<double>(v.columns) * ratio);
    };
    return from_row(last) - from_row(first);
  }

  // Adds lines between two neighbors.
  void add_between(const Vector& first, const Vector& last)
  {
    const double error = 1 / std::cos(angle(first, last) / 2) - 1;
    const Vector middle{first.columns + last.columns, first.rows + last.rows};
    if(error <= m_largest_error || (std::max)(middle.columns, middle.rows) > LARGEST_REACH)
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
    const double length = std::hypot(static_cast<double>(v.columns) * m_sides.width,
                                     static_cast<double>(v.rows) * m_sides.height);
    Line line{x_sign * v.columns, y_sign * v.rows, length, m_parts.size(), 0, false, {0, 0}, 0, 0};
    const auto offset = [&](const std::ptrdiff_t i, const std::ptrdiff_t j) {
      return y_sign * j * m_stride + x_sign * i;
    };
    std::vector<End> ends;
    ends.reserve(static_cast<std::size_t>(v.columns + v.rows + 1));
    std::ptrdiff_t i = 0, j = 0;
    while(i < v.columns || j < v.rows)
    {
      const std::ptrdiff_t lead = (2 * i + 1) * v.rows - (2 * j + 1) * v.columns;
      const double at = lead <= 0 ? (static_cast<double>(i) + 0.5) / static_cast<double>(v.columns)
                                  : (static_cast<double>(j) + 0.5) / static_cast<double>(v.rows);
      ends.push_back({offset(i, j), at});
      if(lead == 0)
      {
        line.passes_corner = true;
        line.offsets = {offset(i + 1, j), offset(i, j + 1)};
      }
      i += lead <= 0 ? 1 : 0;
      j += lead >= 0 ? 1 : 0;
    }
    ends.push_back({offset(i, j), 1});
    line.first_piece = m_pieces.size();
    add_parts(length, ends, m_has_profiles ? cuts(v, offset) : std::vector<Cut>());
    line.beyond_piece = m_pieces.size();
    line.beyond_part = m_parts.size();
    m_lines.push_back(line);
  }

  // where a line crosses a row or a column of centers
  struct Cut
  {
    double at; // relative to its length
    std::ptrdiff_t first, second;
    double share;
  };

  // where a line leaves a cell
  struct End
  {
    std::ptrdiff_t offset;
    double at;
  };

  template <typename Offset>
  static std::vector<Cut> cuts(const Vector& v, const Offset& offset)
  {
    std::vector<Cut> result;
    result.reserve(static_cast<std::size_t>(v.columns + v.rows + 1));
    const auto add_cut = [&](const double at, const std::ptrdiff_t first,
                             const std::ptrdiff_t second, const double share) {
      result.push_back({at, first, second, share});
    };
    const auto part = [](const std::ptrdiff_t i, const std::ptrdiff_t n) {
      return static_cast<double>(i) / static_cast<double>(n);
    };
    for(std::ptrdiff_t i = 1; i < v.columns; ++i)
    {
      const std::ptrdiff_t j = i * v.rows / v.columns;
      add_cut(part(i, v.columns), offset(i, j), offset(i, j + 1),
              part(i * v.rows % v.columns, v.columns));
    }
    for(std::ptrdiff_t j = 1; j < v.rows; ++j)
    {
      const std::ptrdiff_t i = j * v.columns / v.rows;
      add_cut(part(j, v.rows), offset(i, j), offset(i + 1, j),
              part(j * v.columns % v.rows, v.rows));
    }
    const std::ptrdiff_t last = offset(v.columns, v.rows);
    add_cut(1, last, last, 0);
    std::sort(result.begin(), result.end(), [](const Cut& a, const Cut& b) { return a.at < b.at; });
    return result;
  }

  // Adds parts that end where the line enters another cell, or where it is cut.
  void add_parts(const double length, const std::vector<End>& ends, const std::vector<Cut>& cuts)
  {
    double last = 0, last_cut = 0;
    auto cut = cuts.begin();
    const auto add_part = [&](const std::ptrdiff_t offset, const double at) {
      if(at > last)
        m_parts.push_back({offset, (at - last) * length});
      last = at;
    };
    for(const End& end : ends)
    {
      for(; cut != cuts.end() && cut->at <= end.at; ++cut)
      {
        add_part(end.offset, cut->at);
        const double extent = (cut->at - last_cut) * length;
        m_pieces.push_back(
            {cut->first, cut->second, cut->share, extent, 1 / extent, m_parts.size()});
        last_cut = cut->at;
      }
      add_part(end.offset, end.at);
    }
  }

  bool m_has_profiles = false;
  double m_largest_error = LARGEST_ERROR;
  Grid_metric::Sides m_sides{1, 1};
  double m_smallest_ratio = infinity, m_largest_ratio = 0; // of widths to heights
  std::ptrdiff_t m_stride = 0;                             // from row to row
  std::vector<Line> m_lines;
  std::vector<Part> m_parts;
  std::vector<Piece> m_pieces;
  double m_error = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_GRID_LINES_H
