// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_ROW_SEARCH_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_ROW_SEARCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_columns.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Limits of the searches for the rows of a distance matrix.
struct Row_limits
{
  double maximum_distance = std::numeric_limits<double>::infinity();
  std::size_t number_of_nearest = 0;    // columns; 0: all
  std::vector<Intrinsic_point> targets; // if any, a search may stop after them

  // Whether a search may reach a small part of the columns only.
  bool are_given() const
  {
    return number_of_nearest > 0 || maximum_distance < std::numeric_limits<double>::infinity();
  }
};

// Stops a search when the wanted number of columns is settled, including all ties of the last one.
template <typename Columns>
class Nearest_columns_visitor : public Geodesic_visitor_base
{
public:
  Nearest_columns_visitor(const Columns& columns, const std::size_t wanted)
    : m_columns(columns), m_wanted(wanted)
  {
  }

  template <typename Node>
  void on_settled(const Node node, const double distance)
  {
    m_is_done = m_is_done || (m_number >= m_wanted && distance > m_farthest);
    const std::size_t number = m_columns.number_at(node);
    if(m_number < m_wanted && number > 0)
      m_farthest = distance;
    m_number += number;
  }

  bool go_further() const { return !m_is_done; }

  // Whether the wanted number of columns was settled.
  bool is_enough() const { return m_number >= m_wanted; }
  double farthest() const { return m_farthest; }

private:
  const Columns& m_columns;
  std::size_t m_wanted;
  std::size_t m_number = 0;
  double m_farthest = 0;
  bool m_is_done = false;
};

/*
 * Computes rows of a distance matrix, one by one: the workspace of a thread.
 */
template <typename Graph>
class Row_search
{
public:
  // All are referred to, not copied.
  Row_search(const Graph& graph, const Matrix_columns<Graph>& columns, const Row_limits& limits)
    : m_columns(columns), m_limits(limits), m_search(graph), m_row(columns.size())
  {
  }

  // Returns the distances from `source`. The reference is valid until the next call.
  const Distance_row& find(const Intrinsic_point& source)
  {
    m_row.clear();
    if(m_limits.number_of_nearest > 0 && m_columns.are_vertices())
      search_nearest(source);
    else
      m_search.run({{source}}, stop_rule(m_limits.maximum_distance));
    if(m_limits.are_given())
      m_columns.write_reached(m_search, m_row);
    else
      m_columns.write_all(m_search, m_row);
    return m_row;
  }

private:
  using Search = Surface_search<Graph>;

  typename Search::Stop_rule stop_rule(const double maximum_distance) const
  {
    return {maximum_distance, m_limits.targets};
  }

  // Whether arcs depend on labels, so that the range of a search affects the last bits of
  // distances.
  static constexpr bool depends_on_limit = !std::is_same_v<Run_of<Graph>, Geodesic_run_base<Graph>>;

  // A search for few columns labels many nodes beyond them. Limiting the distance avoids this; the
  // estimate is that of the previous row, whose source is near.
  void search_nearest(const Intrinsic_point& source)
  {
    if(depends_on_limit || !search_nearest(source, m_expected_distance))
      search_nearest(source, m_limits.maximum_distance);
  }

  // Returns whether there are enough columns within `distance`.
  bool search_nearest(const Intrinsic_point& source, const double distance)
  {
    constexpr double margin = 1.25;
    Nearest_columns_visitor nearest(m_columns, m_limits.number_of_nearest);
    m_search.run({{source}}, stop_rule((std::min)(distance, m_limits.maximum_distance)), nearest);
    m_expected_distance =
        nearest.is_enough() ? margin * nearest.farthest() : m_limits.maximum_distance;
    return nearest.is_enough() || distance >= m_limits.maximum_distance;
  }

  const Matrix_columns<Graph>& m_columns;
  const Row_limits& m_limits;
  Search m_search;
  Distance_row m_row;
  double m_expected_distance = std::numeric_limits<double>::infinity(); // of the nearest columns
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_ROW_SEARCH_H
