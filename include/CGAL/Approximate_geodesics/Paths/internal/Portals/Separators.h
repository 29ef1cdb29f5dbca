// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_SEPARATORS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_SEPARATORS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Paths/internal/Portals/Two_way_arcs.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <algorithm>
#include <array>
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
 * Nodes are ranked by their distances from a node, or by the difference of those from two nodes;
 * there are three that are far from each other. Nodes below a rank with an arc to one that is not
 * below it are a separator. Of all rankings and ranks, the smallest separator is taken that leaves
 * no more than about two thirds on one side.
 */
class Separator
{
  using Node = Two_way_arcs::Node;

public:
  // `search` belongs to the same arcs.
  Separator(const Two_way_arcs& arcs, Two_way_search& search, Part_nodes part)
    : m_search(search), m_part(std::move(part))
  {
    std::sort(m_part.begin(), m_part.end());
    find_neighbors(arcs);
    find_distances();
    for(std::size_t i = 0; i < m_distances.size(); ++i)
    {
      try_ranking([&](const std::size_t node) { return m_distances[i][node]; });
      for(std::size_t j = 0; j < i; ++j)
        try_ranking(
            [&](const std::size_t node) { return m_distances[i][node] - m_distances[j][node]; });
    }
    sort_nodes();
  }

  // From one end of the separator to the other.
  Part_nodes& nodes() { return m_nodes; }
  // What is left.
  Part_nodes& side(const std::size_t i) { return m_side[i]; }

private:
  void search_from(const Node node, const Part_nodes& targets)
  {
    m_search.run({Seed{node}}, Stop_rule{std::numeric_limits<double>::infinity(), targets});
  }

  double distance(const Node node) const { return m_search.labels().distance(node); }

  // Returns the farthest of some nodes from one of them.
  Node farthest_from(const Node node, const Part_nodes& nodes)
  {
    search_from(node, nodes);
    return *std::max_element(nodes.begin(), nodes.end(), [this](const Node a, const Node b) {
      return std::make_pair(distance(a), b) < std::make_pair(distance(b), a);
    });
  }

  // Neighbors in the part, by their places there.
  void find_neighbors(const Two_way_arcs& arcs)
  {
    m_first_neighbor.push_back(0);
    for(std::size_t i = 0; i < m_part.size(); ++i)
    {
      check_for_interruption_at(i);
      arcs.for_each_neighbor(m_part[i], [this](const Node node) {
        const auto found = std::lower_bound(m_part.begin(), m_part.end(), node);
        if(found != m_part.end() && *found == node)
          m_neighbor.push_back(static_cast<Node>(found - m_part.begin()));
      });
      m_first_neighbor.push_back(m_neighbor.size());
    }
  }

  // Each of the nodes that they are from is far from those before it.
  void find_distances()
  {
    std::vector<double> nearest(m_part.size(), infinity);
    Node next = farthest_from(m_part.front(), m_part);
    for(std::vector<double>& distances : m_distances)
    {
      search_from(next, m_part);
      distances.resize(m_part.size());
      for(std::size_t i = 0; i < m_part.size(); ++i)
      {
        distances[i] = distance(m_part[i]);
        nearest[i] = (std::min)(nearest[i], distances[i]);
      }
      const auto farthest = std::max_element(nearest.begin(), nearest.end());
      next = m_part[static_cast<std::size_t>(farthest - nearest.begin())];
    }
  }

  // Keeps a separator if it is smaller than those before it.
  template <typename F>
  void try_ranking(const F& key_of)
  {
    const std::size_t size = m_part.size();
    std::vector<std::pair<double, std::size_t>> ranked;
    for(std::size_t i = 0; i < size; ++i)
      ranked.emplace_back(key_of(i), i);
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::size_t> rank_of(size);
    for(std::size_t i = 0; i < size; ++i)
      rank_of[ranked[i].second] = i;
    std::vector<std::size_t> highest = rank_of; // of a node and its neighbors
    for(std::size_t i = 0; i < size; ++i)
      for(std::size_t j = m_first_neighbor[i]; j < m_first_neighbor[i + 1]; ++j)
        highest[i] = (std::max)(highest[i], rank_of[m_neighbor[j]]);
    const auto [rank, number] = best_rank(rank_of, highest);
    if(m_side[1].empty() || number < m_nodes.size())
      divide(rank_of, highest, rank);
  }

  // Returns where to divide, and the size of the separator. A node is in those at the ranks above
  // its own, up to that of its highest neighbor.
  static std::pair<std::size_t, std::size_t> best_rank(const std::vector<std::size_t>& rank_of,
                                                       const std::vector<std::size_t>& highest)
  {
    const std::size_t size = rank_of.size();
    std::vector<std::size_t> more(size + 2), fewer(size + 2);
    for(std::size_t i = 0; i < size; ++i)
    {
      ++more[rank_of[i] + 1];
      ++fewer[highest[i] + 1];
    }
    std::size_t number = 0, smallest = size, result = size / 2;
    for(std::size_t rank = 0; rank <= 2 * size / 3; ++rank)
    {
      number = number + more[rank] - fewer[rank];
      if(rank >= size / 3 && number < smallest)
      {
        smallest = number;
        result = rank;
      }
    }
    return {result, smallest};
  }

  void divide(const std::vector<std::size_t>& rank_of,
              const std::vector<std::size_t>& highest,
              const std::size_t rank)
  {
    m_nodes.clear();
    m_side[0].clear();
    m_side[1].clear();
    for(std::size_t i = 0; i < m_part.size(); ++i)
      (rank_of[i] >= rank   ? m_side[1]
       : highest[i] >= rank ? m_nodes
                            : m_side[0])
          .push_back(m_part[i]);
  }

  // Neighbors in this order are near to each other, so that the same portals serve them.
  void sort_nodes()
  {
    if(m_nodes.empty())
      return;
    search_from(farthest_from(m_nodes.front(), m_nodes), m_nodes);
    std::stable_sort(m_nodes.begin(), m_nodes.end(),
                     [this](const Node a, const Node b) { return distance(a) < distance(b); });
  }

  Two_way_search& m_search;
  Part_nodes m_part;
  std::vector<std::size_t> m_first_neighbor;
  std::vector<Node> m_neighbor;
  std::array<std::vector<double>, 3> m_distances;
  Part_nodes m_nodes;
  std::array<Part_nodes, 2> m_side;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PORTALS_SEPARATORS_H
