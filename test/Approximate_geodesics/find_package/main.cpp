// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Uses the installed headers: the corners of a tetrahedron are as far apart as its edges are long.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>

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
  return EXIT_SUCCESS;
}
