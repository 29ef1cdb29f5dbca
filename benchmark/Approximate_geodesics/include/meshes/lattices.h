// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_LATTICES_H
#define BENCHMARK_LATTICES_H

#include "meshes/Mesh.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>

// Regular meshes, with about `side` times `side` vertices.

inline double half_turn() { return std::acos(-1.); }

// A grid of squares with diagonals; vertex (x, y) is at `place(x, y)`. It is optionally periodic in
// x.
template <typename F>
Mesh lattice(const std::size_t side, F place, const bool is_closed = false)
{
  Mesh mesh;
  for(std::size_t y = 0; y < side; ++y)
    for(std::size_t x = 0; x < side; ++x)
      mesh.add_vertex(place(double(x), double(y)));
  const auto vertex = [&](const std::size_t x, const std::size_t y) {
    return Vertex(Mesh::size_type(y * side + x % side));
  };
  for(std::size_t y = 0; y + 1 < side; ++y)
    for(std::size_t x = 0; x + (is_closed ? 0 : 1) < side; ++x)
    {
      mesh.add_face(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1));
      mesh.add_face(vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1));
    }
  return mesh;
}

inline Mesh flat_lattice(const std::size_t side)
{
  return lattice(side, [](const double x, const double y) { return Mesh::Point(x, y, 0); });
}

inline Mesh wavy_lattice(const std::size_t side)
{
  return lattice(side, [](const double x, const double y) {
    return Mesh::Point(x, y, 3 * std::sin(x / 7) * std::cos(y / 9));
  });
}

// Integer heights in meters at a spacing of ten meters, like elevation data.
inline Mesh height_field(const std::size_t side)
{
  return lattice(side, [](const double x, const double y) {
    const double hills = 40 * std::sin(x / 31) * std::cos(y / 17) + 15 * std::sin(x / 5 + y / 7);
    return Mesh::Point(10 * x, 10 * y, std::round(hills + 3 * std::sin(x * y / 11)));
  });
}

inline Mesh cylinder(const std::size_t side)
{
  const double radius = double(side) / (2 * half_turn());
  const auto place = [&](const double x, const double y) {
    return Mesh::Point(radius * std::cos(x / radius), radius * std::sin(x / radius), y);
  };
  return lattice(side, place, true);
}

// Meridians and parallels, without the poles.
inline Mesh globe(const std::size_t side)
{
  const auto place = [&](const double x, const double y) {
    const double longitude = 2 * half_turn() * x / double(side);
    const double colatitude = half_turn() * (y + 1) / double(side + 1);
    return Mesh::Point(std::sin(colatitude) * std::cos(longitude),
                       std::sin(colatitude) * std::sin(longitude), std::cos(colatitude));
  };
  return lattice(side, place, true);
}

// An octahedron whose faces are subdivided and projected to the sphere.
inline Mesh subdivided_sphere(const std::size_t side)
{
  const int n = int(side / 2); // parts per edge
  Mesh mesh;
  using Place = std::array<int, 3>; // |x| + |y| + |z| = n
  std::map<Place, Vertex> vertices;
  const auto vertex = [&](const int x, const int y, const int z) {
    const auto [found, is_new] = vertices.try_emplace({x, y, z});
    const double radius = std::hypot(double(x), double(y), double(z));
    if(is_new)
      found->second = mesh.add_vertex({x / radius, y / radius, z / radius});
    return found->second;
  };
  for(const int a : {-1, 1})
    for(const int b : {-1, 1})
      for(const int c : {-1, 1})
      {
        const auto corner = [&](const int i, const int j) {
          return vertex(a * i, b * j, c * (n - i - j));
        };
        const auto add_face = [&](const Vertex p, const Vertex q, const Vertex r) {
          a* b* c > 0 ? mesh.add_face(p, q, r) : mesh.add_face(p, r, q);
        };
        for(int i = 0; i < n; ++i)
          for(int j = 0; i + j < n; ++j)
          {
            add_face(corner(i, j), corner(i + 1, j), corner(i, j + 1));
            if(i + j + 1 < n)
              add_face(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
          }
      }
  return mesh;
}

#endif // BENCHMARK_LATTICES_H
