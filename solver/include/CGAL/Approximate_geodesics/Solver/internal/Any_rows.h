// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ANY_ROWS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ANY_ROWS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/Nearest_rows.h>
#include <CGAL/Approximate_geodesics/Matrices/Radius_rows.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/make_symmetric.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <variant>

namespace CGAL::Approximate_geodesics::internal {

// A sink that writes dense rows to memory of the caller.
class Rows_in_place
{
public:
  explicit Rows_in_place(double* const distances) : m_distances(distances) {}

  void start(const Distance_matrix_plan& plan)
  {
    m_symmetric_size = plan.is_symmetric() ? plan.number_of_rows() : 0;
  }

  template <typename Block>
  void collect(Block& /* block */, const std::size_t row, const Distance_row& distances) const
  {
    std::copy(distances.begin(), distances.end(), m_distances + row * distances.size());
  }

  template <typename Block>
  void add(std::size_t /* number */, Block& /* block */)
  {
  }

  bool finish(const bool is_done) const
  {
    if(is_done)
      make_symmetric(m_distances, m_symmetric_size);
    return is_done;
  }

private:
  double* m_distances;
  std::size_t m_symmetric_size = 0;
};

/*
 * A type-erased sink: the computation is instantiated once per graph, not once per pair of graph
 * and sink.
 */
class Any_rows
{
public:
  using Block = Sparse_block<double>;

  // The sinks are referred to, not copied.
  explicit Any_rows(Rows_in_place& rows) : m_rows(&rows) {}
  explicit Any_rows(Radius_rows<double>& rows) : m_rows(&rows) {}
  explicit Any_rows(Nearest_rows<double>& rows)
    : m_rows(&rows), m_number_of_nearest(rows.number_of_nearest())
  {
  }

  static constexpr bool can_be_symmetric = true; // except for nearest rows, see start()

  std::size_t number_of_nearest() const { return m_number_of_nearest; }

  void start(const Distance_matrix_plan& plan)
  {
    if(plan.is_symmetric() && m_number_of_nearest > 0)
      reject(
          "symmetric: not supported for the nearest columns, because nearest neighbors are not a "
          "symmetric relation");
    std::visit([&](auto* const rows) { rows->start(plan); }, m_rows);
  }

  void collect(Block& block, const std::size_t row, const Distance_row& distances)
  {
    std::visit([&](auto* const rows) { rows->collect(block, row, distances); }, m_rows);
  }

  void add(const std::size_t number, Block& block)
  {
    std::visit([&](auto* const rows) { rows->add(number, block); }, m_rows);
  }

  bool finish(const bool is_done)
  {
    return std::visit([&](auto* const rows) { return rows->finish(is_done); }, m_rows);
  }

private:
  std::variant<Rows_in_place*, Radius_rows<double>*, Nearest_rows<double>*> m_rows;
  std::size_t m_number_of_nearest = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ANY_ROWS_H
