#ifndef GEODESIC_DISTANCES_OUTPUT_FILES_H
#define GEODESIC_DISTANCES_OUTPUT_FILES_H

#include "../command_line/New_files.h"
#include "../command_line/read_options.h"
#include "Options.h"
#include "Places.h"
#include "picture.h"
#include "write_results.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

// The files that are written.
class Output_files
{
public:
  // Refuses to go on if one of them exists or could not be written, before anything is computed.
  explicit Output_files(const Options& options) : m_options(options)
  {
    const std::filesystem::path last = std::filesystem::path(options.output).filename();
    if(last.empty() || last == "." || last == "..")
      reject_option("output", '"' + options.output +
                                  "\" is no name that files can begin with; to write into a "
                                  "folder, add one, as in folder/bunny");
    if(options.draws)
      check_drawing_programs();
    for(const char* const ending : ALL_ENDINGS) // what is not written goes
      check_is_not_read(name(ending));
    if(!options.graph_to_save.empty())
    {
      check_is_not_read(options.graph_to_save);
      for(const char* const ending : ALL_ENDINGS)
        if(is_same(name(ending), options.graph_to_save))
          reject_option("save-graph", name(ending) + " is a file of --output, too");
      check("save-graph", options.graph_to_save);
    }
    for(const std::string& file : names())
      check("output", file);
    for(const std::string& file : names_of_others())
      if(std::filesystem::exists(file))
        m_removed.push_back(checked_to_be_removed(file));
  }

  // Writes all of them, or none. `save_graph(out)` writes the graph.
  template <typename SaveGraph>
  void write(const Mesh_of_file& mesh, const Results& results, const SaveGraph save_graph) const
  {
    const auto with = [&](const auto write_results) {
      return [&, write_results](std::ostream& out) { write_results(out, results); };
    };
    New_files files(m_options.overwrites);
    files.write(name(".ply"), [&](std::ostream& out) {
      write_ply(out, mesh.mesh, results, m_options.has_uniform_colors);
    });
    const std::string surface =
        files.write(name(".vtp"), [&](std::ostream& out) { write_vtp(out, mesh.mesh, results); });
    const std::string paths = files.write(name("_paths.vtp"), with(write_paths_vtp));
    if(!m_options.targets.empty())
      files.write(name(".polylines.txt"), with(write_polylines));
    if(m_options.isolines.are_given())
      files.write(name("_isolines.vtp"),
                  [&](std::ostream& out) { write_lines_vtp(out, results.isolines); });
    if(m_options.offsets.are_given())
    {
      files.write(name("_offsets.vtp"),
                  [&](std::ostream& out) { write_lines_vtp(out, results.offsets); });
      files.write(name("_offsets.polylines.txt"), with(write_offset_polylines));
    }
    if(m_options.writes_table)
      files.write(name(".csv"), [&](std::ostream& out) { write_csv(out, mesh, results); });
    if(!m_options.graph_to_save.empty())
      files.write(m_options.graph_to_save, save_graph);
    if(m_options.draws)
      draw_picture({surface, paths, files.add(name(".png"))}, m_options);
    for(const std::string& file : m_removed)
      files.remove(file);
    files.put_in_place();
  }

  void print(std::ostream& out) const
  {
    out << "\nWritten:";
    for(const std::string& file : names())
      out << ' ' << file;
    if(!m_options.graph_to_save.empty())
      out << ' ' << m_options.graph_to_save;
    out << '\n';
    for(const std::string& file : m_removed)
      out << "Removed, as it was of an earlier run: " << file << '\n';
  }

private:
  static constexpr std::array<const char*, 9> ALL_ENDINGS{".ply",
                                                          ".vtp",
                                                          "_paths.vtp",
                                                          ".polylines.txt",
                                                          "_isolines.vtp",
                                                          "_offsets.vtp",
                                                          "_offsets.polylines.txt",
                                                          ".csv",
                                                          ".png"};

  static bool is_same(const std::string& a, const std::string& b)
  {
    std::error_code ignored; // pipes have no path
    const auto path = [&](const std::string& file) {
      const std::filesystem::path result = std::filesystem::weakly_canonical(file, ignored);
      return result.empty() ? std::filesystem::path(file) : result;
    };
    return path(a) == path(b);
  }

  static bool contains(const std::vector<std::string>& files, const std::string& file)
  {
    return std::find(files.begin(), files.end(), file) != files.end();
  }

  void check_is_not_read(const std::string& file) const
  {
    std::vector<std::string> inputs{m_options.input, m_options.weights, m_options.barriers,
                                    m_options.graph_to_load};
    for(const auto& places : {m_options.sources, m_options.curve, m_options.targets})
      std::transform(places.begin(), places.end(), std::back_inserter(inputs),
                     Place_finder::file_of);
    for(const std::string& input : inputs)
      if(!input.empty() && is_same(file, input))
        reject_option("output", file + " is a file that is read");
  }

  void check(const char* const option, const std::string& file) const
  {
    if(std::filesystem::exists(file) && !m_options.overwrites)
      reject_option(option, file + " exists; --force replaces it");
    New_file::check(file);
  }

  // Other programs write pictures and tables, too.
  std::string checked_to_be_removed(const std::string& file) const
  {
    std::string line;
    if(file == name(".csv"))
      std::getline(std::ifstream(file), line);
    if(!std::filesystem::is_regular_file(file) || file == name(".png") ||
       (file == name(".csv") && line != HEADER_OF_CSV))
      reject_option("output", file +
                                  " exists, which this run does not write, and may be no file of "
                                  "an earlier run; move it, or choose another name");
    if(!m_options.overwrites)
      reject_option("output", file + " exists, of an earlier run; --force removes it");
    return file;
  }

  std::string name(const char* const ending) const { return m_options.output + ending; }

  std::vector<std::string> names() const
  {
    std::vector<std::string> result{name(".ply"), name(".vtp"), name("_paths.vtp")};
    if(!m_options.targets.empty())
      result.push_back(name(".polylines.txt"));
    if(m_options.isolines.are_given())
      result.push_back(name("_isolines.vtp"));
    if(m_options.offsets.are_given())
      result.insert(result.end(), {name("_offsets.vtp"), name("_offsets.polylines.txt")});
    if(m_options.writes_table)
      result.push_back(name(".csv"));
    if(m_options.draws)
      result.push_back(name(".png"));
    return result;
  }

  // Those that this call does not write: of an earlier run, they would pass for results of this
  // one.
  std::vector<std::string> names_of_others() const
  {
    std::vector<std::string> result;
    for(const char* const ending : ALL_ENDINGS)
      if(!contains(names(), name(ending)))
        result.push_back(name(ending));
    return result;
  }

  const Options& m_options;
  std::vector<std::string> m_removed;
};

#endif // GEODESIC_DISTANCES_OUTPUT_FILES_H
