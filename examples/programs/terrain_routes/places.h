#ifndef TERRAIN_ROUTES_PLACES_H
#define TERRAIN_ROUTES_PLACES_H

#include "../command_line/lines_of_file.h"
#include "rasters/Raster.h"
#include "rasters/descriptions.h"

#include <CGAL/Geodesic_grids/Grid_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

using CGAL::Approximate_geodesics::Grid_cell;

// Cells that are given by texts.

inline double coordinate(const std::string& text, const std::string& place)
{
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  if(text.empty() || *end != '\0' || !std::isfinite(result))
    throw std::invalid_argument('"' + place + "\" is not x,y, cell:C,R or file:NAME");
  return result;
}

// Returns the longitude of the same place that is in the turn where the raster begins.
inline double longitude_on(const Raster_frame& frame, const double x)
{
  const double turn = 360 / frame.system.degrees,
               west =
                   std::min(frame.x, frame.x + static_cast<double>(frame.columns) * frame.x_step);
  return x - turn * std::floor((x - west) / turn);
}

// Longitudes may be those of any turn.
inline Grid_cell
cell_of(const std::string& place, const Raster_frame& frame, const bool is_periodic)
{
  const bool is_cell = place.rfind("cell:", 0) == 0;
  const std::string text = is_cell ? place.substr(5) : place;
  const std::size_t comma = std::min(text.find(','), text.size());
  double column = coordinate(text.substr(0, comma), place);
  double row = coordinate(comma < text.size() ? text.substr(comma + 1) : "", place);
  if(is_cell && (column != std::floor(column) || row != std::floor(row)))
    throw std::invalid_argument(place + ": column and row must be whole numbers");
  if(!is_cell)
  {
    if(frame.system.is_geographic)
      column = longitude_on(frame, column);
    column = std::floor((column - frame.x) / frame.x_step);
    const auto columns = static_cast<double>(frame.columns);
    if(is_periodic)
      column -= columns * std::floor(column / columns);
    row = std::floor((row - frame.y) / frame.y_step);
  }
  if(!(column >= 0 && column < static_cast<double>(frame.columns) && row >= 0 &&
       row < static_cast<double>(frame.rows)))
    throw std::invalid_argument(
        place + " is not in the raster, which has " + std::to_string(frame.columns) +
        " columns and " + std::to_string(frame.rows) + " rows, " +
        described_extent("x", frame.x, frame.x_step, frame.columns) + ", and " +
        described_extent("y", frame.y, frame.y_step, frame.rows));
  return {static_cast<std::size_t>(column), static_cast<std::size_t>(row)};
}

inline std::vector<Grid_cell> cells_of(const std::string& option,
                                       const std::vector<std::string>& texts,
                                       const Raster_frame& frame,
                                       const bool is_periodic)
{
  std::vector<Grid_cell> result;
  for(const std::string& text : texts)
    if(text.rfind("file:", 0) == 0)
      for_each_line(option, text.substr(5), [&](const std::vector<std::string>& words) {
        for(const std::string& word : words)
          result.push_back(cell_of(word, frame, is_periodic));
      });
    else
      name_in_errors(option, [&] { result.push_back(cell_of(text, frame, is_periodic)); });
  if(result.empty() && !texts.empty()) // files may hold nothing but comments
    throw std::invalid_argument(option + ": there must be at least one");
  return result;
}

#endif // TERRAIN_ROUTES_PLACES_H
