// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_INTERRUPTION_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_INTERRUPTION_H

#include <CGAL/license/Approximate_geodesics.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

/*
 * A per-thread hook that can cancel a computation by throwing. Long functions without a visitor
 * poll it, and some report progress to it. An outer caller may install it; worker threads of a
 * parallel loop have none.
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

// Thrown by the worker threads of a loop that another thread has canceled. The loop rethrows the
// exception of that thread.
struct Loop_canceled
{
};

inline void check_for_interruption()
{
  if(Interruption* const interruption = Interruption::of_this_thread())
    return interruption->check();
#ifdef CGAL_LINKED_WITH_TBB
  if(tbb::is_current_task_group_canceling())
    throw Loop_canceled();
#endif
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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_INTERRUPTION_H
