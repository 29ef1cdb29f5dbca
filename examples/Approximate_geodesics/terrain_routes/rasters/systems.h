#ifndef TERRAIN_ROUTES_RASTERS_SYSTEMS_H
#define TERRAIN_ROUTES_RASTERS_SYSTEMS_H

#include "Raster.h"

#include <cpl_conv.h>
#include <ogr_srs_api.h>

#include <cmath>
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
    result.unit_of_heights = Length_unit{name, meters};
}

// Refuses a system of a kind that has no lengths, or that is not known to have any.
inline Map_system read_system(const std::string& file, OGRSpatialReferenceH system)
{
  Map_system result;
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

#endif // TERRAIN_ROUTES_RASTERS_SYSTEMS_H
