// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PARALLEL_EXPANSION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PARALLEL_EXPANSION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_statistics.h>
#include <CGAL/Approximate_geodesics/Search/internal/Candidate_list.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/optional_members.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// The part of a node that has no parts.
constexpr std::size_t whole_node = (std::numeric_limits<std::size_t>::max)();

/*
 * Finds the arcs of several nodes with the graph's threads. Labels do not change meanwhile, and
 * what the threads find is taken in the order of the nodes; so results do not depend on the number
 * of threads. A graph may divide the arcs of a node into parts.
 */
template <typename Graph>
class Parallel_expansion
{
  using Node = Labels::Node;

  static constexpr std::size_t tasks_per_turn = has_parts<Graph> ? 1 : 8;
  static constexpr std::size_t fewest_tasks = has_parts<Graph> ? 16 : 64; // to be worth their while

public:
  // Lists what there is to do for these nodes. Returns whether threads are worth their while.
  template <typename Labels>
  bool prepare(const Graph& graph,
               const Node* const nodes,
               const std::size_t number_of_nodes,
               [[maybe_unused]] const Labels& labels)
  {
    m_tasks.clear();
    for(std::size_t i = 0; i < number_of_nodes; ++i)
      if constexpr(has_parts<Graph>)
        for(std::size_t part = graph.number_of_parts(nodes[i], labels); part > 0; --part)
          m_tasks.push_back({nodes[i], part - 1});
      else
        m_tasks.push_back({nodes[i], whole_node});
    return m_tasks.size() >= fewest_tasks;
  }

  // Calls `append_arcs(candidates, node, part, counter)` for all of this.
  template <typename Counter, typename F>
  void run(const Loop& loop, const Counter& counter, const F& append_arcs)
  {
    m_number_of_turns = (m_tasks.size() + tasks_per_turn - 1) / tasks_per_turn;
    if(m_found.size() < m_number_of_turns)
      m_found.resize(m_number_of_turns);
    loop.run(m_number_of_turns, [&](const std::size_t turn) {
      Found found{std::move(m_found[turn].candidates), {}}; // away from where other threads write
      found.candidates.clear();
      const std::size_t first = turn * tasks_per_turn;
      const std::size_t beyond = (std::min)(first + tasks_per_turn, m_tasks.size());
      for(std::size_t i = first; i < beyond; ++i)
        append_arcs(found.candidates, m_tasks[i].node, m_tasks[i].part,
                    counter.with(found.statistics));
      m_found[turn] = std::move(found);
    });
    for(std::size_t turn = 0; turn < m_number_of_turns; ++turn)
      counter.add(m_found[turn].statistics);
  }

  // Calls `f(candidates)` for what was found, one part of it after the other.
  template <typename F>
  void for_each_list(const F& f) const
  {
    for(std::size_t turn = 0; turn < m_number_of_turns; ++turn)
      f(m_found[turn].candidates);
  }

private:
  struct Task
  {
    Node node;
    std::size_t part;
  };

  struct Found
  {
    Candidate_list<Graph> candidates;
    Propagation_statistics statistics;
  };

  std::vector<Task> m_tasks;
  std::size_t m_number_of_turns = 0;
  std::vector<Found> m_found; // by turn
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PARALLEL_EXPANSION_H
