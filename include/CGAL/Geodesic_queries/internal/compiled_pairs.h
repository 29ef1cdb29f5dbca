// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEODESIC_QUERIES_INTERNAL_COMPILED_PAIRS_H
#define CGAL_GEODESIC_QUERIES_INTERNAL_COMPILED_PAIRS_H

#include <CGAL/license/Geodesic_queries.h>

#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/internal/compiled_matrices.h>

// What programs can compile once for pairs that landmarks guide, as `compiled_searches.h` does for
// searches.
#ifdef CGAL_APPROXIMATE_GEODESICS_COMPILED

namespace CGAL::Approximate_geodesics {

CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class Guided_search<Edge_graph>;
CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class Guided_search<Discrete_geodesic_graph>;
CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class Guided_search<Saddle_vertex_graph>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_COMPILED

#endif // CGAL_GEODESIC_QUERIES_INTERNAL_COMPILED_PAIRS_H
