// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_PLAN_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_PLAN_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

/*
 * A fingerprint of a distance matrix, by parts, so that messages can name the difference between
 * two matrices.
 */
struct Matrix_identity
{
  enum Part
  {
    KIND,
    MESH,
    GRAPH,
    NUMBER_OF_SOURCES, // the number itself, not a checksum
    NUMBER_OF_TARGETS,
    SOURCES,
    TARGETS,
    LIMIT,
    DISTANCES,
    NUMBER_OF_PARTS
  };

  // Returns the text of messages for a part that differs.
  static const char* name(const std::size_t part)
  {
    constexpr std::array<const char*, NUMBER_OF_PARTS> names{
        "another kind of file or of numbers",
        "another mesh, or other lengths, weights or barriers",
        "another graph, or another bound epsilon",
        "another number of sources",
        "another number of targets",
        "other sources",
        "other targets",
        "another maximum_distance or number of nearest",
        "distances that differ, as another version or compilation of the program gives them"};
    return names[part];
  }

  // Returns that text, with the values of both matrices if possible.
  std::string difference(const std::size_t part, const Matrix_identity& other) const
  {
    if(part != NUMBER_OF_SOURCES && part != NUMBER_OF_TARGETS)
      return name(part);
    return std::string(name(part)) + " (" + std::to_string(parts[part]) + ", not " +
           std::to_string(other.parts[part]) + ')';
  }

  std::array<std::uint64_t, NUMBER_OF_PARTS> parts{};
};

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsMatrices
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

  using Identity = internal::Matrix_identity;

  // `order` lists the rows in the order of computation. `identity` is called by sinks that compare
  // the computation with an earlier run; it costs as much as a row.
  Distance_matrix_plan(std::vector<std::size_t> order,
                       const std::size_t number_of_columns,
                       const double maximum_distance = std::numeric_limits<double>::infinity(),
                       const std::size_t number_of_nearest = 0,
                       std::function<Identity()> identity = {},
                       const bool is_symmetric = false)
    : m_order(std::move(order)),
      m_number_of_columns(number_of_columns),
      m_maximum_distance(maximum_distance),
      m_number_of_nearest(number_of_nearest),
      m_rows_per_block(suitable_rows_per_block()),
      m_identity(std::move(identity)),
      m_is_symmetric(is_symmetric)
  {
  }

  Identity identity() const { return m_identity(); }

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
  std::function<Identity()> m_identity;
  bool m_is_symmetric;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_DISTANCE_MATRIX_PLAN_H
