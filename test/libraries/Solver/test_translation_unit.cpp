// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics.h>

#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics.h> // twice does no harm

// Uses the whole in a second translation unit of the same program.

int distance_of_the_other_translation_unit();

int distance_of_the_other_translation_unit()
{
  using namespace geodesics_test;
  Mesh mesh = to_mesh(flat_grid(3, 3));
  const auto map = mesh.add_property_map<Vertex, double>("distance").first;
  CGAL::approximate_geodesic_distances(mesh, map, Vertex(0), CGAL::parameters::maximum_distance(5));
  CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh> paths(mesh);
  paths.add_source_point(Vertex(0));
  const double again = paths.shortest_distance_to_source_points(Vertex(2)).first;
  return again == map[Vertex(2)] ? static_cast<int>(again) : -1;
}
