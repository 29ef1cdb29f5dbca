// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WATCHED_EXACT_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WATCHED_EXACT_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/interruption.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * The exact graph with searches that can be interrupted amid the arcs of a node. On a convex
 * surface there are no pseudo-sources, so the arcs of the source are the whole search.
 */
class Watched_exact_graph : public Saddle_vertex_graph
{
public:
  using Saddle_vertex_graph::Saddle_vertex_graph;

  template <typename Labels, typename F>
  void for_each_arc(const Node node, const Labels& labels, F f) const
  {
    constexpr unsigned arcs_between_looks = 256;
    unsigned number = 0;
    Saddle_vertex_graph::for_each_arc(node, labels, [&](const auto&... arc) {
      if(++number % arcs_between_looks == 0)
        check_for_interruption();
      f(arc...);
    });
  }
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_WATCHED_EXACT_GRAPH_H
