// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_FIRST_PREDECESSORS_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_FIRST_PREDECESSORS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Tile_graph.h>

#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Makes a graph report all arcs that attain labels. Graphs leave out arcs back to where a path
// comes from, and those that cannot lower a label, which does not hold of any arc if labels are
// doubled.
template <typename Node>
struct Doubled_labels
{
  double distance(const Node node) const { return 2 * labels[node]; }
  Node predecessor(Node /* node */) const { return null_node; }

  const std::vector<double>& labels;
  Node null_node;
};

/*
 * Returns, for the nodes of a tile, the first of the nodes of its window, in the order of places,
 * that have smaller labels and an arc that attains the label of the node. It is `null_node` if
 * there is none: for sources, and where the cost of the last arc is zero, or vanishes in rounding.
 */
template <typename Graph>
std::vector<typename Graph::Node> first_predecessors(const Tile_graph<Graph>& tile,
                                                     const std::vector<double>& labels)
{
  using Node = typename Graph::Node;
  constexpr Node null_node = Tile_graph<Graph>::null_node;
  std::vector<Node> result(labels.size(), null_node);
  std::size_t turn = 0;
  tile.for_each_node([&](const Node node, const Grid_place& /* place */) {
    constexpr std::size_t nodes_between_checks = 4096;
    if(turn++ % nodes_between_checks == 0)
      check_for_interruption(turn, labels.size());
    const double label = labels[node];
    if(label == infinity)
      return;
    const auto look_at = [&](const std::size_t target, const double cost) {
      if(result[target] == null_node && label + cost <= labels[target] && label < labels[target])
        result[target] = node;
    };
    tile.for_each_arc_in_window(node, Doubled_labels<Node>{labels, null_node},
                                [&](const Node first, const auto cost, const auto... number) {
                                  if constexpr(sizeof...(number) == 0)
                                    look_at(first, cost);
                                  else
                                    for(std::size_t i = 0; i < (number + ...); ++i)
                                      look_at(first + i, cost[i]);
                                });
  });
  return result;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_FIRST_PREDECESSORS_H
