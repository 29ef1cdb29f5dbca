#ifndef GEODESIC_DISTANCES_OPTIONS_H
#define GEODESIC_DISTANCES_OPTIONS_H

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// At which distances lines are wanted.
struct Levels
{
  std::vector<double> values;
  std::optional<std::size_t> number; // that are spread evenly
  std::optional<double> step;        // all multiples of it

  bool are_given() const { return number || step || !values.empty(); }
};

// What the user wants.
struct Options
{
  std::string input;
  std::vector<std::string> sources;
  std::vector<std::string> curve; // in place of sources, unless it is empty
  bool is_signed = false;
  std::vector<std::string> targets;
  std::uint64_t seed = 0;

  std::optional<double> epsilon; // none: along edges
  double maximum_distance = std::numeric_limits<double>::infinity();
  bool straightens = false;
  std::string weights;
  std::string barriers;
  bool accepts_weaker_bound = false;
  std::string graph_to_load;
  std::string graph_to_save;

  std::string output;
  bool overwrites = false;
  bool writes_table = false;
  Levels isolines;
  Levels offsets;
  bool draws = false;
  bool has_uniform_colors = false;
  std::vector<std::string> view; // azimuth, elevation, axis
  bool compares = false;
  bool prints_statistics = false;
  bool asks_for_help = false;

  bool has_costs() const { return !weights.empty() || !barriers.empty(); }
};

#endif // GEODESIC_DISTANCES_OPTIONS_H
