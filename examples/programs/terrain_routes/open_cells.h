#ifndef TERRAIN_ROUTES_OPEN_CELLS_H
#define TERRAIN_ROUTES_OPEN_CELLS_H

#include "../command_line/read_options.h"
#include "Costs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// Cells that can be entered, beside those that cannot.

struct Near_cell
{
  Grid_cell cell;
  double distance; // between centers
};

// Returns the nearest cell that can be entered; none if no cell can be.
inline std::optional<Near_cell> nearest_open_cell(const Costs& costs, const Grid_cell& cell)
{
  const Grid_shape& shape = costs.shape();
  std::optional<Near_cell> result;
  const auto look_at_row = [&](const std::size_t row) {
    const std::vector<bool> is_open = costs.open_row(row);
    const auto& sides = costs.metric().between(cell.row, row);
    const double y = (static_cast<double>(row) - static_cast<double>(cell.row)) * sides.height;
    for(std::size_t column = 0; column < shape.columns; ++column)
    {
      std::size_t columns = std::max(column, cell.column) - std::min(column, cell.column);
      if(shape.is_periodic)
        columns = std::min(columns, shape.columns - columns);
      const double distance = std::hypot(static_cast<double>(columns) * sides.width, y);
      if(is_open[column] && (!result || distance < result->distance))
        result = {{column, row}, distance};
    }
  };
  for(std::size_t i = 0; i < shape.rows; ++i)
  {
    if(result && result->distance <= static_cast<double>(i) * costs.metric().smallest().height)
      break;
    if(cell.row >= i)
      look_at_row(cell.row - i);
    if(i > 0 && cell.row + i < shape.rows)
      look_at_row(cell.row + i);
  }
  return result;
}

// Returns what a user should know of a cell that cannot be entered.
inline std::string closed_cell(const Costs& costs, const Grid_cell& cell)
{
  std::ostringstream out;
  out << "cell " << cell.column << ',' << cell.row
      << " cannot be entered, as it has no data or an infinite friction; ";
  const std::optional<Near_cell> near = nearest_open_cell(costs, cell);
  if(!near)
    out << "nor can any other cell";
  else
    out << "the nearest cell that can be is " << near->cell.column << ',' << near->cell.row << ", "
        << near->distance << with_blank(costs.unit_of_lengths()) << " away; --snap moves it there";
  return out.str();
}

// Moves cells that cannot be entered to the nearest ones that can, and returns lines about it.
inline std::string snap(const Costs& costs, const char* const role, std::vector<Grid_cell>& cells)
{
  std::ostringstream out;
  for(Grid_cell& cell : cells)
    if(!costs.is_open(cell))
      if(const std::optional<Near_cell> near = nearest_open_cell(costs, cell))
      {
        out << "The " << role << " cell " << cell.column << ',' << cell.row
            << " cannot be entered; moved by " << near->distance
            << with_blank(costs.unit_of_lengths()) << " to cell " << near->cell.column << ','
            << near->cell.row << '\n';
        cell = near->cell;
      }
  return out.str();
}

// Refuses sources that cannot be entered, as no path leads from there.
inline void check_sources(const Costs& costs, const std::vector<Grid_cell>& sources)
{
  for(const Grid_cell& source : sources)
    if(!costs.is_open(source))
      reject_option("sources", closed_cell(costs, source));
}

#endif // TERRAIN_ROUTES_OPEN_CELLS_H
