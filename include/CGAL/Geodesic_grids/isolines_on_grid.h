// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_ISOLINES_ON_GRID_H
#define CGAL_GEODESIC_GRIDS_ISOLINES_ON_GRID_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/internal/Grid_isoline.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicGridsFunctions
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
 * \param shape the numbers of columns and rows, the size of a cell, and in `no_data` a value that
 *        counts as NaN. For costs, there must be none if it is that of friction and can be `0`, as
 *        sources cost `0`
 * \param values one value per cell, row by row, for example from
 *        `approximate_geodesic_distances_on_grid()`; squares with a corner that is infinite, NaN or
 *        `no_data` have no isolines
 * \param isovalue the isovalue; an infinite one has no isolines
 * \param polylines receives the polylines, in the unit of the sizes of cells; the last point of a
 *        closed polyline equals its first point. On a periodic grid, a polyline that leaves the
 * grid goes on beyond it, and one that goes round it ends there where it begins, one width farther
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
  const auto number = static_cast<std::size_t>(std::distance(std::begin(values), std::end(values)));
  if(number != shape.number_of_cells())
    internal::reject("there are " + std::to_string(number) + " values, and " +
                     std::to_string(shape.number_of_cells()) + " cells");
  if(std::isnan(isovalue))
    internal::reject("the isovalue is not a number");
  internal::Grid_isoline isoline(shape, isovalue);
  std::vector<double> row, next_row;
  auto value = std::begin(values);
  const std::optional<double> no_data =
      internal::no_data_of<std::decay_t<decltype(*value)>>(shape.no_data);
  for(std::size_t i = 0; i < shape.rows; ++i)
  {
    next_row.resize(shape.columns);
    for(double& v : next_row)
    {
      v = static_cast<double>(*value++);
      if(internal::is_no_data(no_data, v))
        v = std::numeric_limits<double>::quiet_NaN();
    }
    if(i > 0)
      isoline.add_squares(i - 1, row, next_row);
    row.swap(next_row);
  }
  return isoline.write(polylines);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_GRIDS_ISOLINES_ON_GRID_H
