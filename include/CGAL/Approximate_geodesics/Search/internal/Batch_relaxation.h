// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Bounded_labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/Candidate.h>
#include <CGAL/Approximate_geodesics/Search/internal/Candidate_list.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/Parallel_expansion.h>
#include <CGAL/Approximate_geodesics/Search/internal/heuristics.h>
#include <CGAL/Approximate_geodesics/Search/internal/optional_members.h>
#include <CGAL/Approximate_geodesics/Search/internal/watches.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

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
template <typename Graph, typename Queue, typename Labels, typename Heuristic, typename Counter>
class Batch_relaxation
{
  using Node = internal::Labels::Node;

public:
  // `candidates` is memory to work in, and `limit` the largest distance, in units of the graph.
  Batch_relaxation(const Graph& graph,
                   Queue& queue,
                   Labels& labels,
                   Candidate_list<Graph>& candidates,
                   const Heuristic& heuristic,
                   const double limit,
                   const Counter& counter)
    : m_graph(graph),
      m_queue(queue),
      m_labels(labels),
      m_candidates(candidates),
      m_heuristic(heuristic),
      m_limit(limit),
      m_counter(counter)
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
      extract();
      if(!watch.go_further(m_size))
        return false;
      if(relax_in_parallel())
        continue;
      if constexpr(std::is_same_v<Watch, No_watch>)
        find_candidates();
      else
        find_candidates_apart();
      lower_labels(m_candidates, 0, m_candidates.size());
    }
    return true;
  }

  // the number of nodes that the first loop has appended
  std::size_t size() const { return m_size; }

private:
  // The first loop: appends the nodes of a batch to the order, but for those of stale entries.
  void extract()
  {
    const auto& batch = next_batch();
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
      const bool is_skipped = is_stale(key, distances[node], node, m_heuristic);
      end += static_cast<std::ptrdiff_t>(!is_skipped);
      m_counter.on_stale_pops(is_skipped ? 1 : 0);
    }
    order.resize(static_cast<std::size_t>(end - order.data()));
    m_size = order.size() - first;
  }

  // The second loop: looks at the arcs of these nodes, and writes down those that lower a label.
  void find_candidates()
  {
    if constexpr(expands_together<Graph>)
      return find_candidates_together();
    const auto& order = m_labels.order();
    const double* const distances = m_labels.distances(); // kept in a register
    m_candidates.clear();
    for(std::size_t i = order.size() - m_size; i < order.size(); ++i)
    {
      m_counter.on_expansion();
      const Node node = order[i];
      if constexpr(may_have_threads<Graph>)
        append_arcs(m_candidates, node, whole_node, m_counter);
      else
        m_candidates.append(m_graph, node, distances, m_counter, [&](const auto& visitor) {
          m_graph.for_each_arc(node, labels(), visitor);
        });
      if constexpr(needs_expansion_history<Graph>)
        m_labels.set_expanded(node);
    }
  }

  // Beside the calls of a watch, this loop would lack registers: a run would take 7 % longer.
  BOOST_NOINLINE void find_candidates_apart() { find_candidates(); }

  // The same for graphs that find the arcs of several nodes together.
  void find_candidates_together()
  {
    const auto& order = m_labels.order();
    m_candidates.clear();
    for(std::size_t i = order.size() - m_size, number = 0; i < order.size(); i += number)
    {
      number = (std::min)(nodes_at_a_time<Graph>, order.size() - i);
      append_arcs(m_candidates, order.data() + i, number, m_counter);
    }
    set_expanded();
  }

  void set_expanded()
  {
    const auto& order = m_labels.order();
    for(std::size_t i = order.size() - m_size; i < order.size(); ++i)
    {
      m_counter.on_expansion();
      if constexpr(needs_expansion_history<Graph>)
        m_labels.set_expanded(order[i]);
    }
  }

  // The third loop: lowers the labels of the ends of candidates, and enters these nodes.
  void lower_labels(const Candidate_list<Graph>& candidates,
                    const std::size_t first,
                    const std::size_t beyond)
  {
    const double* const distances = m_labels.distances(); // kept in a register
    for(std::size_t i = first; i < beyond; ++i)
    {
      const auto c = candidates[i];
      // still, after the earlier ones
      if(c.distance < distances[c.node] && c.distance <= m_limit)
      {
        m_counter.on_improvement();
        m_labels.set(c.node, c.distance, c.predecessor);
        if constexpr(needs_bounds<Graph>)
          m_labels.set_arrival(c.node, c.arrival);
        m_queue.push(c.node, key(c));
      }
    }
  }

  decltype(auto) next_batch()
  {
    if constexpr(may_have_threads<Graph> && has_rounds<Queue>)
      if(m_graph.is_parallel())
        return m_queue.extract_round(Parallel_expansion<Graph>::largest_batch);
    return m_queue.extract_min();
  }

  // as the graph sees them
  decltype(auto) labels() const
  {
    if constexpr(needs_bounds<Graph>)
      return Limited_labels<Labels, Heuristic>(m_labels, m_limit, m_heuristic);
    else
      return static_cast<const Labels&>(m_labels);
  }

  // Not inline, so that there is one compilation of it, whoever calls it: it may round otherwise in
  // another one, and be slower.
  BOOST_NOINLINE void append_arcs(Candidate_list<Graph>& candidates,
                                  const Node node,
                                  [[maybe_unused]] const std::size_t part,
                                  const Counter& counter) const
  {
    candidates.append(m_graph, node, m_labels.distances(), counter, [&](const auto& visitor) {
      if constexpr(has_parts<Graph>)
        if(part != whole_node)
          return m_graph.for_each_arc_of_part(node, part, labels(), visitor);
      m_graph.for_each_arc(node, labels(), visitor);
    });
  }

  void append_arcs(Candidate_list<Graph>& candidates,
                   const Node* const nodes,
                   const std::size_t number,
                   const Counter& counter) const
  {
    if constexpr(expands_together<Graph>)
      candidates.append_together(m_graph, nodes, number, m_labels, counter);
    else
      for(std::size_t i = 0; i < number; ++i)
        append_arcs(candidates, nodes[i], whole_node, counter);
  }

  // The second and the third loop with the graph's threads. Returns false, and does nothing, if
  // these are not worth their while.
  bool relax_in_parallel()
  {
    if constexpr(may_have_threads<Graph>)
    {
      const auto& order = m_labels.order();
      const Node* const nodes = order.data() + (order.size() - m_size);
      if(!m_graph.is_parallel() || !m_expansion.prepare(m_graph, nodes, m_size, labels()))
        return false;
      m_expansion.run(m_graph, m_counter,
                      [this](auto&&... arguments) { this->append_arcs(arguments...); });
      set_expanded();
      m_expansion.for_each_part([this](auto&&... arguments) { this->lower_labels(arguments...); });
      return true;
    }
    return false;
  }

  // Along an arc, a consistent heuristic falls by no more than the length of the arc, but for
  // rounding; and keys must not fall.
  double key(const internal::Candidate& c) const
  {
    if constexpr(is_heuristic<Heuristic>)
      return (std::max)(c.distance + m_heuristic(c.node), m_smallest_key);
    else
      return c.distance;
  }

  const Graph& m_graph;
  Queue& m_queue;
  Labels& m_labels;
  Candidate_list<Graph>& m_candidates;
  const Heuristic& m_heuristic;
  double m_limit;
  double m_smallest_key = 0; // of the batch, if there is a heuristic
  std::size_t m_size = 0;
  Counter m_counter;
  Parallel_expansion<Graph> m_expansion; // empty unless the graph has threads
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
