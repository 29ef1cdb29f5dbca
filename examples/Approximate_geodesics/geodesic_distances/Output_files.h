#ifndef GEODESIC_DISTANCES_OUTPUT_FILES_H
#define GEODESIC_DISTANCES_OUTPUT_FILES_H

#include "../command_line/files.h"
#include "../command_line/read_options.h"
#include "Options.h"
#include "picture.h"
#include "write_results.h"

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

// The files that are written.
class Output_files
{
public:
  // Refuses to go on if one of them exists or could not be written, before anything is computed.
  explicit Output_files(const Options& options) : m_options(options)
  {
    if(options.draws)
      check_drawing_programs();
    for(const std::string& file : names())
    {
      if(std::filesystem::exists(file) && !options.overwrites)
        reject_option("output", file + " exists; --force overwrites it");
      if(std::filesystem::exists(options.input) && std::filesystem::exists(file) &&
         std::filesystem::equivalent(options.input, file))
        reject_option("output", file + " is the mesh that is read");
      check_writable(file);
    }
  }

  // but for the graph, which is written when it is built
  void write(const Mesh& mesh, const Results& results) const
  {
    write_ply(name(".ply"), mesh, results);
    write_vtp(name(".vtp"), mesh, results);
    write_paths_vtp(name("_paths.vtp"), results);
    if(!m_options.targets.empty())
      write_polylines(name(".polylines.txt"), results);
    if(m_options.has_isolines())
      write_isolines_vtp(name("_isolines.vtp"), results);
    if(m_options.writes_table)
      write_csv(name(".csv"), mesh, results);
    if(m_options.draws)
      draw_picture(m_options.output, m_options.view);
  }

  void print(std::ostream& out) const
  {
    out << "\nWritten:";
    for(const std::string& file : names())
      out << ' ' << file;
    out << '\n';
  }

private:
  std::string name(const char* const ending) const { return m_options.output + ending; }

  std::vector<std::string> names() const
  {
    std::vector<std::string> result{name(".ply"), name(".vtp"), name("_paths.vtp")};
    if(!m_options.targets.empty())
      result.push_back(name(".polylines.txt"));
    if(m_options.has_isolines())
      result.push_back(name("_isolines.vtp"));
    if(m_options.writes_table)
      result.push_back(name(".csv"));
    if(m_options.draws)
      result.push_back(name(".png"));
    if(!m_options.graph_to_save.empty())
      result.push_back(m_options.graph_to_save);
    return result;
  }

  const Options& m_options;
};

#endif // GEODESIC_DISTANCES_OUTPUT_FILES_H
