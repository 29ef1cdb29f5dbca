// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_INTERNAL_VERTICES_BEFORE_H
#define CGAL_APPROXIMATE_GEODESICS_INTERNAL_VERTICES_BEFORE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/internal/Path.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * For nodes that a search has reached, the vertex before them on the path, or the search's null
 * node if there is none. What is found on the way is kept, so that asking for all nodes takes time
 * in proportion to their number.
 */
template <typename Search>
class Vertices_before
{
  using Node = typename Search::Node;

public:
  explicit Vertices_before(const Search& search) : m_search(search) {}

  Node operator()(const Node node)
  {
    if constexpr(!has_places<typename Search::Graph>)
      return m_search.predecessor(node);
    if(m_before.empty())
      m_before.resize(m_search.graph().number_of_nodes(), Search::null_node);

    const Node vertex = vertex_of(node);
    m_way.clear();
    Node n = node;
    while(m_before[n] == Search::null_node)
    {
      const Node previous = m_search.predecessor(n);
      if(previous == Search::null_node)
        return keep(Search::null_node);
      m_way.push_back(n);
      const Node candidate = vertex_of(previous);
      if(candidate != Search::null_node && candidate != vertex)
        return keep(candidate);
      n = previous;
    }
    return keep(m_before[n]);
  }

private:
  // null_node if it is not a vertex, nor stands for one
  Node vertex_of(const Node node) const { return place(m_search.graph(), node).vertex; }

  Node keep(const Node before)
  {
    for(const Node n : m_way)
      m_before[n] = before;
    return before;
  }

  const Search& m_search;
  std::vector<Node> m_before; // null_node where it is not known
  std::vector<Node> m_way;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_INTERNAL_VERTICES_BEFORE_H
