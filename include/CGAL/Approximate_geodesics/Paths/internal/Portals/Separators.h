// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_SEPARATORS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_SEPARATORS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Two_way_arcs.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

using Two_way_search = Propagation<Two_way_arcs>;

// Nodes of a graph: a connected part of it, or what separators have left of one.
using Part_nodes = std::vector<Two_way_arcs::Node>;

// Returns the connected parts of a graph, in the order of their smallest nodes.
inline std::vector<Part_nodes> connected_parts(const Two_way_arcs& arcs)
{
  using Node = Two_way_arcs::Node;
  std::vector<bool> is_known(arcs.number_of_nodes());
  std::vector<Part_nodes> result;
  for(Node first = 0; first < arcs.number_of_nodes(); ++first)
  {
    if(is_known[first])
      continue;
    is_known[first] = true;
    Part_nodes part = {first};
    for(std::size_t i = 0; i < part.size(); ++i)
    {
      check_for_interruption_at(i);
      arcs.for_each_neighbor(part[i], [&](const Node node) {
        if(!is_known[node])
          part.push_back(node);
        is_known[node] = true;
      });
    }
    result.push_back(std::move(part));
  }
  return result;
}

/*
 * A separator of a part: nodes such that no arc joins the two sides that are left.
 *
 * Nodes are ranked by the difference of their distances from two nodes that are far from each
 * other. Those below a rank with an arc to one that is not below it are a separator, and the
 * smallest one is taken that leaves no more than about two thirds on one side.
 */
class Separator
{
  using Node = Two_way_arcs::Node;

public:
  // `search` belongs to the same arcs.
  Separator(const Two_way_arcs& arcs, Two_way_search& search, Part_nodes part)
    : m_arcs(arcs), m_search(search), m_ranked(std::move(part))
  {
    rank_nodes();
    find_highest_neighbors();
    divide(best_rank());
    sort_nodes();
  }

  // From one end of the separator to the other.
  Part_nodes& nodes() { return m_nodes; }
  // What is left.
  Part_nodes& side(const std::size_t i) { return m_side[i]; }

private:
  struct Ranked_node
  {
    double difference;
    Node node;
    bool operator<(const Ranked_node& other) const
    {
      return std::make_pair(difference, node) < std::make_pair(other.difference, other.node);
    }
  };

  void search_from(const Node node, const Part_nodes& targets)
  {
    m_search.run({Seed{node}}, Stop_rule{std::numeric_limits<double>::infinity(), targets});
  }

  double distance(const Node node) const { return m_search.labels().distance(node); }

  // Returns the farthest of some nodes from one of them, after a search from there.
  Node farthest_from(const Node node, const Part_nodes& nodes)
  {
    search_from(node, nodes);
    return *std::max_element(nodes.begin(), nodes.end(), [this](const Node a, const Node b) {
      return std::make_pair(distance(a), b) < std::make_pair(distance(b), a);
    });
  }

  void rank_nodes()
  {
    std::sort(m_ranked.begin(), m_ranked.end());
    const Node one = farthest_from(m_ranked.front(), m_ranked);
    const Node other = farthest_from(one, m_ranked);
    std::vector<Ranked_node> ranked;
    for(const Node node : m_ranked)
      ranked.push_back({distance(node), node});
    search_from(other, m_ranked);
    for(Ranked_node& r : ranked)
      r.difference -= distance(r.node);
    std::sort(ranked.begin(), ranked.end());
    std::transform(ranked.begin(), ranked.end(), m_ranked.begin(),
                   [](const Ranked_node& r) { return r.node; });
  }

  // For each rank, the highest one among the neighbors of the node.
  void find_highest_neighbors()
  {
    m_by_number.reserve(m_ranked.size());
    for(std::size_t i = 0; i < m_ranked.size(); ++i)
      m_by_number.emplace_back(m_ranked[i], i);
    std::sort(m_by_number.begin(), m_by_number.end());
    m_highest.resize(m_ranked.size());
    for(std::size_t i = 0; i < m_ranked.size(); ++i)
    {
      m_highest[i] = i;
      m_arcs.for_each_neighbor(m_ranked[i], [&](const Node node) {
        const auto found = std::lower_bound(m_by_number.begin(), m_by_number.end(),
                                            std::make_pair(node, std::size_t(0)));
        if(found != m_by_number.end() && found->first == node)
          m_highest[i] = (std::max)(m_highest[i], found->second);
      });
    }
  }

  // Returns where to divide. The node of rank `i` is in the separators at the ranks from `i + 1` to
  // that of its highest neighbor.
  std::size_t best_rank() const
  {
    const std::size_t size = m_ranked.size();
    std::vector<std::ptrdiff_t> change(size + 2);
    for(std::size_t i = 0; i < size; ++i)
    {
      ++change[i + 1];
      --change[m_highest[i] + 1];
    }
    std::ptrdiff_t number = 0, smallest = (std::numeric_limits<std::ptrdiff_t>::max)();
    std::size_t result = size / 2;
    for(std::size_t rank = 0; rank <= 2 * size / 3; ++rank)
    {
      number += change[rank];
      if(rank >= size / 3 && number < smallest)
      {
        smallest = number;
        result = rank;
      }
    }
    return result;
  }

  void divide(const std::size_t rank)
  {
    for(std::size_t i = 0; i < m_ranked.size(); ++i)
      (i >= rank ? m_side[1] : m_highest[i] >= rank ? m_nodes : m_side[0]).push_back(m_ranked[i]);
  }

  // Neighbors in this order are near to each other, so that the same portals serve them.
  void sort_nodes()
  {
    if(m_nodes.empty())
      return;
    std::sort(m_nodes.begin(), m_nodes.end());
    search_from(farthest_from(m_nodes.front(), m_nodes), m_nodes);
    std::stable_sort(m_nodes.begin(), m_nodes.end(),
                     [this](const Node a, const Node b) { return distance(a) < distance(b); });
  }

  const Two_way_arcs& m_arcs;
  Two_way_search& m_search;
  Part_nodes m_ranked;                                   // the nodes of the part
  std::vector<std::pair<Node, std::size_t>> m_by_number; // and their ranks
  std::vector<std::size_t> m_highest;
  Part_nodes m_nodes;
  Part_nodes m_side[2];
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_SEPARATORS_H
