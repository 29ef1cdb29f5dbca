// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_GRID_NODES_H
#define CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_GRID_NODES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Grid_files/Grid_window.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The numbers of the nodes of a `Grid_graph` of this many columns and rows: centers of cells, row
 * by row, then blocks of nodes at corners and sides, also for one more column and row. Their places
 * do not depend on the part of a grid that the graph is of.
 */
class Grid_nodes
{
public:
  Grid_nodes() = default;
  Grid_nodes(const std::size_t columns,
             const std::size_t rows,
             const std::size_t size_of_block,
             const bool is_periodic = false)
    : m_columns(columns),
      m_rows(rows),
      m_size_of_block(size_of_block),
      m_period(is_periodic ? columns : 0),
      m_beyond(size_of_block > 0 ? 1 : 0)
  {
  }

  // Returns the number of columns and rows that have nodes.
  std::size_t columns() const { return m_columns + m_beyond; }
  std::size_t rows() const { return m_rows + m_beyond; }

  // Returns a place whose column may be beyond either end of a periodic grid, with the one that it
  // stands for. Columns below 0 have wrapped around.
  Grid_place in_grid(Grid_place p) const
  {
    if(m_period > 0 && p.column >= m_period)
      p.column += p.column < 2 * m_period ? 0 - m_period : m_period;
    return p;
  }

  // Returns a place with a column that may be beyond the grid, less than half a turn from another
  // one.
  Grid_place beside(Grid_place p, const Grid_place& other) const
  {
    if(m_period > 0 && p.column > other.column + m_period / 2)
      p.column -= m_period;
    else if(m_period > 0 && other.column > p.column + m_period / 2)
      p.column += m_period;
    return p;
  }

  // Returns how many nodes a cell, its corner and its sides may have together.
  std::size_t number_of_slots() const { return 1 + m_size_of_block; }

  std::size_t number_of_nodes() const
  {
    return m_columns * m_rows + columns() * rows() * m_size_of_block;
  }

  bool has(const Grid_place& p) const { return p.slot > 0 || has_center(p.column, p.row); }
  bool has_center(const std::size_t column, const std::size_t row) const
  {
    return column < m_columns && row < m_rows;
  }

  // Returns the number of the node at an existing place.
  std::size_t node(const Grid_place& p) const
  {
    return p.slot == 0
               ? p.row * m_columns + p.column
               : m_columns * m_rows + (p.row * columns() + p.column) * m_size_of_block + p.slot - 1;
  }

  // for 32 bits, where divisions are faster
  Grid_place place(const std::uint32_t node) const
  {
    const auto number_of_cells = static_cast<std::uint32_t>(m_columns * m_rows);
    if(node < number_of_cells)
    {
      const auto n = static_cast<std::uint32_t>(m_columns);
      return {node % n, node / n, 0};
    }
    const auto n = static_cast<std::uint32_t>(columns());
    const auto size = static_cast<std::uint32_t>(m_size_of_block);
    const std::uint32_t block = (node - number_of_cells) / size;
    return {block % n, block / n, 1 + (node - number_of_cells) % size};
  }

private:
  std::size_t m_columns = 0, m_rows = 0;
  std::size_t m_size_of_block = 0;
  std::size_t m_period = 0; // in columns, if there is one
  std::size_t m_beyond = 0; // the last column and the last row
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRID_FILES_INTERNAL_GRID_NODES_H
