#ifndef TERRAIN_ROUTES_CELL_VALUES_H
#define TERRAIN_ROUTES_CELL_VALUES_H

#include "../command_line/Progress.h"
#include "rasters/Raster.h"

#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Mapped_file.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

using CGAL::Approximate_geodesics::Grid_window;

// The values of a raster, in memory or in a file.
class Cell_values
{
public:
  // Reads them, multiplies them by `unit`, and keeps `no_data` for cells without a value.
  // `check(value, column, row)` refuses others that are wrong. An empty name of a file stands for
  // memory.
  template <typename Check>
  Cell_values(Raster_reader& raster,
              const std::string& file,
              const double unit,
              const double no_data,
              const Check& check)
    : m_columns(raster.frame().columns),
      m_file_name(file),
      m_file(file, m_columns * raster.frame().rows * sizeof(double), Mapped_file::Mode::NEW)
  {
    Progress progress("Reading the raster");
    const std::size_t rows = raster.frame().rows;
    std::vector<double> values;
    std::vector<bool> has_data;
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xffffffffffffffff, 0xffffffffffffffff, true, true>
        checksum;
    for(std::size_t row = 0; row < rows; ++row)
    {
      progress.set_part(row, rows);
      raster.read_row(values, has_data);
      for(std::size_t column = 0; column < m_columns; ++column)
      {
        values[column] = has_data[column] ? values[column] * unit : no_data;
        m_number_without += has_data[column] ? 0 : 1;
        if(has_data[column])
          check(values[column], column, row);
      }
      checksum.process_bytes(values.data(), size_of_row());
      const auto part = m_file.part(row * size_of_row(), size_of_row());
      std::copy(values.begin(), values.end(), part.template data<double>());
    }
    m_checksum = checksum.checksum();
  }

  std::uint64_t checksum() const { return m_checksum; }

  // Returns the number of cells without a value.
  std::size_t number_without() const { return m_number_without; }

  // Returns the values of a window, row by row. After the last column, the first one follows.
  std::vector<double> window(const Grid_window& window) const
  {
    std::vector<double> result;
    result.reserve(window.columns * window.rows);
    const auto part = m_file.part(window.first_row * size_of_row(), window.rows * size_of_row());
    for(std::size_t row = 0; row < window.rows; ++row)
    {
      const double* const first = part.data<const double>() + row * m_columns;
      for(std::size_t done = 0, column = window.first_column; done < window.columns; column = 0)
      {
        const std::size_t number = std::min(window.columns - done, m_columns - column);
        result.insert(result.end(), first + column, first + column + number);
        done += number;
      }
    }
    return result;
  }

  // Returns the values of a row.
  std::vector<double> row(const std::size_t row) const { return window({0, row, m_columns, 1}); }

  void remove_file() const
  {
    std::error_code ignored; // what is left does no harm
    if(!m_file_name.empty())
      std::filesystem::remove(m_file_name, ignored);
  }

private:
  using Mapped_file = CGAL::Approximate_geodesics::internal::Mapped_file;

  std::uint64_t size_of_row() const { return m_columns * sizeof(double); }

  std::size_t m_columns;
  std::string m_file_name;
  Mapped_file m_file;
  std::uint64_t m_checksum = 0;
  std::size_t m_number_without = 0;
};

#endif // TERRAIN_ROUTES_CELL_VALUES_H
