// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Search/internal/concept_checks.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The targets of a run, which may stop when their distances are final: nodes, and points given by
 * the arcs that lead to them.
 */
template <typename Queue, typename Heuristic>
struct Goal
{
  using Node = Labels::Node;
  using Arcs = std::vector<Last_arc>;

  const Labels& labels;
  const Queue& queue;
  const Heuristic& heuristic;
  std::vector<Node> targets; // those that are not final
  std::vector<Arcs> points;  // those that are not final; lengths are in units of the graph

  // Whether no targets are left.
  bool is_empty() const { return targets.empty() && points.empty(); }

  bool is_final(const Node node) const
  {
    return is_final_key(labels.distance(node) + heuristic(node));
  }

  // Whether all distances are final. Checks one target at a time, so that the cost does not depend
  // on the number of targets.
  bool is_met()
  {
    while(!targets.empty() && is_final(targets.back()))
      targets.pop_back();
    while(targets.empty() && !points.empty() && is_final(points.back()))
      points.pop_back();
    return is_empty();
  }

  // The largest distance of the targets that are not known to be final; infinity if there are none.
  double distance() const
  {
    double result = is_empty() ? infinity : 0;
    for(const Node target : targets)
      result = (std::max)(result, labels.distance(target));
    for(const Arcs& arcs : points)
      result = (std::max)(result, shortest(arcs));
    return result;
  }

private:
  double shortest(const Arcs& arcs) const
  {
    double result = infinity;
    for(const Last_arc& arc : arcs)
      result = (std::min)(result, labels.distance(arc.node) + arc.length);
    return result;
  }

  // Whether all nodes on the shortest path to the target of these arcs are final.
  bool is_final(const Arcs& arcs) const { return is_final_key(shortest(arcs)); }

  // Whether a node with such a key is final, and so are the nodes before it on its path, whose keys
  // can be slightly larger if a heuristic was rounded.
  bool is_final_key(const double key) const
  {
    constexpr double rounding = is_heuristic<Heuristic> ? 1e-12 : 0;
    return queue.is_final(key * (1 + rounding));
  }
};

// Sorts a part of the order by distance, and removes repeated nodes. Returns its new end.
inline std::size_t sort_order(Labels& labels, const std::size_t first, const std::size_t end)
{
  auto& order = labels.order();
  const auto position = [&](const std::size_t i) {
    return order.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::sort(position(first), position(end), [&](const Labels::Node a, const Labels::Node b) {
    return std::make_pair(labels.distance(a), a) < std::make_pair(labels.distance(b), b);
  });
  const auto repetitions = std::unique(position(first), position(end));
  const auto number = static_cast<std::size_t>(position(end) - repetitions);
  order.erase(repetitions, position(end));
  return end - number;
}

template <typename Visitor>
constexpr bool is_idle_visitor = std::is_same_v<std::decay_t<Visitor>, Geodesic_visitor_base>;

// Whether a visitor is notified of settled nodes, which requires sorting them.
template <typename Visitor>
constexpr bool is_told_of_nodes =
    !is_idle_visitor<Visitor> &&
    !is_valid<Visitor&, std::false_type>(
        [](auto& v) -> std::bool_constant<std::decay_t<decltype(v)>::is_told_of_nodes> {});

/*
 * Monitors a run, once per batch of entries: notifies the visitor of nodes as soon as they are
 * final, and stops the run when the goal is met or on request of the visitor.
 *
 * The nodes expanded since the last notification become final together, when the queue advances to
 * larger keys. So checking the first of them is sufficient.
 */
template <typename Goal, typename Visitor>
class Watch
{
public:
  // `unit` converts labels to distances for the visitor. If `counts` is set, the order is sorted,
  // and each node occurs once.
  Watch(Labels& labels, Goal goal, Visitor& visitor, const double unit, const bool counts)
    : m_labels(labels),
      m_goal(std::move(goal)),
      m_visitor(visitor),
      m_unit(unit),
      m_sorts(counts || is_told_of_nodes<Visitor>),
      m_has_goal(!m_goal.is_empty()),
      m_is_needed(m_has_goal || m_sorts || !is_idle_visitor<Visitor>)
  {
  }

  // Must be called after `number_appended` nodes were appended to the order. Returns whether to
  // expand these; otherwise the run stops.
  bool go_further(const std::size_t number_appended)
  {
    if(!m_is_needed)
      return true;
    const std::size_t number_of_earlier = m_labels.order().size() - number_appended;
    if(m_number_final == number_of_earlier || !m_goal.is_final(m_labels.order()[m_number_final]))
      return true;
    settle(number_of_earlier);
    return !(m_has_goal && m_goal.is_met()) && m_visitor.go_further();
  }

  // Must be called when the queue is empty.
  void finish() { settle(m_labels.order().size()); }

private:
  // Settles the nodes of the order up to `end`.
  void settle(const std::size_t end)
  {
    [[maybe_unused]] std::size_t i = m_number_final;
    m_number_final = m_sorts ? sort_order(m_labels, m_number_final, end) : end;
    if constexpr(is_told_of_nodes<Visitor>)
      for(; i < m_number_final; ++i)
      {
        const Labels::Node node = m_labels.order()[i];
        m_visitor.on_settled(node, m_labels.distance(node) * m_unit);
      }
    m_visitor.on_progress(m_number_final, m_labels.number_of_nodes());
  }

  Labels& m_labels;
  Goal m_goal;
  Visitor& m_visitor;
  double m_unit;
  bool m_sorts, m_has_goal, m_is_needed;
  std::size_t m_number_final = 0;
};

// A path that ends with a scanned arc, and the graph's data about it.
template <typename Payload>
struct Candidate : Payload
{
  double distance;
  Labels::Node node;
  Labels::Node predecessor;
};

/*
 * The paths along arcs that are shorter than the labels of their targets. All paths are written,
 * and the next one overwrites one that does not lower a label: no branch depends on a distance.
 * Memory is kept when the list is cleared.
 */
template <typename Payload>
class Candidate_list
{
  using Node = Labels::Node;

public:
  using Candidate = internal::Candidate<Payload>;

  std::size_t size() const { return m_size; }
  const Candidate& operator[](const std::size_t i) const { return m_memory[i]; }

  // The number of scanned arcs, if they are counted.
  std::size_t number_of_arcs() const { return m_number_of_arcs; }

  // Which thread appends to a part, in `append_in_parallel()`; 0 elsewhere.
  std::size_t thread() const { return m_thread; }

  // Removes all candidates. `distances` are the labels, which must not change before the next call.
  void start(const double* const distances, const bool counts)
  {
    m_distances = distances;
    m_counts = counts;
    m_size = m_number_of_arcs = 0;
    m_next_call = {};
  }

  // Requests that arcs are listed again, perhaps of no node, before the search expands nodes with
  // larger labels than this one. The node is one with a smaller label.
  void call_again(const Node node, const double label) { m_next_call = Queue_entry{label, node}; }

  // The request, if there is one.
  const std::optional<Queue_entry>& next_call() const { return m_next_call; }

  // Reserves memory for `number` more arcs, and one that is rejected, which is written, too.
  void make_room(const std::size_t number) { reserve(number + 1); }

  // Appends an arc of a node with this label, unless `is_arc` is false.
  void append(const bool is_arc,
              const Node node,
              const double label,
              const Node target,
              const double length)
  {
    CGAL_assertion(m_size < m_memory.size());
    set(m_memory[m_size], node, target, label + length);
    m_number_of_arcs += is_arc ? 1 : 0;
    m_size += static_cast<std::size_t>(is_arc & (label + length < m_distances[target]));
  }

  void append(const bool is_arc,
              const Node node,
              const double label,
              const Node target,
              const double length,
              const Payload& payload)
  {
    static_cast<Payload&>(m_memory[m_size]) = payload;
    append(is_arc, node, label, target, length);
  }

  // Appends the arcs that a graph reports for these nodes.
  template <typename Graph, typename Labels>
  void append_arcs(const Graph& graph,
                   const Node* const nodes,
                   const std::size_t number,
                   const Labels& labels)
  {
    if(m_counts)
      append_counted_arcs<1>(graph, nodes, number, labels);
    else
      append_counted_arcs<0>(graph, nodes, number, labels);
  }

  // Calls `append(i, candidates)` for all `i` below `number`, in parallel, and appends the results
  // in the order of `i`. So they do not depend on the number of threads.
  template <typename Loop, typename F>
  void append_in_parallel(const Loop& loop, const std::size_t number, const F& append)
  {
    m_turns.resize(number);
    m_lists.resize((std::max)(m_lists.size(), loop.number_of_threads()));
    for(std::size_t thread = 0; thread < m_lists.size(); ++thread)
    {
      m_lists[thread].start(m_distances, m_counts);
      m_lists[thread].m_thread = thread;
    }
    loop.run(number, [&](const std::size_t i, const std::size_t thread) {
      Candidate_list list = std::move(m_lists[thread]); // avoids false sharing
      const std::size_t first = list.size();
      append(i, list);
      m_turns[i] = {thread, first, list.size()};
      m_lists[thread] = std::move(list);
    });
    for(const auto& [thread, first, beyond] : m_turns)
    {
      const Candidate* const part = m_lists[thread].m_memory.data();
      std::copy(part + first, part + beyond, reserve(beyond - first));
      m_size += beyond - first;
    }
    for(const Candidate_list& list : m_lists)
      m_number_of_arcs += list.m_number_of_arcs;
  }

  std::size_t memory() const
  {
    std::size_t result = m_memory.capacity() * sizeof(Candidate);
    for(const Candidate_list& list : m_lists)
      result += sizeof(Candidate_list) + list.memory();
    return result + m_turns.capacity() * sizeof(Turn);
  }

private:
  // The candidates of an iteration of a parallel loop, and the thread whose list has them.
  struct Turn
  {
    std::size_t thread;
    std::size_t first, beyond;
  };

  template <std::size_t COUNT, typename Graph>
  struct Arc_visitor
  {
    void operator()(const Node target, const double length) const
    {
      if constexpr(!has_maximum_degree<Graph>)
      {
        list.m_size = static_cast<std::size_t>(end - list.m_memory.data());
        end = list.reserve(1); // which may move the others
      }
      end = append(end, target, length);
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
      list.m_number_of_arcs += COUNT;
      CGAL_assertion(position < list.m_memory.data() + list.m_memory.size());
      set(*position, node, target, distance + length);
      return position + static_cast<std::ptrdiff_t>(position->distance < distances[target]);
    }

    Candidate_list& list;
    const double* distances; // labels
    double distance;
    Node node;
    Candidate*& end;
  };

  // Not inline: inlined beside the calls of a watch, this loop would spill registers.
  template <std::size_t COUNT, typename Graph, typename Labels>
  BOOST_NOINLINE void append_counted_arcs(const Graph& graph,
                                          const Node* const nodes,
                                          const std::size_t number,
                                          const Labels& labels)
  {
    const double* const distances = m_distances; // kept in a register
    std::size_t largest_degree = 1;
    if constexpr(has_maximum_degree<Graph>)
      largest_degree = graph.maximum_degree();
    for(std::size_t i = 0; i < number; ++i)
    {
      Candidate* end = reserve(largest_degree);
      graph.for_each_arc(
          nodes[i], labels,
          Arc_visitor<COUNT, Graph>{*this, distances, distances[nodes[i]], nodes[i], end});
      m_size = static_cast<std::size_t>(end - m_memory.data());
    }
  }

  static void
  set(Candidate& candidate, const Node predecessor, const Node node, const double distance)
  {
    candidate.distance = distance;
    candidate.node = node;
    candidate.predecessor = predecessor;
  }

  // Returns the position of the next candidate.
  Candidate* reserve(const std::size_t room)
  {
    if(m_memory.size() < m_size + room)
      m_memory.resize(2 * (m_size + room));
    return m_memory.data() + m_size;
  }

  std::vector<Candidate> m_memory;
  std::size_t m_size = 0;
  std::size_t m_number_of_arcs = 0;
  const double* m_distances = nullptr;
  bool m_counts = false;
  std::optional<Queue_entry> m_next_call;
  std::vector<Candidate_list> m_lists; // by thread, for locality
  std::size_t m_thread = 0;
  std::vector<Turn> m_turns;
};

// Whether nodes are expanded too often. A rounded heuristic can cause this: sums with it absorb
// very short arcs, so that keys do not order their nodes.
inline bool reopens_too_often(const Labels& labels)
{
  constexpr std::size_t most_expansions_per_node = 3;
  return labels.order().size() / most_expansions_per_node > labels.number_of_nodes();
}

/*
 * The three loops that process a batch of entries. `Propagation.h` describes the algorithm. In the
 * first and the second one, no branch depends on a distance.
 */
template <typename Graph, typename Queue, typename Heuristic>
class Batch_relaxation
{
  using Node = Labels::Node;

public:
  using Run = Run_of<Graph>;
  using Candidates = Candidate_list<typename Run::Payload>;

  // `candidates` is a workspace, and `limit` the largest distance, in units of the graph. Counts if
  // `statistics` is not null.
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

  // Expands nodes until the queue is empty, or nodes are expanded too often. Returns false if the
  // watch stopped it.
  template <typename Watch>
  bool run(Watch& watch, const bool reports_progress = true)
  {
    constexpr std::size_t nodes_between_looks = 1024;
    std::size_t next_look = m_labels.order().size() + nodes_between_looks;
    while(!m_queue.is_empty())
    {
      if constexpr(is_heuristic<Heuristic>)
        if(reopens_too_often(m_labels))
        {
          m_labels.append_to_order(m_queue);
          m_queue.clear();
          return true;
        }
      if(m_labels.order().size() >= next_look)
      {
        next_look = m_labels.order().size() + nodes_between_looks;
        look_for_interruption(reports_progress);
      }
      const auto& batch = next_batch();
      extract(batch);
      if(!watch.go_further(m_size))
        return false;
      if(m_size == 0 && !is_requested(batch)) // all entries are stale
        continue;
      // The second loop: scans the arcs of these nodes, and lists those that lower a label.
      m_candidates.start(m_labels.distances(), m_statistics != nullptr);
      const auto& order = m_labels.order();
      m_run.expand(order.data() + (order.size() - m_size), m_size,
                   static_cast<const Labels&>(m_labels), m_candidates);
      const std::size_t number_lowered = lower_labels();
      if(m_statistics != nullptr)
        count(number_lowered);
    }
    return true;
  }

  // The number of nodes that the first loop appended.
  std::size_t size() const { return m_size; }

private:
  BOOST_NOINLINE void look_for_interruption(const bool reports_progress) const
  {
    if(reports_progress)
      check_for_interruption(m_labels.order().size(), m_labels.number_of_nodes());
    else
      check_for_interruption();
  }

  decltype(auto) next_batch()
  {
    if constexpr(has_rounds<Queue>)
      if(m_run.largest_batch() > 0)
        return m_queue.extract_round(m_run.largest_batch());
    return m_queue.extract_min();
  }

  // The first loop: appends the nodes of a batch to the order, except for those of stale entries.
  template <typename Batch>
  void extract(const Batch& batch)
  {
    const double* const distances = m_labels.distances(); // kept in a register
    auto& order = m_labels.order();
    const std::size_t first = order.size();
    order.resize(first + batch.size());
    Node* end = order.data() + first;
    if constexpr(is_heuristic<Heuristic>)
      m_smallest_key = infinity;
    for(const auto& [key, node] : batch)
    {
      if constexpr(is_heuristic<Heuristic>)
        m_smallest_key = (std::min)(m_smallest_key, key);
      if constexpr(has_prefetch<Graph>)
        m_graph.prefetch(node);
      *end = node;
      end += static_cast<std::ptrdiff_t>(!is_stale(key, distances[node], node));
    }
    order.resize(static_cast<std::size_t>(end - order.data()));
    m_size = order.size() - first;
    if(m_statistics != nullptr)
    {
      m_statistics->pops += batch.size() - m_size;
      m_statistics->stale_pops += batch.size() - m_size;
    }
  }

  // Whether an entry is stale: its node was entered again since then, with a smaller key. The entry
  // of the present label never is. So every node with a label is in the order or in the queue, and
  // its label is reset before the next run.
  bool is_stale(const double key, const double distance, const Node node) const
  {
    if constexpr(is_heuristic<Heuristic>)
      if(key <= m_largest_raised_key)
        return false;
    return is_above(key, distance, node, m_heuristic);
  }

  // Whether the run of the graph has requested this call, though no node is to be expanded. The
  // request may be in the queue several times.
  template <typename Batch>
  bool is_requested(const Batch& batch) const
  {
    return std::any_of(batch.begin(), batch.end(), [this](const auto& entry) {
      const auto& [key, node] = entry;
      return m_request && m_request->key == key && m_request->node == node;
    });
  }

  // The third loop: lowers the labels of the candidates' nodes, and pushes these. Returns their
  // number.
  std::size_t lower_labels()
  {
    std::size_t number = 0;
    const double* const distances = m_labels.distances(); // kept in a register
    const std::size_t size = m_candidates.size();
    for(std::size_t i = 0; i < size; ++i)
    {
      const auto c = m_candidates[i];
      // earlier candidates may have lowered the label
      if(c.distance < distances[c.node] && c.distance <= m_limit)
      {
        m_labels.set(c.node, c.distance, c.predecessor);
        m_run.on_label(c.node, c.distance, c);
        m_queue.push(c.node, key(c.node, c.distance));
        ++number;
      }
    }
    m_request = m_candidates.next_call();
    if(m_request) // the entry will be stale
      m_queue.push(m_request->node, m_request->key);
    return number;
  }

  void count(const std::size_t number_lowered)
  {
    m_statistics->pops += m_size;
    m_statistics->relaxations += m_candidates.number_of_arcs();
    m_statistics->improvements += number_lowered;
  }

  // Keys must not decrease, and are raised if they do: by rounding, or because the heuristic is not
  // consistent. Those that are raised by more than rounding are remembered, as they would look like
  // keys of stale entries.
  double key(const Node node, const double distance)
  {
    if constexpr(is_heuristic<Heuristic>)
    {
      const double sum = distance + m_heuristic(node);
      if(sum >= m_smallest_key)
        return sum;
      if(m_smallest_key > m_largest_raised_key &&
         is_above(m_smallest_key, distance, node, m_heuristic))
        m_largest_raised_key = m_smallest_key;
      return m_smallest_key;
    }
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
  double m_smallest_key = 0;        // of the batch, if there is a heuristic
  double m_largest_raised_key = -1; // by more than rounding
  std::size_t m_size = 0;
  std::optional<Queue_entry> m_request; // of the graph's run, to be called again
  Propagation_statistics* m_statistics;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_BATCH_RELAXATION_H
