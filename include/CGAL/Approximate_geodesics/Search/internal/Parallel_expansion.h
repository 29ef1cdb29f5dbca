// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PARALLEL_EXPANSION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PARALLEL_EXPANSION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Candidate.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Finds the arcs of several nodes with the graph's threads. Labels do not change meanwhile, and
 * what the threads find is put together in the order of the nodes; so results do not depend on the
 * number of threads.
 */
template <typename Graph>
class Parallel_expansion
{
  using Node = Labels::Node;
  using Candidate = Candidate_of<Graph>;

public:
  // Whether several threads are worth their while.
  static bool is_useful(const Graph& graph, const std::size_t number_of_tasks)
  {
    constexpr std::size_t fewest = 16;
    return graph.is_parallel() && number_of_tasks >= fewest;
  }

  // Calls `f(candidates)` with the paths along arcs that are shorter than labels say, one part of
  // them after the other.
  template <typename Labels, typename F>
  void expand(const Graph& graph,
              const Node* const nodes,
              const std::size_t number_of_nodes,
              const Labels& labels,
              F f)
  {
    m_tasks.clear();
    for(std::size_t i = 0; i < number_of_nodes; ++i)
      for(std::size_t part = graph.number_of_parts(nodes[i], labels); part > 0; --part)
        m_tasks.push_back({nodes[i], part - 1});
    if(m_found.size() < m_tasks.size())
      m_found.resize(m_tasks.size());
    graph.loop().run(m_tasks.size(), [&](const std::size_t i) { work(graph, i, labels); });
    for(std::size_t i = 0; i < m_tasks.size(); ++i)
      f(m_found[i]);
  }

private:
  struct Task
  {
    Node node;
    std::size_t part;
  };

  template <typename Labels>
  void work(const Graph& graph, const std::size_t i, const Labels& labels)
  {
    std::vector<Candidate>& found = m_found[i];
    found.clear();
    const auto [node, part] = m_tasks[i];
    const double distance = labels.distance(node);
    graph.for_each_arc_of_part(
        node, part, labels,
        [&, from = node](const Node target, const double length, const auto& arrival) {
          if(distance + length < labels.distance(target))
            found.push_back({{distance + length, target, from}, arrival});
        });
  }

  std::vector<Task> m_tasks;
  std::vector<std::vector<Candidate>> m_found; // by task
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_PARALLEL_EXPANSION_H
