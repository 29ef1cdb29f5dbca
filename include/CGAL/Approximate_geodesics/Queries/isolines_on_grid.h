// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_ISOLINES_ON_GRID_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_ISOLINES_ON_GRID_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Graphs/Grid_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

/*
 * The isoline of a grid that separates centers below a value from the others, by marching squares.
 * The sides of squares join the centers of neighboring cells. A center with exactly this value
 * counts as above. A square has a segment for each side that ascends counterclockwise, from there
 * to one that descends; so each point of a side is the start of at most one segment, and the end of
 * at most one.
 */
class Grid_isoline
{
public:
  using Polyline = std::vector<Grid_point>;

  Grid_isoline(const Grid_shape& shape, const std::vector<double>& values, const double isovalue)
    : m_shape(shape), m_values(values), m_isovalue(isovalue)
  {
    for(std::size_t row = 0; row + 1 < shape.rows; ++row)
      for(std::size_t column = 0; column + 1 < shape.columns; ++column)
        add_square({column, row});
    std::sort(m_segments.begin(), m_segments.end());
  }

  template <typename OutputIterator>
  OutputIterator write(OutputIterator polylines)
  {
    std::vector<std::size_t> ends;
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
  // between two sides, which have the number `2 i` for the side from cell `i` along the row, and
  // `2 i + 1` for that along the column
  struct Segment
  {
    std::size_t start, end;
    friend bool operator<(const Segment& a, const Segment& b) { return a.start < b.start; }
  };

  void add_square(const Grid_cell& cell)
  {
    const std::size_t i = m_shape.index(cell), below = i + m_shape.columns;
    const std::array<std::size_t, 4> corners{i, i + 1, below + 1, below},
        sides{2 * i, 2 * (i + 1) + 1, 2 * below, 2 * i + 1};
    std::array<bool, 4> is_above{};
    double sum = 0;
    for(std::size_t k = 0; k < 4; ++k)
    {
      const double value = m_values[corners[k]];
      if(!std::isfinite(value))
        return;
      is_above[k] = value >= m_isovalue;
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
        m_segments.push_back({sides[k], sides[last % 4]});
      }
  }

  // Returns the polyline from a segment to its end, or back to its start if it is closed.
  Polyline follow(std::size_t i, std::vector<bool>& is_passed) const
  {
    Polyline result(1, point(m_segments[i].start));
    while(i < m_segments.size() && !is_passed[i])
    {
      is_passed[i] = true;
      const std::size_t end = m_segments[i].end;
      const Grid_point p = point(end);
      if(p.x != result.back().x || p.y != result.back().y) // points may coincide at a center
        result.push_back(p);
      const auto next = std::lower_bound(m_segments.begin(), m_segments.end(), Segment{end, 0});
      i = next != m_segments.end() && next->start == end
              ? static_cast<std::size_t>(next - m_segments.begin())
              : m_segments.size();
    }
    return result;
  }

  // Returns where the values on a side are equal to the isovalue.
  Grid_point point(const std::size_t side) const
  {
    const std::size_t first = side / 2, second = first + (side % 2 == 0 ? 1 : m_shape.columns);
    const Grid_point p = m_shape.center(m_shape.cell(first)),
                     q = m_shape.center(m_shape.cell(second));
    const bool ascends = m_values[first] < m_isovalue;
    const Grid_point &low = ascends ? p : q, &high = ascends ? q : p;
    const double a = m_values[ascends ? first : second], b = m_values[ascends ? second : first];
    if(b == m_isovalue)
      return high;
    const double scale = std::isfinite(b - a) ? 1 : 0.5; // differences may overflow
    const double t = (m_isovalue * scale - a * scale) / (b * scale - a * scale);
    return {low.x + t * (high.x - low.x), low.y + t * (high.y - low.y)};
  }

  const Grid_shape& m_shape;
  const std::vector<double>& m_values;
  double m_isovalue;
  std::vector<Segment> m_segments; // by their starts
};

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsQueries
 *
 * computes the isolines of the values of the cells of a grid at one isovalue, by marching squares:
 * of costs, for lines of equal time, or of heights.
 *
 * Values are those of the centers, and are linear on the sides of the squares between four of them.
 * The part with smaller values is to the left of an isoline, where x is to the right and y is
 * upward: isolines of costs run counterclockwise around sources. They consist of polylines, which
 * are closed or end at the border of the grid, or next to a cell without a finite value. Where two
 * opposite corners of a square are above, they are joined if the mean of all four is.
 *
 * \tparam ValueRange a model of `ConstRange` whose value type converts to `double`
 * \tparam OutputIterator a model of `OutputIterator` that takes `std::vector<Grid_point>`
 *
 * \param shape the numbers of columns and rows, the size of a cell, and a value that counts as NaN
 * \param values one value per cell, row by row, for example from
 *        `approximate_geodesic_distances_on_grid()`; squares with a corner that is infinite, NaN or
 *        `no_data` have no isolines
 * \param isovalue the isovalue; an infinite one has no isolines
 * \param polylines receives the polylines, in the unit of the sizes of cells; the last point of a
 *        closed polyline equals its first point
 *
 * \return the output iterator, after the last polyline.
 *
 * \throws std::invalid_argument if there are not as many values as cells, or the isovalue is NaN.
 *
 * Run time is \cgalBigO{n + k \log k} for `n` cells and `k` segments.
 *
 * \sa `isolines()`
 */
template <typename ValueRange, typename OutputIterator>
OutputIterator isolines_on_grid(const Grid_shape& shape,
                                const ValueRange& values,
                                const double isovalue,
                                OutputIterator polylines)
{
  std::vector<double> numbers;
  for(const auto& value : values)
  {
    const double number = static_cast<double>(value);
    numbers.push_back(internal::is_no_data(shape, number) ? std::nan("") : number);
  }
  if(numbers.size() != shape.number_of_cells())
    internal::reject("there are " + std::to_string(numbers.size()) + " values, and " +
                     std::to_string(shape.number_of_cells()) + " cells");
  if(std::isnan(isovalue))
    internal::reject("the isovalue is not a number");
  return internal::Grid_isoline(shape, numbers, isovalue).write(polylines);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_ISOLINES_ON_GRID_H
