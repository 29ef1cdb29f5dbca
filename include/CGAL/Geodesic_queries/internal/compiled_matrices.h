// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_COMPILED_MATRICES_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_COMPILED_MATRICES_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_searches.h>
#include <CGAL/Geodesic_queries/internal/distance_matrix.h>

// What programs can compile once for matrices and lists of pairs, as `compiled_searches.h` does for
// searches.
#ifdef CGAL_APPROXIMATE_GEODESICS_COMPILED

namespace CGAL::Approximate_geodesics {

CGAL_APPROXIMATE_GEODESICS_GRAPH(Discrete_geodesic_graph)
CGAL_APPROXIMATE_GEODESICS_SEARCH(Discrete_geodesic_graph)
CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class internal::Row_search<
    Discrete_geodesic_graph>;
CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class internal::Row_search<Saddle_vertex_graph>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_COMPILED

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_COMPILED_MATRICES_H
