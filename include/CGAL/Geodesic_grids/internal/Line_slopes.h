// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_LINE_SLOPES_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_LINE_SLOPES_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Geodesic_costs/internal/Slope_limit.h>
#include <CGAL/Geodesic_grids/internal/Grid_lines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Whether lines keep a limit of the slope everywhere.
 *
 * The surface between the centers of four cells is two triangles, by either of the two diagonals. A
 * line has to keep the limit on both surfaces, in each triangle that it crosses. So it does not
 * slip through between two high cells that touch at a corner, and on a plane both are the plane.
 */
class Line_slopes
{
public:
  // no limit
  Line_slopes() = default;

  Line_slopes(const Grid_lines& lines, const std::ptrdiff_t stride, const Slope_limit limit)
    : m_limit(limit), m_stride(stride)
  {
    if(limit.is_none())
      return;
    for(const Grid_lines::Line& line : lines.lines())
      for(const int diagonal : {1, -1})
      {
        m_first.push_back(m_cuts.size());
        add_cuts(line, diagonal);
      }
    m_first.push_back(m_cuts.size());
  }

  bool are_limited() const { return !m_first.empty(); }

  // Returns whether a line, by its position among all, keeps the limit. `height` points to that of
  // its first cell, and `scale` is its length relative to that of the table.
  bool allow(const std::size_t line, const double* const height, const double scale) const
  {
    return allow_all(m_first[2 * line], m_first[2 * line + 1], height, scale) &&
           allow_all(m_first[2 * line + 1], m_first[2 * line + 2], height, scale);
  }

  std::size_t memory() const { return memory_of(m_first, m_cuts); }

private:
  // Where a line enters another triangle, or ends: between two centers, at the share of the second.
  struct Cut
  {
    double at; // relative to the length of the line
    std::ptrdiff_t first, second;
    double share;
    double length; // of the line from the cut before
  };

  bool allow_all(const std::size_t first,
                 const std::size_t beyond,
                 const double* const height,
                 const double scale) const
  {
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    double last = *height;
    for(std::size_t i = first; i < beyond; ++i)
    {
      const Cut& cut = m_cuts[i];
      const double a = height[cut.first], b = height[cut.second];
      const double next = a + cut.share * (b - a);
      const double error =
          rounding * (std::max)({std::abs(a), std::abs(b), std::abs(last)}); // of differences
      if(!m_limit.allows(next - last, scale * cut.length, error))
        return false;
      last = next;
    }
    return true;
  }

  // Adds the cuts of a line by columns, rows, and one of the diagonals of each four centers: for
  // `1`, the one in the quadrant of the line.
  void add_cuts(const Grid_lines::Line& line, const int diagonal)
  {
    const std::ptrdiff_t columns = std::abs(line.columns), rows = std::abs(line.rows);
    const std::size_t first = m_cuts.size();
    for(std::ptrdiff_t i = 1; i < columns; ++i)
      add_cut(line, i, columns, 0, 1);
    for(std::ptrdiff_t j = 1; j < rows; ++j)
      add_cut(line, j, rows, 1, 0);
    // on a diagonal, columns minus rows, or their sum, is an integer
    const std::ptrdiff_t number = std::abs(columns - diagonal * rows);
    for(std::ptrdiff_t k = 1; k < number; ++k)
      add_cut(line, k, number, 1, diagonal);
    const std::ptrdiff_t last = offset(line, columns, rows);
    m_cuts.push_back({1, last, last, 0, 0});
    const auto begin = m_cuts.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, m_cuts.end(), [](const Cut& a, const Cut& b) { return a.at < b.at; });
    double before = 0;
    for(auto cut = begin; cut != m_cuts.end(); ++cut)
    {
      cut->length = (cut->at - before) * line.length;
      before = cut->at;
    }
  }

  // Adds the cut at `i / number` of a line, between two centers that are so many columns and rows
  // apart. There the line is at no other column, row or diagonal, as it passes no center.
  void add_cut(const Grid_lines::Line& line,
               const std::ptrdiff_t i,
               const std::ptrdiff_t number,
               const std::ptrdiff_t to_column,
               const std::ptrdiff_t to_row)
  {
    const std::ptrdiff_t x = i * std::abs(line.columns), y = i * std::abs(line.rows);
    const std::ptrdiff_t column = x / number, row = y / number + (to_row < 0 ? 1 : 0);
    const std::ptrdiff_t rest = to_column != 0 ? x % number : y % number;
    const auto part = [&](const std::ptrdiff_t n) {
      return static_cast<double>(n) / static_cast<double>(number);
    };
    m_cuts.push_back({part(i), offset(line, column, row),
                      offset(line, column + to_column, row + to_row), part(rest), 0});
  }

  std::ptrdiff_t offset(const Grid_lines::Line& line,
                        const std::ptrdiff_t columns,
                        const std::ptrdiff_t rows) const
  {
    return (line.rows < 0 ? -rows : rows) * m_stride + (line.columns < 0 ? -columns : columns);
  }

  Slope_limit m_limit;
  std::ptrdiff_t m_stride = 0;      // from row to row
  std::vector<std::size_t> m_first; // of the cuts of each line, for both diagonals, and beyond
  std::vector<Cut> m_cuts;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_LINE_SLOPES_H
