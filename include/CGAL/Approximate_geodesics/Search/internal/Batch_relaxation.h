// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_statistics.h>
#include <CGAL/Approximate_geodesics/Search/internal/Candidate_list.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/heuristics.h>
#include <CGAL/Approximate_geodesics/Search/internal/optional_members.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

// Whether nodes are expanded again too often, which a rounded heuristic can cause: beside it, very
// short arcs vanish, so that keys no longer order their nodes.
inline bool reopens_too_often(const Labels& labels)
{
  constexpr std::size_t most_expansions_per_node = 3;
  return labels.order().size() / most_expansions_per_node > labels.number_of_nodes();
}

/*
 * The three loops that a search works through a batch of entries in. They are described where the
 * algorithm is, in `Propagation.h`. In the first and the second one, no branch depends on a
 * distance.
 */
template <typename Graph, typename Queue, typename Heuristic>
class Batch_relaxation
{
  using Node = Labels::Node;

public:
  using Run = Run_of<Graph>;
  using Candidates = Candidate_list<typename Run::Payload>;

  // `candidates` is memory to work in, and `limit` the largest distance, in units of the graph.
  // Counts if there are statistics.
  Batch_relaxation(const Graph& graph,
                   Run& run,
                   Queue& queue,
                   Labels& labels,
                   Candidates& candidates,
                   const Heuristic& heuristic,
                   const double limit,
                   Propagation_statistics* const statistics)
    : m_graph(graph),
      m_run(run),
      m_queue(queue),
      m_labels(labels),
      m_candidates(candidates),
      m_heuristic(heuristic),
      m_limit(limit),
      m_statistics(statistics)
  {
  }

  // Expands nodes until the queue is empty, or too often. Returns whether the watch let it.
  template <typename Watch>
  bool run(Watch& watch)
  {
    while(!m_queue.is_empty())
    {
      if constexpr(is_heuristic<Heuristic>)
        if(reopens_too_often(m_labels))
        {
          m_labels.append_to_order(m_queue);
          m_queue.clear();
          return true;
        }
      extract(next_batch());
      if(!watch.go_further(m_size))
        return false;
      find_candidates();
      if(m_statistics == nullptr)
        lower_labels<0>();
      else
        count_and_lower_labels();
    }
    return true;
  }

  // the number of nodes that the first loop has appended
  std::size_t size() const { return m_size; }

private:
  decltype(auto) next_batch()
  {
    if constexpr(has_rounds<Queue>)
      if(m_run.largest_batch() > 0)
        return m_queue.extract_round(m_run.largest_batch());
    return m_queue.extract_min();
  }

  // The first loop: appends the nodes of a batch to the order, but for those of stale entries.
  template <typename Batch>
  void extract(const Batch& batch)
  {
    const double* const distances = m_labels.distances(); // kept in a register
    auto& order = m_labels.order();
    const std::size_t first = order.size();
    order.resize(first + batch.size());
    Node* end = order.data() + first;
    if constexpr(is_heuristic<Heuristic>)
      m_smallest_key = std::numeric_limits<double>::infinity();
    for(const auto& [key, node] : batch)
    {
      if constexpr(is_heuristic<Heuristic>)
        m_smallest_key = (std::min)(m_smallest_key, key);
      if constexpr(has_prefetch<Graph>)
        m_graph.prefetch(node);
      *end = node;
      end += static_cast<std::ptrdiff_t>(!is_stale(key, distances[node], node, m_heuristic));
    }
    order.resize(static_cast<std::size_t>(end - order.data()));
    m_size = order.size() - first;
    if(m_statistics != nullptr)
    {
      m_statistics->pops += batch.size() - m_size;
      m_statistics->stale_pops += batch.size() - m_size;
    }
  }

  // The second loop: looks at the arcs of these nodes, and writes down those that lower a label.
  void find_candidates()
  {
    m_candidates.start(m_labels.distances(), m_statistics != nullptr);
    const auto& order = m_labels.order();
    m_run.expand(order.data() + (order.size() - m_size), m_size,
                 static_cast<const Labels&>(m_labels), m_candidates);
  }

  // The third loop: lowers the labels of the ends of candidates, and enters these nodes.
  template <std::size_t COUNT>
  std::size_t lower_labels()
  {
    std::size_t number = 0;
    const double* const distances = m_labels.distances(); // kept in a register
    const std::size_t size = m_candidates.size();
    for(std::size_t i = 0; i < size; ++i)
    {
      const auto c = m_candidates[i];
      // still, after the earlier ones
      if(c.distance < distances[c.node] && c.distance <= m_limit)
      {
        m_labels.set(c.node, c.distance, c.predecessor);
        m_run.on_label(c.node, c.distance, c);
        m_queue.push(c.node, key(c.node, c.distance));
        number += COUNT;
      }
    }
    return number;
  }

  void count_and_lower_labels()
  {
    m_statistics->pops += m_size;
    m_statistics->relaxations += m_candidates.number_of_arcs();
    m_statistics->improvements += lower_labels<1>();
  }

  // Along an arc, a consistent heuristic falls by no more than the length of the arc, but for
  // rounding; and keys must not fall.
  double key(const Node node, const double distance) const
  {
    if constexpr(is_heuristic<Heuristic>)
      return (std::max)(distance + m_heuristic(node), m_smallest_key);
    else
      return distance;
  }

  const Graph& m_graph;
  Run& m_run;
  Queue& m_queue;
  Labels& m_labels;
  Candidates& m_candidates;
  const Heuristic& m_heuristic;
  double m_limit;
  double m_smallest_key = 0; // of the batch, if there is a heuristic
  std::size_t m_size = 0;
  Propagation_statistics* m_statistics;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
