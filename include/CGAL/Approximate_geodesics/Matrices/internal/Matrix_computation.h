// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_COMPUTATION_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_COMPUTATION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_visitor_base.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Matrix_columns.h>
#include <CGAL/Approximate_geodesics/Matrices/internal/Row_search.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <boost/type_traits/detected_or.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

// Detection of the optional members of models of `DistanceRowSink`.

template <typename Rows>
using Block_of = typename Rows::Block;
template <typename Rows>
using Number_of_nearest = decltype(std::declval<const Rows&>().number_of_nearest());
template <typename Rows>
using Next_block = decltype(std::declval<Rows&>().next_block());
template <typename Rows>
using Number_done = decltype(std::declval<const Rows&>().number_of_rows_done());
template <typename Rows>
using Can_be_symmetric = std::bool_constant<Rows::can_be_symmetric>;

// Rows are received by a sink, in blocks, or by a function object, one by one.
template <typename Rows>
constexpr bool is_row_sink = boost::is_detected_v<Block_of, Rows>;

template <typename Rows>
constexpr bool can_be_symmetric =
    boost::detected_or_t<std::false_type, Can_be_symmetric, Rows>::value;

template <typename Rows>
constexpr bool check_rows()
{
  using T = std::remove_reference_t<Rows>;
  constexpr bool takes_rows =
      is_row_sink<T> || std::is_invocable_v<T&, std::size_t, const Distance_row&>;
  constexpr bool can_change = !is_row_sink<T> || !std::is_const_v<T>;
  static_assert(takes_rows,
                "rows must be a row sink, such as Dense_rows, or callable with the number of a row "
                "and a `const Distance_row&`");
  static_assert(can_change, "a row sink must not be const");
  return takes_rows && can_change;
}

// Returns the number of nearest columns that a sink keeps per row; 0 means all.
template <typename Rows>
std::size_t number_of_nearest([[maybe_unused]] const Rows& rows)
{
  if constexpr(boost::is_detected_v<Number_of_nearest, Rows>)
    return rows.number_of_nearest();
  else
    return 0;
}

/*
 * Reports the progress to a visitor, and asks it whether to continue. The class is thread-safe: it
 * serializes calls to the visitor.
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
    check_for_interruption();
    const std::lock_guard lock(m_mutex);
    return m_visitor.go_further();
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

/*
 * Computes the rows of a distance matrix with one or several threads. Sinks receive blocks of rows
 * as they are completed; function objects receive single rows in order.
 */
template <typename Graph, typename Rows, typename Visitor>
class Matrix_computation
{
public:
  // All are referred to, not copied.
  Matrix_computation(const Graph& graph,
                     const std::vector<Intrinsic_point>& sources,
                     const Matrix_columns<Graph>& columns,
                     const Row_limits& limits,
                     const Distance_matrix_plan& plan,
                     Rows& rows,
                     Visitor& visitor)
    : m_graph(graph),
      m_sources(sources),
      m_columns(columns),
      m_limits(limits),
      m_plan(plan),
      m_rows(rows),
      m_progress(visitor, plan.number_of_rows(), number_done())
  {
  }

  // Returns false if the visitor stopped the computation.
  bool run(const Loop& loop)
  {
    if(loop.is_parallel() && m_plan.number_of_rows() > 1)
      loop.run(m_plan.number_of_blocks(),
               [this](std::size_t /* block */, std::size_t /* thread */) { work_or_stop(); });
    else
      work();
    return !m_is_stopped;
  }

private:
  // The first iteration of a thread computes rows until none are left; further iterations find
  // none. If a function object runs its own parallel loop, its thread may enter another iteration
  // of this loop. That iteration must return at once: waiting for a row that the same thread
  // computes would be a deadlock.
  void work_or_stop()
  {
    if(m_is_finished || m_is_stopped || !enter())
      return;
    try
    {
      work();
    }
    catch(...)
    {
      stop();
      leave();
      throw;
    }
    leave();
  }

  bool enter()
  {
    const std::lock_guard lock(m_mutex);
    return m_threads.insert(std::this_thread::get_id()).second;
  }

  void leave()
  {
    const std::lock_guard lock(m_mutex);
    m_threads.erase(std::this_thread::get_id());
  }

  void work()
  {
    Row_search<Graph> search(m_graph, m_columns, m_limits);
    if constexpr(is_row_sink<Rows>)
      compute_blocks(search);
    else
      compute_rows(search);
    m_is_finished = true;
  }

  void compute_blocks(Row_search<Graph>& search)
  {
    typename Rows::Block block;
    while(const std::optional<std::size_t> number = next_block())
    {
      const auto rows = m_plan.rows_of_block(*number);
      for(const std::size_t row : rows)
      {
        if(!goes_further())
          return;
        m_rows.collect(block, row, search.find(m_sources[row]));
      }
      m_rows.add(*number, block);
      m_done += rows.size();
      m_progress.report(number_done());
    }
  }

  std::optional<std::size_t> next_block()
  {
    if constexpr(boost::is_detected_v<Next_block, Rows>)
      return m_rows.next_block();
    else
    {
      const std::size_t number = m_next++;
      return number < m_plan.number_of_blocks() ? std::optional(number) : std::nullopt;
    }
  }

  std::size_t number_done() const
  {
    if constexpr(boost::is_detected_v<Number_done, Rows>)
      return m_rows.number_of_rows_done();
    else
      return m_done;
  }

  void compute_rows(Row_search<Graph>& search)
  {
    for(std::size_t row = m_next++; row < m_plan.number_of_rows(); row = m_next++)
      if(!goes_further() || !hand_over(row, search.find(m_sources[row])))
        return;
  }

  // Rows are assigned in order, so the thread with the next row never waits: there is no deadlock.
  bool hand_over(const std::size_t row, const Distance_row& distances)
  {
    {
      std::unique_lock lock(m_mutex);
      m_turn.wait(lock, [&] { return m_done == row || m_is_stopped; });
    }
    if(m_is_stopped)
      return false;
    m_rows(row, distances);
    m_progress.report(row + 1);
    {
      const std::lock_guard lock(m_mutex);
      ++m_done;
    }
    m_turn.notify_all();
    return true;
  }

  bool goes_further()
  {
    if(!m_is_stopped && !m_progress.go_further())
      stop();
    return !m_is_stopped;
  }

  void stop()
  {
    {
      const std::lock_guard lock(m_mutex); // otherwise a thread about to wait could miss it
      m_is_stopped = true;
    }
    m_turn.notify_all();
  }

  const Graph& m_graph;
  const std::vector<Intrinsic_point>& m_sources;
  const Matrix_columns<Graph>& m_columns;
  const Row_limits& m_limits;
  const Distance_matrix_plan& m_plan;
  Rows& m_rows;

  std::atomic<std::size_t> m_next{0}; // a row or a block
  std::atomic<std::size_t> m_done{0}; // completed rows
  Matrix_progress<Visitor> m_progress;
  std::atomic<bool> m_is_finished{false};
  std::atomic<bool> m_is_stopped{false};
  std::mutex m_mutex;
  std::set<std::thread::id> m_threads; // that are computing rows
  std::condition_variable m_turn;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_MATRIX_COMPUTATION_H
