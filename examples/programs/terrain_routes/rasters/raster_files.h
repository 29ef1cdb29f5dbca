#ifndef TERRAIN_ROUTES_RASTERS_RASTER_FILES_H
#define TERRAIN_ROUTES_RASTERS_RASTER_FILES_H

#include "../../command_line/New_files.h"
#include "../../command_line/files.h"
#include "Raster.h"
#include "ascii_grid.h"
#include "gdal.h"
#include "npy.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

// Files of rasters by the ends of their names.

inline std::string ending_of(const std::string& file)
{
  return std::filesystem::path(file).extension().string();
}

inline std::unique_ptr<Raster_reader> open_raster(const std::string& file,
                                                  const std::optional<int> band)
{
  check_readable(file);
  std::unique_ptr<Raster_reader> result;
  const std::string ending = ending_of(file);
  if(ending == ".npy")
    result = std::make_unique<Npy_reader>(file);
  else if(ending == ".asc")
    result = std::make_unique<Ascii_grid_reader>(file);
  else
    result = open_gdal(file, band);
  if(band.value_or(1) > 1 && (ending == ".npy" || ending == ".asc"))
    reject_raster(file, "it has no bands that could be chosen");
  check_number_of_cells(file, result->frame());
  return result;
}

// What rasters that belong to this one are written as: in the same format, if the program writes
// it.
inline std::string ending_of_outputs(const std::string& file)
{
  const std::string ending = ending_of(file);
  return ending == ".npy" || ending == ".asc" ? ending : ".tif";
}

// Adds a raster to the files that are written. `row(i)` returns the values of a row, in this unit,
// which only GeoTIFF has a place for.
template <typename Row>
void write_raster(New_files& files,
                  const std::string& name,
                  const Raster_frame& frame,
                  const std::string& unit,
                  const Row& row)
{
  const std::string ending = ending_of(name);
  if(ending == ".npy")
    files.write(name, [&](std::ostream& out) { write_npy(out, frame, row); });
  else if(ending == ".asc")
    files.write(name, [&](std::ostream& out) { write_ascii_grid(out, frame, row); });
  else
    write_geotiff(files.add(name), name, frame, unit, row);
}

#endif // TERRAIN_ROUTES_RASTERS_RASTER_FILES_H
