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

// `concurrency_tag(Tag())` as a chain that goes on with names of this package. In CGAL 6, the
// parameter is CGAL's, and so is a chain that starts with it.
template <typename Tag>
auto with_concurrency(Tag tag)
{
  using CGAL::Approximate_geodesics::internal::Named_parameters;
  return Named_parameters<Tag, CGAL::internal_np::concurrency_tag_t>(tag);
}

// Calls `f(np)` for one thread, and for several numbers of them.
template <typename F>
void for_each_number_of_threads(F f)
{
  f(with_concurrency(CGAL::Sequential_tag()));
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control more_than_cores(tbb::global_control::max_allowed_parallelism, 7);
  for(const int number : {1, 2, 3, 7})
  {
    SCOPED_TRACE(testing::Message() << number << " threads");
    tbb::task_arena arena(number);
    arena.execute([&] { f(with_concurrency(CGAL::Parallel_tag())); });
  }
#endif
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_NUMBERS_OF_THREADS_H
