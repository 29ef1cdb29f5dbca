#ifndef TERRAIN_ROUTES_RASTERS_RASTER_H
#define TERRAIN_ROUTES_RASTERS_RASTER_H

#include "units.h"

#include <CGAL/Geodesic_grids/Grid_shape.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// What coordinates of a map are.
struct Map_system
{
  bool is_known() const { return !name.empty(); }

  std::string name;       // none if the file tells of no system
  std::string well_known; // in well-known text
  std::string crs;        // its name for GeoJSON, if it has one
  bool is_geographic = false;
  Length_unit unit{"", 1}; // of coordinates, if they are not angles
  double degrees = 1;      // of the unit of coordinates, if they are
  CGAL::Approximate_geodesics::Grid_ellipsoid ellipsoid;
  std::optional<Length_unit> unit_of_heights; // if the system has them
};

// What a file tells of a raster beside its values.
struct Raster_frame
{
  std::size_t columns = 0, rows = 0;

  // The map coordinates of the corner where the first row begins, and the steps from column to
  // column and from row to row: downward in files for images, so that the latter is negative.
  double x = 0, y = 0;
  double x_step = 1, y_step = 1;
  bool is_on_map = false; // else the steps are 1
  Map_system system;

  // The smallest and the largest ratio of lengths on the map to those on the ellipsoid, where a
  // projection tells.
  std::optional<std::array<double, 2>> stretch;
  bool is_round = false; // whether its columns are all longitudes, where a projection tells
};

// What the values of a raster are.
struct Raster_values
{
  std::string type;
  bool are_floats = false; // with the 32 bits of this type
  std::string band;        // such as "band 1 of 3", if there are several
  std::string unit;        // as the file has it
  double scale = 1, offset = 0;
  std::optional<double> no_data;
  std::string mask; // what hides cells, if anything does
  std::string note; // what else a reader should know
};

// The values of a raster, read row by row.
class Raster_reader
{
public:
  Raster_reader() = default;
  Raster_reader(const Raster_reader&) = delete;
  Raster_reader& operator=(const Raster_reader&) = delete;
  virtual ~Raster_reader() = default;

  const Raster_frame& frame() const { return m_frame; }
  const Raster_values& values() const { return m_values; }

  // Takes another value for no data than the file has.
  void set_no_data(const double value) { m_values.no_data = value; }

  // Reads the next row: values as they are meant, and whether cells have one.
  void read_row(std::vector<double>& values, std::vector<bool>& has_data)
  {
    using namespace CGAL::Approximate_geodesics::internal;
    read_stored_row(values);
    has_data.assign(values.size(), true);
    read_mask(has_data);
    const std::optional<double> no_data =
        m_values.are_floats ? no_data_of<float>(m_values.no_data) : m_values.no_data;
    for(std::size_t i = 0; i < values.size(); ++i)
    {
      has_data[i] = has_data[i] && !is_no_data(no_data, values[i]);
      values[i] = values[i] * m_values.scale + m_values.offset;
    }
  }

protected:
  // Reads the next row as it is in the file.
  virtual void read_stored_row(std::vector<double>& values) = 0;

  // Clears the elements of those cells of this row that a mask hides.
  virtual void read_mask(std::vector<bool>& /* is_visible */) {}

  Raster_frame m_frame;
  Raster_values m_values;
};

[[noreturn]] inline void reject_raster(const std::string& file, const std::string& reason)
{
  throw std::invalid_argument("cannot read a raster from " + file + ": " + reason);
}

// Refuses a raster without cells, or of a size that no memory could have.
inline void check_number_of_cells(const std::string& file, const Raster_frame& frame)
{
  constexpr std::size_t most = (std::numeric_limits<std::size_t>::max)() / sizeof(double);
  if(frame.columns == 0 || frame.rows == 0)
    reject_raster(file, "it has no cells");
  if(frame.rows > most / frame.columns)
    reject_raster(file, "it has too many cells: " + std::to_string(frame.columns) +
                            " columns and " + std::to_string(frame.rows) + " rows");
}

#endif // TERRAIN_ROUTES_RASTERS_RASTER_H
