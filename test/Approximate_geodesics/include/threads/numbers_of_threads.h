// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_NUMBERS_OF_THREADS_H
#define APPROXIMATE_GEODESICS_TEST_NUMBERS_OF_THREADS_H

#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace geodesics_test {

// Calls `f(np)` for one thread, and for several numbers of them.
template <typename F>
void for_each_number_of_threads(F f)
{
  f(CGAL::parameters::concurrency_tag(CGAL::Sequential_tag()));
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control more_than_cores(tbb::global_control::max_allowed_parallelism, 7);
  for(const int number : {1, 2, 3, 7})
  {
    SCOPED_TRACE(testing::Message() << number << " threads");
    tbb::task_arena arena(number);
    arena.execute([&] { f(CGAL::parameters::concurrency_tag(CGAL::Parallel_tag())); });
  }
#endif
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_NUMBERS_OF_THREADS_H
