// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_NEAREST_ROWS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_NEAREST_ROWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/Sparse_rows.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

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
 * \ingroup PkgApproximateGeodesicsMatrices
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

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_NEAREST_ROWS_H
