#include "gdal.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

bool has_gdal() { return false; }

std::unique_ptr<Raster_reader> open_gdal(const std::string& file, std::optional<int> /* band */)
{
  reject_raster(file, "its name must end with .npy or .asc, as this program was compiled without "
                      "GDAL, which reads other formats");
}

Map_system system_of_prj(const std::string& file, const std::string& /* text */)
{
  reject_raster(file,
                "this program was compiled without GDAL, which understands coordinate "
                "systems; without this file, say what coordinates are by --unit or --degrees");
}

bool is_same_system(const Map_system& a, const Map_system& b)
{
  return a.well_known == b.well_known;
}

void write_geotiff(const std::string& /* place */,
                   const std::string& name,
                   const Raster_frame& /* frame */,
                   const std::string& /* unit */,
                   const std::function<const std::vector<double>&(std::size_t)>& /* row */)
{
  throw std::invalid_argument("cannot write " + name + ": this program was compiled without GDAL");
}
