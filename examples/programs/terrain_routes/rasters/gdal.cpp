#include "gdal.h"

#include "systems.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
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

class Gdal_reader : public Raster_reader
{
public:
  Gdal_reader(const std::string& file, const std::optional<int> band) : m_file(file)
  {
    prepare_gdal();
    m_dataset.reset(GDALOpen(file.c_str(), GA_ReadOnly));
    if(!m_dataset)
      reject_raster(file, CPLGetLastErrorMsg());
    choose_band(band);
    m_frame.columns = static_cast<std::size_t>(GDALGetRasterXSize(m_dataset.get()));
    m_frame.rows = static_cast<std::size_t>(GDALGetRasterYSize(m_dataset.get()));
    read_type();
    read_scale();
    find_masks();
    read_transform();
    if(const OGRSpatialReferenceH system = GDALGetSpatialRef(m_dataset.get()))
    {
      m_frame.system = read_system(m_file, system);
      read_stretch(system, m_frame);
    }
  }

private:
  void read_stored_row(std::vector<double>& values) override
  {
    values.resize(m_frame.columns);
    read(m_band, m_row++, values);
    if(m_has_signed_bytes)
      for(double& value : values)
        value -= value > 127 ? 256 : 0;
  }

  void read_mask(std::vector<bool>& is_visible) override
  {
    for(const GDALRasterBandH mask : m_masks)
    {
      m_mask_row.resize(is_visible.size());
      read(mask, m_row - 1, m_mask_row);
      for(std::size_t i = 0; i < is_visible.size(); ++i)
        is_visible[i] = is_visible[i] && m_mask_row[i] != 0;
    }
  }

  void read(const GDALRasterBandH band, const int row, std::vector<double>& values)
  {
    const int columns = static_cast<int>(values.size());
    if(GDALRasterIO(band, GF_Read, 0, row, columns, 1, values.data(), columns, 1, GDT_Float64, 0,
                    0) != CE_None)
      reject_raster(m_file, CPLGetLastErrorMsg());
  }

  void choose_band(const std::optional<int> wanted)
  {
    const int number = GDALGetRasterCount(m_dataset.get()), band = wanted.value_or(1);
    const char* const part =
        CSLFetchNameValue(GDALGetMetadata(m_dataset.get(), "SUBDATASETS"), "SUBDATASET_1_NAME");
    if(number == 0 && part != nullptr)
      reject_raster(m_file, std::string("it holds several rasters, which have names of their own, "
                                        "such as ") +
                                part + "; gdal_translate makes a file of one of them");
    if(band > number)
      reject_raster(m_file, "it has " + std::to_string(number) + " bands, and no band " +
                                std::to_string(band));
    m_band = GDALGetRasterBand(m_dataset.get(), band);
    if(number > 1)
      m_values.band = "band " + std::to_string(band) + " of " + std::to_string(number);
    check_color(wanted.has_value());
  }

  // Colors are no costs or heights, unless the user has chosen one of them.
  void check_color(const bool is_chosen) const
  {
    const GDALColorInterp color = GDALGetRasterColorInterpretation(m_band);
    const std::string name = GDALGetColorInterpretationName(color);
    if(color == GCI_AlphaBand)
      reject_raster(m_file, "its " + (m_values.band.empty() ? "band" : m_values.band) +
                                " tells what is transparent (Alpha); --band chooses another one");
    if(color > GCI_PaletteIndex && color != GCI_Max && !is_chosen)
      reject_raster(m_file, "its " + (m_values.band.empty() ? "band" : m_values.band) +
                                " is a color (" + name + "); --band chooses one of values");
  }

  void read_type()
  {
    const GDALDataType type = GDALGetRasterDataType(m_band);
    m_values.type = GDALGetDataTypeName(type);
    m_values.are_floats = type == GDT_Float32;
    if(GDALDataTypeIsComplex(type) != 0)
      reject_raster(m_file, "its values are complex numbers (" + m_values.type + ")");
    const char* const pixel_type = GDALGetMetadataItem(m_band, "PIXELTYPE", "IMAGE_STRUCTURE");
    m_has_signed_bytes =
        type == GDT_Byte && pixel_type != nullptr && EQUAL(pixel_type, "SIGNEDBYTE");
    if(m_has_signed_bytes)
      m_values.type = "Int8";
    if(GDALGetRasterColorTable(m_band) != nullptr)
      m_values.note = "they are indices of a table of colors";
  }

  void read_scale()
  {
    m_values.unit = GDALGetRasterUnitType(m_band);
    int has_scale = 0, has_offset = 0;
    const double scale = GDALGetRasterScale(m_band, &has_scale),
                 offset = GDALGetRasterOffset(m_band, &has_offset);
    m_values.scale = has_scale != 0 ? scale : 1;
    m_values.offset = has_offset != 0 ? offset : 0;
    if(!(std::isfinite(m_values.scale) && m_values.scale != 0 && std::isfinite(m_values.offset)))
      reject_raster(m_file, "its values have the scale " + std::to_string(scale) +
                                " and the offset " + std::to_string(offset));
  }

  // GDAL's mask is that of a value for no data, or of something else; an alpha band may be there
  // beside either.
  void find_masks()
  {
    int has_no_data = 0;
    const double no_data = GDALGetRasterNoDataValue(m_band, &has_no_data);
    if(has_no_data != 0)
      m_values.no_data = no_data;
    const int flags = GDALGetMaskFlags(m_band);
    if((flags & GMF_ALL_VALID) == 0 && flags != GMF_NODATA)
      add_mask(GDALGetMaskBand(m_band), (flags & GMF_ALPHA) != 0    ? "an alpha band"
                                        : (flags & GMF_NODATA) != 0 ? "values for no data in all "
                                                                      "bands"
                                                                    : "a mask");
    for(int i = 1; i <= GDALGetRasterCount(m_dataset.get()) && (flags & GMF_ALPHA) == 0; ++i)
      if(const GDALRasterBandH band = GDALGetRasterBand(m_dataset.get(), i);
         GDALGetRasterColorInterpretation(band) == GCI_AlphaBand)
        add_mask(band, "an alpha band");
  }

  void add_mask(const GDALRasterBandH mask, const char* const name)
  {
    m_masks.push_back(mask);
    m_values.mask += (m_values.mask.empty() ? "" : ", and by ") + std::string(name);
  }

  void read_transform()
  {
    double t[6];
    if(GDALGetGeoTransform(m_dataset.get(), t) != CE_None)
    {
      if(GDALGetGCPCount(m_dataset.get()) > 0)
        reject_raster(m_file, "control points tell where its cells are; gdalwarp makes a raster of "
                              "rows and columns on the map");
      return;
    }
    constexpr double rounding = 1e-3; // of a cell, at the last row or column
    if(!(std::abs(t[2]) * static_cast<double>(m_frame.rows) <= rounding * std::abs(t[1]) &&
         std::abs(t[4]) * static_cast<double>(m_frame.columns) <= rounding * std::abs(t[5])))
      reject_raster(m_file, "its rows do not run along the x axis of the map");
    m_frame.is_on_map = true;
    m_frame.x = t[0];
    m_frame.y = t[3];
    m_frame.x_step = t[1];
    m_frame.y_step = t[5];
  }

  std::string m_file;
  Dataset m_dataset;
  GDALRasterBandH m_band = nullptr;
  std::vector<GDALRasterBandH> m_masks;
  std::vector<double> m_mask_row;
  bool m_has_signed_bytes = false;
  int m_row = 0;
};

// Returns the system without heights.
System plane_system(const Map_system& system)
{
  System result(OSRNewSpatialReference(system.well_known.c_str()));
  if(result)
  {
    OSRStripVertical(result.get());
    OSRDemoteTo2D(result.get(), nullptr); // which leaves compound systems as they are
  }
  return result;
}

} // namespace

bool has_gdal() { return true; }

std::unique_ptr<Raster_reader> open_gdal(const std::string& file, const std::optional<int> band)
{
  return std::make_unique<Gdal_reader>(file, band);
}

Map_system system_of_prj(const std::string& file, const std::string& text)
{
  prepare_gdal();
  const System system(OSRNewSpatialReference(nullptr));
  std::vector<char> copy(text.begin(), text.end());
  copy.push_back('\0');
  char* lines[] = {copy.data(), nullptr};
  if(OSRImportFromESRI(system.get(), lines) != OGRERR_NONE)
    reject_raster(file, "it is not understood as a coordinate system");
  return read_system(file, system.get());
}

bool is_same_system(const Map_system& a, const Map_system& b)
{
  const System first = plane_system(a), second = plane_system(b);
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
  return first && second && OSRIsSameEx(first.get(), second.get(), options) != 0;
}

void write_geotiff(const std::string& place,
                   const std::string& name,
                   const Raster_frame& frame,
                   const std::string& unit,
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
  if(frame.is_on_map)
    GDALSetGeoTransform(dataset.get(), transform);
  GDALSetProjection(dataset.get(), frame.system.well_known.c_str());
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  GDALSetRasterNoDataValue(band, std::numeric_limits<double>::quiet_NaN());
  if(!unit.empty())
    GDALSetRasterUnitType(band, unit.c_str());
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
