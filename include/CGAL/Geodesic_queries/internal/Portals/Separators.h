// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_SEPARATORS_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_SEPARATORS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>
#include <CGAL/Geodesic_queries/internal/Portals/Two_way_arcs.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

using Two_way_search = Propagation<Two_way_arcs>;

// Nodes of a graph.
using Part_nodes = std::vector<Two_way_arcs::Node>;

// Returns the connected parts that a graph has without some nodes, in the order of their smallest
// nodes. Nodes of a part are sorted.
inline std::vector<Part_nodes> connected_parts(const Two_way_arcs& arcs,
                                               const Part_nodes& removed = {})
{
  using Node = Two_way_arcs::Node;
  std::vector<bool> is_known(arcs.number_of_nodes());
  for(const Node node : removed)
    is_known[node] = true;
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
    std::sort(part.begin(), part.end());
    result.push_back(std::move(part));
  }
  return result;
}

/*
 * A separator of a connected graph: nodes without which it falls into parts.
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
  Separator(const Two_way_arcs& arcs, Two_way_search& search) : m_arcs(arcs), m_search(search)
  {
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

private:
  double distance(const Node node) const { return m_search.labels().distance(node); }

  // Each of the nodes that they are from is far from those before it.
  void find_distances()
  {
    const std::size_t size = m_arcs.number_of_nodes();
    std::vector<double> nearest(size, infinity);
    m_search.run_from(0);
    const double* row = m_search.labels().distances();
    auto next = static_cast<Node>(std::max_element(row, row + size) - row);
    for(std::vector<double>& distances : m_distances)
    {
      m_search.run_from(next);
      row = m_search.labels().distances();
      distances.assign(row, row + size);
      for(std::size_t i = 0; i < size; ++i)
        nearest[i] = (std::min)(nearest[i], distances[i]);
      next = static_cast<Node>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    }
  }

  // Keeps a separator if it is smaller than those before it.
  template <typename F>
  void try_ranking(const F& key_of)
  {
    const std::size_t size = m_arcs.number_of_nodes();
    std::vector<std::pair<double, Node>> ranked;
    for(Node i = 0; i < size; ++i)
      ranked.emplace_back(key_of(i), i);
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::size_t> rank_of(size);
    for(std::size_t i = 0; i < size; ++i)
      rank_of[ranked[i].second] = i;
    std::vector<std::size_t> highest = rank_of; // of a node and its neighbors
    for(Node i = 0; i < size; ++i)
      m_arcs.for_each_neighbor(
          i, [&](const Node j) { highest[i] = (std::max)(highest[i], rank_of[j]); });
    const auto [rank, number] = best_rank(rank_of, highest);
    if(m_is_found && number >= m_nodes.size())
      return;
    m_is_found = true;
    m_nodes.clear();
    for(Node i = 0; i < size; ++i)
      if(rank_of[i] < rank && highest[i] >= rank)
        m_nodes.push_back(i);
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

  // Neighbors in this order are near to each other, so that the same portals serve them.
  void sort_nodes()
  {
    if(m_nodes.empty())
      return;
    m_search.run_from(m_nodes.front());
    m_search.run_from(
        *std::max_element(m_nodes.begin(), m_nodes.end(), [this](const Node a, const Node b) {
          return distance(a) < distance(b);
        }));
    std::stable_sort(m_nodes.begin(), m_nodes.end(),
                     [this](const Node a, const Node b) { return distance(a) < distance(b); });
  }

  const Two_way_arcs& m_arcs;
  Two_way_search& m_search;
  std::array<std::vector<double>, 3> m_distances;
  bool m_is_found = false;
  Part_nodes m_nodes;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_PORTALS_SEPARATORS_H
