// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_PROGRESS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_PROGRESS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_visitor_base.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>

#include <boost/type_traits/is_detected.hpp>

#include <chrono>
#include <cstddef>
#include <limits>
#include <mutex>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// A thread-safe visitor may also observe the searches for rows: `visitor_of_search()` returns the
// visitor of a search, which may throw an exception to stop it.
template <typename Visitor>
using Visitor_of_search = decltype(std::declval<Visitor&>().visitor_of_search());

template <typename Visitor>
constexpr bool watches_searches = boost::is_detected_v<Visitor_of_search, Visitor>;

/*
 * Reports the progress to a visitor, and asks it whether to continue. The class is thread-safe. It
 * serializes calls to the visitor, except for go_further() of a visitor that observes searches.
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
    if constexpr(watches_searches<Visitor>)
      return m_visitor.go_further();
    const std::lock_guard lock(m_mutex);
    return m_visitor.go_further();
  }

  auto visitor_of_search()
  {
    if constexpr(watches_searches<Visitor>)
      return m_visitor.visitor_of_search();
    else
      return Geodesic_visitor_base();
  }

  void report(const std::size_t number_done)
  {
    const std::lock_guard lock(m_mutex);
    if(number_done < m_done)
      return; // overtaken by another thread
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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_PROGRESS_H
