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
#include <array>
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

  static constexpr std::size_t tasks_per_turn = has_parts<Graph> ? 1 : nodes_at_a_time<Graph>;
  static constexpr std::size_t fewest_tasks = has_parts<Graph> ? 16 : 64; // to be worth their while

public:
  // The most nodes whose arcs are to be found before labels change. The more there are, the more of
  // them get shorter paths by others of them, and are expanded again.
  static constexpr std::size_t largest_batch =
      has_parts<Graph> ? (std::numeric_limits<std::size_t>::max)() : 4 * nodes_at_a_time<Graph>;

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

  // Calls `append_arcs(candidates, nodes, number, counter)` for all of this, or, if the graph may
  // divide the arcs of a node, `append_arcs(candidates, node, part, counter)`.
  template <typename Counter, typename F>
  void run(const Graph& graph, const Counter& counter, const F& append_arcs)
  {
    m_turns.resize((m_tasks.size() + tasks_per_turn - 1) / tasks_per_turn);
    m_lists.resize((std::max)(m_lists.size(), Loop::number_of_threads()));
    for(Candidate_list<Graph>& list : m_lists)
      list.clear();
    graph.loop().run(m_turns.size(), [&](const std::size_t number, const std::size_t thread) {
      Candidate_list<Graph> list = std::move(m_lists[thread]); // away from where others write
      Turn turn{thread, list.size(), 0, {}};
      const Task* const first = m_tasks.data() + number * tasks_per_turn;
      const Task* const end =
          first + (std::min)(tasks_per_turn, m_tasks.size() - number * tasks_per_turn);
      if constexpr(has_prefetch<Graph>)
        for(const Task* task = first; task < end; ++task)
          graph.prefetch(task->node);
      append(list, first, end, counter.with(turn.statistics), append_arcs);
      turn.beyond = list.size();
      m_lists[thread] = std::move(list);
      m_turns[number] = turn;
    });
    for(const Turn& turn : m_turns)
      counter.add(turn.statistics);
  }

  // Calls `f(candidates, first, beyond)` for what was found, one part of it after the other.
  template <typename F>
  void for_each_part(const F& f) const
  {
    for(const Turn& turn : m_turns)
      f(m_lists[turn.thread], turn.first, turn.beyond);
  }

private:
  struct Task
  {
    Node node;
    std::size_t part;
  };

  // what was found in a turn, and where it is
  struct Turn
  {
    std::size_t thread;
    std::size_t first, beyond;
    Propagation_statistics statistics;
  };

  template <typename Counter, typename F>
  static void append(Candidate_list<Graph>& list,
                     const Task* const first,
                     const Task* const end,
                     const Counter& counter,
                     const F& append_arcs)
  {
    if constexpr(has_parts<Graph>)
      for(const Task* task = first; task < end; ++task)
        append_arcs(list, task->node, task->part, counter);
    else
    {
      std::array<Node, tasks_per_turn> nodes;
      std::transform(first, end, nodes.begin(), [](const Task& task) { return task.node; });
      append_arcs(list, nodes.data(), static_cast<std::size_t>(end - first), counter);
    }
  }

  std::vector<Task> m_tasks;
  std::vector<Turn> m_turns;
  std::vector<Candidate_list<Graph>> m_lists; // by thread, so that memory stays in its cache
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PARALLEL_EXPANSION_H
