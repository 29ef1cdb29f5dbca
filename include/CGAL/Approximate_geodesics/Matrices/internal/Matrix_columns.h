// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_COLUMNS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_COLUMNS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The target points of the columns of a distance matrix, and the extraction of their distances
 * after a search.
 */
template <typename Graph>
class Matrix_columns
{
  using Column = Distance_row::Column;
  using Index = Intrinsic_triangulation::Index;

public:
  // A column per point, in the given order. The graph is referred to, not copied.
  Matrix_columns(const Graph& graph, const std::vector<Intrinsic_point>& points)
  {
    m_vertices.reserve(points.size());
    for(const Intrinsic_point& p : points)
    {
      if(!p.is_vertex())
        m_points.columns.push_back(static_cast<Column>(m_vertices.size()));
      m_vertices.push_back(p.vertex);
    }
    sort_by_vertex(graph.triangulation().number_of_vertices());
    attach(graph, points);
  }

  std::size_t size() const { return m_vertices.size(); }
  bool are_vertices() const { return m_points.columns.empty(); }

  // Returns the number of columns whose target is a node.
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
        return m_vertices[c] == Intrinsic_triangulation::null_index ? infinity
                                                                    : nodes.distance(m_vertices[c]);
      });
      write_points(search, row);
    }
  }

  // Writes the distances of reached columns only. Columns of vertices take time proportional to the
  // number of reached nodes.
  template <typename SurfaceSearch>
  void write_reached(const SurfaceSearch& search, Distance_row& row) const
  {
    for(const Index node : search.search().reached_nodes())
      for(std::size_t i = 0; i < number_at(node); ++i)
        set(m_columns[m_first_at[node] + i], search.search().distance(node), row);
    write_points(search, row);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // A straight segment from a node to a point, in units of the graph.
  struct Last_arc
  {
    typename Graph::Node node;
    double length;
  };

  // Columns whose targets are not vertices. Points are attached to the graph once for all rows,
  // unless attachment depends on the search.
  struct Point_columns
  {
    std::vector<Column> columns;
    Points_by_face points;
    std::vector<std::size_t> first_arc; // by point, and the end
    std::vector<Last_arc> arcs;
  };

  bool is_vertex(const Index node) const { return node + std::size_t(1) < m_first_at.size(); }

  static void set(const Column column, const double distance, Distance_row& row)
  {
    if(distance < infinity)
      row.set(column, distance);
  }

  void attach(const Graph& graph, const std::vector<Intrinsic_point>& points)
  {
    std::vector<Intrinsic_point> points_of_columns;
    for(const Column column : m_points.columns)
    {
      points_of_columns.push_back(points[column]);
      m_points.first_arc.push_back(m_points.arcs.size());
      if constexpr(!Run_of<Graph>::attaches_by_labels)
        attach_target(graph, points[column])
            .for_each_node([this](const auto node, const double length) {
              m_points.arcs.push_back({node, length});
            });
    }
    m_points.first_arc.push_back(m_points.arcs.size());
    m_points.points = Points_by_face(graph.triangulation(), std::move(points_of_columns));
  }

  template <typename SurfaceSearch>
  void write_points(const SurfaceSearch& search, Distance_row& row) const
  {
    if(are_vertices())
      return;
    if constexpr(Run_of<Graph>::attaches_by_labels)
      for(std::size_t i = 0; i < m_points.columns.size(); ++i)
        set(m_points.columns[i], search.distance(m_points.points[i]), row);
    else
    {
      std::vector<double> distances = distances_by_line(search);
      for(std::size_t i = 0; i < m_points.columns.size(); ++i)
      {
        const double distance = (std::min)(distances[i], distance_over_nodes(search, i));
        set(m_points.columns[i], search.is_known(distance) ? distance : infinity, row);
      }
    }
  }

  // Returns the lengths of straight segments from the source to all points; infinity if the source
  // is a node.
  template <typename SurfaceSearch>
  std::vector<double> distances_by_line(const SurfaceSearch& search) const
  {
    const Graph& graph = search.graph();
    const Source_point& source = search.sources().front();
    std::vector<double> result(m_points.columns.size(), infinity);
    if(source.point.is_vertex())
      return result;
    graph.attach(source.point)
        .for_each_point(m_points.points, [&](const std::size_t i, const double length) {
          result[i] = (std::min)(result[i], source.distance + length * graph.unit());
        });
    return result;
  }

  template <typename SurfaceSearch>
  double distance_over_nodes(const SurfaceSearch& search, const std::size_t i) const
  {
    double result = infinity;
    for(std::size_t arc = m_points.first_arc[i]; arc < m_points.first_arc[i + 1]; ++arc)
    {
      const auto [node, length] = m_points.arcs[arc];
      result = (std::min)(result, search.search().distance(node) + length * search.graph().unit());
    }
    return result;
  }

  // Groups columns by vertex: several columns may have the same target.
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

  std::vector<Index> m_vertices;  // by column; null_index if not a vertex
  std::vector<Column> m_first_at; // by vertex, into m_columns
  std::vector<Column> m_columns;  // grouped by vertex
  Point_columns m_points;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_COLUMNS_H
