// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_NEEDLES_H
#define BENCHMARK_NEEDLES_H

#include "meshes/Mesh.h"
#include "meshes/lattices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

// Meshes of faces that are far longer than wide.

// Columns around a cylinder of radius 1, whose faces are `aspect` times as high as wide, with
// vertices moved by up to `jitter` times the shorter of both.
inline Mesh tube(const std::size_t columns,
                 const std::size_t rows,
                 const double aspect,
                 const double jitter = 0)
{
  const double width = 2 * half_turn() / double(columns);
  const double step = jitter * width * (std::min)(1., aspect);
  std::mt19937_64 random(1);
  const auto moved = [&](const double x) {
    return x + step * (2 * double(random() >> 11) / double(1ull << 53) - 1);
  };
  Mesh mesh;
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const double x = moved(std::cos(double(i) * width));
      const double y = moved(std::sin(double(i) * width));
      mesh.add_vertex(Mesh::Point(x, y, moved(double(j) * width * aspect)));
    }
  for(std::size_t j = 0; j + 1 < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const auto vertex = [&](const std::size_t x, const std::size_t y) {
        return Vertex(Mesh::size_type((j + y) * columns + (i + x) % columns));
      };
      mesh.add_face(vertex(0, 0), vertex(1, 0), vertex(1, 1));
      mesh.add_face(vertex(0, 0), vertex(1, 1), vertex(0, 1));
    }
  return mesh;
}

// A prism that is closed by fans; as a gear, if `depth` is that of teeth.
inline Mesh extruded(const std::size_t sides, const double height, const double depth)
{
  Mesh mesh = tube(sides, 2, 1);
  for(const Vertex v : mesh.vertices())
  {
    const Mesh::Point p = mesh.point(v);
    const double radius = v.idx() % sides / 10 % 2 == 0 ? 1 : 1 + depth;
    mesh.point(v) = Mesh::Point(radius * p.x(), radius * p.y(), v.idx() < sides ? 0 : height);
  }
  const Vertex bottom = mesh.add_vertex(Mesh::Point(0, 0, 0));
  const Vertex top = mesh.add_vertex(Mesh::Point(0, 0, height));
  for(std::size_t i = 0; i < sides; ++i)
  {
    const Mesh::size_type a = Mesh::size_type(i), b = Mesh::size_type((i + 1) % sides);
    const Mesh::size_type n = Mesh::size_type(sides);
    mesh.add_face(Vertex(b), Vertex(a), bottom);
    mesh.add_face(Vertex(a + n), Vertex(b + n), top);
  }
  return mesh;
}

// A band around an axis, with vertices on both sides only.
inline Mesh helix(const std::size_t columns)
{
  Mesh mesh;
  for(std::size_t i = 0; i < columns; ++i)
    for(const double radius : {0.5, 1.})
    {
      const double angle = 0.01 * double(i);
      mesh.add_vertex(Mesh::Point(radius * std::cos(angle), radius * std::sin(angle), 0.1 * angle));
    }
  for(Mesh::size_type i = 0; i + 3 < mesh.number_of_vertices(); i += 2)
  {
    mesh.add_face(Vertex(i), Vertex(i + 2), Vertex(i + 3));
    mesh.add_face(Vertex(i), Vertex(i + 3), Vertex(i + 1));
  }
  return mesh;
}

#endif // BENCHMARK_NEEDLES_H
