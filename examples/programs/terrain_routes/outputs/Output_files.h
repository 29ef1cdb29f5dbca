#ifndef TERRAIN_ROUTES_OUTPUT_FILES_H
#define TERRAIN_ROUTES_OUTPUT_FILES_H

#include "../../command_line/New_file.h"
#include "../../command_line/New_files.h"
#include "../../command_line/read_options.h"
#include "../Answer.h"
#include "../Options.h"
#include "../rasters/raster_files.h"
#include "picture.h"
#include "write_lines.h"

#include <algorithm>
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
    if(!options.draws && std::filesystem::exists(name(".png")))
      reject_option("output", name(".png") +
                                  " exists, which this call does not write, and may be no file of "
                                  "an earlier call; move it, or choose another name");
    if(const std::vector<std::string> stale = stale_files(); !stale.empty() && !options.overwrites)
      reject_option("output", stale.front() + " is of an earlier call, and would stay beside what "
                                              "is written; --force removes it");
  }

  // Writes all of them, or none.
  void write(Answer& answer) const
  {
    New_files files(m_options.overwrites);
    const auto raster = [&](const char* const ending, const std::string& unit, const auto row) {
      write_raster(
          files, name(ending + m_raster), answer.frame(), unit,
          [&, row](const std::size_t i) -> const std::vector<double>& { return (answer.*row)(i); });
    };
    const auto lines = [&](const char* const ending, const auto write_lines) {
      files.write(name(ending), [&](std::ostream& out) { write_lines(out, answer); });
    };
    const std::string unit = answer.costs().unit_of_costs();
    raster("_cost", unit, &Answer::cost_row);
    if(m_options.writes_back_links)
      raster("_back_links", "degrees", &Answer::back_link_row);
    if(m_options.writes_corridor)
      raster("_corridor", unit, &Answer::corridor_row);
    if(!m_options.targets.empty())
      lines("_paths.geojson", write_routes);
    if(m_options.writes_table)
      lines("_paths.csv", write_route_table);
    if(m_options.has_isochrones())
      lines("_isochrones.geojson", write_isochrones);
    if(m_options.draws)
      draw_picture(m_options.output, files.add(name(".png")), m_options.colors, answer);
    for(const std::string& file : stale_files())
      files.remove(file);
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

  // Files that another call has written under this name, and this one does not replace.
  std::vector<std::string> stale_files() const
  {
    const std::vector<std::string> written = names();
    std::vector<std::string> result;
    const auto look_for = [&](const std::string& file) {
      if(std::filesystem::is_regular_file(file) && !is_same(file, m_options.friction) &&
         !is_same(file, m_options.heights) &&
         std::find(written.begin(), written.end(), file) == written.end())
        result.push_back(file);
    };
    for(const char* const raster : {"_cost", "_back_links", "_corridor"})
      for(const char* const ending : {".tif", ".asc", ".npy"})
        look_for(name(std::string(raster) + ending));
    for(const char* const ending : {"_paths.geojson", "_paths.csv", "_isochrones.geojson"})
      look_for(name(ending));
    return result;
  }

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
