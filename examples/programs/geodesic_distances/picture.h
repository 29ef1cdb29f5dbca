#ifndef GEODESIC_DISTANCES_PICTURE_H
#define GEODESIC_DISTANCES_PICTURE_H

#include "../command_line/quoted_for_shell.h"
#include "../command_line/read_options.h"
#include "../command_line/script_file.h"
#include "Options.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

// What is drawn, and where to.
struct Picture
{
  std::string surface; // a VTP file
  std::string paths;   // another one
  std::string file;
};

// What the numbers are, and in which unit.
inline std::string title_of_distances(const Options& options)
{
  return options.weights.empty() ? "Distance, in the unit of the coordinates"
                                 : "Cost, weights times lengths in the unit of the coordinates";
}

// Draws with VTK, without a display.
inline void draw_picture(const Picture& picture, const Options& options)
{
  std::string command = "xvfb-run --auto-servernum /usr/bin/python3 " +
                        quoted_for_shell(script_file(DRAW_PICTURE_SCRIPT));
  for(const std::string& name : {picture.surface, picture.paths, picture.file})
    command += ' ' + quoted_for_shell(name);
  for(const std::string& word : options.view)
    command += ' ' + quoted_for_shell(word);
  command += options.has_uniform_colors ? " uniform" : " rainbow";
  command += ' ' + quoted_for_shell(title_of_distances(options));
  if(std::system(command.c_str()) != 0)
    throw std::runtime_error("no picture was drawn: what went wrong is told above");
}

// Refuses to draw without what is needed for it.
inline void check_drawing_programs()
{
  const auto fails = [](const char* const command) { return std::system(command) != 0; };
  if(fails("command -v xvfb-run >/dev/null"))
    reject_option("picture", "the program xvfb-run is needed (Debian: xvfb, xauth)");
  if(fails("/usr/bin/python3 -c 'import importlib.util, sys;"
           " sys.exit(importlib.util.find_spec(\"vtk\") is None)' 2>/dev/null"))
    reject_option("picture", "/usr/bin/python3 with VTK is needed (Debian: python3-vtk9)");
}

#endif // GEODESIC_DISTANCES_PICTURE_H
