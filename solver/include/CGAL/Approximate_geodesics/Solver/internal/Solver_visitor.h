// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_VISITOR_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_VISITOR_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_visitor_base.h>
#include <CGAL/Approximate_geodesics/Search/Geodesic_visitor_base.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The visitor of one call of a solver: of the construction of a graph, or of the rows of a matrix.
 * Any thread may query it, but only the calling thread calls the watch, at limited frequency; other
 * threads only read whether the call was ended.
 */
class Solver_visitor final : public Distance_matrix_visitor_base, public Interruption
{
  using Clock = std::chrono::steady_clock;

public:
  class Of_search;

  // The watch is referred to, not copied.
  explicit Solver_visitor(const Solver_watch& watch) : m_watch(watch) { of_this_thread() = this; }
  ~Solver_visitor() { of_this_thread() = m_outer; }
  Solver_visitor(const Solver_visitor&) = delete;
  Solver_visitor& operator=(const Solver_visitor&) = delete;

  void set_progress(const std::size_t number_done, const std::size_t number) override
  {
    m_number_done = (std::min)(number_done, number); // nodes may be counted repeatedly
    m_number = number;
  }

  void on_progress(const Distance_matrix_progress& progress)
  {
    set_progress(progress.number_done, progress.number_of_rows);
  }

  // Calls the watch if enough time has passed.
  bool go_further()
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

  // Throws if the watch ends the call.
  void check() override
  {
    if(!go_further())
      throw Solver_interrupted();
  }

  Of_search visitor_of_search();

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
  std::atomic<std::size_t> m_number_done{0}; // also written by other threads
  std::atomic<std::size_t> m_number{0};
};

/*
 * The visitor of one search. It queries the clock rarely, because steps are short.
 */
class Solver_visitor::Of_search : public Geodesic_visitor_base
{
public:
  static constexpr bool is_told_of_nodes = false; // would require sorting

  // `is_whole_call` tells whether the call consists of this search.
  Of_search(Solver_visitor& visitor, const bool is_whole_call)
    : m_visitor(visitor), m_is_whole_call(is_whole_call)
  {
  }

  void on_progress(const std::size_t number_done, const std::size_t number)
  {
    m_number_done = number_done;
    m_number = number;
  }

  bool go_further()
  {
    constexpr std::size_t nodes_between_looks = 1024;
    if(m_number_done - m_last_look < nodes_between_looks) // wraps around at a new search
      return true;
    m_last_look = m_number_done;
    if(m_is_whole_call)
      m_visitor.set_progress(m_number_done, m_number);
    m_visitor.check();
    return true;
  }

private:
  Solver_visitor& m_visitor;
  bool m_is_whole_call;
  std::size_t m_number_done = 0;
  std::size_t m_number = 0;
  std::size_t m_last_look = 0;
};

inline Solver_visitor::Of_search Solver_visitor::visitor_of_search() { return {*this, false}; }

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_SOLVER_VISITOR_H
