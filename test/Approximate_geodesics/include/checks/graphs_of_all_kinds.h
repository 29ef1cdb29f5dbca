// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GRAPHS_OF_ALL_KINDS_H
#define APPROXIMATE_GEODESICS_TEST_GRAPHS_OF_ALL_KINDS_H

#include "meshes/test_weights.h"
#include "oracles/test_oracles.h"
#include "peers/Published_geometric_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Geodesic_costs.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

namespace geodesics_test {

using CGAL::Approximate_geodesics::Discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Fixed_number_of_points;
using CGAL::Approximate_geodesics::Geometric_points;
using CGAL::Approximate_geodesics::Lazy_discrete_geodesic_graph;
using CGAL::Approximate_geodesics::Points_at_interval;
using CGAL::Approximate_geodesics::Published_geometric_points;
using CGAL::Approximate_geodesics::Saddle_vertex_graph;
using CGAL::Approximate_geodesics::Steiner_graph;

// A graph with its parameters.
template <typename GeodesicGraph>
struct Kind_of_graph
{
  using Graph = GeodesicGraph;

  std::string name;
  std::function<Graph(Triangulation)> make;
  double epsilon = infinity;   // the bound, if there is one
  double deviation = 0;        // relative, of distances that were found in another order
  double asymmetry = 1e-12;    // relative, of distances there and back
  double rounding_of_arcs = 0; // relative, of an edge or a chain of arcs along it
};

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

// Calls `f(kind)` for each of those that can do with lengths alone.
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

template <typename F>
void for_each_graph(const double epsilon, F f)
{
  for_each_graph_of_lengths(epsilon, f);
  for_each_graph_with_points(epsilon, f);
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_GRAPHS_OF_ALL_KINDS_H
