#ifndef TERRAIN_ROUTES_SEARCH_H
#define TERRAIN_ROUTES_SEARCH_H

#include "../command_line/Interruption.h"
#include "../command_line/Progress.h"
#include "../command_line/read_options.h"
#include "Costs.h"
#include "Options.h"

#include <CGAL/Approximate_geodesics/Grid_files/Tiled_grid_search.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

using CGAL::Approximate_geodesics::Grid_cell;
using CGAL::Approximate_geodesics::Grid_place;

// The number of columns and rows of tiles that the memory suffices for.
inline std::size_t side_of_tiles(const Costs& costs, const Options& options)
{
  constexpr double of_program = 24 << 20, of_cell = 160, of_height = 32, of_node = 140;
  constexpr std::size_t least = 32, most = 2048; // searches of larger ones are not faster
  if(options.work_folder.empty())
    return std::max(costs.shape().columns, costs.shape().rows);
  if(options.memory == 0)
    return most;
  constexpr double number_of_corners = 4;
  const double nodes_of_cell =
      static_cast<double>(costs.graph({0, 0, 1, 1}, false).number_of_nodes() - 1) /
      number_of_corners;
  const double size_of_cell =
      of_cell + (costs.has_heights() ? of_height : 0) + of_node * nodes_of_cell;
  const auto margins = static_cast<double>(2 * (Grid_graph::largest_reach() + 1)); // of tiles
  const double side =
      std::sqrt(std::max(0., static_cast<double>(options.memory) - of_program) / size_of_cell) -
      margins;
  if(side < static_cast<double>(least))
    reject_option("memory",
                  "it is too little; " +
                      std::to_string(static_cast<std::size_t>(
                                         of_program + size_of_cell * std::pow(least + margins, 2)) /
                                         (1 << 20) +
                                     1) +
                      "M are needed");
  return std::min(most, static_cast<std::size_t>(side));
}

// A search from some cells, in memory, or in files that a later call resumes from.
class Search : public CGAL::Approximate_geodesics::Tiled_grid_search<Graph_of_window>
{
public:
  // `name` is that of a folder within the work folder.
  Search(const Graph_of_window& graphs,
         const Options& options,
         const std::vector<Grid_cell>& sources,
         const std::string& name)
    : Tiled_grid_search(graphs.costs.shape().columns,
                        graphs.costs.shape().rows,
                        graphs,
                        sources,
                        side_of_tiles(graphs.costs, options),
                        options.work_folder.empty() ? "" : options.work_folder + '/' + name,
                        graphs.costs.identity() + (graphs.goes_to_sources ? ", backward" : ""),
                        graphs.costs.shape().is_periodic)
  {
    work("Searching", [&](Visitor& visitor) { return run(visitor); });
    if(options.writes_back_links || !options.targets.empty())
      work("Ordering ties", [&](Visitor& visitor) { return order_ties(visitor); });
  }

private:
  struct Visitor : CGAL::Approximate_geodesics::Geodesic_visitor_base
  {
    void on_progress(const std::size_t done, const std::size_t all) const
    {
      progress->set_part(done, all);
    }

    static bool go_further() { return Interruption::signal() == 0; }

    Progress* progress = nullptr;
  };

  // In memory, there is nothing to keep if the user interrupts the program.
  template <typename F>
  void work(const char* const what, const F& f)
  {
    Progress progress(what);
    Visitor visitor;
    visitor.progress = &progress;
    std::optional<Interruption> interruption;
    if(number_of_tiles() > 1)
      interruption.emplace();
    if(f(visitor))
      return;
    std::cerr << "The same call goes on from here.\n";
    Interruption::check();
  }
};

#endif // TERRAIN_ROUTES_SEARCH_H
