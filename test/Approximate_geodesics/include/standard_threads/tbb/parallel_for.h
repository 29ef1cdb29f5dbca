// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_PARALLEL_FOR_H
#define APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_PARALLEL_FOR_H

#include <tbb/blocked_range.h>

#include <atomic>
#include <cstddef>
#include <thread>

// Stands in for TBB where the thread sanitizer watches: that does not see how a TBB which was not
// compiled for it hands tasks from one thread to another, and would report every loop.

namespace tbb {

template <typename F>
void parallel_for(const blocked_range<std::size_t>& range, const F& f)
{
  std::atomic<std::size_t> next(range.begin());
  const auto work = [&] {
    for(std::size_t i = next++; i < range.end(); i = next++)
      f(blocked_range<std::size_t>(i, i + 1));
  };
  std::thread other(work);
  work();
  other.join();
}

} // namespace tbb

#endif // APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_PARALLEL_FOR_H
