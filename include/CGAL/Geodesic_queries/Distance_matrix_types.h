// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_DISTANCE_MATRIX_TYPES_H
#define CGAL_GEODESIC_QUERIES_DISTANCE_MATRIX_TYPES_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * A row of a distance matrix: the distances from one source to all columns. It is a range of
 * numbers of type `double`, in the unit of the mesh, which are infinite for columns that were not
 * reached.
 *
 * \cgalModels{ConstRange}
 */
class Distance_row
{
public:
  /// \name Types
  /// @{

  /// the number of a column.
  using Column = std::uint32_t;

  /// a distance.
  using value_type = double;

  /// a random access iterator.
  using const_iterator = std::vector<double>::const_iterator;

  /// the same type: distances are read-only.
  using iterator = const_iterator;

  /// @}

  /// \name Access
  /// @{

  /// returns the number of columns.
  std::size_t size() const { return m_distances.size(); }

  /// returns an iterator to the first distance.
  const_iterator begin() const { return m_distances.begin(); }

  /// returns the past-the-end iterator.
  const_iterator end() const { return m_distances.end(); }

  /// returns the distance to a column. \pre `column < size()`
  double operator[](const std::size_t column) const
  {
    CGAL_precondition(column < size());
    return m_distances[column];
  }

  /// returns the columns that were reached, in ascending order. After a limited search, this takes
  /// \cgalBigO{k \log k} for `k` reached columns, independent of the number of all columns.
  const std::vector<Column>& reached() const
  {
    if(m_order == Order::UNKNOWN || (m_order == Order::NONE && m_reached.size() > size() / 32))
    {
      m_reached.clear(); // listing all is faster than sorting many columns
      for(std::size_t i = 0; i < size(); ++i)
        if(m_distances[i] < internal::infinity)
          m_reached.push_back(static_cast<Column>(i));
    }
    else if(m_order == Order::NONE)
      std::sort(m_reached.begin(), m_reached.end());
    m_order = Order::ASCENDING;
    return m_reached;
  }

  /// @}

  /// \name Modifiers
  /// @{

  /// constructs a row in which no column is reached.
  explicit Distance_row(const std::size_t size = 0) : m_distances(size, internal::infinity) {}

  /// sets the distance of a column. \pre `column < size()`, and `distance` is not infinite.
  void set(const Column column, const double distance)
  {
    if(m_order != Order::UNKNOWN)
    {
      if(m_distances[column] == internal::infinity)
        m_reached.push_back(column);
      m_order = Order::NONE;
    }
    m_distances[column] = distance;
  }

  /// sets the distances of all columns to `f(column)`, which may be infinite.
  template <typename F>
  void set_all(F f)
  {
    for(std::size_t i = 0; i < size(); ++i)
      m_distances[i] = f(static_cast<Column>(i));
    m_reached.clear();
    m_order = Order::UNKNOWN;
  }

  /// resets all distances, in time proportional to setting them.
  void clear()
  {
    if(m_order == Order::UNKNOWN)
      std::fill(m_distances.begin(), m_distances.end(), internal::infinity);
    else
      for(const Column column : m_reached)
        m_distances[column] = internal::infinity;
    m_reached.clear();
    m_order = Order::ASCENDING;
  }

  /// @}

private:
  // The state of the list of reached columns: not available, unsorted, or sorted.
  enum class Order
  {
    UNKNOWN,
    NONE,
    ASCENDING
  };

  std::vector<double> m_distances;
  mutable std::vector<Column> m_reached; // listed and sorted on demand
  mutable Order m_order = Order::ASCENDING;
};

namespace internal {

/*
 * What a distance matrix is computed from, and its first row: a sink that resumes an earlier run
 * checks that it was the same computation.
 */
struct Matrix_facts
{
  const Intrinsic_triangulation& triangulation;
  std::vector<double> graph; // numbers that distinguish graphs on the same triangulation
  const std::vector<Intrinsic_point>& sources;
  const std::vector<Intrinsic_point>& targets;
  double maximum_distance;
  std::size_t number_of_nearest;
  Distance_row first_row; // empty if there are no sources
};

} // namespace internal

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * The layout of a distance matrix, which is passed to a row sink before the first row: its size,
 * and the blocks of rows in which it is computed.
 *
 * Rows with nearby sources are in the same block, for locality of memory accesses. Blocks depend
 * only on the mesh and on the sources, not on the number of threads.
 */
class Distance_matrix_plan
{
public:
  /// the rows of a block.
  using Rows = Iterator_range<std::vector<std::size_t>::const_iterator>;

  /// returns the number of rows.
  std::size_t number_of_rows() const { return m_order.size(); }

  /// returns the number of columns.
  std::size_t number_of_columns() const { return m_number_of_columns; }

  /// returns the distance beyond which columns are not reached, in the unit of the mesh.
  double maximum_distance() const { return m_maximum_distance; }

  /// returns whether each distance and its transpose are to be replaced by the smaller of the two,
  /// after all rows are computed.
  bool is_symmetric() const { return m_is_symmetric; }

  /// returns the number of blocks.
  std::size_t number_of_blocks() const
  {
    return (number_of_rows() + m_rows_per_block - 1) / m_rows_per_block;
  }

  /// returns the number of rows of every block but the last one, which may have fewer.
  std::size_t rows_per_block() const { return m_rows_per_block; }

  /// returns the rows of a block, in the order in which they are computed.
  Rows rows_of_block(const std::size_t number) const
  {
    const auto at = [this](const std::size_t i) {
      return m_order.begin() + static_cast<std::ptrdiff_t>((std::min)(i, m_order.size()));
    };
    return {at(number * m_rows_per_block), at((number + 1) * m_rows_per_block)};
  }

  /// \cond SKIP_IN_MANUAL

  // `order` lists the rows in the order of computation. `facts` computes the first row.
  Distance_matrix_plan(std::vector<std::size_t> order,
                       const std::size_t number_of_columns,
                       const double maximum_distance = std::numeric_limits<double>::infinity(),
                       const std::size_t number_of_nearest = 0,
                       std::function<internal::Matrix_facts()> facts = {},
                       const bool is_symmetric = false)
    : m_order(std::move(order)),
      m_number_of_columns(number_of_columns),
      m_maximum_distance(maximum_distance),
      m_number_of_nearest(number_of_nearest),
      m_rows_per_block(suitable_rows_per_block()),
      m_facts(std::move(facts)),
      m_is_symmetric(is_symmetric)
  {
  }

  internal::Matrix_facts facts() const { return m_facts(); }

  /// \endcond

private:
  // Limits rows so that there are enough blocks for many threads, and a block does not exceed a
  // memory limit.
  std::size_t suitable_rows_per_block() const
  {
    constexpr std::size_t blocks = 512, most = 64, bytes = 16 << 20;
    const std::size_t size_of_row =
        (std::max<std::size_t>)(1, m_number_of_columns) * sizeof(double);
    const bool is_sparse =
        m_number_of_nearest > 0 || m_maximum_distance < std::numeric_limits<double>::infinity();
    const std::size_t by_memory = (is_sparse ? 4 : 1) * bytes / size_of_row;
    const std::size_t result = (std::min)({number_of_rows() / blocks, most, by_memory});
    return (std::max<std::size_t>)(1, result);
  }

  std::vector<std::size_t> m_order;
  std::size_t m_number_of_columns;
  double m_maximum_distance;
  std::size_t m_number_of_nearest;
  std::size_t m_rows_per_block;
  std::function<internal::Matrix_facts()> m_facts;
  bool m_is_symmetric;
};

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * The progress of the computation of a distance matrix.
 */
struct Distance_matrix_progress
{
  /// the number of rows of the matrix.
  std::size_t number_of_rows;

  /// the number of completed rows, including those of earlier runs and other processes.
  std::size_t number_done;

  /// the number of completed rows per second since the start of this run.
  double rows_per_second;

  /// the estimated number of seconds until completion, at the rate of this run.
  double seconds_left;
};

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * A visitor that does nothing. Derived classes only define the functions that they need. The
 * functions are not virtual: those of the derived class hide them.
 *
 * \cgalModels{DistanceMatrixVisitor}
 */
struct Distance_matrix_visitor_base
{
  /// does nothing.
  void on_progress(const Distance_matrix_progress& /* progress */) {}

  /// returns `true`.
  bool go_further() { return true; }
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_DISTANCE_MATRIX_TYPES_H
