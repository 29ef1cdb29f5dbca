// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_SURFACE_SUBJECTS_H
#define APPROXIMATE_GEODESICS_TEST_SURFACE_SUBJECTS_H

#include "meshes/sample_meshes.h"
#include "meshes/test_meshes.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_test {

// The meshes that points are taken from.
struct Subject
{
  std::string name;
  Mesh mesh;
  bool has_exact_distances; // the exact class can do without isolated vertices and empty faces
};

inline std::vector<Subject> generated_subjects()
{
  std::vector<Subject> result;
  for(Named_mesh& named : generated_meshes(test_seed()))
  {
    const auto is_isolated = [&](const Vertex v) { return named.mesh.is_isolated(v); };
    const auto vertices = named.mesh.vertices();
    const bool is_regular = named.name != "edges of length zero" &&
                            named.name.find("strip") == std::string::npos &&
                            std::none_of(vertices.begin(), vertices.end(), is_isolated);
    result.push_back({named.name, std::move(named.mesh), is_regular});
  }
  return result;
}

inline std::vector<Subject> sample_subjects()
{
  std::vector<Subject> result;
  for(const char* name :
      {"tetrahedron.off", "icosahedron.off", "cube-meshed.off", "eight.off", "cross.off",
       "mesh_with_border.off", "joint.off", "cactus.off", "plane.off", "pinion_small.off",
       "anchor.off", "part.off", "open_cube.off", "ellipsoid.off", "octahedron.off", "spool.off"})
    result.push_back({name, sample_mesh(name), true});
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_SURFACE_SUBJECTS_H
