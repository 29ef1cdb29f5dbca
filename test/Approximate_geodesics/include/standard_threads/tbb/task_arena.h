// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_TASK_ARENA_H
#define APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_TASK_ARENA_H

// Stands in for TBB's: see parallel_for.h.

namespace tbb::this_task_arena {

inline int max_concurrency() { return 2; }

template <typename F>
void isolate(const F& f)
{
  f();
}

} // namespace tbb::this_task_arena

#endif // APPROXIMATE_GEODESICS_TEST_STANDARD_THREADS_TBB_TASK_ARENA_H
