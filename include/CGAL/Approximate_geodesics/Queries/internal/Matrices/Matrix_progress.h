// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_MATRIX_PROGRESS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_MATRIX_PROGRESS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/Matrices/Distance_matrix_visitor_base.h>

#include <chrono>
#include <cstddef>
#include <limits>
#include <mutex>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * Tells a visitor how far the rows are, and asks it whether to go on. Any thread may call, and the
 * visitor is called by one at a time.
 */
template <typename Visitor>
class Matrix_progress
{
  using Clock = std::chrono::steady_clock;

public:
  Matrix_progress(Visitor& visitor,
                  const std::size_t number_of_rows,
                  const std::size_t number_done_before)
    : m_visitor(visitor), m_number_of_rows(number_of_rows), m_done_before(number_done_before)
  {
  }

  bool go_further()
  {
    const std::lock_guard lock(m_mutex);
    return m_visitor.go_further();
  }

  void report(const std::size_t number_done)
  {
    const std::lock_guard lock(m_mutex);
    if(number_done < m_done)
      return; // another thread was faster
    m_done = number_done;
    const double seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
    const double rate = double(number_done - m_done_before) / seconds;
    m_visitor.on_progress({m_number_of_rows, number_done, rate,
                           rate > 0 ? double(m_number_of_rows - number_done) / rate
                                    : std::numeric_limits<double>::infinity()});
  }

private:
  Visitor& m_visitor;
  std::mutex m_mutex;
  std::size_t m_number_of_rows;
  std::size_t m_done_before;
  std::size_t m_done = 0;
  Clock::time_point m_start = Clock::now();
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_MATRICES_MATRIX_PROGRESS_H
