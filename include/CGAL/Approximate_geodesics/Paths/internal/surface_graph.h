// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// What models of `SurfaceGraph` may leave out.

// Whether paths in a graph may have points other than vertices.
template <typename SurfaceGraph, typename = void>
constexpr bool has_crossing_arcs = true;

template <typename SurfaceGraph>
constexpr bool
    has_crossing_arcs<SurfaceGraph, std::void_t<decltype(SurfaceGraph::arcs_are_edges)>> =
        !SurfaceGraph::arcs_are_edges;

// Whether a graph has nodes that are not vertices, and tells where they are.
template <typename SurfaceGraph, typename = void>
constexpr bool has_positions = false;

template <typename SurfaceGraph>
constexpr bool
    has_positions<SurfaceGraph,
                  std::void_t<decltype(std::declval<const SurfaceGraph&>().position(0))>> = true;

// Where a node is.
template <typename SurfaceGraph>
Intrinsic_point position(const SurfaceGraph& graph, const typename SurfaceGraph::Node node)
{
  if constexpr(has_positions<SurfaceGraph>)
    if(node >= graph.triangulation().number_of_vertices())
      return graph.position(node);
  return Intrinsic_point::at_vertex(node);
}

// Calls `f(h, t)` for the edges that an arc crosses. Returns its length before it was rounded.
template <typename SurfaceGraph, typename F>
double for_each_crossing(const SurfaceGraph& graph,
                         const typename SurfaceGraph::Node source,
                         const typename SurfaceGraph::Node target,
                         const double length,
                         F f)
{
  if constexpr(has_crossing_arcs<SurfaceGraph>)
    return graph.for_each_crossing(source, target, length, f);
  else
    return length;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_SURFACE_GRAPH_H
