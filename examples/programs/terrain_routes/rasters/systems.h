#ifndef TERRAIN_ROUTES_RASTERS_SYSTEMS_H
#define TERRAIN_ROUTES_RASTERS_SYSTEMS_H

#include "Raster.h"

#include <cpl_conv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

// Coordinate systems, as GDAL understands them. For gdal.cpp only.

struct Destroy_system
{
  void operator()(void* const system) const { OSRDestroySpatialReference(system); }
};

using System = std::unique_ptr<void, Destroy_system>;

inline std::string crs_of(OGRSpatialReferenceH system)
{
  const char* const name = OSRGetAuthorityName(system, nullptr);
  const char* const code = OSRGetAuthorityCode(system, nullptr);
  return name == nullptr || code == nullptr ? ""
                                            : std::string("urn:ogc:def:crs:") + name + "::" + code;
}

inline std::string well_known_text(OGRSpatialReferenceH system)
{
  const char* const options[] = {"FORMAT=WKT2", nullptr};
  char* text = nullptr;
  const bool is_done = OSRExportToWktEx(system, &text, options) == OGRERR_NONE;
  const std::string result = is_done && text != nullptr ? text : "";
  CPLFree(text);
  return result;
}

inline CGAL::Approximate_geodesics::Grid_ellipsoid ellipsoid_of(const std::string& file,
                                                                OGRSpatialReferenceH system)
{
  OGRErr error = OGRERR_NONE;
  const double radius = OSRGetSemiMajor(system, &error);
  const double inverse = OSRGetInvFlattening(system, nullptr);
  if(error != OGRERR_NONE || !(radius > 0))
    reject_raster(file, "its coordinate system is in degrees, and does not name the ellipsoid that "
                        "they are of");
  return {radius, inverse > 0 ? 1 / inverse : 0};
}

// Reads the unit of heights of a system of three coordinates.
inline void read_vertical(OGRSpatialReferenceH system, Map_system& result)
{
  if(OSRIsCompound(system) == 0)
    return;
  char* name = nullptr;
  const double meters = OSRGetTargetLinearUnits(system, "VERT_CS", &name);
  if(name != nullptr && meters > 0)
    result.unit_of_heights = length_unit(name).value_or(Length_unit{name, meters});
}

// Whether it stands for no system: GDAL has one of this kind for files that tell only whether their
// coordinates are those of centers.
inline bool is_blank(OGRSpatialReferenceH system)
{
  char* unit = nullptr;
  OSRGetLinearUnits(system, &unit);
  return OSRIsLocal(system) != 0 && unit != nullptr && EQUAL(unit, "unknown");
}

// Refuses a system of a kind that has no lengths, or that is not known to have any.
inline Map_system read_system(const std::string& file, OGRSpatialReferenceH system)
{
  Map_system result;
  if(is_blank(system))
    return result;
  const char* const name = OSRGetName(system);
  result.name = name != nullptr && *name != '\0' ? name : "unnamed";
  result.well_known = well_known_text(system);
  result.crs = crs_of(system);
  if(OSRIsGeographic(system) != 0)
  {
    if(OSRIsDerivedGeographic(system) != 0)
      reject_raster(file, "its coordinate system, " + result.name +
                              ", has another pole than the Earth; gdalwarp -t_srs EPSG:4326 "
                              "transforms it");
    result.is_geographic = true;
    constexpr double rounding = 1e-9;
    result.degrees = OSRGetAngularUnits(system, nullptr) * 180 / std::acos(-1.);
    if(std::abs(result.degrees - 1) < rounding)
      result.degrees = 1;
    result.ellipsoid = ellipsoid_of(file, system);
  }
  else if(OSRIsProjected(system) != 0 || OSRIsLocal(system) != 0)
  {
    char* unit = nullptr;
    const double meters = OSRGetLinearUnits(system, &unit);
    const std::string text = unit == nullptr ? "" : unit;
    const auto known = length_unit(text);
    result.unit = {known ? known->name : text, meters};
  }
  else
    reject_raster(file, "its coordinate system, " + result.name +
                            ", is neither geographic, nor projected, nor local");
  if(!(result.degrees > 0 && result.unit.meters > 0))
    reject_raster(file, "the unit of its coordinate system, " + result.name + ", has no size");
  read_vertical(system, result);
  return result;
}

// Adds to the range of ratios of lengths on a map to those on the ellipsoid: along both axes, at a
// place that is given by parts of the raster. `transformation` leads to longitudes and latitudes.
inline void add_stretch(const Raster_frame& frame,
                        OGRCoordinateTransformationH transformation,
                        const CGAL::Approximate_geodesics::Grid_ellipsoid& ellipsoid,
                        const double x_part,
                        const double y_part,
                        std::array<double, 2>& range)
{
  const double columns = x_part * static_cast<double>(frame.columns),
               rows = y_part * static_cast<double>(frame.rows);
  double x[] = {frame.x + columns * frame.x_step, 0, 0},
         y[] = {frame.y + rows * frame.y_step, 0, 0};
  x[1] = x[0] + frame.x_step, y[1] = y[0];
  x[2] = x[0], y[2] = y[0] + frame.y_step;
  if(OCTTransform(transformation, 3, x, y, nullptr) == 0)
    return;
  const double radians = std::acos(-1.) / 180, latitude = y[0] * radians;
  const double square =
      1 - ellipsoid.flattening * (2 - ellipsoid.flattening) * std::pow(std::sin(latitude), 2);
  const double across = ellipsoid.equatorial_radius / std::sqrt(square),
               along = across * std::pow(1 - ellipsoid.flattening, 2) / square;
  for(const int i : {1, 2})
  {
    const double on_map = std::abs(i == 1 ? frame.x_step : frame.y_step) * frame.system.unit.meters;
    const double longitude = std::remainder(x[i] - x[0], 360.); // the shorter way round
    const double ratio = on_map / std::hypot(longitude * radians * across * std::cos(latitude),
                                             (y[i] - y[0]) * radians * along);
    if(std::isfinite(ratio))
      range = {std::min(range[0], ratio), std::max(range[1], ratio)};
  }
}

// Whether the columns of a raster are all longitudes once, in the middle row.
inline bool is_round(const Raster_frame& frame, OGRCoordinateTransformationH transformation)
{
  const auto columns = static_cast<double>(frame.columns);
  const double middle = frame.y + 0.5 * static_cast<double>(frame.rows) * frame.y_step;
  double x[] = {frame.x, frame.x + frame.x_step, frame.x + columns * frame.x_step},
         y[] = {middle, middle, middle};
  if(OCTTransform(transformation, 3, x, y, nullptr) == 0)
    return false;
  constexpr double round = 360;
  const double cell = std::abs(std::remainder(x[1] - x[0], round));
  return std::abs(columns * cell - round) < 0.5 * cell &&
         std::abs(std::remainder(x[2] - x[0], round)) < 0.5 * cell;
}

// Reads that range at nine places of a raster, as far as they can be transformed, and whether it
// goes round.
inline void read_stretch(OGRSpatialReferenceH system, Raster_frame& frame)
{
  if(!frame.is_on_map || OSRIsProjected(system) == 0)
    return;
  const System geographic(OSRCloneGeogCS(system)), plane(OSRClone(system));
  if(!geographic)
    return;
  OSRSetAxisMappingStrategy(geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
  OSRSetAxisMappingStrategy(plane.get(), OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<void, void (*)(void*)> transformation(
      OCTNewCoordinateTransformation(plane.get(), geographic.get()),
      [](void* const t) { OCTDestroyCoordinateTransformation(t); });
  const double degrees = OSRGetAngularUnits(geographic.get(), nullptr) * 180 / std::acos(-1.);
  if(!transformation || !(std::abs(degrees - 1) < 1e-9))
    return;
  std::array<double, 2> range{std::numeric_limits<double>::infinity(), 0};
  for(const double x : {0., 0.5, 1.})
    for(const double y : {0., 0.5, 1.})
      add_stretch(frame, transformation.get(), ellipsoid_of("", geographic.get()), x, y, range);
  if(range[1] > 0)
    frame.stretch = range;
  frame.is_round = is_round(frame, transformation.get());
}

#endif // TERRAIN_ROUTES_RASTERS_SYSTEMS_H
