#ifndef TERRAIN_ROUTES_RASTERS_DESCRIPTIONS_H
#define TERRAIN_ROUTES_RASTERS_DESCRIPTIONS_H

#include "Raster.h"

#include <CGAL/Geodesic_grids/Grid_shape.h>
#include <CGAL/Geodesic_grids/internal/Grid_metric.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>

// What was read, in words.

// Returns the extent of a raster along an axis of the map.
inline std::string
described_extent(const char* const axis, const double first, const double step, const std::size_t n)
{
  std::ostringstream out;
  out.precision(12);
  const double last = first + step * static_cast<double>(n);
  out << axis << " from " << std::min(first, last) << " to " << std::max(first, last);
  return out.str();
}

// Returns a line on the values of a raster.
inline std::string described_raster(const std::string& file,
                                    const Raster_reader& raster,
                                    const std::size_t number_without,
                                    const char* const role)
{
  const Raster_values& values = raster.values();
  std::ostringstream out;
  out.precision(12);
  out << file << ": " << role << ", " << values.type;
  if(!values.band.empty())
    out << ", " << values.band;
  if(values.scale != 1 || values.offset != 0)
    out << ", multiplied by " << values.scale << ", plus " << values.offset;
  if(!values.unit.empty())
    out << ", unit " << values.unit;
  if(!values.note.empty())
    out << "; " << values.note;
  out << "; " << number_without << " cells without data";
  const char* separator = " (by ";
  if(values.no_data)
  {
    out << separator << "the value " << *values.no_data;
    separator = ", and by ";
  }
  if(!values.mask.empty())
    out << separator << values.mask;
  out << (values.no_data || !values.mask.empty() ? ")\n" : "\n");
  return out.str();
}

// Returns lines on the map: its system, extent, and the size of cells.
inline std::string
described_map(const Raster_frame& frame,
              const CGAL::Approximate_geodesics::Grid_shape& shape,
              const CGAL::Approximate_geodesics::internal::Grid_metric::Sides& middle,
              const std::string& unit)
{
  const Map_system& system = frame.system;
  std::ostringstream out;
  out.precision(12);
  out << "Map: "
      << (system.is_known()      ? system.name
          : system.is_geographic ? "longitudes and latitudes on WGS 84"
          : frame.is_on_map      ? "no coordinate system"
                                 : "no map");
  if(frame.is_on_map)
    out << "; " << described_extent("x", frame.x, frame.x_step, frame.columns) << ", "
        << described_extent("y", frame.y, frame.y_step, frame.rows);
  if(system.is_geographic)
    out << (system.degrees == 1 ? " degrees" : " (not in degrees)");
  else if(!system.unit.name.empty())
    out << ' ' << system.unit.name;
  if(system.is_geographic)
    out << ", radius of the equator " << shape.ellipsoid.equatorial_radius << " m";
  if(shape.is_periodic)
    out << "; the first column follows the last one";
  const std::string in = with_blank(unit);
  out.precision(6);
  constexpr double worth_telling = 0.01;
  if(frame.stretch && std::max((*frame.stretch)[1] - 1, 1 - (*frame.stretch)[0]) > worth_telling)
    out << "\nProjection: lengths on the map are " << (*frame.stretch)[0] << " to "
        << (*frame.stretch)[1] << " times those on the ground";
  if(frame.is_round)
    out << "\nRound the Earth: no path leads from the last column to the first one, as coordinates "
           "are not in degrees";
  out << "\nCells: " << middle.width << in << " by " << middle.height << in
      << (shape.first_latitude ? " in the middle" : "")
      << (unit.empty() ? ", in the unit of the map"
          : !system.is_known() && !system.is_geographic && system.unit.name.empty()
              ? ", as they are taken for meters"
              : "")
      << '\n';
  return out.str();
}

// Returns a line on the unit of heights, and where it is from.
inline std::string described_heights(const Length_unit& unit, const bool is_told)
{
  return "Heights: in " + unit.name + (is_told ? "\n" : ", as no other unit is told\n");
}

#endif // TERRAIN_ROUTES_RASTERS_DESCRIPTIONS_H
