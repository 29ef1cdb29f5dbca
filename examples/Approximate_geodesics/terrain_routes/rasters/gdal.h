#ifndef TERRAIN_ROUTES_RASTERS_GDAL_H
#define TERRAIN_ROUTES_RASTERS_GDAL_H

#include "Raster.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

// Rasters of all formats that GDAL reads, and GeoTIFF files. It is the only place that knows GDAL.

// Whether the program was compiled with GDAL.
bool has_gdal();

// Throws std::invalid_argument if there is no such raster.
std::unique_ptr<Raster_reader> open_gdal(const std::string& file, int band);

// Writes a GeoTIFF file to `place`, which is called `name` in messages. Infinity becomes NaN, which
// stands for no data. `row(i)` returns the values of a row.
void write_geotiff(const std::string& place,
                   const std::string& name,
                   const Raster_frame& frame,
                   const std::function<const std::vector<double>&(std::size_t)>& row);

#endif // TERRAIN_ROUTES_RASTERS_GDAL_H
