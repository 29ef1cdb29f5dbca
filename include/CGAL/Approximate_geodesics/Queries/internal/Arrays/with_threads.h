// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_ARRAYS_WITH_THREADS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_ARRAYS_WITH_THREADS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Queries/Arrays/Solver_watch.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>
#endif

#include <cstddef>
#include <string>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB

// Tells the threads that come to help which visitor their work belongs to, if any.
class Visitor_for_helpers : public tbb::task_scheduler_observer
{
public:
  Visitor_for_helpers(tbb::task_arena& arena, Solver_visitor* const visitor)
    : tbb::task_scheduler_observer(arena), m_visitor(visitor)
  {
    observe(true);
  }

  ~Visitor_for_helpers() override { observe(false); }

  void on_scheduler_entry(const bool is_helper) override
  {
    if(is_helper)
      Solver_visitor::of_this_thread() = m_visitor;
  }

  void on_scheduler_exit(const bool is_helper) override
  {
    if(is_helper)
      Solver_visitor::of_this_thread() = nullptr;
  }

private:
  Solver_visitor* m_visitor;
};

#endif

// Calls `f` where so many threads may take part in loops, this one among them; `0` stands for as
// many as there are cores.
template <typename F>
void with_threads([[maybe_unused]] const std::size_t number,
                  [[maybe_unused]] Solver_visitor* const visitor,
                  const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  constexpr std::size_t most = 1 << 16;
  if(number > most)
    reject("the number of threads is " + std::to_string(number) + ", above " +
           std::to_string(most));
  tbb::task_arena arena(number == 0 ? tbb::task_arena::automatic : static_cast<int>(number));
  const Visitor_for_helpers visitor_for_helpers(arena, visitor);
  arena.execute(f);
#else
  f();
#endif
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_ARRAYS_WITH_THREADS_H
