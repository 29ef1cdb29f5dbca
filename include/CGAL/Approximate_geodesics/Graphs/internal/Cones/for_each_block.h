// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_FOR_EACH_BLOCK_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_FOR_EACH_BLOCK_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Calls `f(i)` for every i below `number`: in turn, or at the same time under `Parallel_tag`.
template <typename ConcurrencyTag, typename F>
void for_each_block(const std::size_t number, F f)
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible_v<ConcurrencyTag, Parallel_tag>,
                "Parallel_tag is given, but TBB is not available");
#else
  if constexpr(std::is_convertible_v<ConcurrencyTag, Parallel_tag>)
  {
    tbb::parallel_for(std::size_t(0), number, f);
    return;
  }
#endif
  for(std::size_t i = 0; i < number; ++i)
    f(i);
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_FOR_EACH_BLOCK_H
