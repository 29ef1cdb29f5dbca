// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_ROW_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_ROW_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
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
      list_reached(); // faster than sorting many columns
    else if(m_order == Order::NONE)
      std::sort(m_reached.begin(), m_reached.end());
    m_order = Order::ASCENDING;
    return m_reached;
  }

  /// @}

  /// \name Modifiers
  /// @{

  /// constructs a row in which no column is reached.
  explicit Distance_row(const std::size_t size = 0) : m_distances(size, infinity) {}

  /// sets the distance of a column. \pre `column < size()`, and `distance` is not infinite.
  void set(const Column column, const double distance)
  {
    if(m_order != Order::UNKNOWN)
    {
      if(m_distances[column] == infinity)
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
      std::fill(m_distances.begin(), m_distances.end(), infinity);
    else
      for(const Column column : m_reached)
        m_distances[column] = infinity;
    m_reached.clear();
    m_order = Order::ASCENDING;
  }

  /// @}

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The state of the list of reached columns: not available, unsorted, or sorted.
  enum class Order
  {
    UNKNOWN,
    NONE,
    ASCENDING
  };

  void list_reached() const
  {
    m_reached.clear();
    for(std::size_t i = 0; i < size(); ++i)
      if(m_distances[i] < infinity)
        m_reached.push_back(static_cast<Column>(i));
  }

  std::vector<double> m_distances;
  mutable std::vector<Column> m_reached; // listed and sorted on demand
  mutable Order m_order = Order::ASCENDING;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_ROW_H
