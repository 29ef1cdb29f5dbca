// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_GRID_ISOLINE_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_GRID_ISOLINE_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Geodesic_grids/Grid_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The isoline of a grid that separates centers below a value from the others, by marching squares.
 * The sides of squares join the centers of neighboring cells. A center with exactly this value
 * counts as above. A square has a segment for each side that ascends counterclockwise, from there
 * to one that descends; so each point of a side is the start of at most one segment, and the end of
 * at most one.
 *
 * It takes the values of two rows at a time, as a grid need not fit in memory.
 */
class Grid_isoline
{
public:
  using Polyline = std::vector<Grid_point>;

  Grid_isoline(const Grid_shape& shape, const double isovalue)
    : m_shape(shape), m_isovalue(isovalue)
  {
  }

  // Adds the squares between a row and the next one, which have these values.
  void add_squares(const std::size_t row,
                   const std::vector<double>& values,
                   const std::vector<double>& next_values)
  {
    const std::size_t last = m_shape.columns - (m_shape.is_periodic ? 0 : 1);
    for(std::size_t i = 0; i < last; ++i)
    {
      const std::size_t next = (i + 1) % m_shape.columns;
      add_square({i, row}, {values[i], values[next], next_values[next], next_values[i]});
    }
  }

  // Writes the polylines when all squares have been added.
  template <typename OutputIterator>
  OutputIterator write(OutputIterator polylines)
  {
    std::sort(m_segments.begin(), m_segments.end());
    std::vector<Side> ends;
    for(const Segment& segment : m_segments)
      ends.push_back(segment.end);
    std::sort(ends.begin(), ends.end());
    std::vector<bool> is_passed(m_segments.size());
    for(const bool from_end : {true, false}) // then closed polylines remain
      for(std::size_t i = 0; i < m_segments.size(); ++i)
        if(!is_passed[i] &&
           !(from_end && std::binary_search(ends.begin(), ends.end(), m_segments[i].start)))
        {
          Polyline polyline = follow(i, is_passed);
          if(polyline.size() > 1) // a single point if only one center is above
            *polylines++ = std::move(polyline);
        }
    return polylines;
  }

private:
  // `2 i` is the side from cell `i` along the row, and `2 i + 1` that along the column.
  using Side = std::uint64_t;
  using Corners = std::array<double, 4>; // values, counterclockwise

  struct Segment
  {
    Side start, end;
    Grid_point start_point, end_point;
    friend bool operator<(const Segment& a, const Segment& b) { return a.start < b.start; }
  };

  void add_square(const Grid_cell& cell, const Corners& values)
  {
    std::array<bool, 4> is_above{};
    for(std::size_t k = 0; k < 4; ++k)
      is_above[k] = values[k] >= m_isovalue;
    if(is_above[0] == is_above[1] && is_above[1] == is_above[2] && is_above[2] == is_above[3])
      return; // as most squares
    double sum = 0;
    for(const double value : values)
    {
      if(!std::isfinite(value))
        return;
      sum += value / 4;
    }
    // Where opposite corners are below, they are on the same side if the middle is, too.
    const bool joins_above = sum >= m_isovalue;
    for(std::size_t k = 0; k < 4; ++k)
      if(!is_above[k] && is_above[(k + 1) % 4])
      {
        const bool is_saddle = !is_above[(k + 2) % 4] && is_above[(k + 3) % 4];
        std::size_t last = k + 1; // the side that descends
        if(is_saddle && joins_above)
          last = k + 3;
        else
          while(is_above[(last + 1) % 4])
            ++last;
        add_segment(cell, values, k, last % 4);
      }
  }

  void add_segment(const Grid_cell& cell,
                   const Corners& values,
                   const std::size_t first,
                   const std::size_t last)
  {
    const Side first_of_row = static_cast<Side>(cell.row) * m_shape.columns;
    const Side i = first_of_row + cell.column,
               next = first_of_row + (cell.column + 1) % m_shape.columns;
    const std::array<Side, 4> sides{2 * i, 2 * next + 1, 2 * (i + m_shape.columns), 2 * i + 1};
    m_segments.push_back({sides[first], sides[last], point(cell, values, first, (first + 1) % 4),
                          point(cell, values, (last + 1) % 4, last)});
  }

  // Returns where the values on a side are equal to the isovalue, from the corner below it to the
  // one above it: so both squares of the side find the same point.
  Grid_point point(const Grid_cell& cell,
                   const Corners& values,
                   const std::size_t below,
                   const std::size_t above) const
  {
    const auto center = [&](const std::size_t corner) {
      return m_shape.center(
          {cell.column + (corner == 1 || corner == 2 ? 1 : 0), cell.row + (corner >= 2 ? 1 : 0)});
    };
    const double a = values[below], b = values[above];
    const Grid_point low = center(below), high = center(above);
    if(b == m_isovalue)
      return high;
    const double scale = std::isfinite(b - a) ? 1 : 0.5; // differences may overflow
    const double t = (m_isovalue * scale - a * scale) / (b * scale - a * scale);
    return {low.x + t * (high.x - low.x), low.y + t * (high.y - low.y)};
  }

  // Returns the polyline from a segment to its end, or back to its start if it is closed. On a
  // periodic grid, it goes on beyond the last column.
  Polyline follow(std::size_t i, std::vector<bool>& is_passed) const
  {
    Polyline result(1, m_segments[i].start_point);
    while(i < m_segments.size() && !is_passed[i])
    {
      is_passed[i] = true;
      const Segment& segment = m_segments[i];
      const double turns =
          m_shape.is_periodic
              ? std::round((result.back().x - segment.start_point.x) / m_shape.width())
              : 0;
      const Grid_point p{segment.end_point.x + turns * m_shape.width(), segment.end_point.y};
      if(p.x != result.back().x || p.y != result.back().y) // points may coincide at a center
        result.push_back(p);
      const auto next =
          std::lower_bound(m_segments.begin(), m_segments.end(), Segment{segment.end, 0, {}, {}});
      i = next != m_segments.end() && next->start == segment.end
              ? static_cast<std::size_t>(next - m_segments.begin())
              : m_segments.size();
    }
    return result;
  }

  Grid_shape m_shape;
  double m_isovalue;
  std::vector<Segment> m_segments;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_GRID_ISOLINE_H
