// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_SURFACES_H
#define BENCHMARK_SURFACES_H

#include "meshes/Mesh.h"
#include "meshes/lattices.h"

#include <cmath>
#include <cstddef>
#include <random>

// Surfaces unlike scans, with about `side` times `side` vertices.

// between -1 and 1
inline double random_sign(std::mt19937_64& random)
{
  return 2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1;
}

// A plane with random vertices, and noise in height of 1e-4 edge lengths.
inline Mesh nearly_flat(const std::size_t side)
{
  std::mt19937_64 random(1);
  return lattice(side, [&](const double x, const double y) {
    constexpr double jitter = 0.3, height = 1e-4;
    const double i = x + jitter * random_sign(random), j = y + jitter * random_sign(random);
    return Mesh::Point(i, j, height * random_sign(random));
  });
}

// Of `subdivided_sphere()`, on average.
inline double edge_of_sphere(const std::size_t side) { return half_turn() / double(side); }

// A sphere with irregular faces.
inline Mesh jittered_sphere(const std::size_t side)
{
  std::mt19937_64 random(1);
  Mesh result = subdivided_sphere(side);
  for(const Vertex v : result.vertices())
  {
    const double jitter = 0.3 * edge_of_sphere(side);
    const double x = random_sign(random), y = random_sign(random), z = random_sign(random);
    const Kernel::Vector_3 p = result.point(v) - CGAL::ORIGIN + jitter * Kernel::Vector_3(x, y, z);
    result.point(v) = CGAL::ORIGIN + p / std::sqrt(p.squared_length());
  }
  return result;
}

// A sphere with scanner noise of half an edge length.
inline Mesh noisy_sphere(const std::size_t side)
{
  std::mt19937_64 random(1);
  Mesh result = subdivided_sphere(side);
  for(const Vertex v : result.vertices())
  {
    const double radius = 1 + edge_of_sphere(side) / 2 * random_sign(random);
    const Mesh::Point p = result.point(v);
    result.point(v) = Mesh::Point(radius * p.x(), radius * p.y(), radius * p.z());
  }
  return result;
}

// A regular mesh over a square, with the tip at a vertex.
inline Mesh cone(const std::size_t side)
{
  const double middle = double(side / 2);
  return lattice(side, [&](const double x, const double y) {
    return Mesh::Point(x, y, -std::hypot(x - middle, y - middle));
  });
}

// An open box with an aspect ratio of 100, and faces with an aspect ratio of 25.
inline Mesh long_box(const std::size_t side)
{
  const double quarter = double(side) / 4;
  const auto place = [&](const double x, const double y) {
    const double part = x / quarter - std::floor(x / quarter);
    const int wall = int(x / quarter);
    return Mesh::Point(wall == 0   ? part
                       : wall == 1 ? 1
                       : wall == 2 ? 1 - part
                                   : 0,
                       wall == 0   ? 0
                       : wall == 1 ? part
                       : wall == 2 ? 1
                                   : 1 - part,
                       100 * y / double(side));
  };
  return lattice(side, place, true);
}

#endif // BENCHMARK_SURFACES_H
