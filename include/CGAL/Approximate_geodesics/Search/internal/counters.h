// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_COUNTERS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_COUNTERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queues/Bucket_statistics.h>
#include <CGAL/Approximate_geodesics/Search/Propagation_statistics.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Counts nothing, and costs nothing.
struct No_counter
{
  void on_stale_pops(std::size_t /* number */) const {}
  void on_expansion() const {}
  void on_relaxation() const {}
  void on_improvement() const {}
};

struct Counter
{
  void on_stale_pops(const std::size_t number) const
  {
    statistics.pops += number;
    statistics.stale_pops += number;
  }
  void on_expansion() const { ++statistics.pops; }
  void on_relaxation() const { ++statistics.relaxations; }
  void on_improvement() const { ++statistics.improvements; }

  Propagation_statistics& statistics;
};

template <typename Queue, typename = void>
constexpr bool counts_comparisons = false;

template <typename Queue>
constexpr bool counts_comparisons<
    Queue,
    std::enable_if_t<std::is_convertible_v<decltype(std::declval<const Queue&>().statistics()),
                                           Bucket_statistics>>> = true;

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_COUNTERS_H
