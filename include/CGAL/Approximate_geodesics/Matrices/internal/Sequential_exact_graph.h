// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_SEQUENTIAL_EXACT_GRAPH_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_SEQUENTIAL_EXACT_GRAPH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>

#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// The exact graph with sequential searches, independent of the concurrency tag.
struct Sequential_exact_graph : Saddle_vertex_graph
{
  template <typename NamedParameters>
  Sequential_exact_graph(Intrinsic_triangulation triangulation, const NamedParameters& /* np */)
    : Saddle_vertex_graph(std::move(triangulation))
  {
  }
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_SEQUENTIAL_EXACT_GRAPH_H
