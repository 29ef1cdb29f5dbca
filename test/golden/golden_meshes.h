// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_GOLDEN_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_GOLDEN_MESHES_H

#include "Hash.h"
#include "meshes/random_soups.h"
#include "meshes/sample_meshes.h"
#include "meshes/test_meshes.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace geodesics_test {

// A scan, mechanical parts, several components, boundaries, and faces without area.
inline std::vector<Named_mesh> golden_samples()
{
  std::vector<Named_mesh> result;
  for(const std::string name :
      {"ALSTOM_TEST4", "anchor", "blobby_3cc", "cactus", "cube-meshed", "degtri_sliding",
       "elephant", "hand", "mesh_with_border", "patch-20", "pinion_small", "plane"})
  {
    result.push_back({name, sample_mesh(name + ".off")});
    if(result.back().mesh.is_empty())
      throw std::runtime_error("the sample mesh " + name + " cannot be read");
  }
  return result;
}

inline std::vector<Named_mesh> golden_meshes()
{
  Random random(1);
  std::vector<Named_mesh> result = golden_samples();
  const auto add = [&](const std::string& name, const Soup& soup) {
    result.push_back({name, to_mesh(soup)});
  };
  add("single triangle", {{Point(0, 0, 0), Point(3, 0, 0), Point(0, 4, 0)}, {{0, 1, 2}}});
  add("flat grid", flat_grid(18, 13));
  add("terrain", terrain(20, 15, random));
  add("sphere", sphere(16, 11));
  add("random soup", random_soup(40, 90, random));
  add("scattered parts", scattered_parts(random));
  add("faces without area", with_caps(flat_grid(8, 7), [] { return 0.5; }));
  add("terrain with steps", terrain_with_steps(12, 10, random));
  return result;
}

inline Hash hash(const Mesh& mesh)
{
  Hash result;
  for(const Vertex v : mesh.vertices())
    result.add(mesh.point(v));
  for(const Halfedge h : mesh.halfedges())
  {
    result.add(mesh.target(h));
    result.add(mesh.next(h));
    result.add(mesh.face(h));
  }
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_GOLDEN_MESHES_H
