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
#include <cstddef>
#include <limits>
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
    m_epsilon = search.starts_from_curves() ? epsilon_from_samples(graph().m_rules)
                                            : graph().m_rules.epsilon;
  }

  // Several threads take part if there is enough to do for them.
  template <typename Labels, typename Candidates>
  void expand(const Node* const nodes,
              const std::size_t number,
              const Labels& labels,
              Candidates& candidates)
  {
    constexpr std::size_t fewest_nodes = 64;
    m_is_expanded.resize(graph().number_of_nodes());
    const std::size_t number_of_turns = (number + NODES_AT_A_TIME - 1) / NODES_AT_A_TIME;
    const auto expand_some = [&](const std::size_t i, Candidates& part, Front_memory& memory) {
      boost::container::small_vector<Node, NODES_AT_A_TIME> together;
      const Node* const beyond = nodes + (std::min)((i + 1) * NODES_AT_A_TIME, number);
      for(const Node* n = nodes + i * NODES_AT_A_TIME; n != beyond; ++n)
        if(const Node node = *n; graph().advances_together() && !m_is_expanded[node])
          together.push_back(node);
        else
          graph().find_arcs_in_turn(
              node, m_is_expanded[node], labels, [&](const Node target, const double length) {
                part.make_room(1);
                part.append(true, node, labels.distance(node), target, length);
              });
      graph().expand(together.data(), together.size(), m_epsilon, labels, part, memory);
    };
    if(graph().is_parallel() && number >= fewest_nodes)
      candidates.append_in_parallel(graph().m_loop, number_of_turns,
                                    [&](const std::size_t i, Candidates& part) {
                                      Front_memory memory;
                                      expand_some(i, part, memory);
                                    });
    else
      for(std::size_t i = 0; i < number_of_turns; ++i)
        expand_some(i, candidates, m_memory);
    for(std::size_t i = 0; i < number; ++i)
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

  // In a larger batch, more nodes get shorter paths from other nodes of the batch, and have to be
  // expanded again.
  std::size_t largest_batch() const { return graph().is_parallel() ? 4 * NODES_AT_A_TIME : 0; }

  std::size_t memory() const { return memory_of(m_is_expanded, m_memory); }

private:
  static constexpr std::size_t NODES_AT_A_TIME = 32;

  double m_epsilon;
  std::vector<bool> m_is_expanded; // empty before the first expansion
  Front_memory m_memory;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_RUN_H
