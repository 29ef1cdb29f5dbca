// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_TREE_PATHS_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_TREE_PATHS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Paths in the shortest-path tree of a search. Lengths are in units of the graph, unless noted.

// Appends the edges that a line crosses. All lines use this function object, as graphs instantiate
// much code for its type.
struct Append_crossing
{
  void operator()(const Intrinsic_point::Index h, const double t) const
  {
    points.push_back(Intrinsic_point::on_edge(h, t));
  }

  std::vector<Intrinsic_point>& points;
};

// Appends the crossings of a line with edges, and adds its length. `for_each_crossing(f)` reports
// the crossings in the opposite order, and returns the length.
template <typename ForEachCrossing>
void append_backward(ForEachCrossing for_each_crossing, Path& path)
{
  const auto beyond = static_cast<std::ptrdiff_t>(path.points.size());
  path.length += for_each_crossing(Append_crossing{path.points});
  std::reverse(path.points.begin() + beyond, path.points.end());
}

// Appends the rest of the path from `node` back to the start of the search. Returns the last node.
template <typename Search>
typename Search::Node append_tree_path(const Search& search, typename Search::Node node, Path& path)
{
  for(auto previous = search.predecessor(node); previous != Search::null_node;
      previous = search.predecessor(node))
  {
    if constexpr(has_crossing_arcs<typename Search::Graph>)
      append_backward(
          [&](auto f) {
            return search.graph_run().for_each_crossing(previous, node, search.labels(), f);
          },
          path);
    else
      path.length += search.labels().distance(node) - search.labels().distance(previous);
    append(position(search.graph(), previous), search.graph().triangulation(), path);
    node = previous;
  }
  return node;
}

// The path from `node` back to the start of the search, with its length in the unit of the mesh; it
// has no points if `node` was not reached.
template <typename Search>
Path tree_path(const Search& search, const typename Search::Node node)
{
  Path result;
  if(!search.is_reached(node))
    return result;
  result.points.push_back(position(search.graph(), node));
  append_tree_path(search, node, result);
  result.length *= search.graph().unit();
  return result;
}

/*
 * The vertex before a node on its path, or the search's null node if there is none. Results are
 * kept along the path, so that run time for all nodes is linear.
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
  // null_node if the node is not at a vertex
  Node vertex_of(const Node node) const { return position(m_search.graph(), node).vertex; }

  const Search& m_search;
  std::vector<Node> m_before; // null_node where it is not known
};

// Returns a path that a search has found, from its target, as one from the source to the target of
// a pair.
template <typename SurfaceGraph>
Path from_source_to_target(const SurfaceGraph& graph, Path path)
{
  if(!leads_to_sources(graph))
    std::reverse(path.points.begin(), path.points.end());
  return path;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_TREE_PATHS_H
