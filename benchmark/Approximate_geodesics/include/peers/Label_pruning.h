// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_LABEL_PRUNING_H
#define BENCHMARK_LABEL_PRUNING_H

#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cone_expansion.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <cstddef>

// Counts the windows of an expansion; does nothing, at no cost, if `COUNTS` is false.
template <bool COUNTS>
class Window_count
{
public:
  void add(const std::size_t number) const
  {
    if constexpr(COUNTS)
      m_number += number;
  }

  std::size_t number() const { return m_number; }

private:
  mutable std::size_t m_number = 0;
};

// Prunes no window, and counts windows.
template <bool COUNTS>
struct Counting_windows : CGAL::Approximate_geodesics::internal::Leave_out_nothing
{
  explicit Counting_windows(const Window_count<COUNTS>& the_count) : count(the_count) {}

  bool prune(const CGAL::Approximate_geodesics::internal::Window&) const
  {
    count.add(1);
    return false;
  }

  const Window_count<COUNTS>& count;
};

// Prunes a window if its labels show that paths over an end of its edge are good enough for all
// nodes behind it.
template <bool COUNTS, typename Labels>
struct Label_pruning : CGAL::Approximate_geodesics::internal::Leave_out_nothing
{
  using Triangulation = CGAL::Approximate_geodesics::Intrinsic_triangulation;

  static constexpr bool wants_distances = true;

  Label_pruning(const Triangulation& the_triangulation,
                const Labels& the_labels,
                const double the_label_of_tip,
                const double the_factor,
                const Window_count<COUNTS>& the_count)
    : triangulation(the_triangulation),
      labels(the_labels),
      label_of_tip(the_label_of_tip),
      factor(the_factor),
      count(the_count)
  {
  }

  bool prune(const CGAL::Approximate_geodesics::internal::Window& w) const
  {
    const double edge = triangulation.length(w.halfedge);
    if(labels.distance(w.left_end) - label_of_tip < factor * (w.right_distance - edge) ||
       labels.distance(w.right_end) - label_of_tip < factor * (w.left_distance - edge))
      return true;
    count.add(1);
    return false;
  }

  const Triangulation& triangulation;
  const Labels& labels;
  double label_of_tip, factor;
  const Window_count<COUNTS>& count;
};

#endif // BENCHMARK_LABEL_PRUNING_H
