// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_LINES_FROM_CURVES_H
#define CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_LINES_FROM_CURVES_H

#include <CGAL/license/Geodesic_constructions.h>

#include <CGAL/Approximate_geodesics/Base/Geodesic_run_base.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Cones/Cones_of_point.h>
#include <CGAL/Approximate_geodesics/Surface/Lines_in_faces.h>
#include <CGAL/Geodesic_constructions/Intrinsic_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Lines_from_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Nodes_beside.h>
#include <CGAL/Geodesic_constructions/internal/Curves/Sample_sector.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// What a search from curves asks of a graph, over what the graph tells of an attached point: lines
// in faces, cones, or nodes on sides.

template <typename Graph>
using Attachment_of =
    decltype(std::declval<const Graph&>().attach(std::declval<Intrinsic_point>()));

template <typename Graph>
constexpr bool attaches_in_faces = std::is_base_of_v<Lines_in_faces, Attachment_of<Graph>>;

template <typename Graph>
constexpr bool attaches_in_cones = std::is_base_of_v<Cones_of_point, Attachment_of<Graph>>;

template <typename Graph>
constexpr bool attaches_on_sides = tells_nodes_on_sides<Attachment_of<Graph>>;

// Whether searches of a graph can start from curves. If its run finds lines from labels, these have
// to be sights.
template <typename Graph>
constexpr bool has_curves = (attaches_in_faces<Graph> || attaches_in_cones<Graph> ||
                             attaches_on_sides<Graph>)&&(!Run_of<Graph>::attaches_by_labels ||
                                                         follows_sights<Run_of<Graph>>);

// Calls `f(node, length, foot)` for the lines from inside the segment between two points of a curve
// to the nodes beside it, and `on_sample(sample)` for points that stand for parts of it: see
// `Strips_of_curve`.
template <typename Graph, typename F, typename OnSample>
void for_each_node_beside(const Graph& graph,
                          const Intrinsic_point& from,
                          const Intrinsic_point& to,
                          F f,
                          [[maybe_unused]] OnSample on_sample)
{
  const Intrinsic_triangulation& t = graph.triangulation();
  if constexpr(attaches_on_sides<Graph>)
    for_each_node_of_sides(t, graph.attach(from), from, to, f);
  else
    for_each_corner_beside(t, from, to,
                           [&](const Index v, const Face_point& corner, const Face_point& foot,
                               const Intrinsic_point& p) {
                             f(v, Line_weights{t}.between(corner.halfedge, foot, corner), p);
                           });
  if constexpr(attaches_in_cones<Graph>)
    Strips_of_curve<F, OnSample>{t, slope_of_strips(graph.attach(from).rules()), f, on_sample}
        .follow(from, to);
}

// Calls `f(node, length)` for the lines from a point of a curve. Lines in cones are left out where
// labels, upper bounds of distances in units of the graph, show them to be of no use.
template <typename Graph, typename Labels, typename F>
void for_each_node_from(const Graph& graph,
                        const Intrinsic_point& point,
                        [[maybe_unused]] const Labels& labels,
                        F f)
{
  if constexpr(attaches_in_cones<Graph>)
    for_each_node_in_cones(graph.triangulation(), graph.attach(point), labels, f);
  else
    graph.attach(point).for_each_node(f);
}

// The same for the lines that a sample is needed for. Only graphs with cones have samples.
template <typename Graph, typename Labels, typename F>
void for_each_node_from_sample([[maybe_unused]] const Graph& graph,
                               [[maybe_unused]] const Curve_sample& sample,
                               [[maybe_unused]] const Labels& labels,
                               [[maybe_unused]] F f)
{
  if constexpr(attaches_in_cones<Graph>)
    for_each_node_in_sector(graph.triangulation(), graph.attach(sample.point), sample, labels, f);
}

// Calls `f(node, length, arrival, foot)` for the lines from a curve, whose initial label is
// `label`, that a run finds from its upper bounds.
template <typename Graph, typename Run, typename F>
void for_each_line_by_labels(
    const Graph& graph, const Run& run, const Intrinsic_curve& curve, const double label, F f)
{
  Lines_from_curve(graph.triangulation(), run.tables())
      .for_each_line(
          curve, label, [&](const Index node) { return run.bound(node); }, f);
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_CONSTRUCTIONS_INTERNAL_CURVES_LINES_FROM_CURVES_H
