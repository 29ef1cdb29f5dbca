#ifndef GEODESIC_DISTANCES_PARSE_OPTIONS_H
#define GEODESIC_DISTANCES_PARSE_OPTIONS_H

#include "../command_line/read_options.h"
#include "Options.h"
#include "describe_options.h"

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Refuses options that are wrong, or that do not go together, before the mesh is read.

inline Levels
levels(const std::string& option, const std::vector<std::string>& texts, const bool may_be_negative)
{
  Levels result;
  for(const std::string& text : texts)
    if(text.rfind("count:", 0) == 0)
    {
      const double number = number_of(option, text.substr(6));
      if(!(number >= 1 && number <= 100000 && number == std::floor(number)) || texts.size() > 1)
        reject_option(option, text + ": a number from 1 to 100000 must follow, and no more");
      result.number = static_cast<std::size_t>(number);
    }
    else if(text.rfind("step:", 0) == 0)
    {
      const double step = number_of(option, text.substr(5));
      if(!(step > 0 && std::isfinite(step)) || texts.size() > 1)
        reject_option(option, text + ": a number above 0 must follow, and no more");
      result.step = step;
    }
    else if(may_be_negative && std::isfinite(number_of(option, text)))
      result.values.push_back(number_of(option, text));
    else
      result.values.push_back(number_from_0(option, text, false));
  return result;
}

inline void read_levels(const po::variables_map& values, Options& options)
{
  const auto read = [&](const char* const option, const bool may_be_negative) {
    return values.count(option) == 0
               ? Levels()
               : levels(option, values[option].as<std::vector<std::string>>(), may_be_negative);
  };
  options.isolines = read("isolines", options.is_signed);
  options.offsets = read("offset", false);
  for(const double offset : options.offsets.values)
    if(offset == 0)
      reject_option("offset", "a curve at distance 0 would be the source");
  if(options.offsets.are_given() && !(options.epsilon && *options.epsilon == 0))
    reject_option("offset", "these curves are exact, and need --epsilon 0");
}

inline void check_curve(const po::variables_map& values, const Options& options)
{
  if(options.curve.empty())
  {
    if(options.is_signed)
      reject_option("signed", "it is for --curve");
    return;
  }
  if(!values["sources"].defaulted())
    reject_option("curve", "it takes the place of --sources; both are given");
  if(options.compares)
    reject_option("compare", "CGAL's Surface_mesh_shortest_path knows no curves");
}

// The words may come as one, in quotes.
inline void read_view(const po::variables_map& values, Options& options)
{
  options.view = {"0", "0", "y"};
  if(values.count("view") == 0)
    return;
  if(!options.draws)
    reject_option("view", "it is for --picture");
  options.view.clear();
  for(const std::string& text : values["view"].as<std::vector<std::string>>())
  {
    std::istringstream words(text);
    for(std::string word; words >> word;)
      options.view.push_back(word);
  }
  if(options.view.size() != 3)
    reject_option("view", "it takes an azimuth, an elevation, and an axis, such as 30 20 z");
  for(std::size_t i = 0; i < 2; ++i)
    if(!std::isfinite(number_of("view", options.view[i])))
      reject_option("view", options.view[i] + " is not an angle");
  const std::string& axis = options.view[2];
  if(axis != "x" && axis != "y" && axis != "z")
    reject_option("view", "the axis that points up is \"" + axis + "\", and must be x, y or z");
}

// What goes with a bound only.
inline void check_costs(const Options& options)
{
  for(const auto& [name, value] :
      {std::pair<const char*, const std::string&>("weights", options.weights),
       {"barriers", options.barriers}})
    if(!value.empty() && !(options.epsilon && *options.epsilon > 0))
      reject_option(name, "it needs --epsilon E with E above 0");
  if(options.has_costs() && options.compares)
    reject_option("compare", "exact distances know neither weights nor barriers");
  for(const std::string& source : options.sources)
    if(options.compares && source.find(',') != std::string::npos)
      reject_option("compare", "the sources must be vertices: from points on edges, CGAL's "
                               "Surface_mesh_shortest_path can be wrong");
  if(!options.weights.empty() && options.straightens)
    reject_option("straighten", "cheapest paths in faces with weights are not straight");
  if(options.accepts_weaker_bound && !options.has_costs())
    reject_option("accept-weaker-bound",
                  "it is for --weights and --barriers; any other bound holds "
                  "on every mesh");
}

inline void check_graph_files(const Options& options)
{
  if(!options.graph_to_load.empty() && options.epsilon)
    reject_option("load-graph", "the graph has its own bound; leave out --epsilon");
  for(const auto& [name, value] :
      {std::pair<const char*, const std::string&>("load-graph", options.graph_to_load),
       {"save-graph", options.graph_to_save}})
    if(!value.empty() && options.has_costs())
      reject_option(name, "graphs with weights or barriers have no files");
  if(!options.graph_to_save.empty() && !options.graph_to_load.empty())
    reject_option("save-graph", "the graph of --load-graph has a file");
  if(!options.graph_to_save.empty() && !(options.epsilon && *options.epsilon > 0))
    reject_option("save-graph",
                  "it needs --epsilon E with E above 0; other graphs are quickly made");
}

inline void read_values(const po::variables_map& values, Options& options)
{
  const auto text = [&](const char* option) { return values[option].as<std::string>(); };
  if(values.count("epsilon") > 0)
    options.epsilon = error_bound("epsilon", text("epsilon"));
  if(values.count("maximum-distance") > 0)
    options.maximum_distance = number_from_0("maximum-distance", text("maximum-distance"), true);
  if(values.count("seed") > 0)
    options.seed = whole_number("seed", text("seed"), 0);
  read_levels(values, options);
  if(options.straightens && options.targets.empty())
    reject_option("straighten", "it is for the paths to --targets");
  read_view(values, options);
  const std::string colors = text("colors");
  if(colors != "rainbow" && colors != "uniform")
    reject_option("colors", '"' + colors + "\" is neither rainbow nor uniform");
  options.has_uniform_colors = colors == "uniform";
}

// The name of a file stands for those of all files, and asks for its own.
inline void read_output(const po::variables_map& values, Options& options)
{
  const auto ends_with = [&](const std::string& ending) {
    const bool result = options.output.size() > ending.size() &&
                        options.output.substr(options.output.size() - ending.size()) == ending &&
                        options.output[options.output.size() - ending.size() - 1] != '/';
    if(result)
      options.output.resize(options.output.size() - ending.size());
    return result;
  };
  const auto check = [](const bool is_given, const char* const text) {
    if(!is_given)
      reject_option("output", text);
  };
  if(ends_with(".csv"))
    options.writes_table = true;
  else if(ends_with(".png"))
    options.draws = true;
  else if(ends_with("_offsets.vtp") || ends_with("_offsets.polylines.txt"))
    check(values.count("offset") > 0, "offsets are the curves at --offset; there are none");
  else if(ends_with("_isolines.vtp"))
    check(values.count("isolines") > 0, "isolines are the lines at --isolines; there are none");
  else if(ends_with(".polylines.txt"))
    check(!options.targets.empty(), "polylines are the paths to --targets; there are none");
  else if(!ends_with("_paths.vtp") && !ends_with(".vtp"))
    ends_with(".ply");
}

inline Options parse_options(const int argc, char* argv[])
{
  Options options;
  const po::options_description description = describe_options(options);
  const auto values = read_options(argc, argv, description, options.input);
  if(options.asks_for_help)
    print_help(description);
  else
  {
    read_output(values, options);
    read_values(values, options);
    check_curve(values, options);
    check_costs(options);
    check_graph_files(options);
  }
  return options;
}

#endif // GEODESIC_DISTANCES_PARSE_OPTIONS_H
