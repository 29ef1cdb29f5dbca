// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_VERTEX_PREDECESSORS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_VERTEX_PREDECESSORS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>

#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * For nodes that a search has reached, the vertex before them on the path, or the search's null
 * node if there is none. What is found on the way is kept, so that asking for all nodes takes time
 * in proportion to their number.
 */
template <typename Search>
class Vertex_predecessors
{
  using Node = typename Search::Node;

public:
  explicit Vertex_predecessors(const Search& search) : m_search(search)
  {
    if constexpr(has_positions<typename Search::Graph>)
    {
      const std::size_t number_of_nodes = search.graph().number_of_nodes();
      if(number_of_nodes > search.graph().triangulation().number_of_vertices())
        m_before.resize(number_of_nodes, Search::null_node);
    }
  }

  // Allocates nothing.
  Node operator()(const Node node)
  {
    if(m_before.empty()) // all nodes are vertices
      return m_search.predecessor(node);

    const Node vertex = vertex_of(node);
    Node result = m_before[node], end_of_way = node;
    while(result == Search::null_node)
    {
      end_of_way = m_search.predecessor(end_of_way);
      if(end_of_way == Search::null_node)
        return Search::null_node;
      const Node candidate = vertex_of(end_of_way);
      const bool is_another = candidate != Search::null_node && candidate != vertex;
      result = is_another ? candidate : m_before[end_of_way];
    }
    for(Node n = node; n != end_of_way; n = m_search.predecessor(n))
      m_before[n] = result;
    return result;
  }

private:
  // null_node if it is not a vertex, nor stands for one
  Node vertex_of(const Node node) const { return position(m_search.graph(), node).vertex; }

  const Search& m_search;
  std::vector<Node> m_before; // null_node where it is not known
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_VERTEX_PREDECESSORS_H
