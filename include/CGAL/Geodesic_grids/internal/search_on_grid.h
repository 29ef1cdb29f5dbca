// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_GRIDS_INTERNAL_SEARCH_ON_GRID_H
#define CGAL_GEODESIC_GRIDS_INTERNAL_SEARCH_ON_GRID_H

#include <CGAL/license/Geodesic_grids.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

// Searches between cells, for functions and for `Grid_solver`.

namespace CGAL::Approximate_geodesics::internal {

// Returns the seeds of a source, or of a range of sources.
template <typename Sources>
std::vector<Seed> seeds_of_cells(const Grid_graph& graph, const Sources& sources)
{
  if constexpr(std::is_convertible_v<const Sources&, Grid_cell>)
    return {Seed{graph.node(sources)}};
  else
  {
    std::vector<Seed> result;
    for(const Grid_cell& source : sources)
      result.push_back(name_in_message([&] { return name_in_list("source", result.size()); },
                                       [&] {
                                         return Seed{graph.node(source), 0, result.size()};
                                       }));
    return result;
  }
}

// Lets the points of a path follow each other: on a periodic grid, the last one is beyond the grid
// if the path leaves it, as no arc extends over half of the columns.
inline void unwind(const Grid_shape& shape, std::vector<Grid_point>& path)
{
  if(!shape.is_periodic)
    return;
  for(std::size_t i = 1; i < path.size(); ++i)
    path[i].x += shape.width() * std::round((path[i - 1].x - path[i].x) / shape.width());
}

// Runs an A* search, and returns the points of the path to `target`, from the source on; none if
// there is no path.
inline std::vector<Grid_point> find_path_on_grid(Propagation<Grid_graph>& search,
                                                 const std::vector<Seed>& seeds,
                                                 const double maximum_distance,
                                                 const Grid_graph::Node target)
{
  using Node = Grid_graph::Node;
  const Grid_graph& graph = search.graph();
  search.run_toward(seeds, Stop_rule{maximum_distance, {target}},
                    [&](const Node node) { return graph.lower_bound(node, target); });
  std::vector<Grid_point> result;
  if(search.is_reached(target))
    for(Node node = target; node != search.null_node; node = search.predecessor(node))
      result.push_back(graph.position(node));
  std::reverse(result.begin(), result.end());
  unwind(graph.shape(), result);
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_GRIDS_INTERNAL_SEARCH_ON_GRID_H
