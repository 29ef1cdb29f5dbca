// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXACT_DISTANCES_H
#define APPROXIMATE_GEODESICS_TEST_EXACT_DISTANCES_H

#include "meshes/test_soup.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <limits>
#include <vector>

namespace geodesics_test {

using Exact_shortest_paths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

// The distances along the surface, by CGAL's exact class. The mesh has no isolated vertices.
inline std::vector<double> exact_distances(const Mesh& mesh, const Vertex source)
{
  Exact_shortest_paths paths(mesh);
  paths.add_source_point(source);
  std::vector<double> result(mesh.num_vertices(), std::numeric_limits<double>::infinity());
  for(const Vertex v : mesh.vertices())
  {
    const double distance = paths.shortest_distance_to_source_points(v).first;
    if(distance >= 0)
      result[v.idx()] = distance;
  }
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXACT_DISTANCES_H
