// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles/exact_distances.h"

#include <limits>

template class CGAL::Surface_mesh_shortest_path<
    CGAL::Surface_mesh_shortest_path_traits<geodesics_test::Kernel, geodesics_test::Mesh>>;

namespace geodesics_test {

// The distances along the surface, by CGAL's exact class. The mesh has no isolated vertices.
std::vector<double> exact_distances(const Mesh& mesh, const Vertex source)
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
