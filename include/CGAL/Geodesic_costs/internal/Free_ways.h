// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_FREE_WAYS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_FREE_WAYS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>
#include <CGAL/Approximate_geodesics/Search/internal/extensions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Where arcs cost nothing, a search has no reason to prefer a straight way to one that wanders.
 * These are the paths of least cost whose free ways are shortest, as a tree like that of the
 * search.
 *
 * Labels do not depend on the order in which a search expands nodes, and neither does which arcs
 * attain them. So a second search, over those arcs alone, gives the same paths after any search. It
 * follows the labels: nodes with equal labels, which free arcs join, are settled by the length of
 * free ways behind them. It takes longer than the first search, as it looks at all arcs, and is
 * only made when a path is asked for, and the first one has taken a free arc.
 */
template <typename Graph>
class Free_ways
{
  using Node = Labels::Node;
  using Seed_index = std::uint32_t;

public:
  static constexpr Seed_index null_seed = (std::numeric_limits<Seed_index>::max)();

  // Returns whether there are free ways; they are found at the first call after `forget()`.
  bool exist(const Graph& graph, const Labels& labels, const std::vector<Seed>& seeds)
  {
    if(m_state == UNKNOWN)
      find(graph, labels, seeds);
    return m_state == EXIST;
  }

  // Returns whether they have been found.
  bool are_known() const { return m_state == EXIST; }

  // \pre There are free ways, and the node was reached.

  Node predecessor(const Node node) const { return m_ways[node].predecessor; }
  Seed_index seed(const Node node) const { return m_ways[node].seed; }
  // that of the free parts of the path
  double length(const Node node) const { return m_ways[node].length; }

  // Must be called before labels change.
  void forget()
  {
    m_state = UNKNOWN;
    for(const Node node : m_nodes)
      m_ways[node] = Way();
    m_nodes.clear();
  }

  // Must be called when a run starts: there are no ways until `forget()`, as labels are not final.
  void wait()
  {
    forget();
    m_state = NONE;
  }

  std::size_t memory() const { return memory_of(m_ways, m_nodes); }

private:
  enum State
  {
    UNKNOWN,
    NONE,
    EXIST
  };

  struct Way
  {
    double length = infinity;
    Node predecessor = Labels::null_node;
    Seed_index seed = null_seed;
    bool is_settled = false;
  };

  // Labels with which a graph reports all arcs of a node.
  struct Only_label
  {
    double distance(const Node other) const { return other == node ? 0 : infinity; }
    static Node predecessor(Node /* node */) { return Labels::null_node; }

    Node node;
  };

  using Entry = std::pair<double, Node>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

  void find(const Graph& graph, const Labels& labels, const std::vector<Seed>& seeds)
  {
    if(!graph.has_free_arcs() || !takes_free_arc(labels))
    {
      m_state = NONE;
      return;
    }
    try
    {
      m_ways.resize(labels.number_of_nodes());
      list_nodes(labels);
      start(labels, seeds);
      for(std::size_t first = 0; first < m_nodes.size();)
      {
        const auto beyond = static_cast<std::size_t>(
            std::find_if(m_nodes.begin() + static_cast<std::ptrdiff_t>(first), m_nodes.end(),
                         [&](const Node node) {
                           return labels.distance(node) != labels.distance(m_nodes[first]);
                         }) -
            m_nodes.begin());
        settle(first, beyond, graph, labels);
        first = beyond;
      }
      m_state = EXIST;
    }
    catch(...)
    {
      forget();
      throw;
    }
  }

  // Returns whether the search has taken an arc that left the label as it was.
  static bool takes_free_arc(const Labels& labels)
  {
    return std::any_of(labels.order().begin(), labels.order().end(), [&](const Node node) {
      return labels.is_reached(node) && labels.predecessor(node) != Labels::null_node &&
             labels.distance(labels.predecessor(node)) == labels.distance(node);
    });
  }

  // Lists the nodes that were reached, by their labels.
  void list_nodes(const Labels& labels)
  {
    m_nodes.reserve(labels.order().size());
    for(const Node node : labels.order())
      if(labels.is_reached(node))
        m_nodes.push_back(node);
    const auto key = [&](const Node node) { return std::make_pair(labels.distance(node), node); };
    std::sort(m_nodes.begin(), m_nodes.end(),
              [&](const Node a, const Node b) { return key(a) < key(b); });
    m_nodes.erase(std::unique(m_nodes.begin(), m_nodes.end()), m_nodes.end());
  }

  void start(const Labels& labels, const std::vector<Seed>& seeds)
  {
    for(std::size_t i = 0; i < seeds.size(); ++i)
      if(Way& way = m_ways[seeds[i].node];
         labels.distance(seeds[i].node) == seeds[i].distance && seeds[i].free_length < way.length)
        way = {seeds[i].free_length, Labels::null_node, static_cast<Seed_index>(i), false};
  }

  // Settles the nodes of a range, which have the same label.
  void settle(const std::size_t first,
              const std::size_t beyond,
              const Graph& graph,
              const Labels& labels)
  {
    Queue queue;
    for(std::size_t i = first; i < beyond; ++i)
      if(m_ways[m_nodes[i]].length < infinity)
        queue.push({m_ways[m_nodes[i]].length, m_nodes[i]});
    settle(queue, graph, labels);
    // the search may have taken an arc that the graph leaves out
    for(std::size_t i = first; i < beyond; ++i)
      while(!m_ways[m_nodes[i]].is_settled)
      {
        follow_search(m_nodes[i], labels, queue);
        settle(queue, graph, labels);
      }
  }

  void settle(Queue& queue, const Graph& graph, const Labels& labels)
  {
    for(; !queue.empty(); ++m_number_settled)
    {
      const auto [length, node] = queue.top();
      queue.pop();
      if(m_ways[node].is_settled)
        continue;
      check_for_interruption_at(m_number_settled);
      m_ways[node].is_settled = true;
      relax(node, graph, labels, queue);
    }
  }

  void relax(const Node node, const Graph& graph, const Labels& labels, Queue& queue)
  {
    const double label = labels.distance(node), length = m_ways[node].length;
    const bool is_start = m_ways[node].predecessor == Labels::null_node;
    const auto offer = [&](const Node target, const double cost, const double length_of_arc) {
      if(label + cost == labels.distance(target) &&
         this->offer(target, length + length_of_arc, node) && labels.distance(target) == label)
        queue.push({length + length_of_arc, target});
    };
    graph.for_each_free_arc(node, is_start, one_by_one([&](const Node target, const double arc) {
                              offer(target, 0, arc);
                            }));
    graph.for_each_arc(node, Only_label{node},
                       one_by_one([&](const Node target, const double cost) {
                         if(cost > 0)
                           offer(target, cost, 0);
                       }));
  }

  // Makes a graph report arcs to consecutive nodes one by one.
  template <typename F>
  static auto one_by_one(const F& f)
  {
    return [f](const Node first, const auto arc, const auto... number) {
      if constexpr(sizeof...(number) == 0)
        f(first, arc);
      else
        for(std::size_t i = 0; i < (number + ...); ++i)
          f(first + static_cast<Node>(i), arc[i]);
    };
  }

  // Offers a way by a node. Returns whether it is better than the present one; of equal ways, that
  // by the first node is.
  bool offer(const Node target, const double length, const Node predecessor)
  {
    Way& way = m_ways[target];
    const bool is_better =
        length < way.length || (length == way.length && way.predecessor != Labels::null_node &&
                                predecessor < way.predecessor);
    if(way.is_settled || !is_better)
      return false;
    way = {length, predecessor, m_ways[predecessor].seed, false};
    return true;
  }

  // Gives the first node that is not settled, on the path of the search to this one, the way of the
  // node before. Those behind have to wait for it, or ways could go around in a circle.
  void follow_search(Node node, const Labels& labels, Queue& queue)
  {
    const auto before = [&](const Node n) {
      const Node result = labels.predecessor(n);
      return result != Labels::null_node && labels.is_reached(result) ? result : Labels::null_node;
    };
    while(before(node) != Labels::null_node && !m_ways[before(node)].is_settled)
      node = before(node);
    const Node last = before(node);
    m_ways[node] = last == Labels::null_node
                       ? Way{0, last, null_seed, false}
                       : Way{m_ways[last].length, last, m_ways[last].seed, false};
    queue.push({m_ways[node].length, node});
  }

  State m_state = UNKNOWN;
  std::vector<Way> m_ways;   // per node
  std::vector<Node> m_nodes; // those that were reached, by their labels
  std::size_t m_number_settled = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_FREE_WAYS_H
