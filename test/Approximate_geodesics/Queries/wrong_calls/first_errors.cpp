// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is wrong if a macro says so, and then has more errors than one, or lacks a header: see
// `CMakeLists.txt`.

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;

#if defined(WRONG_TRAITS)
using Shortest_paths = AG::Surface_mesh_shortest_path<Traits>; // as CGAL's exact class has it
#else
using Shortest_paths = AG::Surface_mesh_shortest_path<Mesh>;
#endif

void call(const Mesh& mesh, const Mesh::Property_map<Mesh::Vertex_index, double> distances)
{
  Shortest_paths shortest_paths(mesh);
#if defined(WRONG_CHAIN) // which begins with a name of CGAL's
  const auto np = parameters::vertex_point_map(mesh.points()).epsilon(0.1);
#elif defined(WRONG_SIGNS) // without the header
  const auto np = parameters::signed_distances(true);
#else
  const auto np = parameters::epsilon(0.1).vertex_point_map(mesh.points());
#endif
  CGAL::approximate_geodesic_distances(mesh, distances, Mesh::Vertex_index(0), np);
}
