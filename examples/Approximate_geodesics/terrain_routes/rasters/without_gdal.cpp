#include "gdal.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

bool has_gdal() { return false; }

std::unique_ptr<Raster_reader> open_gdal(const std::string& file, int /* band */)
{
  reject_raster(file, "its name must end with .npy or .asc, as this program was compiled without "
                      "GDAL, which reads other formats");
}

void write_geotiff(const std::string& /* place */,
                   const std::string& name,
                   const Raster_frame& /* frame */,
                   const std::function<const std::vector<double>&(std::size_t)>& /* row */)
{
  throw std::invalid_argument("cannot write " + name + ": this program was compiled without GDAL");
}
