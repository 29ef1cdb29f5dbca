// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_FREE_ENDS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_FREE_ENDS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Free_ways.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// Ends of paths that are not nodes, and lie where a path costs nothing: which lines they begin and
// end with is a question of their lengths, see `Free_ways`.

namespace CGAL::Approximate_geodesics::internal {

// Gives the seeds of lines from sources that cost nothing the lengths of these lines.
template <typename Graph, typename Source, typename Seed>
void add_free_seeds([[maybe_unused]] const Graph& graph,
                    [[maybe_unused]] const std::vector<Source>& sources,
                    [[maybe_unused]] std::vector<Seed>& seeds)
{
  if constexpr(tells_free_arcs<Graph>)
    if(graph.has_free_arcs())
    {
      for(Seed& seed : seeds)
        if(seed.distance == sources[seed.source].distance)
          seed.free_length = std::numeric_limits<double>::max();
      for(std::size_t i = 0; i < sources.size(); ++i)
        graph.attach_free(sources[i].point, false)
            .for_each_node([&](const auto node, const double length) {
              seeds.push_back({node, sources[i].distance, i, length});
            });
    }
}

// Exchanges the last node of a path to a point for one from which the path costs as much, if its
// free parts are shorter then.
template <typename Search, typename Answer>
void shorten_free_end([[maybe_unused]] const Search& search,
                      [[maybe_unused]] const Intrinsic_point& point,
                      [[maybe_unused]] Answer& answer)
{
  if constexpr(tells_free_arcs<typename Search::Graph>)
    if(!point.is_vertex() && search.graph().has_free_arcs())
    {
      double least = std::numeric_limits<double>::infinity();
      const auto consider = [&](const auto node, const double cost, const double free_length) {
        const double length = search.free_length(node) + free_length;
        if(search.distance(node) + cost * search.graph().unit() == answer.distance &&
           length < least)
        {
          least = length;
          answer.node = node;
          answer.last_length = cost;
        }
      };
      search.graph()
          .attach_free(point, true)
          .for_each_node([&](const auto node, const double length) { consider(node, 0, length); });
      search.graph().attach_target(point).for_each_node([&](const auto node, const double cost) {
        if(cost > 0)
          consider(node, cost, 0);
      });
    }
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_FREE_ENDS_H
