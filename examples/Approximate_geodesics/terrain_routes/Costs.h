#ifndef TERRAIN_ROUTES_COSTS_H
#define TERRAIN_ROUTES_COSTS_H

#include "../command_line/Progress.h"
#include "../command_line/files.h"
#include "Options.h"
#include "rasters/Raster.h"
#include "rasters/raster_files.h"

#include <CGAL/Approximate_geodesics/Graphs/Grid_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Grid_shape.h>
#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Mapped_file.h>

#include <boost/crc.hpp>
#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/sync/file_lock.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

using CGAL::Approximate_geodesics::Grid_graph;
using CGAL::Approximate_geodesics::Grid_shape;
using CGAL::Approximate_geodesics::Grid_window;

// The costs of all cells, in memory or in a file of the work folder, and the graphs of windows.
class Costs
{
public:
  // Opens the raster.
  explicit Costs(const Options& options)
    : m_options(options),
      m_raster(open_raster(options.input, options.band)),
      m_frame(m_raster->frame())
  {
    if(options.no_data)
      m_frame.no_data = options.no_data;
    read_cell_size();
  }

  // Reads its values. No other member function may be called before, but for `frame()`.
  void read()
  {
    const std::string& folder = m_options.work_folder;
    if(!folder.empty())
      lock(folder);
    m_values = std::make_unique<Mapped_file>(folder.empty() ? "" : file(),
                                             size_of_row() * m_frame.rows, Mapped_file::Mode::NEW);
    read_rows();
    m_raster.reset();
  }

  const Raster_frame& frame() const { return m_frame; }
  const Grid_shape& shape() const { return m_shape; }

  // A text that tells them, and what paths follow from them, apart from others.
  std::string identity() const
  {
    std::ostringstream out;
    out.precision(17);
    out << std::hex << m_checksum << std::dec << ", cells of " << m_shape.cell_width << " by "
        << m_shape.cell_height << ", epsilon ";
    if(m_options.epsilon)
      out << *m_options.epsilon;
    else
      out << "none";
    return out.str();
  }

  Grid_graph operator()(const Grid_window& window) const
  {
    const Grid_shape shape{
        window.columns, window.rows, m_shape.cell_width, m_shape.cell_height, {}};
    std::vector<double> friction;
    friction.reserve(shape.number_of_cells());
    const auto part = m_values->part(window.first_row * size_of_row(), window.rows * size_of_row());
    for(std::size_t row = 0; row < window.rows; ++row)
    {
      const double* const first =
          part.data<const double>() + row * m_frame.columns + window.first_column;
      friction.insert(friction.end(), first, first + window.columns);
    }
    return m_options.epsilon
               ? Grid_graph(shape, friction, CGAL::parameters::epsilon(*m_options.epsilon))
               : Grid_graph(shape, friction);
  }

  // Calls `f(column, cost)` for the cells of a row.
  template <typename F>
  void for_each_cost(const std::size_t row, F f) const
  {
    const auto part = m_values->part(row * size_of_row(), size_of_row());
    for(std::size_t column = 0; column < m_frame.columns; ++column)
      f(column, part.data<const double>()[column]);
  }

  // Removes the file.
  void remove_file()
  {
    std::error_code ignored; // what is left does no harm
    if(!m_options.work_folder.empty())
      for(const std::string& name : {file(), lock_file(), m_options.work_folder})
        std::filesystem::remove(name, ignored);
  }

private:
  using Mapped_file = CGAL::Approximate_geodesics::internal::Mapped_file;

  std::string file() const { return m_options.work_folder + "/costs"; }
  std::string lock_file() const { return m_options.work_folder + "/in_use"; }
  std::uint64_t size_of_row() const { return m_frame.columns * sizeof(double); }

  void read_cell_size()
  {
    if(m_frame.is_in_degrees && !m_options.cell_size)
      reject_raster(m_options.input, "its coordinates are in degrees, so that lengths of paths are "
                                     "not known; --cell-size W,H gives cells a size in meters");
    m_shape = {
        m_frame.columns, m_frame.rows, std::abs(m_frame.x_step), std::abs(m_frame.y_step), {}};
    if(m_options.cell_size)
    {
      m_shape.cell_width = (*m_options.cell_size)[0];
      m_shape.cell_height = (*m_options.cell_size)[1];
    }
    for(const double size : {m_shape.cell_width, m_shape.cell_height})
      if(!(size > 0 && std::isfinite(size)))
        reject_raster(m_options.input, "its cells have no size above 0");
  }

  // Keeps other processes from writing there.
  void lock(const std::string& folder)
  {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if(error)
      fail_to("create", folder, error.value());
    std::ofstream(lock_file(), std::ios::app);
    try
    {
      boost::interprocess::file_lock(lock_file().c_str()).swap(m_lock);
      if(m_lock.try_lock())
        return;
    }
    catch(const boost::interprocess::interprocess_exception& e)
    {
      fail_to("write into", folder, e.get_native_error());
    }
    throw std::invalid_argument("--work-folder " + folder + ": another process works there");
  }

  void read_rows()
  {
    Progress progress("Reading the raster");
    std::vector<double> values;
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xffffffffffffffff, 0xffffffffffffffff, true, true>
        checksum;
    for(std::size_t row = 0; row < m_frame.rows; ++row)
    {
      progress.set_part(row, m_frame.rows);
      m_raster->read_row(values);
      for(std::size_t column = 0; column < m_frame.columns; ++column)
        values[column] = checked(values[column], column, row);
      checksum.process_bytes(values.data(), size_of_row());
      const auto part = m_values->part(row * size_of_row(), size_of_row());
      std::copy(values.begin(), values.end(), part.data<double>());
    }
    m_checksum = checksum.checksum();
  }

  double checked(const double value, const std::size_t column, const std::size_t row) const
  {
    if(m_frame.no_data &&
       (value == *m_frame.no_data || (std::isnan(value) && std::isnan(*m_frame.no_data))))
      return std::numeric_limits<double>::infinity();
    if(value >= 0)
      return value;
    std::ostringstream out;
    out << "the cost of cell " << column << ',' << row << " (column, row) is " << value
        << "; it must be a number that is not negative, or no data (see --no-data)";
    reject_raster(m_options.input, out.str());
  }

  const Options& m_options;
  std::unique_ptr<Raster_reader> m_raster; // until it has been read
  Raster_frame m_frame;
  Grid_shape m_shape;
  std::unique_ptr<Mapped_file> m_values; // infinity for cells that cannot be entered
  std::uint64_t m_checksum = 0;
  boost::interprocess::file_lock m_lock; // the system releases it when the process ends
};

#endif // TERRAIN_ROUTES_COSTS_H
