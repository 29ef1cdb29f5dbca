#ifndef GEODESIC_DISTANCES_OPTIONS_H
#define GEODESIC_DISTANCES_OPTIONS_H

#include "../command_line/read_options.h"

#include <boost/program_options.hpp>

#include <cstdint>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

struct Options
{
  std::string input;
  std::vector<std::string> sources;
  std::vector<std::string> targets;
  bool is_along_edges = true; // no epsilon is given
  double epsilon = 0;
  double maximum_distance = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 0;
  std::string output;
  bool compares = false;
  bool draws = false;
  std::string view;
  bool asks_for_help = false;
};

inline boost::program_options::options_description describe_options(Options& options)
{
  namespace po = boost::program_options;
  po::options_description description("Options");
  po::options_description_easy_init add = description.add_options();
  add("help,h", po::bool_switch(&options.asks_for_help), "print this text");
  add("source,s", po::value(&options.sources)->multitoken()->value_name("V ..."),
      "where to start: indices of vertices, counted from 0 in the order of the file (unless the "
      "file had to be repaired), or random:K for K random ones (default: 0)");
  add("target,t", po::value(&options.targets)->multitoken()->value_name("V ..."),
      "where paths from the nearest source shall lead to, given likewise");
  add("epsilon,e", po::value(&options.epsilon)->value_name("E"),
      "let paths run across faces, and be at most 1 + E times as long as the shortest ones on the "
      "surface; 0 gives the shortest ones (default: along edges, without a bound)");
  add("maximum-distance,m", po::value(&options.maximum_distance)->value_name("D"),
      "do not go farther than this, in the unit of the mesh's coordinates");
  add("seed", po::value(&options.seed)->value_name("N"), "what random vertices depend on");
  add("compare,c", po::bool_switch(&options.compares),
      "compute the exact distances too, with CGAL's Surface_mesh_shortest_path and with epsilon 0, "
      "and print the errors; the former takes some seconds and a gigabyte for 40,000 vertices, and "
      "grows fast");
  add("output,o",
      po::value(&options.output)->default_value("geodesic_distances")->value_name("NAME"),
      "what the names of the files written begin with");
  add("picture,p", po::bool_switch(&options.draws),
      "draw the distances and the paths into NAME.png (needs xvfb-run and VTK for Python)");
  add("view", po::value(&options.view)->default_value("0 0 y")->value_name("VIEW"),
      "where the picture is seen from: azimuth and elevation in degrees, and the axis that points "
      "up");
  return description;
}

inline void print_help(const boost::program_options::options_description& description)
{
  std::cout
      << "Usage: geodesic_distances MESH [options]\n\n"
         "Finds the distance on a triangle mesh from the nearest of some source vertices to all\n"
         "other vertices, and the shortest paths to some targets: along edges, or across faces.\n\n"
         "MESH is in any format that CGAL reads (OFF, PLY, OBJ, STL, ...). A table is printed: "
         "the\n"
         "size of the mesh, the time taken, what the search did, and the range of the distances.\n"
         "Written are\n"
         "  NAME.ply            the mesh, with a distance (-1: not reached) and a color for "
         "every\n"
         "                      vertex, from blue (near) over green to red (far),\n"
         "  NAME.polylines.txt  a path per line: the number of points, then their coordinates,\n"
         "  NAME.vtk            all of it in one file, for ParaView and other viewers,\n"
         "  NAME.png            if asked for: a picture of it, with an isoline every 5 % of the\n"
         "                      largest distance.\n\n"
      << description
      << "\nExamples:\n"
         "  geodesic_distances bunny.off --epsilon 0.1 --target 1000 --compare --picture\n"
         "  geodesic_distances terrain.ply --source random:5 --seed 7 --maximum-distance 250\n";
}

inline Options parse_options(const int argc, char* argv[])
{
  Options options;
  const boost::program_options::options_description description = describe_options(options);
  const auto values = read_options(argc, argv, description, options.input);
  options.is_along_edges = values.count("epsilon") == 0;
  if(options.sources.empty())
    options.sources = {"0"};
  if(options.asks_for_help)
    print_help(description);
  return options;
}

#endif // GEODESIC_DISTANCES_OPTIONS_H
