// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_COMPILED_SEARCHES_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_COMPILED_SEARCHES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Queries/internal/query_parameters.h>

#include <vector>

/*
 * The target `Approximate_geodesics::compiled` instantiates what a query does once the mesh is
 * read: these functions, and what they call, know neither the type of the mesh nor the named
 * parameters. A program that links the target does not compile them again.
 */
#ifdef CGAL_APPROXIMATE_GEODESICS_COMPILED
#ifndef CGAL_APPROXIMATE_GEODESICS_INSTANTIATION // empty where the library is compiled
#define CGAL_APPROXIMATE_GEODESICS_INSTANTIATION extern
#endif

#define CGAL_APPROXIMATE_GEODESICS_SEARCH(GRAPH)                                                   \
  CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class Surface_search<GRAPH>;                   \
  CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template void Surface_search<GRAPH>::run(               \
      std::vector<Source_point>, const Stop_rule&, Geodesic_visitor_base&);

#define CGAL_APPROXIMATE_GEODESICS_GRAPH(GRAPH)                                                    \
  CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template GRAPH                                          \
  internal::graph_with_epsilon<GRAPH, Sequential_tag>(Intrinsic_triangulation, double);

namespace CGAL::Approximate_geodesics {

CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template internal::Edge_lengths
internal::straight_lengths(Mesh_points, const Intrinsic_triangulation&, const Loop&);
CGAL_APPROXIMATE_GEODESICS_GRAPH(Lazy_discrete_geodesic_graph)
CGAL_APPROXIMATE_GEODESICS_GRAPH(Saddle_vertex_graph)
CGAL_APPROXIMATE_GEODESICS_SEARCH(Edge_graph)
CGAL_APPROXIMATE_GEODESICS_SEARCH(Lazy_discrete_geodesic_graph)
CGAL_APPROXIMATE_GEODESICS_SEARCH(Saddle_vertex_graph)

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_COMPILED

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_COMPILED_SEARCHES_H
