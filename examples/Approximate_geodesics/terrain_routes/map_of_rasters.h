#ifndef TERRAIN_ROUTES_MAP_OF_RASTERS_H
#define TERRAIN_ROUTES_MAP_OF_RASTERS_H

#include "../command_line/read_options.h"
#include "Options.h"
#include "rasters/Raster.h"

#include <CGAL/Approximate_geodesics/Graphs/Grid_shape.h>

#include <algorithm>
#include <cmath>
#include <string>

// Where the cells of rasters are.

// Refuses a raster of heights with other cells than that of friction. Files without a map may go
// with any.
inline void
check_same_map(const std::string& file, const Raster_frame& heights, const Raster_frame& friction)
{
  const auto size = [](const Raster_frame& frame) {
    return std::to_string(frame.columns) + " columns and " + std::to_string(frame.rows) + " rows";
  };
  if(heights.columns != friction.columns || heights.rows != friction.rows)
    reject_raster(file,
                  "it has " + size(heights) + ", and the raster of friction has " + size(friction));
  constexpr double rounding = 1e-3; // of a cell
  const auto differ = [&](const double a, const double b, const double step) {
    return !(std::abs(a - b) <= rounding * std::abs(step));
  };
  const auto end = [](const double first, const double step, const std::size_t number) {
    return first + step * static_cast<double>(number);
  };
  const Raster_frame &a = heights, &b = friction;
  if(a.is_on_map && b.is_on_map &&
     (differ(a.x, b.x, b.x_step) || differ(a.y, b.y, b.y_step) ||
      differ(end(a.x, a.x_step, a.columns), end(b.x, b.x_step, b.columns), b.x_step) ||
      differ(end(a.y, a.y_step, a.rows), end(b.y, b.y_step, b.rows), b.y_step)))
    reject_raster(file, "its cells are elsewhere on the map than those of the raster of friction");
}

// Returns the shape of the grid. Metrics are the same for both signs of latitudes, so rows can run
// northward, too.
inline CGAL::Approximate_geodesics::Grid_shape shape_of(const Raster_frame& frame,
                                                        const Options& options)
{
  CGAL::Approximate_geodesics::Grid_shape result{
      frame.columns, frame.rows, std::abs(frame.x_step), std::abs(frame.y_step), {}};
  if(options.cell_size)
  {
    result.cell_width = (*options.cell_size)[0];
    result.cell_height = (*options.cell_size)[1];
  }
  else if(frame.is_in_degrees || options.is_in_degrees)
  {
    if(!frame.is_on_map)
      reject_option("degrees", options.main_raster() + " does not tell where its cells are");
    result.first_latitude = frame.y_step < 0 ? frame.y : -frame.y;
  }
  for(const double size : {result.cell_width, result.cell_height})
    if(!(size > 0 && std::isfinite(size)))
      reject_raster(options.main_raster(), "its cells have no size above 0");
  if(options.epsilon && result.first_latitude)
    reject_option("epsilon", "there is no bound where coordinates are in degrees; --cell-size W,H "
                             "gives cells a size in meters");
  return result;
}

#endif // TERRAIN_ROUTES_MAP_OF_RASTERS_H
