// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_RUN_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_RUN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_front.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The run of a discrete geodesic graph. For paths, it bounds the rounding errors of lengths of
 * arcs, which are differences of labels.
 */
template <typename Graph>
class Arc_run : public Geodesic_run_base<Graph>
{
  using Base = Geodesic_run_base<Graph>;

public:
  using Node = Index;

  explicit Arc_run(const Graph& searched) : Base(searched) {}

  template <typename Labels, typename F>
  double
  for_each_crossing(const Node source, const Node target, const Labels& labels, const F& f) const
  {
    const double label = labels.distance(target), length = label - labels.distance(source);
    const double rounding = std::numeric_limits<double>::epsilon() * label;
    // lines more than twice as long are not searched for: this could take very long
    return graph().for_each_crossing(source, target, length, f, (std::min)(rounding, length));
  }

protected:
  using Base::graph;
};

/*
 * The run of a lazy graph, which records the nodes that were expanded. Nodes that are expanded for
 * the first time are expanded together. All arcs of nodes that are expanded again are computed, as
 * arcs that were of no use with the larger label may be needed.
 *
 * Some nodes of a batch get shorter paths over other ones, and would be expanded again. But few of
 * those paths are not along an edge. So the edges are looked at first: a node with a shorter path
 * along one waits, and only this arc is appended. This is why several threads can expand many nodes
 * of the queue at once.
 */
template <typename Graph>
class Cone_run : public Arc_run<Graph>
{
  using Base = Arc_run<Graph>;
  using Base::graph;

public:
  using Node = Index;

  explicit Cone_run(const Graph& searched) : Base(searched), m_epsilon(searched.epsilon()) {}

  template <typename Search>
  void start(Search& search)
  {
    m_epsilon = search.starts_from_curves() ? graph().m_rules.epsilon_from_samples()
                                            : graph().m_rules.epsilon;
  }

  // Several threads take part if there is enough to do for them.
  template <typename Labels, typename Candidates>
  void expand(const Node* const nodes,
              const std::size_t number,
              const Labels& labels,
              Candidates& candidates)
  {
    constexpr std::size_t fewest_nodes = 32;
    const Loop& loop = graph().m_loop;
    const bool is_shared = graph().is_parallel() && number >= fewest_nodes;
    m_is_expanded.resize(graph().number_of_nodes());
    m_waits.resize(number);
    m_memories.resize(
        (std::max)(m_memories.size(), is_shared ? loop.number_of_threads() : std::size_t(1)));
    const std::size_t size_of_turn = graph().is_parallel() ? SIZE_OF_TASK : LARGEST_FRONT;
    const std::size_t number_of_turns = (number + size_of_turn - 1) / size_of_turn;
    const auto take_turn = [&](const std::size_t i, Candidates& part, Front_memory& memory) {
      const std::size_t first = i * size_of_turn, beyond = (std::min)(first + size_of_turn, number);
      expand_some(nodes, first, beyond, labels, part, memory);
    };
    if(is_shared)
      candidates.append_in_parallel(loop, number_of_turns,
                                    [&](const std::size_t i, Candidates& part) {
                                      take_turn(i, part, m_memories[part.thread()]);
                                    });
    else
      for(std::size_t i = 0; i < number_of_turns; ++i)
        take_turn(i, candidates, m_memories.front());
    for(std::size_t i = 0; i < number; ++i)
      if(!m_waits[i])
        m_is_expanded[nodes[i]] = true;
  }

  void discard(const Node node)
  {
    if(!m_is_expanded.empty())
      m_is_expanded[node] = false;
  }

  void forget(const std::vector<Node>& nodes)
  {
    if(!m_is_expanded.empty())
      reset(m_is_expanded, nodes, false);
  }

  void forget_all() { m_is_expanded.clear(); }

  std::size_t largest_batch() const
  {
    if(!graph().is_parallel())
      return 0;
    return graph().advances_together() ? LARGEST_BATCH : LARGEST_BATCH_WITHOUT_WAITING;
  }

  std::size_t memory() const
  {
    std::size_t result = memory_of(m_is_expanded, m_waits, m_memories);
    for(const Front_memory& memory : m_memories)
      result += memory.memory();
    return result;
  }

private:
  static constexpr std::size_t LARGEST_FRONT = 32; // nodes that are expanded together
  static constexpr std::size_t SIZE_OF_TASK = 16;  // the same for several threads: short tasks

  // Entries, most of which are stale. In a larger batch, more nodes get shorter paths that are not
  // along an edge, and are expanded again: where sizes of faces vary, a third more at 512, and half
  // more at 4096. Without waiting, any shorter path counts.
  static constexpr std::size_t LARGEST_BATCH = 512, LARGEST_BATCH_WITHOUT_WAITING = 128;

  // Expands the nodes from the `first` one on, as a task of one thread.
  template <typename Labels, typename Candidates>
  void expand_some(const Node* const nodes,
                   const std::size_t first,
                   const std::size_t beyond,
                   const Labels& labels,
                   Candidates& candidates,
                   Front_memory& memory)
  {
    boost::container::small_vector<Node, LARGEST_FRONT> together;
    const bool advances_together = graph().advances_together();
    for(std::size_t i = first; i < beyond; ++i)
    {
      const Node node = nodes[i];
      m_waits[i] = advances_together && append_shorter_path(node, labels, candidates);
      if(m_waits[i])
        continue;
      if(advances_together && !m_is_expanded[node])
        together.push_back(node);
      else
        graph().find_arcs_in_turn(
            node, m_is_expanded[node], labels, [&](const Node target, const double length) {
              candidates.make_room(1);
              candidates.append(true, node, labels.distance(node), target, length);
            });
    }
    graph().expand(together.data(), together.size(), m_epsilon, labels, candidates, memory);
  }

  // As it is stored in a label: if it were compared with more digits, a node might wait for a path
  // that does not lower its label.
  using Sum = std::conditional_t<FLT_EVAL_METHOD == 0, double, volatile double>;

  // Appends the edges that lead to `node` and lower its label. Returns whether there are any.
  template <typename Labels, typename Candidates>
  bool append_shorter_path(const Node node, const Labels& labels, Candidates& candidates) const
  {
    const Intrinsic_triangulation& triangulation = graph().m_triangulation.get();
    const double label = labels.distance(node);
    bool result = false;
    for(Index h = triangulation.first_halfedge(node); h < triangulation.beyond_halfedge(node); ++h)
    {
      const Node neighbor = triangulation.target(h);
      const double label_of_neighbor = labels.distance(neighbor), length = triangulation.length(h);
      const Sum sum = label_of_neighbor + length;
      if(!(sum < label))
        continue;
      candidates.make_room(1);
      candidates.append(true, neighbor, label_of_neighbor, node, length);
      result = true;
    }
    return result;
  }

  double m_epsilon;
  std::vector<bool> m_is_expanded;      // empty before the first expansion
  std::vector<char> m_waits;            // by node of the batch; bytes, as several threads write
  std::vector<Front_memory> m_memories; // by thread
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_RUN_H
