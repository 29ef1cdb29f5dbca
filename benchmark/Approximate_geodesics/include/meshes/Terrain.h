// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_TERRAIN_H
#define BENCHMARK_TERRAIN_H

#include "meshes/Mesh.h"

#include <cmath>
#include <cstddef>
#include <random>

// A square of hills over a grid with randomly perturbed points, by up to a third of the spacing;
// perturbations of a fourth and more produce needles. With a grading above 1, the spacing grows as
// a power of the coordinate, so that edge lengths differ by orders of magnitude.
inline Mesh
terrain(const std::size_t side, const double grading = 1, const double largest_shift = 1. / 3)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-largest_shift, largest_shift);
  const double extent = double(side);
  const auto place = [&](const std::size_t i) {
    return extent * std::pow((double(i) + 1 + shift(random)) / extent, grading);
  };
  Mesh mesh;
  mesh.reserve(Mesh::size_type(side * side), Mesh::size_type(3 * side * side),
               Mesh::size_type(2 * side * side));
  for(std::size_t y = 0; y < side; ++y)
    for(std::size_t x = 0; x < side; ++x)
    {
      const double u = place(x), v = place(y);
      mesh.add_vertex({u, v, 20 * std::sin(u / 50) * std::cos(v / 70)});
    }
  const auto vertex = [&](const std::size_t x, const std::size_t y) {
    return Vertex(Mesh::size_type(y * side + x));
  };
  for(std::size_t y = 0; y + 1 < side; ++y)
    for(std::size_t x = 0; x + 1 < side; ++x)
    {
      mesh.add_face(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1));
      mesh.add_face(vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1));
    }
  return mesh;
}

// The terrain with additional random perturbations of heights, by up to a third of the spacing.
inline Mesh rough_terrain(const std::size_t side)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-1. / 3, 1. / 3);
  Mesh result = terrain(side);
  for(const Vertex v : result.vertices())
    result.point(v) = result.point(v) + Kernel::Vector_3(0, 0, shift(random));
  return result;
}

#endif // BENCHMARK_TERRAIN_H
