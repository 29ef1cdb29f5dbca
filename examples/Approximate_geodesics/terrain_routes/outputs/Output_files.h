#ifndef TERRAIN_ROUTES_OUTPUT_FILES_H
#define TERRAIN_ROUTES_OUTPUT_FILES_H

#include "../command_line/New_file.h"
#include "../command_line/New_files.h"
#include "../command_line/read_options.h"
#include "Answer.h"
#include "Options.h"
#include "picture.h"
#include "rasters/raster_files.h"
#include "write_lines.h"

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

// The files that are written.
class Output_files
{
public:
  // Refuses to go on if one of them exists or could not be written, before anything is computed.
  explicit Output_files(const Options& options)
    : m_options(options), m_raster(ending_of_outputs(options.main_raster()))
  {
    const std::filesystem::path last = std::filesystem::path(options.output).filename();
    if(last.empty() || last == "." || last == "..")
      reject_option("output", '"' + options.output +
                                  "\" is no name that files can begin with; to write into a "
                                  "folder, add one, as in folder/valley");
    if(m_raster == ".tif" && !has_gdal())
      open_gdal(options.main_raster(), 1); // refuses that
    if(options.draws)
      check_drawing_programs();
    for(const std::string& file : names())
      check(file);
  }

  // Writes all of them, or none.
  void write(Answer& answer) const
  {
    New_files files(m_options.overwrites);
    const auto raster = [&](const char* const ending, const auto row) {
      write_raster(
          files, name(ending + m_raster), answer.frame(),
          [&, row](const std::size_t i) -> const std::vector<double>& { return (answer.*row)(i); });
    };
    const auto lines = [&](const char* const ending, const auto write_lines) {
      files.write(name(ending), [&](std::ostream& out) { write_lines(out, answer); });
    };
    raster("_cost", &Answer::cost_row);
    if(m_options.writes_back_links)
      raster("_back_links", &Answer::back_link_row);
    if(m_options.writes_corridor)
      raster("_corridor", &Answer::corridor_row);
    if(!m_options.targets.empty())
      lines("_paths.geojson", write_routes);
    if(m_options.writes_table)
      lines("_paths.csv", write_route_table);
    if(m_options.has_isochrones())
      lines("_isochrones.geojson", write_isochrones);
    if(m_options.draws)
      draw_picture(m_options.output, files.add(name(".png")), answer);
    files.put_in_place();
  }

  void print(std::ostream& out) const
  {
    out << "\nWritten:";
    for(const std::string& file : names())
      out << ' ' << file;
    out << '\n';
  }

private:
  static bool is_same(const std::string& a, const std::string& b)
  {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(a, ignored) ==
           std::filesystem::weakly_canonical(b, ignored);
  }

  void check(const std::string& file) const
  {
    if(is_same(file, m_options.friction) || is_same(file, m_options.heights))
      reject_option("output", file + " is a file that is read");
    if(std::filesystem::exists(file) && !m_options.overwrites)
      reject_option("output", file + " exists; --force replaces it");
    New_file::check(file);
  }

  std::string name(const std::string& ending) const { return m_options.output + ending; }

  std::vector<std::string> names() const
  {
    std::vector<std::string> result{name("_cost" + m_raster)};
    if(m_options.writes_back_links)
      result.push_back(name("_back_links" + m_raster));
    if(m_options.writes_corridor)
      result.push_back(name("_corridor" + m_raster));
    if(!m_options.targets.empty())
      result.push_back(name("_paths.geojson"));
    if(m_options.writes_table)
      result.push_back(name("_paths.csv"));
    if(m_options.has_isochrones())
      result.push_back(name("_isochrones.geojson"));
    if(m_options.draws)
      result.push_back(name(".png"));
    return result;
  }

  const Options& m_options;
  std::string m_raster; // the ending of names of rasters
};

#endif // TERRAIN_ROUTES_OUTPUT_FILES_H
