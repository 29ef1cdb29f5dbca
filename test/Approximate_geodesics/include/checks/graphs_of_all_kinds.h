// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GRAPHS_OF_ALL_KINDS_H
#define APPROXIMATE_GEODESICS_TEST_GRAPHS_OF_ALL_KINDS_H

#include "checks/Kind_of_graph.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>

// The package of costs has further kinds. Where its tests are, tests of all kinds are tests of
// these, too; the core alone has its own.
#if __has_include("checks/graphs_with_points.h")
#include "checks/graphs_with_points.h"
#define APPROXIMATE_GEODESICS_TEST_HAS_GRAPHS_WITH_POINTS
#endif

namespace geodesics_test {

using CGAL::Approximate_geodesics::Discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Saddle_vertex_graph;

inline Kind_of_graph<Graph> edge_graph()
{
  return {"edge graph", [](Triangulation t) { return Graph(std::move(t)); }};
}

// Arcs of discrete geodesic graphs are kept as such numbers.
constexpr double single_precision = 1. / (1 << 22);

inline Kind_of_graph<Discrete_geodesic_graph> discrete_geodesic_graph(const double epsilon)
{
  return {"discrete geodesic graph",
          [epsilon](Triangulation t) {
            return Discrete_geodesic_graph(std::move(t), CGAL::parameters::epsilon(epsilon));
          },
          epsilon,
          0,
          epsilon,
          single_precision};
}

inline Kind_of_graph<Lazy_discrete_geodesic_graph>
lazy_graph(const double epsilon, const Lazy_discrete_geodesic_graph::Arcs arcs)
{
  const bool forgets = arcs == Lazy_discrete_geodesic_graph::Arcs::FORGOTTEN;
  return {forgets ? "lazy graph" : "lazy graph that keeps its arcs",
          [=](Triangulation t) {
            return Lazy_discrete_geodesic_graph(std::move(t), CGAL::parameters::epsilon(epsilon),
                                                arcs);
          },
          epsilon,
          forgets ? epsilon : 0,
          epsilon,
          forgets ? epsilon : single_precision};
}

// Whether a node is expanded again depends on the queue, and so do roundings.
inline Kind_of_graph<Saddle_vertex_graph> saddle_vertex_graph()
{
  return {"saddle vertex graph",
          [](Triangulation t) { return Saddle_vertex_graph(std::move(t)); },
          0,
          1e-12,
          1e-12,
          1e-12};
}

// Calls `f(kind)` for each of those that can do with lengths alone, which are the core's.
template <typename F>
void for_each_graph_of_lengths(const double epsilon, F f)
{
  const auto call = [&](const auto& kind) {
    SCOPED_TRACE(kind.name);
    f(kind);
  };
  using Arcs = Lazy_discrete_geodesic_graph::Arcs;
  call(edge_graph());
  call(discrete_geodesic_graph(epsilon));
  call(lazy_graph(epsilon, Arcs::FORGOTTEN));
  call(lazy_graph(epsilon, Arcs::KEPT));
  call(saddle_vertex_graph());
}

template <typename F>
void for_each_graph(const double epsilon, F f)
{
  for_each_graph_of_lengths(epsilon, f);
#ifdef APPROXIMATE_GEODESICS_TEST_HAS_GRAPHS_WITH_POINTS
  for_each_graph_with_points(epsilon, f);
#endif
}

// Calls `f(kind)` for points that divide edges into equal parts, where there are any.
template <typename F>
void with_spaced_points([[maybe_unused]] const std::size_t number, [[maybe_unused]] F f)
{
#ifdef APPROXIMATE_GEODESICS_TEST_HAS_GRAPHS_WITH_POINTS
  SCOPED_TRACE("equally spaced points");
  f(graph_with_spaced_points(number));
#endif
}

// Calls `f(kind)` for those that are small on meshes with edges of very different lengths.
template <typename F>
void for_each_small_graph(const double epsilon, F f)
{
  for_each_graph_of_lengths(epsilon, f);
  with_spaced_points(2, f);
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_GRAPHS_OF_ALL_KINDS_H
