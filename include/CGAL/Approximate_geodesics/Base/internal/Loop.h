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
#include <functional>
#include <type_traits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * A loop whose turns are independent. A tag chooses whether several threads take them; who runs the
 * loop need not know it, and needs no library of threads.
 */
class Loop
{
public:
  using Turn = std::function<void(std::size_t)>;

  template <typename ConcurrencyTag>
  static Loop with_tag()
  {
    Loop result;
    if constexpr(std::is_convertible_v<ConcurrencyTag, Parallel_tag>)
    {
#ifdef CGAL_LINKED_WITH_TBB
      result.m_run = run_all;
#else
      static_assert(!std::is_convertible_v<ConcurrencyTag, Parallel_tag>,
                    "Parallel_tag is enabled but TBB is unavailable.");
#endif
    }
    return result;
  }

  bool is_parallel() const { return m_run != nullptr; }

  // Calls `turn(i)` for all numbers below `size`. \pre The loop is parallel.
  void run(const std::size_t size, const Turn& turn) const { m_run(size, turn); }

  // Calls `f(first, beyond)` for blocks of the numbers below `size`, or for all at once if the loop
  // is not parallel.
  template <typename F>
  void run_blocks(const std::size_t size, const F& f) const
  {
    constexpr std::size_t size_of_block = 4096;
    if(!is_parallel() || size <= size_of_block)
      f(std::size_t(0), size);
    else
      run((size + size_of_block - 1) / size_of_block, [&](const std::size_t i) {
        f(i * size_of_block, (std::min)((i + 1) * size_of_block, size));
      });
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  // Who has time takes the next turn. Who waits for the others takes up nothing of another loop
  // that this one may be part of: that could need what is being used here.
  static void run_all(const std::size_t size, const Turn& turn)
  {
    std::atomic<std::size_t> next(0);
    const auto take_turns = [&](const tbb::blocked_range<std::size_t>& /* threads */) {
      try
      {
        for(std::size_t i = next++; i < size; i = next++)
          turn(i);
      }
      catch(...)
      {
        next = size;
        throw;
      }
    };
    const auto concurrency = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const tbb::blocked_range<std::size_t> threads(0, (std::min)(concurrency, size));
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(threads, take_turns); });
  }
#endif

  void (*m_run)(std::size_t, const Turn&) = nullptr;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LOOP_H
