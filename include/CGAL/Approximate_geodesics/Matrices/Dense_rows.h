// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_DENSE_ROWS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_DENSE_ROWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL::Approximate_geodesics {
namespace internal {

// Replaces each entry of a square matrix and its transpose by the smaller of the two, by tiles of
// `side` rows and columns. Two of the default size fit into the cache. The operation is idempotent.
template <typename T>
void make_symmetric(T* const distances, const std::size_t size, const std::size_t side = 64)
{
  for(std::size_t i = 0; i < size; i += side)
    for(std::size_t j = 0; j <= i; j += side)
      for(std::size_t k = i; k < (std::min)(i + side, size); ++k)
        for(std::size_t l = j; l < (std::min)(j + side, k); ++l)
        {
          T& below = distances[k * size + l];
          T& above = distances[l * size + k];
          below = above = (std::min)(below, above);
        }
}

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
 *
 * A dense distance matrix in memory. It takes `sizeof(T)` bytes per distance.
 *
 * \tparam T the type of distances, `double` or `float`; distances are infinite for columns that
 *         were not reached
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double>
class Dense_rows
{
  static_assert(std::is_floating_point_v<T>, "distances are floating-point numbers");

public:
  /// a row.
  using Row = Iterator_range<const T*>;

  /// constructs a matrix that allocates its memory.
  Dense_rows() = default;

  /// constructs a matrix in memory of the caller, which must have room for all distances.
  explicit Dense_rows(T* const memory) : m_distances(memory, Release{false}) {}

  /// returns the number of rows; `0` if the computation was not completed.
  std::size_t number_of_rows() const { return m_number_of_rows; }

  /// returns the number of columns.
  std::size_t number_of_columns() const { return m_number_of_columns; }

  /// returns the distance from a source to a target. \pre Row and column exist.
  T operator()(const std::size_t row, const std::size_t column) const
  {
    CGAL_precondition(row < number_of_rows() && column < number_of_columns());
    return m_distances[row * number_of_columns() + column];
  }

  /// returns a row. \pre The row exists.
  Row row(const std::size_t number) const
  {
    CGAL_precondition(number < number_of_rows());
    const T* const first = data() + number * number_of_columns();
    return {first, first + number_of_columns()};
  }

  /// returns a pointer to the distances, in row-major order.
  const T* data() const { return m_distances.get(); }

  /// \name Row Sink
  /// @{

  /// empty: rows are written to the matrix directly.
  struct Block
  {
  };

  /// symmetric matrices are supported.
  static constexpr bool can_be_symmetric = true;

  /// allocates the matrix, unless it is in memory of the caller.
  void start(const Distance_matrix_plan& plan)
  {
    m_number_of_rows = 0;
    m_number_of_columns = plan.number_of_columns();
    m_rows_to_come = plan.number_of_rows();
    m_is_symmetric = plan.is_symmetric();
    if(m_distances.get_deleter().is_owner)
      allocate();
  }

  /// writes a row.
  void collect(Block& /* block */, const std::size_t row, const Distance_row& distances)
  {
    std::transform(distances.begin(), distances.end(), m_distances.get() + row * distances.size(),
                   [](const double d) { return static_cast<T>(d); });
  }

  /// does nothing.
  void add(std::size_t /* number */, Block& /* block */) {}

  /// completes the matrix.
  bool finish(const bool is_done)
  {
    if(!is_done)
      return false;
    m_number_of_rows = m_rows_to_come;
    if(m_is_symmetric)
      internal::make_symmetric(m_distances.get(), m_number_of_rows);
    return true;
  }

  /// @}

private:
  struct Release
  {
    bool is_owner = true;

    void operator()(T* const memory) const
    {
      if(is_owner)
        delete[] memory;
    }
  };

  void allocate()
  {
    m_distances.reset(); // frees the old matrix first
    if(m_number_of_columns > 0 &&
       m_rows_to_come > (std::numeric_limits<std::size_t>::max)() / sizeof(T) / m_number_of_columns)
      throw std::bad_array_new_length();
    // not initialized: each thread touches the pages of its rows first
    m_distances.reset(new T[m_rows_to_come * m_number_of_columns]);
  }

  std::unique_ptr<T[], Release> m_distances;
  std::size_t m_number_of_rows = 0;
  std::size_t m_number_of_columns = 0;
  std::size_t m_rows_to_come = 0;
  bool m_is_symmetric = false;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_DENSE_ROWS_H
