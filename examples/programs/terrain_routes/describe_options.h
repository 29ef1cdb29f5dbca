#ifndef TERRAIN_ROUTES_DESCRIBE_OPTIONS_H
#define TERRAIN_ROUTES_DESCRIBE_OPTIONS_H

#include "../command_line/describe_option.h"
#include "Options.h"
#include "rasters/gdal.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <string>
#include <vector>

// The options as --help shows them, in groups.

inline po::options_description describe_raster(Options& options)
{
  po::options_description result = make_group("From where to where");
  po::options_description_easy_init add = result.add_options();
  add("sources,s", po::value(&options.sources)->multitoken()->value_name("P ..."),
      "where to start. P is x,y in the coordinates of the map; cell:C,R for a column and a row, "
      "counted from 0 in the order of the file; or file:NAME for a text file with a P per line, "
      "and comments after #");
  add("targets,t", po::value(&options.targets)->multitoken()->value_name("P ..."),
      "where paths from the cheapest source shall lead to, given likewise");
  add("band", text_option("N"),
      "the band to read of RASTER, or of --heights if that comes alone (default: 1)");
  add("no-data", text_option("V"),
      "the value of cells that cannot be entered, in place of the one that the files name: as it "
      "is "
      "stored, before scale and offset; nan is possible. An infinite friction, masks and alpha "
      "bands forbid cells, too");
  add("snap", po::bool_switch(&options.snaps),
      "move sources and targets that cannot be entered to the nearest cells that can be");
  add("unit", text_option("U"),
      "the unit of coordinates, in place of what the file says: m, km, dm, cm, mm, ft or us-ft");
  add("height-unit", text_option("U"),
      "likewise that of heights (default: what the file says; else that of coordinates, or m)");
  add("cell-size", text_option("W[,H]"),
      "width and height of a cell, in --unit or meters, in place of what the file says");
  add("degrees", po::bool_switch(&options.is_in_degrees),
      "coordinates are degrees of longitude and latitude, as for files that say so");
  return result;
}

inline po::options_description describe_costs(Options& options)
{
  po::options_description result = make_group("What paths cost");
  po::options_description_easy_init add = result.add_options();
  add("heights", po::value(&options.heights)->value_name("HEIGHTS"),
      "a raster of heights, with the cells of RASTER; paths are on the surface");
  add("cost", po::value(&options.cost)->default_value("length")->value_name("MODEL"),
      "what a unit of length costs, which friction multiplies: length; or, by the slope of "
      "HEIGHTS, hiking_time (Tobler) or naismith_time (Naismith, Langmuir), in seconds, or "
      "walking_energy (Minetti), in joules per kilogram. Without a known unit, coordinates are "
      "taken for meters then. Slopes that cost less in zigzags are climbed in zigzags. Where "
      "friction is 0, paths are not the shortest of those that cost the same");
  add("max-slope", text_option("S"),
      "use no lines that are steeper, uphill or downhill, than S units of height per horizontal "
      "unit, nor zigzags within a cell in their place; 0.3 is 30 %. Paths turn at centers of "
      "cells, and so can cross steeper slopes at an angle. Needs --heights");
  add("to-sources", po::bool_switch(&options.goes_to_sources),
      "let costs and paths be those of the ways to the sources");
  return result;
}

inline po::options_description describe_search(Options& options)
{
  po::options_description result = make_group("How to search");
  po::options_description_easy_init add = result.add_options();
  add("epsilon,e", text_option("E"),
      "let paths cost at most 1 + E times as much as the cheapest ones in the plane (default: 0.3 "
      "% too much where friction is equal, in all directions, without a bound where it changes). "
      "Not with --heights, nor in degrees");
  add("memory,m", text_option("SIZE"),
      "use no more memory than this, such as 500M or 2G; the rest is in --work-folder");
  add("work-folder,w", po::value(&options.work_folder)->value_name("DIR"),
      "where to keep what has been found, 20 bytes a cell, 8 more with two rasters, 12 more "
      "with --corridor, and more with --epsilon. If the program is killed or interrupted, the same "
      "call goes on from there. "
      "At the end, its files go");
  return result;
}

inline po::options_description describe_output(Options& options)
{
  po::options_description result = make_group("What to write");
  po::options_description_easy_init add = result.add_options();
  add("output,o", po::value(&options.output)->default_value("terrain_routes")->value_name("NAME"),
      "what the names of the files written begin with, such as folder/valley");
  add("force,f", po::bool_switch(&options.overwrites),
      "replace files that exist, and remove others of these names that an earlier call has "
      "written. They stay as they are if anything fails. A picture, which may be of another "
      "program, is never removed: the call is refused");
  add("back-links,b", po::bool_switch(&options.writes_back_links),
      "write the direction from where the path arrives at each cell");
  add("corridor,c", po::bool_switch(&options.writes_corridor),
      "write what the cheapest path between the sources and the targets costs that passes each "
      "cell, there and on from there");
  add("isochrones,i", texts_option("V ..."),
      "write lines of these costs; or, for count:K, of K that are spread evenly");
  add("csv", po::bool_switch(&options.writes_table), "write the paths as a table, too");
  add("picture,p", po::bool_switch(&options.draws), "draw a picture (needs gnuplot)");
  add("colors", po::value(&options.colors)->default_value("uniform")->value_name("NAME"),
      "the colors of costs in the picture: uniform, whose steps look equally large; or rainbow, "
      "from cold to hot");
  add("help,h", po::bool_switch(&options.asks_for_help),
      "print this text; --version prints the version");
  return result;
}

inline po::options_description describe_options(Options& options)
{
  po::options_description result;
  result.add(describe_raster(options)).add(describe_costs(options));
  result.add(describe_search(options)).add(describe_output(options));
  return result;
}

inline void print_help(const po::options_description& description)
{
  std::cout
      << "Usage: terrain_routes [RASTER] [--heights HEIGHTS] --sources P ... [options]\n\n"
         "Finds what the cheapest path from the nearest source to every cell of a raster costs, "
         "and\n"
         "the cheapest paths to some targets. Paths are not bound to 8 or 16 directions.\n\n"
         "RASTER has the friction of each cell: a cost per unit of length. HEIGHTS has its height. "
         "There\n"
         "is one of them, or both. They are NPY files, ASCII grids (.asc)"
      << (has_gdal() ? " or any rasters that GDAL reads,\nsuch as GeoTIFF.\n"
                     : ".\n(GeoTIFF needs GDAL, and this program was compiled without.)\n")
      << "Masks, values for no data, scales and units count. Lengths are in meters, as far as "
         "files "
         "tell\nwhat coordinates are. Columns of 360 degrees go round. What was read is told, with "
         "units.\n\n"
         "Written are rasters in the format of RASTER or as GeoTIFF, and lines as GeoJSON, in the\n"
         "coordinates of the map:\n"
         "  NAME_cost.tif              the costs; no data or infinity where no path leads to,\n"
         "  NAME_paths.geojson         for targets: the paths, as they are walked, with their "
         "costs "
         "and\n                             lengths on the surface,\n"
         "and, if asked for,\n"
         "  NAME_back_links.tif        in degrees clockwise from the first row; no data at "
         "sources,\n"
         "  NAME_corridor.tif          the costs of the best detours over each cell,\n"
         "  NAME_isochrones.geojson    lines of equal costs,\n"
         "  NAME_paths.csv             a line per point: target, x, y, length so far, and height,\n"
         "  NAME.png                   shaded heights, or friction in gray, isochrones and paths.\n"
      << description
      << "\nThe exit status is 1, with a message on standard error, if something was refused or\n"
         "failed, and else 0: that a target is not reached is an answer, too. Either all files "
         "are\n"
         "written, or none is.\n"
         "\nExamples:\n"
         "  terrain_routes friction.tif -s 412000,5301000 -t 420500,5307250 --picture\n"
         "  terrain_routes --heights dem.tif --cost hiking_time -s 7.66,45.98 -t 7.75,46.02 -i "
         "count:9 -p\n"
         "  terrain_routes friction.npy -s cell:0,0 -e 0.1 --isochrones count:20 --back-links\n"
         "  terrain_routes country.tif -s file:towns.txt --memory 2G --work-folder /scratch/work\n";
}

#endif // TERRAIN_ROUTES_DESCRIBE_OPTIONS_H
