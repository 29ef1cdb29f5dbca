// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/internal/Bounded_labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/Candidate.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/Parallel_expansion.h>
#include <CGAL/Approximate_geodesics/Search/internal/heuristics.h>
#include <CGAL/Approximate_geodesics/Search/internal/optional_members.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

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
  using Candidate = Candidate_of<Graph>;

public:
  // `candidates` is memory to work in, and `limit` the largest distance, in units of the graph.
  Batch_relaxation(const Graph& graph,
                   Queue& queue,
                   Labels& labels,
                   std::vector<Candidate>& candidates,
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
      find_candidates();
      lower_labels();
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

  // The second loop: looks at the arcs of these nodes. Each arc is written down as a candidate; if
  // it does not lower the label of its end, the next one overwrites it.
  void find_candidates()
  {
    const auto& order = m_labels.order();
    const double* const distances = m_labels.distances(); // kept in a register
    m_number_of_candidates = 0;
    if constexpr(needs_bounds<Graph>)
      if(Parallel_expansion<Graph>::is_useful(m_graph, number_of_tasks()))
        return find_candidates_in_parallel();
    for(std::size_t i = order.size() - m_size; i < order.size(); ++i)
    {
      m_counter.on_expansion();
      const Node node = order[i];
      const double distance = distances[node];
      Candidate* end = end_of_candidates();
      const Arc_visitor visitor{*this, distances, distance, node, end};
      if constexpr(needs_bounds<Graph>)
        m_graph.for_each_arc(node, limited_labels(), visitor);
      else
        m_graph.for_each_arc(node, m_labels, visitor);
      m_number_of_candidates = static_cast<std::size_t>(end - m_candidates.data());
      if constexpr(needs_expansion_history<Graph>)
        m_labels.set_expanded(node);
    }
  }

  // The third loop: lowers the labels of the ends of candidates, and enters these nodes.
  void lower_labels()
  {
    const double* const distances = m_labels.distances(); // kept in a register
    for(std::size_t i = 0; i < m_number_of_candidates; ++i)
    {
      const Candidate c = m_candidates[i];
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
    if constexpr(needs_bounds<Graph> && has_rounds<Queue>)
      if(m_graph.is_parallel())
        return m_queue.extract_round();
    return m_queue.extract_min();
  }

  Limited_labels<Labels, Heuristic> limited_labels() const
  {
    return Limited_labels<Labels, Heuristic>(m_labels, m_limit, m_heuristic);
  }

  // What threads can do at the same time for the nodes of the batch.
  std::size_t number_of_tasks() const
  {
    const auto& order = m_labels.order();
    std::size_t result = 0;
    for(std::size_t i = order.size() - m_size; i < order.size(); ++i)
      result += m_graph.number_of_parts(order[i], limited_labels());
    return result;
  }

  void find_candidates_in_parallel()
  {
    const auto& order = m_labels.order();
    for(std::size_t i = 0; i < m_size; ++i)
      m_counter.on_expansion();
    m_parallel_expansion.expand(
        m_graph, order.data() + (order.size() - m_size), m_size, limited_labels(),
        [&](const std::vector<Candidate>& found) {
          if(m_candidates.size() < m_number_of_candidates + found.size())
            m_candidates.resize(2 * (m_number_of_candidates + found.size()));
          std::copy(found.begin(), found.end(),
                    m_candidates.begin() + static_cast<std::ptrdiff_t>(m_number_of_candidates));
          m_number_of_candidates += found.size();
          for(std::size_t i = 0; i < found.size(); ++i)
            m_counter.on_relaxation();
        });
  }

  // Writes down where the arcs of a node lead.
  struct Arc_visitor
  {
    void operator()(const Node target, const double length) const
    {
      if constexpr(!has_maximum_degree<Graph>)
        end = batch.with_room_at(end);
      end = append(end, target, length);
    }

    // an arc that arrives in a certain way
    template <typename Arrival>
    void operator()(const Node target, const double length, const Arrival& arrival) const
    {
      Candidate* const position = batch.with_room_at(end);
      end = append(position, target, length);
      position->arrival = arrival;
    }

    // arcs to consecutive nodes
    void operator()(const Node first, const double* const lengths, const std::size_t number) const
    {
      if constexpr(!has_maximum_degree<Graph>)
        for(std::size_t i = 0; i < number; ++i)
          (*this)(first + static_cast<Node>(i), lengths[i]);
      else
      {
        Candidate* beyond = end; // kept in a register
        for(std::size_t i = 0; i < number; ++i)
          beyond = append(beyond, first + static_cast<Node>(i), lengths[i]);
        end = beyond;
      }
    }

    Candidate* append(Candidate* const position, const Node target, const double length) const
    {
      batch.m_counter.on_relaxation();
      CGAL_assertion(position < batch.m_candidates.data() + batch.m_candidates.size());
      static_cast<internal::Candidate&>(*position) = {distance + length, target, node};
      return position + static_cast<std::ptrdiff_t>(position->distance < distances[target]);
    }

    Batch_relaxation& batch;
    const double* distances; // labels
    double distance;
    Node node;
    Candidate*& end;
  };

  // Returns where the next candidates go. There is room for those of a node if the graph knows how
  // many these may be, or for one.
  Candidate* end_of_candidates()
  {
    std::size_t room = 1;
    if constexpr(has_maximum_degree<Graph>)
      room = m_graph.maximum_degree();
    if(m_candidates.size() < m_number_of_candidates + room)
      m_candidates.resize(2 * (m_number_of_candidates + room));
    return m_candidates.data() + m_number_of_candidates;
  }

  // Makes room for one more, which may move those that are there.
  Candidate* with_room_at(const Candidate* end)
  {
    m_number_of_candidates = static_cast<std::size_t>(end - m_candidates.data());
    return end_of_candidates();
  }

  // Along an arc, a consistent heuristic falls by no more than the length of the arc, but for
  // rounding; and keys must not fall.
  double key(const Candidate& c) const
  {
    if constexpr(is_heuristic<Heuristic>)
      return (std::max)(c.distance + m_heuristic(c.node), m_smallest_key);
    else
      return c.distance;
  }

  const Graph& m_graph;
  Queue& m_queue;
  Labels& m_labels;
  std::vector<Candidate>& m_candidates;
  std::size_t m_number_of_candidates = 0;
  const Heuristic& m_heuristic;
  double m_limit;
  double m_smallest_key = 0; // of the batch, if there is a heuristic
  std::size_t m_size = 0;
  Counter m_counter;
  Parallel_expansion<Graph> m_parallel_expansion; // empty unless the graph has threads
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
