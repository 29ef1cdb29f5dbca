// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_LABELS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_LABELS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_types.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The labels of a search: for each node, the smallest distance found so far and the predecessor on
 * that path; and the order in which nodes were expanded, from which labels are reset before the
 * next run. A run only touches nodes that it reaches. When it has ended, every node with a label is
 * in the order.
 */
class Labels
{
public:
  using Node = std::uint32_t;

  static constexpr Node null_node = (std::numeric_limits<Node>::max)();

  explicit Labels(const std::size_t number_of_nodes)
  {
    reserve_huge_pages(m_distance, number_of_nodes);
    m_distance.resize(number_of_nodes, infinity);
    resize_in_huge_pages(m_predecessor, number_of_nodes);
    reserve_huge_pages(m_order, number_of_nodes + number_of_nodes / 16); // for those expanded twice
  }

  std::size_t number_of_nodes() const { return m_distance.size(); }

  // in units of the graph
  const double* distances() const { return m_distance.data(); }
  double distance(const Node node) const { return m_distance[node]; }
  bool is_reached(const Node node) const { return m_distance[node] != infinity; }

  // of a node that was reached
  Node predecessor(const Node node) const { return m_predecessor[node]; }

  void set(const Node node, const double distance, const Node predecessor)
  {
    m_distance[node] = distance;
    m_predecessor[node] = predecessor;
  }

  const std::vector<Node>& order() const { return m_order; }
  std::vector<Node>& order() { return m_order; }

  // Appends the nodes in a queue, so that `forget()` resets their labels.
  template <typename Queue>
  void append_to_order(const Queue& queue)
  {
    queue.for_each_node([this](const Node node) { m_order.push_back(node); });
  }

  void discard(const Node node) { m_distance[node] = infinity; }

  // Resets the labels of a run that was not left by an exception.
  void forget()
  {
    reset(m_distance, m_order, infinity);
    m_order.clear();
    CGAL_expensive_assertion(std::all_of(m_distance.begin(), m_distance.end(),
                                         [](const double d) { return d == infinity; }));
  }

  void forget_all()
  {
    std::fill(m_distance.begin(), m_distance.end(), infinity);
    m_order.clear();
  }

  std::size_t memory() const { return memory_of(m_distance, m_predecessor, m_order); }

private:
  std::vector<double> m_distance;
  std::vector<Node> m_predecessor; // meaningful where the distance is finite
  std::vector<Node> m_order;
};

/*
 * The seed that the shortest path to each node starts from. It follows from the predecessors, so a
 * search does not write it; it is computed on request, and stored for all nodes on the path.
 */
class Nearest_sources
{
public:
  using Node = Labels::Node;

  static constexpr std::size_t null_source = (std::numeric_limits<std::size_t>::max)();

  std::size_t source(const Node node, const Labels& labels, const std::vector<Seed>& seeds)
  {
    if(!labels.is_reached(node))
      return null_source;
    if(!m_has_roots)
    {
      m_seed.resize(labels.number_of_nodes(), UNKNOWN);
      for(std::size_t i = seeds.size(); i-- > 0;) // of equal seeds, the first wins
        if(const Node n = seeds[i].node; labels.is_reached(n) &&
                                         labels.predecessor(n) == Labels::null_node &&
                                         labels.distance(n) == seeds[i].distance)
          m_seed[n] = static_cast<Seed_index>(i);
      m_has_roots = true;
    }

    Node root = node;
    while(m_seed[root] == UNKNOWN)
      root = labels.predecessor(root);
    const Seed_index seed = m_seed[root];
    for(Node n = node; n != root; n = labels.predecessor(n))
      m_seed[n] = seed;
    return seeds[seed].source;
  }

  // Must be called before the labels are reset.
  void forget(const Labels& labels)
  {
    if(m_has_roots)
      reset(m_seed, labels.order(), UNKNOWN);
    m_has_roots = false;
  }

  // Must be called after the labels have changed in any other way.
  void forget_all()
  {
    if(m_has_roots)
      std::fill(m_seed.begin(), m_seed.end(), UNKNOWN);
    m_has_roots = false;
  }

  std::size_t memory() const { return memory_of(m_seed); }

private:
  using Seed_index = std::uint32_t;
  static constexpr Seed_index UNKNOWN = (std::numeric_limits<Seed_index>::max)();

  std::vector<Seed_index> m_seed; // per node
  bool m_has_roots = false;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_LABELS_H
