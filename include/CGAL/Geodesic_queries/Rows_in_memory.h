// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_ROWS_IN_MEMORY_H
#define CGAL_GEODESIC_QUERIES_ROWS_IN_MEMORY_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

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

/*
 * The entries of a block of rows of a sparse matrix, row by row.
 */
template <typename T>
struct Sparse_block
{
  using Column = Distance_row::Column;

  std::vector<std::size_t> rows;
  std::vector<std::uint32_t> numbers_of_entries; // by row
  std::vector<Column> columns;
  std::vector<T> distances;

  void append(const std::size_t row,
              const std::vector<Column>& columns_of_row,
              const Distance_row& distances_of_row)
  {
    rows.push_back(row);
    numbers_of_entries.push_back(static_cast<std::uint32_t>(columns_of_row.size()));
    columns.insert(columns.end(), columns_of_row.begin(), columns_of_row.end());
    for(const Column column : columns_of_row)
      distances.push_back(static_cast<T>(distances_of_row[column]));
  }

  void clear()
  {
    rows.clear();
    numbers_of_entries.clear();
    columns.clear();
    distances.clear();
  }
};

/*
 * A sparse matrix in compressed sparse row format.
 */
template <typename T>
struct Compressed_rows
{
  using Column = Distance_row::Column;

  std::vector<std::size_t> starts{0}; // of the entries by row, and the end
  std::unique_ptr<Column[]> columns;
  std::unique_ptr<T[]> distances;

  Compressed_rows() = default;

  // Concatenates blocks, whose rows may be in any order. Each block is freed after it was copied,
  // which limits peak memory.
  Compressed_rows(const std::size_t number_of_rows, std::vector<Sparse_block<T>>& blocks)
    : starts(number_of_rows + 1, 0)
  {
    for(const Sparse_block<T>& block : blocks)
      for(std::size_t i = 0; i < block.rows.size(); ++i)
        starts[block.rows[i] + 1] = block.numbers_of_entries[i];
    allocate();
    for(Sparse_block<T>& block_of_rows : blocks)
    {
      const Sparse_block<T> block = std::exchange(block_of_rows, Sparse_block<T>());
      std::size_t from = 0;
      for(std::size_t i = 0; i < block.rows.size(); ++i)
      {
        const std::size_t start = starts[block.rows[i]], number = block.numbers_of_entries[i];
        std::copy_n(block.columns.data() + from, number, columns.get() + start);
        std::copy_n(block.distances.data() + from, number, distances.get() + start);
        from += number;
      }
    }
  }

  // Replaces each distance and its transpose by the smaller of the two. The result has an entry if
  // either exists.
  // \pre Columns ascend, and the matrix is square.
  void make_symmetric()
  {
    const std::size_t number_of_rows = starts.size() - 1;
    const Compressed_rows other = collected(number_of_rows, [&](const auto& add) {
      for(std::size_t row = 0; row < number_of_rows; ++row)
        for(std::size_t i = starts[row]; i < starts[row + 1]; ++i)
          add(columns[i], static_cast<Column>(row), distances[i]);
    });
    *this = collected(number_of_rows, [&](const auto& add) { for_each_of_both(other, add); });
  }

private:
  // \pre Each start except the first one is the number of entries of the previous row.
  void allocate()
  {
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    columns.reset(new Column[starts.back()]);
    distances.reset(new T[starts.back()]);
  }

  // Returns a matrix with the entries for which `for_each(add)` calls `add(row, column, distance)`.
  template <typename ForEach>
  static Compressed_rows collected(const std::size_t number_of_rows, const ForEach& for_each)
  {
    Compressed_rows result;
    result.starts.assign(number_of_rows + 1, 0);
    for_each([&](const std::size_t row, Column, T) { ++result.starts[row + 1]; });
    result.allocate();
    std::vector<std::size_t> next = result.starts;
    for_each([&](const std::size_t row, const Column column, const T distance) {
      result.columns[next[row]] = column;
      result.distances[next[row]++] = distance;
    });
    return result;
  }

  // Calls `f(row, column, distance)` for the union of the entries of both matrices, with the
  // smaller distance.
  template <typename F>
  void for_each_of_both(const Compressed_rows& other, F f) const
  {
    constexpr Column no_column = (std::numeric_limits<Column>::max)();
    for(std::size_t row = 0; row + 1 < starts.size(); ++row)
    {
      std::size_t i = starts[row], j = other.starts[row];
      while(i < starts[row + 1] || j < other.starts[row + 1])
      {
        const Column here = i < starts[row + 1] ? columns[i] : no_column;
        const Column there = j < other.starts[row + 1] ? other.columns[j] : no_column;
        T distance = std::numeric_limits<T>::infinity();
        if(here <= there)
          distance = distances[i++];
        if(there <= here)
          distance = (std::min)(distance, other.distances[j++]);
        f(row, (std::min)(here, there), distance);
      }
    }
  }
};

inline std::size_t checked_number_of_nearest(const std::size_t number)
{
  if(number == 0)
    reject("the number of nearest columns is 0; it must be at least 1");
  return number;
}

// Returns the `number` nearest columns, sorted by distance, then by column.
inline std::vector<Distance_row::Column> nearest_columns(const Distance_row& row,
                                                         const std::size_t number)
{
  using Entry = std::pair<double, Distance_row::Column>;
  std::vector<Entry> entries;
  entries.reserve(row.reached().size());
  for(const auto column : row.reached())
    entries.emplace_back(row[column], column);
  if(number < entries.size())
  {
    const auto end = entries.begin() + static_cast<std::ptrdiff_t>(number);
    std::nth_element(entries.begin(), end, entries.end());
    entries.erase(end, entries.end());
  }
  std::sort(entries.begin(), entries.end());
  std::vector<Distance_row::Column> result;
  result.reserve(entries.size());
  for(const Entry& entry : entries)
    result.push_back(entry.second);
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicQueriesMatrices
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
    if(!m_distances.get_deleter().is_owner)
      return;
    m_distances.reset(); // frees the old matrix first
    if(m_number_of_columns > 0 &&
       m_rows_to_come > (std::numeric_limits<std::size_t>::max)() / sizeof(T) / m_number_of_columns)
      throw std::bad_array_new_length();
    // not initialized: each thread touches the pages of its rows first
    m_distances.reset(new T[m_rows_to_come * m_number_of_columns]);
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

  std::unique_ptr<T[], Release> m_distances;
  std::size_t m_number_of_rows = 0;
  std::size_t m_number_of_columns = 0;
  std::size_t m_rows_to_come = 0;
  bool m_is_symmetric = false;
};

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * A sparse distance matrix in memory, in compressed sparse row format: the common base of
 * `Radius_rows` and `Nearest_rows`. An entry takes `4 + sizeof(T)` bytes.
 *
 * \tparam T the type of distances, `double` or `float`
 */
template <typename T>
class Sparse_rows
{
  static_assert(std::is_floating_point_v<T>, "distances are floating-point numbers");

public:
  /// the number of a column.
  using Column = Distance_row::Column;

  /// returns the number of rows; `0` if the computation was not completed.
  std::size_t number_of_rows() const { return m_rows.starts.size() - 1; }

  /// returns the number of columns.
  std::size_t number_of_columns() const { return m_number_of_columns; }

  /// returns the number of entries.
  std::size_t number_of_entries() const { return m_rows.starts.back(); }

  /// returns the columns of the entries of a row. \pre The row exists.
  Iterator_range<const Column*> columns(const std::size_t row) const
  {
    return part(m_rows.columns.get(), row);
  }

  /// returns the distances of the entries of a row, in the same order. \pre The row exists.
  Iterator_range<const T*> distances(const std::size_t row) const
  {
    return part(m_rows.distances.get(), row);
  }

  /// \name Row Sink
  /// @{

  /// the entries of a block of rows.
  using Block = internal::Sparse_block<T>;

  /// removes all rows.
  void start(const Distance_matrix_plan& plan)
  {
    m_rows = internal::Compressed_rows<T>();
    m_number_of_columns = plan.number_of_columns();
    m_rows_to_come = plan.number_of_rows();
    m_is_symmetric = plan.is_symmetric();
    m_blocks.assign(plan.number_of_blocks(), Block());
  }

  /// stores a block.
  void add(const std::size_t number, Block& block)
  {
    m_blocks[number] = block; // copies without spare capacity
    block.clear();
  }

  /// concatenates all blocks and, if the plan requests it, replaces each distance and its transpose
  /// by the smaller of the two. If an exception is thrown, there are no rows.
  bool finish(const bool is_done)
  {
    if(is_done)
    {
      internal::Compressed_rows<T> rows(m_rows_to_come, m_blocks);
      if(m_is_symmetric)
        rows.make_symmetric();
      m_rows = std::move(rows);
    }
    m_blocks.clear();
    return is_done;
  }

  /// @}

protected:
  /// constructs a matrix without rows.
  Sparse_rows() = default;

private:
  template <typename V>
  Iterator_range<const V*> part(const V* const values, const std::size_t row) const
  {
    CGAL_precondition(row < number_of_rows());
    return {values + m_rows.starts[row], values + m_rows.starts[row + 1]};
  }

  internal::Compressed_rows<T> m_rows;
  std::size_t m_number_of_columns = 0;
  std::size_t m_rows_to_come = 0;
  bool m_is_symmetric = false;
  std::vector<Block> m_blocks; // until they are concatenated
};

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * The distances up to `maximum_distance`, in memory. Columns ascend in each row.
 *
 * \tparam T the type of distances, `double` or `float`
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double>
class Radius_rows : public Sparse_rows<T>
{
public:
  /// \name Row Sink
  /// @{

  using typename Sparse_rows<T>::Block;

  /// symmetric matrices are supported.
  static constexpr bool can_be_symmetric = true;

  /// appends a row to a block.
  void collect(Block& block, const std::size_t row, const Distance_row& distances) const
  {
    block.append(row, distances.reached(), distances);
  }

  /// @}
};

/*!
 * \ingroup PkgGeodesicQueriesMatrices
 *
 * The smallest distances of each row, in memory: the distances to the nearest targets, including
 * the source itself if it is a target. They ascend in each row; ties are broken by column. A row
 * has fewer entries if the search reaches fewer columns.
 *
 * If all targets are vertices, the search for a row ends as soon as its entries are known.
 *
 * \tparam T the type of distances, `double` or `float`
 *
 * \cgalModels{DistanceRowSink}
 */
template <typename T = double>
class Nearest_rows : public Sparse_rows<T>
{
public:
  /// constructs a sink for up to `number` entries per row. \pre `number > 0`
  explicit Nearest_rows(const std::size_t number)
    : m_number(internal::checked_number_of_nearest(number))
  {
  }

  /// \name Row Sink
  /// @{

  using typename Sparse_rows<T>::Block;

  /// returns the maximum number of entries per row.
  std::size_t number_of_nearest() const { return m_number; }

  /// appends a row to a block.
  void collect(Block& block, const std::size_t row, const Distance_row& distances) const
  {
    block.append(row, internal::nearest_columns(distances, m_number), distances);
  }

  /// @}

private:
  std::size_t m_number;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_GEODESIC_QUERIES_ROWS_IN_MEMORY_H
