#ifndef GEODESIC_DISTANCES_DESCRIBE_OPTIONS_H
#define GEODESIC_DISTANCES_DESCRIBE_OPTIONS_H

#include "../command_line/describe_option.h"
#include "Options.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <string>
#include <vector>

// The options as --help shows them, in groups.

inline po::options_description describe_points(Options& options)
{
  po::options_description result = make_group("From where to where");
  po::options_description_easy_init add = result.add_options();
  add("sources,s",
      po::value(&options.sources)->multitoken()->default_value({"0"}, "0")->value_name("P ..."),
      "where to start. P is the index of a vertex, counted from 0 in the order of the file, "
      "whatever had to be repaired in that; or "
      "x,y,z for the nearest point of the surface; random:K for K random vertices; or file:NAME "
      "for the vertices whose indices a text file lists, with comments after #");
  add("curve", po::value(&options.curve)->multitoken()->value_name("P ..."),
      "start from all points of a curve, in place of --sources: from a point to the next one, "
      "given "
      "likewise, it takes the shortest path; or polyline:NAME for the points of a file as the "
      "program writes them. It is closed if the last point is the first one");
  add("signed", po::bool_switch(&options.is_signed),
      "let distances be negative to the left of the curve, which has to be closed, or to end at "
      "borders");
  add("targets,t", po::value(&options.targets)->multitoken()->value_name("P ..."),
      "where paths from the nearest source shall lead to, given likewise. They begin at the "
      "source");
  add("seed", text_option("N"), "what random vertices depend on (default: 0)");
  return result;
}

inline po::options_description describe_paths(Options& options)
{
  po::options_description result = make_group("Which paths");
  po::options_description_easy_init add = result.add_options();
  add("epsilon,e", text_option("E"),
      "let paths run across faces, and be at most 1 + E times as long as the shortest ones on the "
      "surface, for E up to 1: 0.05 stands for 5 %; 0 gives the shortest ones (default: along "
      "edges, without a bound)");
  add("maximum-distance,m", text_option("D"),
      "do not go farther than this, in the unit of the mesh's coordinates");
  add("straighten", po::bool_switch(&options.straightens),
      "make the paths to the targets locally shortest ones");
  add("weights,w", po::value(&options.weights)->value_name("FILE"),
      "what a path costs per unit of length, in each face: a file with a number per face, in the "
      "order of the mesh's file; or property:NAME, a property of the faces in a PLY mesh. 0 makes "
      "a face "
      "free, inf forbidden. Distances are costs then; needs --epsilon");
  add("barriers,b", po::value(&options.barriers)->value_name("FILE"),
      "edges that paths may not cross: a file with the indices of two vertices per line; needs "
      "--epsilon");
  add("accept-weaker-bound", po::bool_switch(&options.accepts_weaker_bound),
      "with weights or barriers: accept faces that are too thin for the bound, and print the one "
      "that holds");
  add("save-graph", po::value(&options.graph_to_save)->value_name("FILE"),
      "write the graph that is searched, for --load-graph; for E above 0, without costs");
  add("load-graph", po::value(&options.graph_to_load)->value_name("FILE"),
      "read the graph in place of building it; takes the place of --epsilon");
  return result;
}

inline po::options_description describe_output(Options& options)
{
  po::options_description result = make_group("What to write");
  po::options_description_easy_init add = result.add_options();
  add("output,o",
      po::value(&options.output)->default_value("geodesic_distances")->value_name("NAME"),
      "what the names of the files written begin with, such as folder/bunny. One that ends like "
      "such "
      "a file, as bunny.ply or bunny.csv, stands for the part before, and asks for that file");
  add("force,f", po::bool_switch(&options.overwrites),
      "replace files that exist, and remove those of an earlier run that this one does not write. "
      "They stay as they are if anything fails. A picture, or a table of another program, is never "
      "removed: the run is refused");
  add("csv", po::bool_switch(&options.writes_table), "write NAME.csv, too");
  add("isolines,i", texts_option("D ..."),
      "write lines at these distances; or, for count:K, at K that are spread evenly; or, for "
      "step:D, at all multiples of D");
  add("offset", texts_option("D ..."),
      "write the curves at these exact distances from the sources, likewise; needs --epsilon 0");
  add("picture,p", po::bool_switch(&options.draws),
      "draw distances and paths into NAME.png (needs xvfb-run and VTK for Python)");
  add("colors", po::value<std::string>()->default_value("rainbow")->value_name("rainbow|uniform"),
      "the colors of NAME.ply and NAME.png, from near to far: from blue over green to red, or from "
      "dark violet to light yellow, in which equal differences look equal");
  add("view", texts_option("A E U"),
      "where the picture is seen from: azimuth and elevation in degrees, and the axis that points "
      "up (default: 0 0 y)");
  return result;
}

inline po::options_description describe_rest(Options& options)
{
  po::options_description result = make_group("Other options");
  po::options_description_easy_init add = result.add_options();
  add("help,h", po::bool_switch(&options.asks_for_help),
      "print this text; --version prints the version");
  add("statistics", po::bool_switch(&options.prints_statistics),
      "print what the search did: pops, relaxations, buckets");
  add("compare,c", po::bool_switch(&options.compares),
      "for sources that are vertices: compute the exact distances too, with CGAL's "
      "Surface_mesh_shortest_path and with epsilon 0, "
      "and print the errors; the former takes some seconds and a gigabyte for 40,000 vertices, and "
      "grows fast");
  return result;
}

inline po::options_description describe_options(Options& options)
{
  po::options_description result;
  result.add(describe_points(options)).add(describe_paths(options));
  result.add(describe_output(options)).add(describe_rest(options));
  return result;
}

inline void print_help(const po::options_description& description)
{
  std::cout
      << "Usage: geodesic_distances MESH [options]\n\n"
         "Finds the distance on a triangle mesh from the nearest source to every vertex, and the\n"
         "shortest paths to some targets: along edges, or across faces within an error bound.\n\n"
         "MESH is an OFF, OBJ, STL, PLY or GOCAD file. What is no surface in it is repaired, "
         "which\n"
         "is told. Vertices keep their numbers, and options take the faces of the file; written "
         "are\n"
         "the faces of the repaired mesh. Vertices in the same place have the same\n"
         "distance. Printed are the size of the mesh, the time taken, the range of the distances,\n"
         "and the length of the path to each target, in the unit of the coordinates. Written are\n"
         "  NAME.vtp             the mesh with distance and nearest_source of every vertex, for\n"
         "                       ParaView and f3d --scalars; NaN and -1 where no source reaches,\n"
         "  NAME.ply             the same for MeshLab and others: distance, also as quality, and\n"
         "                       a color,\n"
         "  NAME_paths.vtp       the sources as points, and the paths as lines with their "
         "lengths,\n"
         "                       from the source to the target,\n"
         "and, if asked for,\n"
         "  NAME.polylines.txt   for targets: a path per line, the number of points, then their\n"
         "                       coordinates; inf where there is no path,\n"
         "  NAME_isolines.vtp    the isolines with their distances,\n"
         "  NAME_offsets.vtp     the offset curves with their distances, the sources on their "
         "left,\n"
         "  NAME_offsets.polylines.txt   the same, a curve per line,\n"
         "  NAME.csv             a line per vertex of the file: index, coordinates, distance (inf\n"
         "                       where no source reaches), nearest_source,\n"
         "  NAME.png             a picture, with isolines at round distances.\n"
         "nearest_source is the position of the source among all --sources, counted from 0, as in\n"
         "NAME_paths.vtp, which has their names, too.\n"
      << description
      << "\nThe exit status is 1, with a message on standard error, if something was refused or\n"
         "failed, and else 0: that a target is not reached is an answer, too. Either all files "
         "are\n"
         "written, or none is.\n"
         "\nExamples:\n"
         "  geodesic_distances bunny.off --epsilon 0.1 --targets 1000 --compare --picture\n"
         "  geodesic_distances terrain.ply --sources random:5 --seed 7 --maximum-distance 250\n"
         "  geodesic_distances terrain.ply -s 0,0,0 -t 90,40,0 -e 0.1 --weights costs.txt\n"
         "  geodesic_distances bunny.off --epsilon 0 --isolines count:20 --csv\n"
         "  geodesic_distances part.stl --curve 3 14 15 3 --signed --epsilon 0 --offset step:0.5\n";
}

#endif // GEODESIC_DISTANCES_DESCRIBE_OPTIONS_H
