#include "gdal.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Close
{
  void operator()(void* const dataset) const { GDALClose(dataset); }
};

using Dataset = std::unique_ptr<void, Close>;

// Messages are part of the errors that are thrown.
void prepare_gdal()
{
  constexpr GIntBig size_of_cache = 16 << 20; // rows are read in order
  GDALAllRegister();
  GDALSetCacheMax64(size_of_cache);
  CPLSetErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
}

std::string authority(OGRSpatialReferenceH reference)
{
  const char* const name = OSRGetAuthorityName(reference, nullptr);
  const char* const code = OSRGetAuthorityCode(reference, nullptr);
  return name == nullptr || code == nullptr ? ""
                                            : std::string("urn:ogc:def:crs:") + name + "::" + code;
}

class Gdal_reader : public Raster_reader
{
public:
  Gdal_reader(const std::string& file, const int band) : m_file(file)
  {
    prepare_gdal();
    m_dataset.reset(GDALOpen(file.c_str(), GA_ReadOnly));
    if(!m_dataset)
      reject_raster(file, CPLGetLastErrorMsg());
    if(band > GDALGetRasterCount(m_dataset.get()))
      reject_raster(file, "it has " + std::to_string(GDALGetRasterCount(m_dataset.get())) +
                              " bands, and no band " + std::to_string(band));
    m_band = GDALGetRasterBand(m_dataset.get(), band);
    m_frame.columns = static_cast<std::size_t>(GDALGetRasterXSize(m_dataset.get()));
    m_frame.rows = static_cast<std::size_t>(GDALGetRasterYSize(m_dataset.get()));
    int has_no_data = 0;
    const double no_data = GDALGetRasterNoDataValue(m_band, &has_no_data);
    if(has_no_data != 0)
      m_frame.no_data = no_data;
    read_transform();
    read_reference();
  }

  void read_row(std::vector<double>& values) override
  {
    values.resize(m_frame.columns);
    const int columns = static_cast<int>(m_frame.columns);
    if(GDALRasterIO(m_band, GF_Read, 0, m_row++, columns, 1, values.data(), columns, 1, GDT_Float64,
                    0, 0) != CE_None)
      reject_raster(m_file, CPLGetLastErrorMsg());
  }

private:
  void read_transform()
  {
    double t[6];
    if(GDALGetGeoTransform(m_dataset.get(), t) != CE_None)
      return;
    if(t[2] != 0 || t[4] != 0)
      reject_raster(m_file, "its rows do not run along the x axis of the map");
    m_frame.is_on_map = true;
    m_frame.x = t[0];
    m_frame.y = t[3];
    m_frame.x_step = t[1];
    m_frame.y_step = t[5];
  }

  void read_reference()
  {
    m_frame.projection = GDALGetProjectionRef(m_dataset.get());
    const OGRSpatialReferenceH reference = GDALGetSpatialRef(m_dataset.get());
    if(reference == nullptr)
      return;
    m_frame.is_in_degrees = OSRIsGeographic(reference) != 0;
    m_frame.crs = authority(reference);
  }

  std::string m_file;
  Dataset m_dataset;
  GDALRasterBandH m_band = nullptr;
  int m_row = 0;
};

} // namespace

bool has_gdal() { return true; }

std::unique_ptr<Raster_reader> open_gdal(const std::string& file, const int band)
{
  return std::make_unique<Gdal_reader>(file, band);
}

void write_geotiff(const std::string& place,
                   const std::string& name,
                   const Raster_frame& frame,
                   const std::function<const std::vector<double>&(std::size_t)>& row)
{
  prepare_gdal();
  const auto fail = [&] {
    throw std::runtime_error("cannot write " + name + ": " + CPLGetLastErrorMsg());
  };
  const int columns = static_cast<int>(frame.columns), rows = static_cast<int>(frame.rows);
  const char* options[] = {"BIGTIFF=IF_SAFER", nullptr};
  Dataset dataset(GDALCreate(GDALGetDriverByName("GTiff"), place.c_str(), columns, rows, 1,
                             GDT_Float64, const_cast<char**>(options)));
  if(!dataset)
    fail();
  double transform[] = {frame.x, frame.x_step, 0, frame.y, 0, frame.y_step};
  GDALSetGeoTransform(dataset.get(), transform);
  GDALSetProjection(dataset.get(), frame.projection.c_str());
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  GDALSetRasterNoDataValue(band, std::numeric_limits<double>::quiet_NaN());
  std::vector<double> values;
  for(int i = 0; i < rows; ++i)
  {
    values = row(static_cast<std::size_t>(i));
    for(double& value : values)
      if(std::isinf(value))
        value = std::numeric_limits<double>::quiet_NaN();
    if(GDALRasterIO(band, GF_Write, 0, i, columns, 1, values.data(), columns, 1, GDT_Float64, 0,
                    0) != CE_None)
      fail();
  }
  CPLErrorReset();
  dataset.reset(); // what was written may still be in memory
  if(CPLGetLastErrorType() >= CE_Failure)
    fail();
}
