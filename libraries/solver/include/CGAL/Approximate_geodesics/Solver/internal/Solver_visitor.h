// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_VISITOR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_VISITOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>

namespace CGAL::Approximate_geodesics::internal {

/*
 * Watches one call of a solver: searches and other long functions poll it, and report their
 * progress to it. Any thread may poll it, but only the calling thread calls the watch, at limited
 * frequency; other threads only read whether the call was ended.
 */
class Solver_visitor final : public Distance_matrix_visitor_base, public Interruption
{
  using Clock = std::chrono::steady_clock;

public:
  // The watch is referred to, not copied.
  explicit Solver_visitor(const Solver_watch& watch) : m_watch(watch) { of_this_thread() = this; }
  ~Solver_visitor() { of_this_thread() = m_outer; }
  Solver_visitor(const Solver_visitor&) = delete;
  Solver_visitor& operator=(const Solver_visitor&) = delete;

  // Reports the progress of a function, which is that of the call unless this has several parts.
  void set_progress(const std::size_t number_done, const std::size_t number) override
  {
    if(!m_has_parts)
      store_progress(number_done, number);
  }

  // Reports the number of parts done, such as rows of a matrix, in place of progress in a part.
  void set_parts_done(const std::size_t number_done, const std::size_t number)
  {
    m_has_parts = true;
    store_progress(number_done, number);
  }

  void on_progress(const Distance_matrix_progress& progress)
  {
    set_parts_done(progress.number_done, progress.number_of_rows);
  }

  // Throws if the call was ended. Calls the watch if enough time has passed.
  void check() override
  {
    if(!m_is_stopped && std::this_thread::get_id() == m_caller)
      ask();
    if(m_is_stopped)
      throw Solver_interrupted();
  }

  // Must be called at the end: throws if the watch ended the call, and otherwise reports full
  // progress.
  void finish()
  {
    if(m_is_stopped)
      throw Solver_interrupted();
    m_number_done = m_number.load();
    tell();
  }

private:
  void store_progress(const std::size_t number_done, const std::size_t number)
  {
    m_number_done = (std::min)(number_done, number); // nodes may be counted repeatedly
    m_number = number;
  }

  void ask()
  {
    const Clock::time_point now = Clock::now();
    if(now - m_last_time < std::chrono::milliseconds(30))
      return;
    m_last_time = now;
    tell();
    m_is_stopped = m_watch.go_further && !m_watch.go_further();
  }

  void tell() const
  {
    if(m_watch.on_progress && m_number > 0)
      m_watch.on_progress(m_number_done, m_number);
  }

  const Solver_watch& m_watch;
  Interruption* m_outer = of_this_thread(); // of an outer call whose watch made this call
  std::thread::id m_caller = std::this_thread::get_id();
  Clock::time_point m_last_time = Clock::now();
  std::atomic<bool> m_is_stopped{false};
  std::atomic<bool> m_has_parts{false};
  std::atomic<std::size_t> m_number_done{0}; // also written by other threads
  std::atomic<std::size_t> m_number{0};
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_VISITOR_H
