// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LOOP_H
#define CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LOOP_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <numeric>
#include <type_traits>
#include <vector>

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
    if(std::is_convertible_v<ConcurrencyTag, Parallel_tag>)
      result.m_run = run_all<ConcurrencyTag>;
    return result;
  }

  bool is_parallel() const { return m_run != nullptr; }

  // Calls `turn(i)` for all numbers below `size`. \pre The loop is parallel.
  void run(const std::size_t size, const Turn& turn) const { m_run(size, turn); }

private:
  template <typename ConcurrencyTag>
  static void run_all(const std::size_t size, const Turn& turn)
  {
    std::vector<std::size_t> numbers(size);
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
    CGAL::for_each<ConcurrencyTag>(numbers, [&](std::size_t& i) {
      turn(i);
      return true;
    });
  }

  void (*m_run)(std::size_t, const Turn&) = nullptr;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_BASE_INTERNAL_LOOP_H
