// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// Optional members of models of `SurfaceGraph`.

// Whether paths in a graph may have points other than vertices.
template <typename SurfaceGraph>
constexpr bool has_crossing_arcs = !is_valid<const SurfaceGraph&, std::true_type>(
    [](auto& g) -> std::bool_constant<std::decay_t<decltype(g)>::arcs_are_edges> {});

// Whether a graph may have nodes that are not vertices, and gives their positions.
template <typename SurfaceGraph>
constexpr bool has_positions =
    is_valid<const SurfaceGraph&, Intrinsic_point>([](auto& g) -> decltype(g.position(0)) {});

// Attaches a target, which differs from attaching a source if arcs are directed.
template <typename SurfaceGraph>
auto attach_target(const SurfaceGraph& graph, const Intrinsic_point& point)
{
  if constexpr(is_valid<const SurfaceGraph&>(
                   [](auto& g) -> decltype(g.attach_target(std::declval<Intrinsic_point>())) {}))
    return graph.attach_target(point);
  else
    return graph.attach(point);
}

// Whether distances are not symmetric.
template <typename SurfaceGraph>
constexpr bool
    is_directed = is_valid<const SurfaceGraph&>([](auto& g) -> decltype(g.leads_to_sources()) {});

// Whether a graph tells how much distances there and back differ, as those must that have landmarks
// or labels at portals.
template <typename SurfaceGraph>
constexpr bool has_asymmetry =
    is_valid<const SurfaceGraph&, double>([](auto& g) -> decltype(g.asymmetry()) {});

// Whether distances are those to the sources of a search.
template <typename SurfaceGraph>
bool leads_to_sources([[maybe_unused]] const SurfaceGraph& graph)
{
  if constexpr(is_directed<SurfaceGraph>)
    return graph.leads_to_sources();
  else
    return false;
}

// Whether an argument is a graph, and not a mesh.
template <typename T>
constexpr bool is_surface_graph = is_valid<const T&, const Intrinsic_triangulation&>(
    [](auto& g) -> decltype(g.triangulation()) {});

// The position of a node.
template <typename SurfaceGraph>
Intrinsic_point position(const SurfaceGraph& graph, const typename SurfaceGraph::Node node)
{
  if constexpr(has_positions<SurfaceGraph>)
    if(node >= graph.triangulation().number_of_vertices())
      return graph.position(node);
  return Intrinsic_point::at_vertex(node);
}

// Reports a missing member of a graph in one line.
template <typename Graph>
struct Check_surface_graph
{
  static const Intrinsic_point point; // these are never evaluated
  static const Points_by_face points;
  static void on_crossing(Intrinsic_point::Index, double);
  static void on_point(std::size_t, double);
  static constexpr bool has_crossings = is_valid<const Graph&, double>(
      [](auto& g) -> decltype(g.for_each_crossing(0, 0, 1., on_crossing)) {});
  static constexpr bool can_attach =
      is_valid<const Graph&>([](auto& g) -> decltype(g.attach(point)) {});
  static constexpr bool attaches_nodes = is_valid<const Graph&>(
      [](auto& g) -> decltype(g.attach(point).for_each_node(on_crossing)) {});
  static constexpr bool attaches_points = is_valid<const Graph&>(
      [](auto& g) -> decltype(g.attach(point).for_each_point(points, on_point)) {});
  static constexpr bool traces_lines =
      is_valid<const Graph&, double>(
          [](auto& g) -> decltype(g.attach(point).for_each_crossing(
                          Intrinsic_point::Index(), 1., on_crossing)) {}) &&
      is_valid<const Graph&, double>(
          [](auto& g) -> decltype(g.attach(point).for_each_crossing(point, 1., on_crossing)) {});

  static_assert(is_surface_graph<Graph>,
                "A model of SurfaceGraph must have `const Intrinsic_triangulation& triangulation() "
                "const`.");
  static_assert(!has_crossing_arcs<Graph> || Run_of<Graph>::attaches_by_labels || has_crossings,
                "A model of SurfaceGraph must have `double for_each_crossing(Node source, Node "
                "target, double length, F f) const`, unless `arcs_are_edges` is `true`.");
  static_assert(can_attach,
                "A model of SurfaceGraph must have `attach(const Intrinsic_point& point) const`.");
  static_assert(
      !can_attach || attaches_nodes,
      "What `attach()` of a model of SurfaceGraph returns must have `for_each_node(F f)`.");
  static_assert(
      !can_attach || attaches_points,
      "What `attach()` of a model of SurfaceGraph returns must have `for_each_point(const "
      "Points_by_face& points, F f)`.");
  static_assert(!can_attach || traces_lines,
                "What `attach()` of a model of SurfaceGraph returns must have `double "
                "for_each_crossing(End end, double length, F f)`, for a node and for a point.");

  static constexpr bool is_done = true;
};

// A bound on the relative rounding error of sums of lengths.
constexpr double rounding_of_distances = 1e-12;

template <typename Graph>
constexpr bool has_epsilon = is_valid<const Graph&>([](auto& g) -> decltype(g.epsilon()) {});

// Returns the error bound of a graph; infinity if it has none.
template <typename Graph>
double error_bound([[maybe_unused]] const Graph& graph)
{
  if constexpr(has_epsilon<Graph>)
    return graph.epsilon();
  else
    return std::numeric_limits<double>::infinity();
}

// Returns the finite cost from a point to a corner of its face, which extends the error bound of
// some graphs; 0 for other graphs.
template <typename Graph>
double cost_to_corner([[maybe_unused]] const Graph& graph,
                      [[maybe_unused]] const Intrinsic_point& point)
{
  double result = 0;
  if constexpr(is_valid<const Graph&>(
                   [](auto& g) -> decltype(g.cost_to_corner(std::declval<Intrinsic_point>())) {}))
    result = graph.unit() * graph.cost_to_corner(point);
  return std::isinf(result) ? 0 : result;
}

// Returns a lower bound on the exact distance if a search with the error bound `epsilon` has found
// `distance`. `cost_to_corner` is the cost from its ends to the nearest vertices.
inline double
smallest_distance(const double distance, const double epsilon, const double cost_to_corner = 0)
{
  if(std::isinf(epsilon))
    return std::isinf(distance) ? distance : 0;
  const double detour = cost_to_corner > 0 ? (2 + epsilon) * cost_to_corner : 0;
  return (std::max)(distance - detour, 0.) / (1 + epsilon) * (1 - rounding_of_distances);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H
