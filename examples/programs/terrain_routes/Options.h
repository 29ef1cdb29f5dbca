#ifndef TERRAIN_ROUTES_OPTIONS_H
#define TERRAIN_ROUTES_OPTIONS_H

#include "rasters/units.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// What the user wants.
struct Options
{
  std::string friction; // a raster of friction, or empty
  std::string heights;  // likewise
  std::vector<std::string> sources;
  std::vector<std::string> targets;
  std::optional<int> band;
  std::optional<double> no_data;
  std::optional<std::array<double, 2>> cell_size;
  bool is_in_degrees = false;
  std::optional<Length_unit> unit; // of coordinates and sizes
  std::optional<Length_unit> unit_of_heights;
  bool snaps = false; // to cells that can be entered
  std::string cost;
  double max_slope = std::numeric_limits<double>::infinity();
  bool goes_to_sources = false;

  std::optional<double> epsilon;
  std::size_t memory = 0; // in bytes; 0 stands for no limit
  std::string work_folder;

  std::string output;
  bool overwrites = false;
  bool writes_back_links = false;
  bool writes_corridor = false;
  bool writes_table = false;
  std::vector<double> isochrones;
  std::optional<std::size_t> number_of_isochrones;
  bool draws = false;
  std::string colors;
  bool asks_for_help = false;

  // The raster whose format others are written in.
  const std::string& main_raster() const { return friction.empty() ? heights : friction; }

  bool has_isochrones() const { return number_of_isochrones || !isochrones.empty(); }
};

#endif // TERRAIN_ROUTES_OPTIONS_H
