// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_COSTS_INTERNAL_STAR_GROUPS_H
#define CGAL_GEODESIC_COSTS_INTERNAL_STAR_GROUPS_H

#include <CGAL/license/Geodesic_costs.h>

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The groups of nodes of a graph with arcs there and back, as `GeodesicGraph` says for searches
 * that are repaired: a node and its neighbors are a group, with the number of the node.
 */
template <typename Graph>
class Star_groups
{
public:
  explicit Star_groups(const Graph& graph) : m_graph(graph) {}

  std::size_t number_of_groups() const { return m_graph.number_of_nodes(); }

  template <typename F>
  void for_each_group(const Index node, F f) const
  {
    f(std::size_t(node));
  }

  template <typename F>
  void for_each_node_of_group(const std::size_t group, F f) const
  {
    const auto node = static_cast<Index>(group);
    f(node);
    m_graph.for_each_arc(node, No_labels(), [&](const Index target, double) { f(target); });
  }

private:
  struct No_labels
  {
  };

  const Graph& m_graph;
};

// The groups of a graph: its own, if it has any, or those of the edge graph.
template <typename Graph>
using Groups_of =
    std::conditional_t<std::is_same_v<Graph, Edge_graph>, Star_groups<Graph>, const Graph&>;

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_COSTS_INTERNAL_STAR_GROUPS_H
