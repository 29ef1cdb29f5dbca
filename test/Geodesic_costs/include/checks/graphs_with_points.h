// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GRAPHS_WITH_POINTS_H
#define APPROXIMATE_GEODESICS_TEST_GRAPHS_WITH_POINTS_H

#include "checks/Kind_of_graph.h"
#include "meshes/test_weights.h"
#include "peers/Published_geometric_points.h"

#include <CGAL/Geodesic_costs.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>

// Kinds of graphs that tests of all kinds have besides those of the core, where this header is.

namespace geodesics_test {

using CGAL::Approximate_geodesics::Points_at_interval;
using CGAL::Approximate_geodesics::Published_geometric_points;

// Arcs that are left out can be as good as others, but for their rounding.
template <typename Placement>
Kind_of_graph<Steiner_graph<Placement>>
graph_with_points(const std::string& name, const Placement& placement, const double epsilon)
{
  return {
      "graph with " + name,
      [placement](Triangulation t) { return Steiner_graph<Placement>(std::move(t), placement); },
      epsilon,
      1e-14,
      1e-12,
      1e-14};
}

inline Kind_of_graph<Steiner_graph<Fixed_number_of_points>>
graph_with_spaced_points(const std::size_t number)
{
  return graph_with_points("equally spaced points", Fixed_number_of_points(number), infinity);
}

// Calls `f(kind)` for each of those that heed weights.
template <typename F>
void for_each_graph_with_points(const double epsilon, F f)
{
  const auto call = [&](const auto& kind) {
    SCOPED_TRACE(kind.name);
    f(kind);
  };
  call(graph_with_spaced_points(2));
  call(graph_with_points("equally dense points", Points_at_interval(0.4), infinity));
  call(graph_with_points("geometric points", lenient_points(epsilon), epsilon));
  call(graph_with_points("published points", Published_geometric_points(epsilon), infinity));
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_GRAPHS_WITH_POINTS_H
