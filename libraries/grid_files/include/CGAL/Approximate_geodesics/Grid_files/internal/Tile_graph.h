// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_TILE_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_TILE_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Arc_lengths.h>
#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>
#include <CGAL/Approximate_geodesics/Grid_files/internal/Grid_nodes.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <limits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The graph of a window, with arcs from the nodes of a tile only.
 */
template <typename Graph>
class Tile_graph
{
public:
  using Node = typename Graph::Node;

  static constexpr Node null_node = (std::numeric_limits<Node>::max)();

  Tile_graph(const Graph& graph,
             const Grid_window& own,
             const Grid_window& window,
             const Grid_nodes& all)
    : m_graph(graph),
      m_own(own),
      m_window(window),
      m_all(all),
      m_nodes(window.columns, window.rows, all.number_of_slots() - 1)
  {
    CGAL_assertion(m_nodes.number_of_nodes() == graph.number_of_nodes());
  }

  std::size_t number_of_nodes() const { return m_graph.number_of_nodes(); }
  double unit() const { return m_graph.unit(); }
  Arc_lengths arc_lengths() const { return m_graph.arc_lengths(); }
  std::size_t maximum_degree() const { return m_graph.maximum_degree(); }

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, const F& f) const
  {
    if(owns(place(node)))
      m_graph.for_each_arc(node, labels, f);
  }

  // The same, from any node.
  template <typename Labels, typename F>
  void for_each_arc_in_window(const Node node, const Labels& labels, const F& f) const
  {
    m_graph.for_each_arc(node, labels, f);
  }

  // of the window
  const Grid_nodes& nodes() const { return m_nodes; }

  // Places in the grid.
  Grid_place place(const Node node) const
  {
    Grid_place p = m_nodes.place(node);
    p.column += m_window.first_column;
    p.row += m_window.first_row;
    return m_all.in_grid(p);
  }

  // Returns the node at a place, or `null_node` if it is not in the window.
  Node node(const Grid_place& p) const
  {
    // numbers below 0 wrap around
    const Grid_place q =
        m_all.in_grid({p.column - m_window.first_column, p.row - m_window.first_row, p.slot});
    return q.column < m_nodes.columns() && q.row < m_nodes.rows() && m_nodes.has(q)
               ? static_cast<Node>(m_nodes.node(q))
               : null_node;
  }

  bool owns(const Grid_place& p) const
  {
    return p.column - m_own.first_column < m_own.columns && p.row - m_own.first_row < m_own.rows;
  }

  // Calls `f(node, place)` for all nodes of the window, in the order of places.
  template <typename F>
  void for_each_node(F f) const
  {
    const std::size_t beyond = m_window.first_column + m_nodes.columns();
    const std::size_t first =
        beyond > m_all.columns() ? m_all.columns() - m_window.first_column : 0;
    for(std::size_t row = 0; row < m_nodes.rows(); ++row)
      for(std::size_t i = 0; i < m_nodes.columns(); ++i)
      {
        const std::size_t column =
            first + i < m_nodes.columns() ? first + i : first + i - m_nodes.columns();
        for(std::size_t slot = m_nodes.has_center(column, row) ? 0 : 1;
            slot < m_nodes.number_of_slots(); ++slot)
          f(static_cast<Node>(m_nodes.node({column, row, slot})),
            m_all.in_grid({m_window.first_column + column, m_window.first_row + row, slot}));
      }
  }

  // Calls `f(place)` for all places of the tile.
  template <typename F>
  void for_each_own_place(F f) const
  {
    for(std::size_t row = 0; row < m_own.rows; ++row)
      for(std::size_t column = 0; column < m_own.columns; ++column)
        for(std::size_t slot = 0; slot < m_nodes.number_of_slots(); ++slot)
          f(Grid_place{m_own.first_column + column, m_own.first_row + row, slot});
  }

private:
  const Graph& m_graph;
  Grid_window m_own;
  Grid_window m_window;
  const Grid_nodes& m_all; // of the grid
  Grid_nodes m_nodes;      // of the window
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_TILE_GRAPH_H
