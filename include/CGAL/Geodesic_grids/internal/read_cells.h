// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_READ_CELLS_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_READ_CELLS_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/Grid_vector.h>
#include <CGAL/Geodesic_grids/internal/Cell_storage.h>
#include <CGAL/Geodesic_grids/internal/Line_costs.h>
#include <CGAL/Geodesic_grids/internal/Slope_costs.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The values of the cells of a grid, read and checked.

namespace CGAL::Approximate_geodesics::internal {

// Returns `check(value, cell)` for all values of a range.
template <typename Range, typename Check>
std::vector<double>
read_cells(const Grid_shape& shape, const Range& range, const char* const role, const Check& check)
{
  const auto number = static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
  if(number != shape.number_of_cells()) // before memory is allocated for a wrong shape
    reject("there are " + std::to_string(number) + " values of " + role + ", and " +
           std::to_string(shape.number_of_cells()) + " cells");
  std::vector<double> result;
  result.reserve(number);
  for(const auto& value : range)
  {
    constexpr std::size_t cells_between_checks = 4096;
    if(result.size() % cells_between_checks == 0)
      check_for_interruption(result.size(), number);
    result.push_back(check(CGAL::to_double(value), shape.cell(result.size())));
  }
  return result;
}

// Returns what stands for no data in a range.
template <typename Range>
std::optional<double> no_data_in(const Range& range, const Grid_shape& shape)
{
  return no_data_of<std::decay_t<decltype(*std::begin(range))>>(shape.no_data);
}

// Friction is a range of numbers, or one number, which is not compared with `no_data`: this may be
// a height. Returns infinity for cells that cannot be entered.
template <typename FrictionRange>
std::vector<double> read_friction(const Grid_shape& shape, const FrictionRange& friction)
{
  if constexpr(std::is_convertible_v<const FrictionRange&, double>)
    return std::vector<double>(shape.number_of_cells(), checked_friction(friction, {}));
  else
  {
    const std::optional<double> no_data = no_data_in(friction, shape);
    return read_cells(shape, friction, "friction", [&](const double value, const Grid_cell& cell) {
      return is_no_data(no_data, value) ? infinity : checked_friction(value, cell);
    });
  }
}

// Gives a cell without a height the mean of its neighbors that can be entered: a line that passes
// beside it interpolates between its height and that of a neighbor.
inline void extend_height(const Grid_shape& shape,
                          const std::vector<double>& friction,
                          std::vector<double>& heights,
                          const Grid_cell& cell)
{
  double sum = 0, number = 0;
  for(std::size_t row = cell.row - 1; row != cell.row + 2; ++row) // numbers below 0 wrap around
    for(std::size_t i = cell.column - 1; i != cell.column + 2; ++i)
      if(const Grid_cell neighbor{shape.is_periodic ? (i + shape.columns) % shape.columns : i, row};
         neighbor.column < shape.columns && row < shape.rows &&
         friction[shape.index(neighbor)] < infinity)
      {
        sum += heights[shape.index(neighbor)];
        ++number;
      }
  heights[shape.index(cell)] = number > 0 ? sum / number : 0;
}

// Cells without a height get infinite friction.
template <typename HeightRange>
std::vector<double>
read_heights(const Grid_shape& shape, const HeightRange& range, std::vector<double>& friction)
{
  constexpr double too_large = 1e100;
  const std::optional<double> no_data = no_data_in(range, shape);
  std::vector<std::size_t> without;
  std::vector<double> result =
      read_cells(shape, range, "height", [&](const double height, const Grid_cell& cell) {
        if(is_no_data(no_data, height))
        {
          without.push_back(shape.index(cell));
          friction[without.back()] = infinity;
          return 0.;
        }
        if(!(std::abs(height) < too_large))
          reject(value_in_message("height", height, cell) +
                 "; it must be a number of at most 1e100, or no_data");
        return height;
      });
  for(const std::size_t i : without)
    extend_height(shape, friction, result, shape.cell(i));
  return result;
}

template <typename Range>
const Range& unwrapped(const Range& range)
{
  return range;
}

template <typename Range>
const Range& unwrapped(const std::reference_wrapper<Range>& range)
{
  return range.get();
}

template <typename NamedParameters>
std::vector<double> heights_of(const Grid_shape& shape,
                               [[maybe_unused]] std::vector<double>& friction,
                               [[maybe_unused]] const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, internal_np::heights_t>)
    return read_heights(shape, unwrapped(parameters::get_parameter(np, internal_np::heights)),
                        friction);
  else
    return {};
}

// Reads heights and cost functions. Cells without a height get infinite friction.
template <typename NamedParameters>
Line_costs read_line_costs(const Grid_shape& shape,
                           const Cell_storage& storage,
                           std::vector<double>& friction,
                           const NamedParameters& np)
{
  std::vector<double> heights = storage.kept(heights_of(shape, friction, np));
  const int sign = parameters::choose_parameter(
                       parameters::get_parameter(np, internal_np::direction_to_source), false)
                       ? -1
                       : 1;
  if constexpr(is_given<NamedParameters, internal_np::face_weight_t>)
  {
    const auto cost = parameters::get_parameter(np, internal_np::face_weight);
    if constexpr(std::is_invocable_v<decltype(cost), double>)
    {
      static_assert(is_given<NamedParameters, internal_np::heights_t>,
                    "a cost function of the slope needs the named parameter heights");
      return Line_costs(std::move(heights),
                        Slope_costs([&](const double slope) { return cost(sign * slope); }));
    }
    else
      return Line_costs(std::move(heights),
                        [cost, sign](const Grid_cell& cell, const Grid_vector& direction) {
                          return cost(cell, sign > 0 ? direction : -direction);
                        });
  }
  else
    return Line_costs(std::move(heights), Slope_costs());
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_READ_CELLS_H
