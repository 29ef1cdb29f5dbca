#ifndef TERRAIN_ROUTES_RASTERS_ASCII_GRID_H
#define TERRAIN_ROUTES_RASTERS_ASCII_GRID_H

#include "../../command_line/files.h"
#include "Raster.h"
#include "gdal.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The text format of ESRI: names and numbers, one pair a line, then values.

class Ascii_grid_reader : public Raster_reader
{
public:
  explicit Ascii_grid_reader(const std::string& file) : m_file(file), m_in(open_to_read(file))
  {
    std::map<std::string, double> header;
    std::string word, text;
    while(m_in >> word && is_name(word))
    {
      m_in >> text;
      header[word] = number(text, word);
    }
    if(m_in)
      m_first_value = word;
    read(header);
    read_system();
    m_values.type = "text";
  }

private:
  // Lets a name be lowercase. What else is there is a value: nan and inf are, too.
  static bool is_name(std::string& text)
  {
    static const std::set<std::string> names{"ncols",     "nrows",       "xllcorner", "yllcorner",
                                             "xllcenter", "yllcenter",   "cellsize",  "dx",
                                             "dy",        "nodata_value"};
    std::string name = text;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if(names.count(name) == 0)
      return false;
    text = name;
    return true;
  }

  void read_stored_row(std::vector<double>& values) override
  {
    values.clear(); // and has as many values as come, whatever the header says
    while(values.size() < m_frame.columns)
    {
      std::string text = std::exchange(m_first_value, "");
      if(text.empty() && !(m_in >> text))
        reject_raster(m_file, "it ends in row " + std::to_string(m_row) + " of " +
                                  std::to_string(m_frame.rows));
      values.push_back(number(text, "row " + std::to_string(m_row)));
    }
    ++m_row;
    std::string more;
    if(m_row == m_frame.rows && m_in >> more)
      reject_raster(m_file, "it has more values than cells");
  }

  double number(const std::string& text, const std::string& place) const
  {
    char* end = nullptr;
    const double result = std::strtod(text.c_str(), &end);
    if(text.empty() || *end != '\0')
      reject_raster(m_file, place + ": \"" + text + "\" is not a number");
    return result;
  }

  // The file gives the corner where the last row begins, or the center of its first cell.
  void read(const std::map<std::string, double>& header)
  {
    const auto has = [&](const char* name) { return header.count(name) > 0; };
    const auto value = [&](const char* name) {
      if(!has(name))
        reject_raster(m_file, std::string("its header has no ") + name);
      return header.at(name);
    };
    const auto size = [&](const char* name) {
      const double result = value(name);
      if(!(result >= 1 && result < 4294967296. && result == std::floor(result)))
        reject_raster(m_file, std::string(name) + " is not a number of cells");
      return static_cast<std::size_t>(result);
    };
    m_frame.is_on_map = true;
    m_frame.columns = size("ncols");
    m_frame.rows = size("nrows");
    m_frame.x_step = has("dx") ? value("dx") : value("cellsize");
    m_frame.y_step = -(has("dy") ? value("dy") : value("cellsize"));
    m_frame.x = has("xllcenter")   ? value("xllcenter") - m_frame.x_step / 2
                : has("xllcorner") ? value("xllcorner")
                                   : 0;
    const double bottom = has("yllcenter")   ? value("yllcenter") + m_frame.y_step / 2
                          : has("yllcorner") ? value("yllcorner")
                                             : 0;
    m_frame.y = bottom - static_cast<double>(m_frame.rows) * m_frame.y_step;
    if(has("nodata_value"))
      m_values.no_data = value("nodata_value");
  }

  // Such files have their coordinate systems beside them.
  void read_system()
  {
    const std::string prj = std::filesystem::path(m_file).replace_extension(".prj").string();
    if(!std::filesystem::exists(prj))
      return;
    std::ifstream in = open_to_read(prj);
    m_frame.system = system_of_prj(prj, {std::istreambuf_iterator<char>(in), {}});
  }

  std::string m_file;
  std::ifstream m_in;
  std::string m_first_value; // which has ended the header
  std::size_t m_row = 0;
};

// Infinity becomes -9999, which stands for no data. `row(i)` returns the values of a row.
template <typename Row>
void write_ascii_grid(std::ostream& out, const Raster_frame& frame, const Row& row)
{
  const double height = std::abs(frame.y_step);
  out << "ncols " << frame.columns << "\nnrows " << frame.rows << "\nxllcorner " << frame.x
      << "\nyllcorner " << frame.y + static_cast<double>(frame.rows) * frame.y_step << '\n';
  if(frame.x_step == height)
    out << "cellsize " << height << '\n';
  else
    out << "dx " << frame.x_step << "\ndy " << height << '\n';
  out << "NODATA_value -9999\n";
  for(std::size_t i = 0; i < frame.rows; ++i)
  {
    const char* separator = "";
    for(const double value : row(i))
    {
      out << separator << (std::isfinite(value) ? value : -9999);
      separator = " ";
    }
    out << '\n';
  }
}

#endif // TERRAIN_ROUTES_RASTERS_ASCII_GRID_H
