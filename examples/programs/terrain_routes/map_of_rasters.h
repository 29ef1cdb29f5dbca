#ifndef TERRAIN_ROUTES_MAP_OF_RASTERS_H
#define TERRAIN_ROUTES_MAP_OF_RASTERS_H

#include "../command_line/read_options.h"
#include "Options.h"
#include "rasters/Raster.h"
#include "rasters/descriptions.h"
#include "rasters/gdal.h"

#include <CGAL/Geodesic_grids/Grid_graph.h>
#include <CGAL/Geodesic_grids/Grid_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

// Where the cells of rasters are, and how large.

using CGAL::Approximate_geodesics::Grid_shape;

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

// Refuses two rasters with different coordinate systems, or one without a system beside one in
// degrees.
inline void
check_same_system(const Options& options, const Raster_frame& heights, const Raster_frame& friction)
{
  const Map_system &a = heights.system, &b = friction.system;
  if(a.is_known() && b.is_known() && !is_same_system(a, b))
    reject_raster(options.heights, "its coordinate system, " + a.name +
                                       ", is not that of the raster of friction, " + b.name);
  const bool is_one_unknown = a.is_known() != b.is_known();
  const bool are_both_on_map = heights.is_on_map && friction.is_on_map;
  if(is_one_unknown && are_both_on_map && (a.is_geographic || b.is_geographic) &&
     !options.is_in_degrees)
    reject_option("degrees", (a.is_known() ? options.friction : options.heights) +
                                 " tells of no coordinate system, and " +
                                 (a.is_known() ? options.heights : options.friction) +
                                 " is in degrees; this option says that both are");
}

// Returns the frame that counts for both rasters, one of which may be missing: with a place on the
// map, and a coordinate system, if one of them has it.
inline Raster_frame
common_frame(const Options& options, const Raster_frame* friction, const Raster_frame* heights)
{
  if(friction == nullptr || heights == nullptr)
    return friction == nullptr ? *heights : *friction;
  check_same_map(options.heights, *heights, *friction);
  check_same_system(options, *heights, *friction);
  Raster_frame result = friction->is_on_map ? *friction : *heights;
  if(!result.system.is_known())
    result.system = heights->system;
  return result;
}

// Lets options replace what files say of coordinates.
inline void apply_options(const Options& options, Raster_frame& frame)
{
  Map_system& system = frame.system;
  if(options.is_in_degrees && system.is_known() && !system.is_geographic)
    reject_option("degrees", options.main_raster() + " has the coordinate system " + system.name);
  if(options.unit && system.is_geographic && !options.cell_size)
    reject_option("unit", options.main_raster() + " is in degrees");
  system.is_geographic = system.is_geographic || options.is_in_degrees;
  if(options.unit)
    system.unit = *options.unit;
}

// Whether lengths are in meters: where it is not known what coordinates are, they may be in any
// unit.
inline bool is_in_meters(const Options& options, const Raster_frame& frame)
{
  return frame.system.is_known() || frame.system.is_geographic || options.unit || options.cell_size;
}

inline void set_cell_size(const Options& options, const Raster_frame& frame, Grid_shape& shape)
{
  const Map_system& system = frame.system;
  if(options.cell_size)
  {
    const double unit = options.unit ? options.unit->meters : 1;
    shape.cell_width = (*options.cell_size)[0] * unit;
    shape.cell_height = (*options.cell_size)[1] * unit;
    return;
  }
  if(!frame.is_on_map && system.is_geographic)
    reject_option("degrees", options.main_raster() + " does not tell where its cells are");
  if(!frame.is_on_map && system.is_known())
    reject_option("cell-size", options.main_raster() + " has a coordinate system, " + system.name +
                                   ", and does not tell how large its cells are");
  const double unit = system.is_geographic ? system.degrees : system.unit.meters;
  shape.cell_width = std::abs(frame.x_step) * unit;
  shape.cell_height = std::abs(frame.y_step) * unit;
  if(!system.is_geographic)
    return;
  shape.first_latitude = (frame.y_step < 0 ? frame.y : -frame.y) * unit;
  shape.ellipsoid = system.ellipsoid;
  constexpr double round = 360; // the size of cells may be rounded
  shape.is_periodic = std::abs(shape.width() - round) < 0.5 * shape.cell_width &&
                      shape.columns > 2 * CGAL::Approximate_geodesics::Grid_graph::largest_reach();
  if(shape.is_periodic)
    shape.cell_width = round / static_cast<double>(shape.columns);
}

// Refuses what is not on a globe.
inline void check_extent(const Options& options, const Raster_frame& frame, const Grid_shape& shape)
{
  constexpr double pole = 90, round = 360, tolerance = 0.01; // of a cell
  const double last = *shape.first_latitude - static_cast<double>(shape.rows) * shape.cell_height;
  const auto is_above = [](const double value, const double limit, const double cell) {
    return !(value <= limit + tolerance * cell);
  };
  const double degrees = frame.system.degrees;
  if(is_above(*shape.first_latitude, pole, shape.cell_height) ||
     is_above(-last, pole, shape.cell_height))
    reject_raster(options.main_raster(), described_extent("latitudes go", frame.y * degrees,
                                                          frame.y_step * degrees, frame.rows) +
                                             "; they must be from -90 to 90 degrees");
  if(is_above(shape.width(), round, shape.cell_width))
    reject_raster(options.main_raster(),
                  described_extent("longitudes go", frame.x * degrees, frame.x_step * degrees,
                                   frame.columns) +
                      ", more than once round; gdal_translate -srcwin leaves columns out that are "
                      "there twice");
}

// Returns the shape of the grid, in meters or in degrees as far as that is known. Metrics are the
// same for both signs of latitudes, so rows can run northward, too.
inline Grid_shape shape_of(const Raster_frame& frame, const Options& options)
{
  Grid_shape result{frame.columns, frame.rows, 1, 1, {}};
  set_cell_size(options, frame, result);
  for(const double size : {result.cell_width, result.cell_height})
    if(!(size > 0 && std::isfinite(size)))
      reject_raster(options.main_raster(), "its cells have no size above 0");
  if(result.first_latitude)
    check_extent(options, frame, result);
  if(options.epsilon && result.first_latitude)
    reject_option("epsilon", "there is no bound where coordinates are in degrees; --cell-size W,H "
                             "gives cells a size in meters");
  return result;
}

// Returns the unit of heights: that of coordinates if no file tells of it, or meters. It has no
// name if nothing is known of either.
inline Length_unit
unit_of_heights(const Options& options, const Raster_frame& frame, const Raster_reader& heights)
{
  const auto known = [&]() -> std::optional<Length_unit> {
    if(options.unit_of_heights)
      return options.unit_of_heights;
    if(const std::string& text = heights.values().unit; !text.empty())
    {
      if(const auto unit = length_unit(text))
        return unit;
      reject_option("height-unit", options.heights + " has heights in \"" + text +
                                       "\", which is no known unit of length");
    }
    return heights.frame().system.unit_of_heights;
  }();
  if(!known)
    return frame.system.is_geographic || options.cell_size ? Length_unit{"m", 1}
                                                           : frame.system.unit;
  if(!is_in_meters(options, frame) && known->meters != 1)
    reject_option("unit", options.heights + " has heights in " + known->name +
                              ", and tells of no coordinate system; this option is to say what "
                              "its coordinates are in");
  return *known;
}

#endif // TERRAIN_ROUTES_MAP_OF_RASTERS_H
