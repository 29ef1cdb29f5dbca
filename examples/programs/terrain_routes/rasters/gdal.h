#ifndef TERRAIN_ROUTES_RASTERS_GDAL_H
#define TERRAIN_ROUTES_RASTERS_GDAL_H

#include "Raster.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Rasters of all formats that GDAL reads, and GeoTIFF files. Coordinate systems, too. It is the
// only place that knows GDAL.

// Whether the program was compiled with GDAL.
bool has_gdal();

// Opens a band, the first one unless it is chosen. Throws std::invalid_argument if there is no such
// raster, or what it holds is not understood.
std::unique_ptr<Raster_reader> open_gdal(const std::string& file, std::optional<int> band);

// Returns the system of a file with the ending .prj, the text of which is `text`.
Map_system system_of_prj(const std::string& file, const std::string& text);

// Whether two systems that are known have the same coordinates, whatever their heights are.
bool is_same_system(const Map_system& a, const Map_system& b);

// Writes a GeoTIFF file to `place`, which is called `name` in messages. Infinity becomes NaN, which
// stands for no data. `row(i)` returns the values of a row, in this unit.
void write_geotiff(const std::string& place,
                   const std::string& name,
                   const Raster_frame& frame,
                   const std::string& unit,
                   const std::function<const std::vector<double>&(std::size_t)>& row);

#endif // TERRAIN_ROUTES_RASTERS_GDAL_H
