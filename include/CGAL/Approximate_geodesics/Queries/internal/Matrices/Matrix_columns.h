// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_MATRIX_COLUMNS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_MATRIX_COLUMNS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The points that the columns of a distance matrix stand for, and their distances after a search.
 */
class Matrix_columns
{
  using Column = Distance_row::Column;
  using Index = Intrinsic_triangulation::Index;

public:
  // A column per point, in the given order.
  Matrix_columns(const Intrinsic_triangulation& triangulation,
                 const std::vector<Intrinsic_point>& points)
  {
    m_vertices.reserve(points.size());
    for(const Intrinsic_point& p : points)
    {
      if(!p.is_vertex())
        m_points.emplace_back(static_cast<Column>(m_vertices.size()), p);
      m_vertices.push_back(p.vertex);
    }
    sort_by_vertex(triangulation.number_of_vertices());
  }

  std::size_t size() const { return m_vertices.size(); }
  bool are_vertices() const { return m_points.empty(); }

  // Returns the number of columns that stand for a node.
  std::size_t number_at(const Index node) const
  {
    return is_vertex(node) ? m_first_at[node + 1] - m_first_at[node] : 0;
  }

  // Writes the distances of all columns.
  template <typename SurfaceSearch>
  void write_all(const SurfaceSearch& search, Distance_row& row) const
  {
    const auto& nodes = search.search();
    if(are_vertices())
      row.set_all([&](const Column c) { return nodes.distance(m_vertices[c]); });
    else
    {
      row.set_all([&](const Column c) {
        return m_vertices[c] == Intrinsic_triangulation::null_index
                   ? std::numeric_limits<double>::infinity()
                   : nodes.distance(m_vertices[c]);
      });
      write_points(search, row);
    }
  }

  // Writes those of the columns that were reached, in as much time as it took to reach them, but
  // for points that are not vertices.
  template <typename SurfaceSearch>
  void write_reached(const SurfaceSearch& search, Distance_row& row) const
  {
    for(const Index node : search.search().reached_nodes())
      for(std::size_t i = 0; i < number_at(node); ++i)
        set(m_columns[m_first_at[node] + i], search.search().distance(node), row);
    write_points(search, row);
  }

private:
  bool is_vertex(const Index node) const { return node + std::size_t(1) < m_first_at.size(); }

  static void set(const Column column, const double distance, Distance_row& row)
  {
    if(distance < std::numeric_limits<double>::infinity())
      row.set(column, distance);
  }

  template <typename SurfaceSearch>
  void write_points(const SurfaceSearch& search, Distance_row& row) const
  {
    for(const auto& [column, point] : m_points)
      set(column, search.distance(point), row);
  }

  // Lists columns by vertex: a vertex may have any number of them.
  void sort_by_vertex(const std::size_t number_of_vertices)
  {
    m_first_at.assign(number_of_vertices + 1, 0);
    for(const Index v : m_vertices)
      if(v != Intrinsic_triangulation::null_index)
        ++m_first_at[v + 1];
    std::partial_sum(m_first_at.begin(), m_first_at.end(), m_first_at.begin());
    m_columns.resize(m_first_at.back());
    std::vector<Column> next(m_first_at.begin(), m_first_at.end() - 1);
    for(std::size_t c = 0; c < size(); ++c)
      if(m_vertices[c] != Intrinsic_triangulation::null_index)
        m_columns[next[m_vertices[c]]++] = static_cast<Column>(c);
  }

  std::vector<Index> m_vertices; // by column; the null index if it is another point
  std::vector<std::pair<Column, Intrinsic_point>> m_points; // columns that are not vertices
  std::vector<Column> m_first_at;                           // by vertex, into the next list
  std::vector<Column> m_columns;                            // by vertex
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_MATRIX_COLUMNS_H
