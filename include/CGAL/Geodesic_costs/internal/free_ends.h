// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_FREE_ENDS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_FREE_ENDS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Search/internal/extensions.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Ends of paths that are not nodes, and lie where a path costs nothing: which lines they begin and
 * end with is a question of their lengths, see `Free_ways`.
 */
template <typename Graph>
class Free_ends
{
public:
  // Gives the seeds of lines from sources that cost nothing the lengths of these lines.
  template <typename Source, typename Seed>
  static void
  add_seeds(const Graph& graph, const std::vector<Source>& sources, std::vector<Seed>& seeds)
  {
    if(!graph.has_free_arcs())
      return;
    for(Seed& seed : seeds)
      if(seed.distance == sources[seed.source].distance)
        seed.free_length = (std::numeric_limits<double>::max)();
    for(std::size_t i = 0; i < sources.size(); ++i)
      graph.attach_free(sources[i].point, false)
          .for_each_node([&](const auto node, const double length) {
            seeds.push_back({node, sources[i].distance, i, length});
          });
  }

  // Exchanges the last node of a path to a point for one from which the path costs as much, if its
  // free parts are shorter then.
  template <typename Search, typename Answer>
  static void shorten(const Search& search, const Intrinsic_point& point, Answer& answer)
  {
    const Graph& graph = search.graph();
    if(point.is_vertex() || !graph.has_free_arcs())
      return;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const auto node, const double cost, const double free_length) {
      const double length = search.free_length(node) + free_length;
      if(search.distance(node) + cost * graph.unit() == answer.distance && length < least)
      {
        least = length;
        answer.node = node;
        answer.last_length = cost;
      }
    };
    graph.attach_free(point, true).for_each_node([&](const auto node, const double length) {
      consider(node, 0, length);
    });
    graph.attach_target(point).for_each_node([&](const auto node, const double cost) {
      if(cost > 0)
        consider(node, cost, 0);
    });
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_FREE_ENDS_H
