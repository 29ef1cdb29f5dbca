// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXACT_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_EXACT_DISTANCES_H

#include "meshes/test_soup.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <vector>

namespace geodesics_test {

using Exact_shortest_paths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

// The distances along the surface, by CGAL's exact class. The mesh has no isolated vertices.
std::vector<double> exact_distances(const Mesh& mesh, const Vertex source);

} // namespace geodesics_test

extern template class CGAL::Surface_mesh_shortest_path<
    CGAL::Surface_mesh_shortest_path_traits<geodesics_test::Kernel, geodesics_test::Mesh>>;

#endif // APPROXIMATE_GEODESICS_TEST_EXACT_DISTANCES_H
