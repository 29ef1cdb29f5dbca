#ifndef TERRAIN_ROUTES_RASTERS_RASTER_H
#define TERRAIN_ROUTES_RASTERS_RASTER_H

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// What a file tells of a raster beside its values.
struct Raster_frame
{
  std::size_t columns = 0, rows = 0;

  // The map coordinates of the corner where the first row begins, and the steps from column to
  // column and from row to row: downward in files for images, so that the latter is negative.
  double x = 0, y = 0;
  double x_step = 1, y_step = 1;

  std::optional<double> no_data;
  std::string projection; // in well-known text, if the file has one
  std::string crs;        // its name for GeoJSON, if it has one
  bool is_in_degrees = false;
  bool is_on_map = false; // else the steps are 1
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

  // Reads the next row.
  virtual void read_row(std::vector<double>& values) = 0;

protected:
  Raster_frame m_frame;
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
