// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_WAVY_TORUS_H
#define BENCHMARK_WAVY_TORUS_H

#include "meshes/Mesh.h"

#include <cmath>
#include <cstddef>

// A smooth torus with waves, without symmetries. It has about `side * side` vertices and faces of
// about equal size. A larger `side` gives a finer mesh of the same surface.
inline Mesh wavy_torus(const std::size_t side)
{
  constexpr double longer = 1.5; // ratio of vertices along the tube to those around it
  const auto along = static_cast<std::size_t>(double(side) * std::sqrt(longer));
  const auto around = static_cast<std::size_t>(double(side) / std::sqrt(longer));
  const double full_turn = 4 * std::acos(0.);
  Mesh mesh;
  const auto vertices = Mesh::size_type(along * around);
  mesh.reserve(vertices, 3 * vertices, 2 * vertices);
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j)
    {
      const double u = full_turn * double(i) / double(along);
      const double v = full_turn * double(j) / double(around);
      const double tube = 0.5 + 0.06 * std::sin(2 * u + v) + 0.04 * std::sin(3 * v - u);
      const double radius = 1 + tube * std::cos(v);
      mesh.add_vertex({radius * std::cos(u), radius * std::sin(u), tube * std::sin(v)});
    }
  const auto vertex = [&](const std::size_t i, const std::size_t j) {
    return Vertex(Mesh::size_type(i % along * around + j % around));
  };
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

#endif // BENCHMARK_WAVY_TORUS_H
