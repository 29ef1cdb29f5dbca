#ifndef TERRAIN_ROUTES_PARSE_OPTIONS_H
#define TERRAIN_ROUTES_PARSE_OPTIONS_H

#include "../command_line/read_options.h"
#include "Options.h"
#include "describe_options.h"
#include "slope_functions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// Refuses options that are wrong, or that do not go together, before the raster is read.

inline void read_isochrones(const std::vector<std::string>& texts, Options& options)
{
  for(const std::string& text : texts)
    if(text.rfind("count:", 0) == 0)
    {
      options.number_of_isochrones = whole_number("isochrones", text.substr(6), 1);
      constexpr std::size_t most = 10000;
      if(texts.size() > 1 || *options.number_of_isochrones > most)
        reject_option("isochrones", text + ": a number from 1 to 10000 must follow, and no more");
    }
    else
      options.isochrones.push_back(number_from_0("isochrones", text, false));
}

inline std::size_t read_memory(const std::string& text)
{
  constexpr double least = 16 << 20, most = 1e15;
  const std::string units = "KMGT";
  const std::size_t unit = text.empty() ? std::string::npos : units.find(text.back());
  const bool has_unit = unit != std::string::npos;
  const double number =
      number_from_0("memory", has_unit ? text.substr(0, text.size() - 1) : text, false);
  const double size = has_unit ? std::ldexp(number, 10 * (static_cast<int>(unit) + 1)) : number;
  if(!(size >= least && size <= most))
    reject_option("memory", text + " is not a size from 16M to 900T");
  return static_cast<std::size_t>(size);
}

inline std::array<double, 2> read_cell_size(const std::string& text)
{
  const std::size_t comma = text.find(',');
  const double width = number_of("cell-size", text.substr(0, comma));
  const double height =
      comma == std::string::npos ? width : number_of("cell-size", text.substr(comma + 1));
  if(!(width > 0 && height > 0 && std::isfinite(width) && std::isfinite(height)))
    reject_option("cell-size", text + ": sizes must be finite numbers above 0");
  return {width, height};
}

inline Length_unit read_unit(const std::string& option, const std::string& text)
{
  const std::optional<Length_unit> result = length_unit(text);
  if(!result)
    reject_option(option, text + " is not m, km, dm, cm, mm, ft or us-ft");
  return *result;
}

inline double read_no_data(const std::string& text)
{
  std::string lower = text;
  std::transform(text.begin(), text.end(), lower.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "nan" ? std::numeric_limits<double>::quiet_NaN() : number_of("no-data", text);
}

inline void read_values(const po::variables_map& values, Options& options)
{
  const auto has = [&](const char* option) { return values.count(option) > 0; };
  const auto text = [&](const char* option) { return values[option].as<std::string>(); };
  if(has("epsilon"))
  {
    options.epsilon = number_from_0("epsilon", text("epsilon"), false);
    if(*options.epsilon == 0)
      reject_option("epsilon", "it must be above 0: exact paths on rasters are not computed");
  }
  if(has("max-slope"))
    options.max_slope = number_from_0("max-slope", text("max-slope"), false);
  if(has("band"))
    options.band = static_cast<int>(whole_number("band", text("band"), 1));
  if(has("no-data"))
    options.no_data = read_no_data(text("no-data"));
  if(has("unit"))
    options.unit = read_unit("unit", text("unit"));
  if(has("height-unit"))
    options.unit_of_heights = read_unit("height-unit", text("height-unit"));
  if(has("cell-size"))
    options.cell_size = read_cell_size(text("cell-size"));
  if(has("memory"))
    options.memory = read_memory(text("memory"));
  if(has("isochrones"))
    read_isochrones(values["isochrones"].as<std::vector<std::string>>(), options);
}

inline void check_combinations(const Options& options)
{
  if(options.sources.empty())
    reject_option("sources", "there must be at least one");
  if(options.targets.empty() && options.writes_corridor)
    reject_option("corridor", "it needs --targets");
  if(options.targets.empty() && options.writes_table)
    reject_option("csv", "it is for the paths to --targets");
  if(options.is_in_degrees && options.unit && !options.cell_size)
    reject_option("unit", "coordinates are in degrees by --degrees");
  if(options.heights.empty() && options.unit_of_heights)
    reject_option("height-unit", "it needs --heights");
  if(options.colors != "uniform" && options.colors != "rainbow")
    reject_option("colors", options.colors + " is not uniform or rainbow");
  if(options.heights.empty() && slope_function(options.cost))
    reject_option("cost", options.cost + " depends on the slope; it needs --heights");
  if(options.heights.empty() && std::isfinite(options.max_slope))
    reject_option("max-slope", "it needs --heights");
  if(options.epsilon && !options.heights.empty())
    reject_option("epsilon", "there is no bound with --heights");
  if(options.memory > 0 && options.work_folder.empty())
    reject_option("memory", "it needs --work-folder, where the rest is kept");
}

inline Options parse_options(const int argc, char* argv[])
{
  Options options;
  const po::options_description description = describe_options(options);
  const auto values = read_options(argc, argv, description, options.friction, "raster", "heights");
  if(options.asks_for_help)
    print_help(description);
  else
  {
    read_values(values, options);
    check_combinations(options);
  }
  return options;
}

#endif // TERRAIN_ROUTES_PARSE_OPTIONS_H
