// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_SIGHT_COUNTING_GRAPH_H
#define BENCHMARK_SIGHT_COUNTING_GRAPH_H

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Saddle_run.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Sight_expansion.h>

#include <cstddef>

// A saddle vertex graph that counts windows. The counter allows one search at a time only.
class Sight_counting_graph : public CGAL::Approximate_geodesics::Saddle_vertex_graph
{
  struct Counter : CGAL::Approximate_geodesics::internal::Sight_visitor_base
  {
    static constexpr bool wants_sights = true;

    void on_sight(const CGAL::Approximate_geodesics::internal::Sight&) { ++number; }

    static inline std::size_t number = 0;
  };

public:
  using Run = CGAL::Approximate_geodesics::internal::Saddle_run<Saddle_vertex_graph, Counter>;

  using Saddle_vertex_graph::Saddle_vertex_graph;

  static void reset() { Counter::number = 0; }

  // Since the last reset.
  static std::size_t number_of_sights() { return Counter::number; }
};

#endif // BENCHMARK_SIGHT_COUNTING_GRAPH_H
