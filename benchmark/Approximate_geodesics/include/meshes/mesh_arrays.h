// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_MESH_ARRAYS_H
#define BENCHMARK_MESH_ARRAYS_H

#include "meshes/Mesh.h"

#include <CGAL/Approximate_geodesics/Solver/read_soup.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

// A mesh as arrays, of 36 bytes a vertex.
struct Mesh_arrays
{
  std::vector<CGAL::Simple_cartesian<float>::Point_3> points;
  std::vector<CGAL::Approximate_geodesics::Soup_triangle> triangles;

  double memory() const
  {
    return double(points.capacity() * sizeof(points[0]) +
                  triangles.capacity() * sizeof(triangles[0]));
  }
};

// A terrain of waves over a grid with randomly perturbed points, of about this number of vertices.
inline Mesh_arrays wavy_terrain(const std::size_t number_of_vertices)
{
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(double(number_of_vertices))));
  std::minstd_rand random(1);
  std::uniform_real_distribution<float> shift(-0.2f, 0.2f);
  Mesh_arrays result;
  result.points.reserve(side * side);
  result.triangles.reserve(2 * (side - 1) * (side - 1));
  for(std::size_t y = 0; y < side; ++y)
    for(std::size_t x = 0; x < side; ++x)
    {
      const float u = float(x) + shift(random), v = float(y) + shift(random);
      result.points.push_back({u, v, 3 * std::sin(u / 7) * std::cos(v / 9)});
    }
  for(std::size_t y = 0; y + 1 < side; ++y)
    for(std::size_t x = 0; x + 1 < side; ++x)
    {
      const auto a = static_cast<std::uint32_t>(y * side + x);
      const auto b = static_cast<std::uint32_t>(a + side);
      result.triangles.push_back({{a, a + 1, b + 1}});
      result.triangles.push_back({{a, b + 1, b}});
    }
  return result;
}

inline Mesh_arrays arrays_of(const Mesh& mesh)
{
  Mesh_arrays result;
  result.points.reserve(mesh.number_of_vertices());
  result.triangles.reserve(mesh.number_of_faces());
  for(const auto& p : mesh.points())
    result.points.push_back({float(p.x()), float(p.y()), float(p.z())});
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    result.triangles.push_back(
        {{mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()}});
  }
  return result;
}

#endif // BENCHMARK_MESH_ARRAYS_H
