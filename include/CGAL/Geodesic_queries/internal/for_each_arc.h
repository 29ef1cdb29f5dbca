// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_FOR_EACH_ARC_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_FOR_EACH_ARC_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/arrays.h>
#include <CGAL/Approximate_geodesics/Search/internal/Labels.h>

#include <cstddef>

namespace CGAL::Approximate_geodesics::internal {

// Takes arcs one by one, or several to consecutive nodes.
template <typename F>
struct Each_arc
{
  void operator()(const Labels::Node target, const double length) const { f(target, length); }

  void
  operator()(const Labels::Node first, const double* const lengths, const std::size_t number) const
  {
    for(std::size_t i = 0; i < number; ++i)
      f(first + static_cast<Labels::Node>(i), lengths[i]);
  }

  const F& f;
};

// Calls `f(node, target, length)` for all arcs of a graph. Those of a node are those of a search
// that starts there.
template <typename Graph, typename F>
void for_each_arc(const Graph& graph, const F& f)
{
  Labels labels(graph.number_of_nodes());
  for(Labels::Node node = 0; node < graph.number_of_nodes(); ++node)
  {
    check_for_interruption_at(node);
    labels.set(node, 0, Labels::null_node);
    const auto on_arc = [&](const Labels::Node target, const double length) {
      f(node, target, length);
    };
    graph.for_each_arc(node, labels, Each_arc<decltype(on_arc)>{on_arc});
    labels.discard(node);
  }
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_FOR_EACH_ARC_H
