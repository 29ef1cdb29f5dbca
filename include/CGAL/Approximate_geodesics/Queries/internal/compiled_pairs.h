// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_COMPILED_PAIRS_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_COMPILED_PAIRS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Paths/Guided_search.h>
#include <CGAL/Approximate_geodesics/Queries/internal/compiled_matrices.h>

// What programs can compile once for pairs that landmarks guide, as `compiled_searches.h` does for
// searches.
#ifdef CGAL_APPROXIMATE_GEODESICS_COMPILED

namespace CGAL::Approximate_geodesics {

CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class Guided_search<Edge_graph>;
CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class Guided_search<Discrete_geodesic_graph>;
CGAL_APPROXIMATE_GEODESICS_INSTANTIATION template class Guided_search<Saddle_vertex_graph>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_COMPILED

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_COMPILED_PAIRS_H
