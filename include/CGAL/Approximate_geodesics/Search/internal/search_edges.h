// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_SEARCH_EDGES_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_SEARCH_EDGES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/Propagation_rules.h>
#include <CGAL/Approximate_geodesics/Search/internal/Batch_relaxation.h>
#include <CGAL/Approximate_geodesics/Search/internal/Candidate_list.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/counters.h>
#include <CGAL/Approximate_geodesics/Search/internal/watches.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Searches the edges of a graph for upper bounds of its distances, until the goal is met. All nodes
// that get labels are appended to the order. `limit` is the largest label, in units of the graph.
template <typename EdgeGraph, typename Queue, typename Heuristic, typename Goal>
void search_edges(const EdgeGraph& edges,
                  Queue& queue,
                  Labels& labels,
                  const std::vector<Seed>& seeds,
                  const double limit,
                  const Heuristic& heuristic,
                  Goal goal)
{
  for(const Seed& seed : seeds)
  {
    const double distance = seed.distance / edges.unit();
    if(!(distance < labels.distance(seed.node) && distance <= limit))
      continue;
    labels.set(seed.node, distance, Labels::null_node);
    queue.push(seed.node, distance + heuristic(seed.node));
  }
  Candidate_list<EdgeGraph> candidates;
  Batch_relaxation<EdgeGraph, Queue, Labels, Heuristic, No_counter> batch(
      edges, queue, labels, candidates, heuristic, limit, No_counter());
  Goal_watch watch(labels, std::move(goal));
  batch.run(watch);
  labels.append_to_order(queue);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_SEARCH_EDGES_H
