// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CONTINUED_RUNS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CONTINUED_RUNS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

// The member functions of `Propagation` that continue an earlier run: one that was kept elsewhere,
// or the last one after arcs or seeds have changed.

template <typename GeodesicGraph, typename PriorityQueue>
template <typename EnterLabels>
void Propagation<GeodesicGraph, PriorityQueue>::resume(const EnterLabels& enter_labels)
{
  static_assert(!internal::has_own_run<Graph>,
                "resume() keeps nothing that the Run of a graph keeps");
  forget();
  guard([&] {
    prepare();
    enter_labels([&](const Node node, const double distance, const Node predecessor,
                     const bool is_open) { take_over(node, distance, predecessor, is_open); });
    propagate_all(Stop_rule(), Geodesic_visitor_base(), internal::No_heuristic());
    m_is_complete = false; // `repair()` would not know the seeds
  });
}

// Closed nodes are kept for `forget()`; open ones will be when they are expanded.
template <typename GeodesicGraph, typename PriorityQueue>
void Propagation<GeodesicGraph, PriorityQueue>::take_over(const Node node,
                                                          const double distance,
                                                          const Node predecessor,
                                                          const bool is_open)
{
  const double label = to_graph_unit(distance);
  if(!(label >= 0 && label < std::numeric_limits<double>::infinity()) ||
     node >= m_labels.number_of_nodes())
    check({Seed{node, distance}}, Stop_rule()); // throws
  m_labels.set(node, label, predecessor);
  if(predecessor == null_node)
    m_seeds.push_back({node, label, node});
  if(is_open)
    m_queue.push(node, label);
  else
    m_labels.order().push_back(node);
}

template <typename GeodesicGraph, typename PriorityQueue>
void Propagation<GeodesicGraph, PriorityQueue>::repair(const std::vector<Seed>& seeds)
{
  check(seeds, Stop_rule());
  Geodesic_visitor_base visitor; // as in other runs, which are instantiated anyway
  if constexpr(internal::is_repairable<Graph>)
    if(m_is_complete && internal::are_changes_known(*m_graph, m_number_of_changes))
    {
      m_sources.forget(m_labels);
      m_ways.forget();
      bool is_worthwhile = false;
      guard([&] {
        std::vector<Seed> in_graph_unit = seeds;
        for(Seed& seed : in_graph_unit)
          seed.distance = to_graph_unit(seed.distance);
        is_worthwhile = m_repair.raise_labels(*m_graph, m_labels, m_seeds, std::move(in_graph_unit),
                                              m_number_of_changes);
      });
      if(is_worthwhile)
      {
        std::vector<Node> border;
        guard([&] { border = m_repair.border(*m_graph, m_labels); });
        forget_seeds();
        search(seeds, Stop_rule(), visitor, internal::No_heuristic(), {}, border);
        guard([&] { m_repair.tidy(m_labels); });
        count_all();
        m_repair.finish();
        return;
      }
      m_repair.finish();
    }
  run(seeds, Stop_rule(), visitor);
}

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_CONTINUED_RUNS_H
