// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Uses the installed headers and the compiled library: the corners of a tetrahedron are as far
// apart as its edges are long.

#include <CGAL/Approximate_geodesics/Matrix_files/Npy_file.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <filesystem>

int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(3, 0, 0), Point(0, 4, 0), Point(0, 0, 12), mesh);

  const auto distances = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  CGAL::approximate_geodesic_distances(mesh, distances, Mesh::Vertex_index(0));

  const double expected[] = {0, 3, 4, 12};
  for(const auto v : mesh.vertices())
    if(distances[v] != expected[v.idx()])
      return EXIT_FAILURE;

  const auto np = CGAL::parameters::concurrency_tag(CGAL::Parallel_if_available_tag());
  using File = CGAL::Approximate_geodesics::Npy_file<double>;
  const char* const name = "distances.npy";
  std::filesystem::remove(name);
  const bool is_complete =
      CGAL::approximate_geodesic_distance_matrix(mesh, File(name), mesh.vertices(), np);
  const bool is_right = is_complete && std::filesystem::file_size(name) == File::length(4, 4);
  std::filesystem::remove(name);
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
