// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WITH_THREADS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WITH_THREADS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <map>
#include <string>

namespace CGAL::Approximate_geodesics::internal {

// Calls `f` in a task arena of `number` threads, including this one; `0` selects one per core.
// Arenas are kept per thread, because some versions of TBB leak memory when an arena is destroyed.
template <typename F>
void with_threads([[maybe_unused]] const std::size_t number, const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  constexpr std::size_t most = 1 << 16;
  if(number > most)
    reject("the number of threads is " + std::to_string(number) + ", more than " +
           std::to_string(most));
  if(number == 0 || number >= static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()))
    return f();
  thread_local std::map<std::size_t, tbb::task_arena> arenas;
  arenas.try_emplace(number, static_cast<int>(number)).first->second.execute(f);
#else
  f();
#endif
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WITH_THREADS_H
