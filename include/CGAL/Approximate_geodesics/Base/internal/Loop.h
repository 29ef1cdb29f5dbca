// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LOOP_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LOOP_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <type_traits>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A per-thread hook that can cancel a computation by throwing: the one way to cancel from outside.
 * Searches and other long functions poll it, and report progress to it. An outer caller may install
 * it; the threads of a parallel loop inherit it.
 */
class Interruption
{
public:
  virtual void check() = 0;
  virtual void set_progress(std::size_t number_done, std::size_t number) = 0;

  static Interruption*& of_this_thread()
  {
    thread_local Interruption* result = nullptr;
    return result;
  }

protected:
  ~Interruption() = default;
};

inline void check_for_interruption()
{
  if(Interruption* const interruption = Interruption::of_this_thread())
    interruption->check();
}

// Reports the progress of all threads together before the check.
inline void check_for_interruption(const std::size_t number_done, const std::size_t number)
{
  if(Interruption* const interruption = Interruption::of_this_thread())
    interruption->set_progress(number_done, number);
  check_for_interruption();
}

// Checks only every few thousand iterations, for loops with cheap iterations.
inline void check_for_interruption_at(const std::size_t turn)
{
  constexpr std::size_t turns_between_checks = 4096;
  if(turn % turns_between_checks == 0)
    check_for_interruption();
}

/*
 * A loop with independent iterations. A concurrency tag selects sequential or parallel execution;
 * functions that run the loop depend neither on the tag nor on TBB, so that they can be compiled
 * into a library.
 */
class Loop
{
public:
  using Turn = std::function<void(std::size_t, std::size_t)>;

  static constexpr std::size_t SIZE_OF_BLOCK = 4096; // of vertices: a fraction of a millisecond

  template <typename ConcurrencyTag>
  static Loop with_tag()
  {
    Loop result;
    if constexpr(std::is_convertible_v<ConcurrencyTag, Parallel_tag>)
    {
#ifdef CGAL_LINKED_WITH_TBB
      result.m_run = run_all;
      result.m_number_of_threads = number_of_tbb_threads;
#else
      static_assert(!std::is_convertible_v<ConcurrencyTag, Parallel_tag>,
                    "Parallel_tag is enabled but TBB is unavailable.");
#endif
    }
    return result;
  }

  // The loop for work on `size` vertices: sequential if starting threads would take longer than it
  // saves. So it depends on the work, but not on the number of threads.
  Loop for_size(const std::size_t size) const { return size > SIZE_OF_BLOCK ? *this : Loop(); }

  bool is_parallel() const { return m_run != nullptr; }

  // Returns the maximum number of threads available to the loop.
  std::size_t number_of_threads() const { return is_parallel() ? m_number_of_threads() : 1; }

  // Calls `turn(i, thread)` for all `i` below `size`. Concurrent calls have different values of
  // `thread`, all below `number_of_threads()`.
  void run(const std::size_t size, const Turn& turn) const
  {
    if(is_parallel() && size > 1)
      m_run(size, turn);
    else
      for(std::size_t i = 0; i < size; ++i)
        turn(i, 0);
  }

  // Calls `f(first, beyond)` for blocks of `[0, size)`, or for the whole range if the loop is
  // sequential.
  template <typename F>
  void run_blocks(const std::size_t size, const F& f) const
  {
    if(!is_parallel() || size <= SIZE_OF_BLOCK)
      f(std::size_t(0), size);
    else
      run((size + SIZE_OF_BLOCK - 1) / SIZE_OF_BLOCK,
          [&](const std::size_t i, std::size_t /* thread */) {
            f(i * SIZE_OF_BLOCK, (std::min)((i + 1) * SIZE_OF_BLOCK, size));
          });
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  struct Loop_canceled
  {
  };

  // The hook of a thread of the loop: that of the caller, until another thread throws.
  class Cancellation final : public Interruption
  {
  public:
    Cancellation(const std::atomic<bool>& is_canceled, Interruption* const caller)
      : m_is_canceled(is_canceled), m_caller(caller)
    {
      of_this_thread() = this;
    }
    ~Cancellation() { of_this_thread() = m_outer; }
    Cancellation(const Cancellation&) = delete;
    Cancellation& operator=(const Cancellation&) = delete;

    void check() override
    {
      if(m_is_canceled)
        throw Loop_canceled();
      if(m_caller != nullptr)
        m_caller->check();
    }

    void set_progress(const std::size_t number_done, const std::size_t number) override
    {
      if(m_caller != nullptr)
        m_caller->set_progress(number_done, number);
    }

  private:
    const std::atomic<bool>& m_is_canceled;
    Interruption* m_caller;
    Interruption* m_outer = of_this_thread();
  };

  static std::size_t number_of_tbb_threads()
  {
    return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  }

  // Distributes iterations dynamically, and rethrows the first exception. Isolation prevents a
  // thread that waits for an inner loop from stealing a task of this one or of an enclosing loop,
  // which could need a resource that is in use.
  static void run_all(const std::size_t size, const Turn& turn)
  {
    std::atomic<std::size_t> next(0);
    std::atomic<bool> is_canceled(false);
    std::exception_ptr error;
    Interruption* const caller = Interruption::of_this_thread();
    const auto take_turns = [&](const tbb::blocked_range<std::size_t>& threads) {
      const Cancellation cancellation(is_canceled, caller);
      try
      {
        tbb::this_task_arena::isolate([&] {
          for(std::size_t i = next++; i < size; i = next++)
            turn(i, threads.begin());
        });
      }
      catch(...)
      {
        next = size;
        if(!is_canceled.exchange(true)) // not that of a thread that was canceled for this reason
          error = std::current_exception();
      }
    };
    const tbb::blocked_range<std::size_t> threads(0, (std::min)(number_of_tbb_threads(), size));
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(threads, take_turns); });
    if(error)
      std::rethrow_exception(error);
  }
#endif

  void (*m_run)(std::size_t, const Turn&) = nullptr;
  std::size_t (*m_number_of_threads)() = nullptr;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LOOP_H
