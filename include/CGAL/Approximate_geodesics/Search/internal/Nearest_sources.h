// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_NEAREST_SOURCES_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_NEAREST_SOURCES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/Propagation_rules.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The seed that the shortest path to each node starts from. It follows from the predecessors, so a
 * search does not write it; it is found when asked for, and kept along the path that was followed.
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
      set_roots(labels, seeds);

    Node root = node;
    while(m_seed[root] == UNKNOWN)
      root = labels.predecessor(root);
    const Seed_index seed = m_seed[root];
    for(Node n = node; n != root; n = labels.predecessor(n))
      m_seed[n] = seed;
    return seeds[seed].source;
  }

  // To be called before the labels are forgotten.
  void forget(const Labels& labels)
  {
    if(m_has_roots)
      for(const Node node : labels.order())
        m_seed[node] = UNKNOWN;
    m_has_roots = false;
  }

  // To be called after the labels have changed in any other way.
  void forget_all()
  {
    if(m_has_roots)
      std::fill(m_seed.begin(), m_seed.end(), UNKNOWN);
    m_has_roots = false;
  }

  std::size_t memory() const { return m_seed.capacity() * sizeof(Seed_index); }

private:
  using Seed_index = std::uint32_t;
  static constexpr Seed_index UNKNOWN = (std::numeric_limits<Seed_index>::max)();

  void set_roots(const Labels& labels, const std::vector<Seed>& seeds)
  {
    m_seed.resize(labels.number_of_nodes(), UNKNOWN);
    for(std::size_t i = seeds.size(); i-- > 0;) // of equal seeds, the first wins
    {
      const Node node = seeds[i].node;
      if(labels.is_reached(node) && labels.predecessor(node) == Labels::null_node &&
         labels.distance(node) == seeds[i].distance)
        m_seed[node] = static_cast<Seed_index>(i);
    }
    m_has_roots = true;
  }

  std::vector<Seed_index> m_seed; // per node
  bool m_has_roots = false;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_NEAREST_SOURCES_H
