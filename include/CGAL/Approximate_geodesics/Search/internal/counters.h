// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_COUNTERS_H
#define CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_COUNTERS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Search/Propagation_statistics.h>

#include <cstddef>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Counts nothing, and costs nothing.
struct No_counter
{
  void on_stale_pops(std::size_t /* number */) const {}
  void on_expansion() const {}
  void on_relaxations(std::size_t /* number */) const {}
  void on_improvement() const {}

  No_counter with(Propagation_statistics& /* share */) const { return {}; }
  void add(const Propagation_statistics& /* share */) const {}
};

// Counts for statistics.
struct Counter
{
  void on_stale_pops(const std::size_t number) const
  {
    statistics.pops += number;
    statistics.stale_pops += number;
  }
  void on_expansion() const { ++statistics.pops; }
  void on_relaxations(const std::size_t number) const { statistics.relaxations += number; }
  void on_improvement() const { ++statistics.improvements; }

  // what one of several threads counts, and what is made of it
  Counter with(Propagation_statistics& share) const { return {share}; }
  void add(const Propagation_statistics& share) const
  {
    statistics.relaxations += share.relaxations;
  }

  Propagation_statistics& statistics;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SEARCH_INTERNAL_COUNTERS_H
