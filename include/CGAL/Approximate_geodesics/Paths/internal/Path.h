// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PATH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PATH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/are_same.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Whether paths may have points other than vertices. If not, points can be of any type.
template <typename GeodesicGraph, typename = void>
constexpr bool has_crossing_arcs = true;

template <typename GeodesicGraph>
constexpr bool
    has_crossing_arcs<GeodesicGraph, std::void_t<decltype(GeodesicGraph::arcs_are_edges)>> =
        !GeodesicGraph::arcs_are_edges;

// Whether a graph has nodes that are not vertices, and tells where they are.
template <typename GeodesicGraph, typename = void>
constexpr bool has_places = false;

template <typename GeodesicGraph>
constexpr bool has_places<GeodesicGraph,
                          std::void_t<decltype(std::declval<const GeodesicGraph&>().place(0))>> =
    true;

// Where a node of a graph is.
template <typename GeodesicGraph>
Intrinsic_point place(const GeodesicGraph& graph, const typename GeodesicGraph::Node node)
{
  if constexpr(has_places<GeodesicGraph>)
    if(node >= graph.triangulation().number_of_vertices())
      return graph.place(node);
  return Intrinsic_point::at_vertex(node);
}

struct Path
{
  // Between two of them, the path runs straight through a face, or along an edge.
  std::vector<Intrinsic_point> points;
  double length = 0; // in units of the graph
};

// Whether a point lies on the edge of a halfedge.
inline bool is_on_edge(const Intrinsic_point& p,
                       const Intrinsic_triangulation& triangulation,
                       const Intrinsic_triangulation::Index halfedge)
{
  if(p.is_in_face())
    return false;
  if(p.is_on_edge())
    return p.halfedge == halfedge || p.halfedge == triangulation.opposite(halfedge);
  return p.vertex == triangulation.source(halfedge) || p.vertex == triangulation.target(halfedge);
}

// Appends a point to a path, unless it is where the path has got to. Removes the last point if the
// path goes straight on there, along an edge.
inline void
append(const Intrinsic_point& point, const Intrinsic_triangulation& triangulation, Path& path)
{
  auto& points = path.points;
  if(are_same(point, points.back(), triangulation))
    return;
  const auto h = points.back().halfedge;
  if(points.size() > 1 && points.back().is_on_edge() &&
     is_on_edge(points[points.size() - 2], triangulation, h) && is_on_edge(point, triangulation, h))
    points.pop_back();
  points.push_back(point);
}

// Appends what follows `node` on the path back to where the search has started. Returns the node
// there.
template <typename Search>
typename Search::Node append_tree_path(const Search& search, typename Search::Node node, Path& path)
{
  for(auto previous = search.predecessor(node); previous != Search::null_node;
      previous = search.predecessor(node))
  {
    const double length =
        (search.distance(node) - search.distance(previous)) / search.graph().unit();
    const auto beyond = static_cast<std::ptrdiff_t>(path.points.size());
    path.length += search.graph().for_each_crossing(
        previous, node, length, [&](const auto halfedge, const double t) {
          path.points.push_back(Intrinsic_point::on_edge(halfedge, t));
        });
    std::reverse(path.points.begin() + beyond, path.points.end());
    append(place(search.graph(), previous), search.graph().triangulation(), path);
    node = previous;
  }
  return node;
}

// The path that a search has found, from `node` back to where it starts; without points if `node`
// was not reached.
template <typename Search>
Path find_path(const Search& search, const typename Search::Node node)
{
  Path result;
  if(!search.is_reached(node))
    return result;
  result.points.push_back(place(search.graph(), node));
  append_tree_path(search, node, result);
  return result;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_PATH_H
