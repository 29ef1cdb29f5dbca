// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <boost/type_traits/detected_or.hpp>
#include <boost/type_traits/is_detected.hpp>
#include <boost/type_traits/is_detected_convertible.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// Optional members of models of `SurfaceGraph`.

template <typename Graph>
using Arcs_are_edges = std::bool_constant<Graph::arcs_are_edges>;

template <typename Graph>
using Position_of_node = decltype(std::declval<const Graph&>().position(0));

// Whether paths in a graph may have points other than vertices.
template <typename SurfaceGraph>
constexpr bool has_crossing_arcs =
    !boost::detected_or_t<std::false_type, Arcs_are_edges, SurfaceGraph>::value;

// Whether a graph may have nodes that are not vertices, and gives their positions.
template <typename SurfaceGraph>
constexpr bool has_positions =
    boost::is_detected_convertible_v<Intrinsic_point, Position_of_node, SurfaceGraph>;

template <typename Graph>
using Attachment_of_target =
    decltype(std::declval<const Graph&>().attach_target(std::declval<Intrinsic_point>()));

template <typename Graph>
using Leads_to_sources = decltype(std::declval<const Graph&>().leads_to_sources());

// Attaches a target, which differs from attaching a source if arcs are directed.
template <typename SurfaceGraph>
auto attach_target(const SurfaceGraph& graph, const Intrinsic_point& point)
{
  if constexpr(boost::is_detected_v<Attachment_of_target, SurfaceGraph>)
    return graph.attach_target(point);
  else
    return graph.attach(point);
}

// Whether distances are not symmetric.
template <typename SurfaceGraph>
constexpr bool is_directed = boost::is_detected_v<Leads_to_sources, SurfaceGraph>;

// Whether distances are those to the sources of a search.
template <typename SurfaceGraph>
bool leads_to_sources([[maybe_unused]] const SurfaceGraph& graph)
{
  if constexpr(is_directed<SurfaceGraph>)
    return graph.leads_to_sources();
  else
    return false;
}

template <typename T>
using Triangulation_of = decltype(std::declval<const T&>().triangulation());

// Whether an argument is a graph, and not a mesh.
template <typename T>
constexpr bool is_surface_graph =
    boost::is_detected_convertible_v<const Intrinsic_triangulation&, Triangulation_of, T>;

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
  using F = void (*)(Intrinsic_point::Index, double);
  using End = Intrinsic_point::Index;

  template <typename G>
  using Crossing = decltype(std::declval<const G&>().for_each_crossing(
      std::declval<End>(), std::declval<End>(), 1., std::declval<F>()));
  template <typename G>
  using Attachment = decltype(std::declval<const G&>().attach(std::declval<Intrinsic_point>()));
  template <typename G>
  using Nodes = decltype(std::declval<Attachment<G>>().for_each_node(std::declval<F>()));
  template <typename G>
  using Points = decltype(std::declval<Attachment<G>>().for_each_point(
      std::declval<Points_by_face>(), std::declval<void (*)(std::size_t, double)>()));
  template <typename G>
  using Crossing_to_node = decltype(std::declval<Attachment<G>>().for_each_crossing(
      std::declval<End>(), 1., std::declval<F>()));
  template <typename G>
  using Crossing_to_point = decltype(std::declval<Attachment<G>>().for_each_crossing(
      std::declval<Intrinsic_point>(), 1., std::declval<F>()));

  static_assert(is_surface_graph<Graph>,
                "A model of SurfaceGraph must have `const Intrinsic_triangulation& triangulation() "
                "const`.");
  static_assert(!has_crossing_arcs<Graph> || Run_of<Graph>::attaches_by_labels ||
                    boost::is_detected_convertible_v<double, Crossing, Graph>,
                "A model of SurfaceGraph must have `double for_each_crossing(Node source, Node "
                "target, double length, F f) const`, unless `arcs_are_edges` is `true`.");
  static constexpr bool can_attach = boost::is_detected_v<Attachment, Graph>;
  static_assert(can_attach,
                "A model of SurfaceGraph must have `attach(const Intrinsic_point& point) const`.");
  static_assert(
      !can_attach || boost::is_detected_v<Nodes, Graph>,
      "What `attach()` of a model of SurfaceGraph returns must have `for_each_node(F f)`.");
  static_assert(
      !can_attach || boost::is_detected_v<Points, Graph>,
      "What `attach()` of a model of SurfaceGraph returns must have `for_each_point(const "
      "Points_by_face& points, F f)`.");
  static_assert(!can_attach || (boost::is_detected_convertible_v<double, Crossing_to_node, Graph> &&
                                boost::is_detected_convertible_v<double, Crossing_to_point, Graph>),
                "What `attach()` of a model of SurfaceGraph returns must have `double "
                "for_each_crossing(End end, double length, F f)`, for a node and for a point.");

  static constexpr bool is_done = true;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H
