// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_STEINER_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_STEINER_MESHES_H

#include "meshes/for_generated_meshes.h"
#include "meshes/test_weights.h"

#include <gtest/gtest.h>

#include <vector>

namespace geodesics_test {

// Calls `f(mesh, weights, random)` for all kinds of meshes, with weights that are much different,
// some of them zero and some infinite.
template <typename F>
void for_weighted_meshes(F f)
{
  for_generated_meshes([&](const Mesh& mesh, Random& random) {
    f(mesh, random_weights(mesh, random, 0.05, 20, 0.05), random);
  });
}

// For graphs with many points per edge.
inline std::vector<Soup> small_soups(Random& random)
{
  const auto pull = [](const Point& p) { return Point(p.x(), 8 * p.y(), p.z()); };
  return {terrain(6, 5, random),
          terrain(5, 4, random).transformed(pull),
          sphere(6, 4),
          fan(9, 1),
          flat_grid(5, 5),
          growing_strip(12, 1e-2, 1e2),
          random_soup(15, 30, random)};
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_STEINER_MESHES_H
