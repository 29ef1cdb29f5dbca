// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_THREADS_H
#define BENCHMARK_THREADS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <type_traits>

static constexpr bool HAS_THREADS =
    std::is_same_v<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>;

// Calls `f(tag)` with a given number of threads, which may exceed the number of cores.
template <typename F>
void with_threads([[maybe_unused]] const std::size_t number, F f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(number > 1)
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number);
    tbb::task_arena(static_cast<int>(number)).execute([&] { f(CGAL::Parallel_tag()); });
    return;
  }
#endif
  f(CGAL::Sequential_tag());
}

#endif // BENCHMARK_THREADS_H
