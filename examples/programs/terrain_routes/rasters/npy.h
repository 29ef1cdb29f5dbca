#ifndef TERRAIN_ROUTES_RASTERS_NPY_H
#define TERRAIN_ROUTES_RASTERS_NPY_H

#include "../../command_line/files.h"
#include "Raster.h"

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <ostream>
#include <regex>
#include <string>
#include <vector>

// NumPy's files of arrays with two dimensions.

class Npy_reader : public Raster_reader
{
public:
  explicit Npy_reader(const std::string& file)
    : m_file(file), m_in(open_to_read(file, std::ios::binary))
  {
    const std::string header = read_header();
    read_shape(header);
    read_type(value(header, "descr", "'([<>|=]?)([fiu])([1248])'"));
    check_length();
  }

private:
  void read_stored_row(std::vector<double>& values) override
  {
    m_bytes.resize(m_frame.columns * m_size);
    if(!m_in.read(m_bytes.data(), static_cast<std::streamsize>(m_bytes.size())))
      reject_raster(m_file, "it ends too early");
    values.resize(m_frame.columns);
    for(std::size_t i = 0; i < values.size(); ++i)
      values[i] = m_number(m_bytes.data() + i * m_size);
  }

  std::string read_header()
  {
    char prefix[8];
    if(!m_in.read(prefix, 8) || std::string(prefix, 6) != "\x93NUMPY")
      reject_raster(m_file, "it is no NPY file");
    std::uint32_t length = 0;
    const std::size_t size_of_length = prefix[6] == 1 ? 2 : 4;
    char bytes[4] = {};
    m_in.read(bytes, static_cast<std::streamsize>(size_of_length));
    std::memcpy(&length, bytes, 4);
    boost::endian::little_to_native_inplace(length);
    constexpr std::uint32_t longest = 1 << 16;
    std::string result(length < longest ? length : 0, ' ');
    if(result.empty() || !m_in.read(result.data(), static_cast<std::streamsize>(length)))
      reject_raster(m_file, "its header is damaged");
    result.erase(result.find_last_not_of(" \n") + 1);
    return result;
  }

  std::smatch
  value(const std::string& header, const std::string& key, const std::string& pattern) const
  {
    std::smatch result;
    if(!std::regex_search(header, result, std::regex("'" + key + "': *" + pattern)))
      reject_raster(m_file, "it must be an array of real numbers with two dimensions: " + header);
    return result;
  }

  void read_shape(const std::string& header)
  {
    const std::smatch shape = value(header, "shape", R"(\((\d+), *(\d+)\))");
    m_frame.rows = std::strtoull(shape.str(1).c_str(), nullptr, 10); // the largest if it overflows
    m_frame.columns = std::strtoull(shape.str(2).c_str(), nullptr, 10);
    check_number_of_cells(m_file, m_frame);
    if(value(header, "fortran_order", "(True|False)")[1] == "True")
      reject_raster(m_file, "it holds columns one after the other; numpy.ascontiguousarray() makes "
                            "an array of rows");
  }

  template <typename T>
  void set_type(const bool is_big)
  {
    m_size = sizeof(T);
    m_number = [is_big](const char* const bytes) {
      char ordered[sizeof(T)];
      std::memcpy(ordered, bytes, sizeof(T));
      if(is_big != (boost::endian::order::native == boost::endian::order::big))
        std::reverse(ordered, ordered + sizeof(T));
      T result;
      std::memcpy(&result, ordered, sizeof(T));
      return static_cast<double>(result);
    };
  }

  void read_type(const std::smatch& type)
  {
    const bool is_big = type[1] == ">";
    const std::string kind = type[2].str() + type[3].str();
    m_values.type = kind;
    m_values.are_floats = kind == "f4";
    if(kind == "f8")
      set_type<double>(is_big);
    else if(kind == "f4")
      set_type<float>(is_big);
    else if(kind == "i1")
      set_type<std::int8_t>(is_big);
    else if(kind == "i2")
      set_type<std::int16_t>(is_big);
    else if(kind == "i4")
      set_type<std::int32_t>(is_big);
    else if(kind == "i8")
      set_type<std::int64_t>(is_big);
    else if(kind == "u1")
      set_type<std::uint8_t>(is_big);
    else if(kind == "u2")
      set_type<std::uint16_t>(is_big);
    else if(kind == "u4")
      set_type<std::uint32_t>(is_big);
    else if(kind == "u8")
      set_type<std::uint64_t>(is_big);
    else
      reject_raster(m_file, "numbers of the type " + kind + " cannot be read");
  }

  void check_length()
  {
    std::error_code error; // of pipes
    const std::uintmax_t size = std::filesystem::file_size(m_file, error);
    const std::uintmax_t expected =
        static_cast<std::uintmax_t>(m_in.tellg()) + m_frame.columns * m_frame.rows * m_size;
    if(!error && size != expected)
      reject_raster(m_file, "it has " + std::to_string(size) + " bytes in place of " +
                                std::to_string(expected));
  }

  std::string m_file;
  std::ifstream m_in;
  std::size_t m_size = 0; // of a number
  std::function<double(const char*)> m_number;
  std::vector<char> m_bytes; // of a row
};

// Writes doubles. `row(i)` returns the values of a row.
template <typename Row>
void write_npy(std::ostream& out, const Raster_frame& frame, const Row& row)
{
  constexpr std::size_t alignment = 64, size_of_prefix = 10;
  constexpr bool is_little = boost::endian::order::native == boost::endian::order::little;
  std::string header = std::string("{'descr': '") + (is_little ? '<' : '>') +
                       "f8', 'fortran_order': False, 'shape': (" + std::to_string(frame.rows) +
                       ", " + std::to_string(frame.columns) + "), }";
  header.append(alignment - 1 - (size_of_prefix + header.size()) % alignment, ' ');
  header += '\n';
  out << "\x93NUMPY\x01" << '\0' << static_cast<char>(header.size() % 256)
      << static_cast<char>(header.size() / 256) << header;
  for(std::size_t i = 0; i < frame.rows; ++i)
  {
    const std::vector<double>& values = row(i);
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(double)));
  }
}

#endif // TERRAIN_ROUTES_RASTERS_NPY_H
