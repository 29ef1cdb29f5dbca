// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_ARRAYS_SOLVER_WATCH_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_ARRAYS_SOLVER_WATCH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/Matrices/Distance_matrix_visitor_base.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <thread>

namespace CGAL {
namespace Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * What a `Solver` calls while it is at work, about 30 times a second, and always in the thread that
 * called it. Both functions can be left empty.
 */
struct Solver_watch
{
  /// returns whether to go on. If not, the call of the solver ends with `Solver_interrupted`.
  std::function<bool()> go_further;

  /// is told how many of how many pieces of work are done: vertices of a search, rows of a matrix,
  /// or points of a sample.
  std::function<void(std::size_t, std::size_t)> on_progress;
};

/*!
 * \ingroup PkgApproximateGeodesicsArrays
 *
 * What a `Solver` throws if a watch has ended a call. The solver is as it was before.
 */
struct Solver_interrupted : std::runtime_error
{
  /// says that the call was ended.
  Solver_interrupted() : std::runtime_error("Approximate_geodesics: the run was interrupted") {}
};

namespace internal {

/*
 * The visitor of one call of a solver. Other threads that take part only learn that it has ended;
 * the clock spares the functions of the watch being called too often.
 */
class Solver_visitor : public Geodesic_visitor_base, public Distance_matrix_visitor_base
{
  using Clock = std::chrono::steady_clock;

public:
  static constexpr bool is_told_of_nodes = false; // which would cost a sort

  // The watch is referred to, not copied.
  explicit Solver_visitor(const Solver_watch& watch) : m_watch(watch) { of_this_thread() = this; }
  ~Solver_visitor() { of_this_thread() = m_outer; }
  Solver_visitor(const Solver_visitor&) = delete;
  Solver_visitor& operator=(const Solver_visitor&) = delete;

  // The visitor of the call that this thread has made, for those who are not given it.
  static Solver_visitor*& of_this_thread()
  {
    thread_local Solver_visitor* result = nullptr;
    return result;
  }

  // of pieces of work that take longer than a look at the clock
  void set_progress(const std::size_t number_done, const std::size_t number)
  {
    m_number_done = (std::min)(number_done, number); // nodes may count more than once
    m_number = number;
  }

  // of a search, after each of many small steps, most of which do not look at the clock
  void on_progress(const std::size_t number_done, const std::size_t number)
  {
    constexpr std::size_t nodes_between_looks = 1024;
    set_progress(number_done, number);
    m_looks_at_clock = number_done >= m_next_look;
    if(m_looks_at_clock)
      m_next_look = number_done + nodes_between_looks;
  }

  void on_progress(const Distance_matrix_progress& progress)
  {
    set_progress(progress.number_done, progress.number_of_rows);
  }

  bool go_further() { return m_looks_at_clock ? look() : !m_is_stopped; }

  // Looks at the clock, and asks the watch if it is time.
  bool look()
  {
    if(m_is_stopped)
      return false;
    if(std::this_thread::get_id() != m_caller)
      return true;
    const Clock::time_point now = Clock::now();
    if(now - m_last_time < std::chrono::milliseconds(30))
      return true;
    m_last_time = now;
    tell();
    m_is_stopped = m_watch.go_further && !m_watch.go_further();
    return !m_is_stopped;
  }

  // Is to be called after the work: throws if it was ended, and else tells that all is done.
  void finish()
  {
    if(m_is_stopped)
      throw Solver_interrupted();
    m_number_done = m_number.load();
    tell();
  }

private:
  void tell() const
  {
    if(m_watch.on_progress)
      m_watch.on_progress(m_number_done, m_number);
  }

  const Solver_watch& m_watch;
  Solver_visitor* m_outer = of_this_thread(); // of a call that has made this one by its watch
  std::thread::id m_caller = std::this_thread::get_id();
  Clock::time_point m_last_time = Clock::now();
  std::atomic<bool> m_is_stopped{false};
  std::atomic<std::size_t> m_number_done{0}; // of other threads, too
  std::atomic<std::size_t> m_number{0};
  std::size_t m_next_look = 0;
  bool m_looks_at_clock = true;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_ARRAYS_SOLVER_WATCH_H
