// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_CONTINUED_RUNS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_CONTINUED_RUNS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Search/internal/concept_checks.h>
#include <CGAL/Approximate_geodesics/Search/internal/extensions.h>
#include <CGAL/Geodesic_costs/internal/Repair.h>
#include <CGAL/Geodesic_costs/internal/Star_groups.h>

#include <boost/type_traits/is_detected_convertible.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

template <typename Groups>
using Number_of_groups = decltype(std::declval<const Groups&>().number_of_groups());

/*
 * Continues an earlier run: one that was kept elsewhere, or the last one after arcs or seeds have
 * changed.
 */
template <typename Search>
class Continued_run
{
  using Graph = typename Search::Graph;
  using Node = typename Search::Node;
  using Groups = Groups_of<Graph>;
  using Repair_of_graph = Repair<std::decay_t<Groups>>;

  // Arcs run within groups of nodes, and no data is stored beside labels.
  static constexpr bool is_repairable =
      boost::is_detected_convertible_v<std::size_t, Number_of_groups, Groups> &&
      !has_own_run<Graph>;

public:
  explicit Continued_run(Search& search) : m_search(search) {}

  template <typename EnterLabels>
  void resume(const EnterLabels& enter_labels)
  {
    static_assert(!has_own_run<Graph>, "resume() keeps nothing that the Run of a graph keeps");
    m_search.forget();
    m_search.guard([&] {
      m_search.prepare();
      enter_labels([&](const Node node, const double distance, const Node predecessor,
                       const bool is_open) { take_over(node, distance, predecessor, is_open); });
      m_search.propagate_all(Stop_rule(), Geodesic_visitor_base(), No_heuristic());
      m_search.m_is_complete = false; // `repair()` would not know the seeds
    });
  }

  void repair(const std::vector<Seed>& seeds)
  {
    m_search.check(seeds, Stop_rule());
    Geodesic_visitor_base visitor; // as in other runs, which are instantiated anyway
    if constexpr(is_repairable)
      if(m_search.m_is_complete &&
         are_changes_known(*m_search.m_graph, m_search.m_number_of_changes))
      {
        m_search.m_sources.forget(m_search.m_labels);
        m_search.m_ways.forget();
        if(raise_labels(seeds))
        {
          continue_from_border(seeds, visitor);
          return;
        }
        kept().finish();
      }
    m_search.run(seeds, Stop_rule(), visitor);
  }

private:
  // Labels a node of a run that is continued. Closed nodes are kept for `forget()`; open ones will
  // be when they are expanded.
  void take_over(const Node node, const double distance, const Node predecessor, const bool is_open)
  {
    const double label = m_search.to_graph_unit(distance);
    if(!(label >= 0 && label < std::numeric_limits<double>::infinity()) ||
       node >= m_search.m_labels.number_of_nodes())
      m_search.check({Seed{node, distance}}, Stop_rule()); // throws
    m_search.m_labels.set(node, label, predecessor);
    if(predecessor == Search::null_node)
      m_search.m_seeds.push_back({node, label, node});
    if(is_open)
      m_search.m_queue.push(node, label);
    else
      m_search.m_labels.order().push_back(node);
  }

  Groups groups() const { return Groups(*m_search.m_graph); }

  Repair_of_graph& kept() const { return static_cast<Repair_of_graph&>(*m_search.m_kept); }

  // Returns whether the labels that are left make a repair worthwhile.
  bool raise_labels(const std::vector<Seed>& seeds_of_run)
  {
    bool result = false;
    m_search.guard([&] {
      std::vector<Seed> seeds = seeds_of_run;
      for(Seed& seed : seeds)
        seed.distance = m_search.to_graph_unit(seed.distance);
      if(!m_search.m_kept)
        m_search.m_kept = std::make_unique<Repair_of_graph>();
      result = kept().raise_labels(groups(), m_search.m_labels, m_search.m_seeds, std::move(seeds),
                                   m_search.m_number_of_changes);
    });
    return result;
  }

  void continue_from_border(const std::vector<Seed>& seeds, Geodesic_visitor_base& visitor)
  {
    std::vector<Node> border;
    m_search.guard([&] { border = kept().border(groups(), m_search.m_labels); });
    m_search.forget_seeds();
    m_search.search(seeds, Stop_rule(), visitor, No_heuristic(), {}, border);
    m_search.guard([&] { kept().tidy(m_search.m_labels); });
    m_search.count_all();
    kept().finish();
  }

  Search& m_search;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_CONTINUED_RUNS_H
