// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_TREE_PATH_H
#define CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_TREE_PATH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/internal/append_point.h>
#include <CGAL/Approximate_geodesics/Paths/internal/surface_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// Paths in the shortest-path tree of a search, whose lengths are in units of the graph.

// What the length of a line may be wrong by, in units of the graph: it is a difference of labels,
// and distances in the unit of the mesh may be multiples of the smallest number.
inline double rounding_of_line(const double label, const double unit)
{
  constexpr double epsilon = 4 * std::numeric_limits<double>::epsilon();
  return epsilon * label + 4 * (std::numeric_limits<double>::denorm_min() / unit);
}

// Appends the edges that a line crosses, which `for_each_crossing(f)` finds in the opposite order
// and whose length it returns.
template <typename ForEachCrossing>
void append_backward(ForEachCrossing for_each_crossing, Path& path)
{
  const auto beyond = static_cast<std::ptrdiff_t>(path.points.size());
  path.length += for_each_crossing([&](const Intrinsic_point::Index h, const double t) {
    path.points.push_back(Intrinsic_point::on_edge(h, t));
  });
  std::reverse(path.points.begin() + beyond, path.points.end());
}

// Appends the line that arrives at `node`, from there back to `end`, which has the label `start`.
// Mostly, how it arrives leads back along it. Where that fails, the line is looked for from its
// start, as the search did; that takes up to as long as all of the search.
template <typename Search>
void append_line_back(const Search& search,
                      const typename Search::Node node,
                      const Intrinsic_point& end,
                      const double start,
                      Path& path)
{
  using Node = typename Search::Node;
  const auto& graph = search.graph();
  const double label = search.label(node), length = label - start;
  const double rounding = rounding_of_line(label, graph.unit());
  const double found =
      graph.for_each_crossing_back(node, search.arrival(node), end, length, rounding,
                                   [&](const Intrinsic_point::Index h, const double t) {
                                     path.points.push_back(Intrinsic_point::on_edge(h, t));
                                   });
  const auto bound = [&](const Node v, const double slack) {
    return (std::min)(label, search.label(v)) * (1 + slack) + rounding;
  };
  if(found >= 0)
    path.length += found;
  else
    append_backward(
        [&](auto f) {
          return graph.attach(end).for_each_crossing(start, bound, Intrinsic_point::at_vertex(node),
                                                     length, rounding, f);
        },
        path);
  append(end, graph.triangulation(), path);
}

// Appends the arc that a search has found from `previous` to `node`, in the opposite direction.
template <typename Search>
void append_arc_back(const Search& search,
                     const typename Search::Node node,
                     const typename Search::Node previous,
                     Path& path)
{
  using Graph = typename Search::Graph;
  const Graph& graph = search.graph();
  const double length = (search.distance(node) - search.distance(previous)) / graph.unit();
  const Intrinsic_point end = position(graph, previous);
  if constexpr(needs_bounds<Graph>)
    return append_line_back(search, node, end, search.label(previous), path);
  else if constexpr(has_crossing_arcs<Graph>)
    append_backward([&](auto f) { return graph.for_each_crossing(previous, node, length, f); },
                    path);
  else
    path.length += length;
  append(end, graph.triangulation(), path);
}

// Appends what follows `node` on the path back to where the search has started. Returns the node
// there.
template <typename Search>
typename Search::Node append_tree_path(const Search& search, typename Search::Node node, Path& path)
{
  for(auto previous = search.predecessor(node); previous != Search::null_node;
      previous = search.predecessor(node))
  {
    append_arc_back(search, node, previous, path);
    node = previous;
  }
  return node;
}

// The path that a search has found, from `node` back to where it starts, with its length in the
// unit of the mesh; without points if `node` was not reached.
template <typename Search>
Path tree_path(const Search& search, const typename Search::Node node)
{
  Path result;
  if(!search.is_reached(node))
    return result;
  result.points.push_back(position(search.graph(), node));
  append_tree_path(search, node, result);
  result.length *= search.graph().unit();
  return result;
}

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_PATHS_INTERNAL_TREE_PATH_H
