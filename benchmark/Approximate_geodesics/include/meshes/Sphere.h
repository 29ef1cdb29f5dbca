// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_SPHERE_H
#define BENCHMARK_SPHERE_H

#include "meshes/Mesh.h"

#include <CGAL/boost/graph/generators.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

// The unit sphere as a subdivided icosahedron, with a given number of parts per edge and `10 *
// parts * parts + 2` vertices; 57 parts give 32,492 vertices, the size of standard cortical
// surfaces.
class Sphere_builder
{
public:
  explicit Sphere_builder(const std::size_t parts) : m_parts(parts)
  {
    CGAL::make_icosahedron(m_icosahedron, Kernel::Point_3(CGAL::ORIGIN));
    for(const auto f : m_icosahedron.faces())
      divide(corners(f));
  }

  const Mesh& mesh() const { return m_mesh; }

private:
  using Corners = std::array<Vertex, 3>;

  // Identifies a vertex in all faces of the icosahedron that share it: the weights of their
  // corners.
  using Weights = std::map<Vertex, std::size_t>;

  Corners corners(const Mesh::Face_index f) const
  {
    const auto h = m_icosahedron.halfedge(f);
    return {m_icosahedron.source(h), m_icosahedron.target(h),
            m_icosahedron.target(m_icosahedron.next(h))};
  }

  void divide(const Corners& corners)
  {
    for(std::size_t i = 0; i < m_parts; ++i)
      for(std::size_t j = 0; i + j < m_parts; ++j)
      {
        const Vertex a = vertex(corners, i + 1, j), b = vertex(corners, i, j + 1);
        m_mesh.add_face(vertex(corners, i, j), a, b);
        if(i + j + 1 < m_parts)
          m_mesh.add_face(a, vertex(corners, i + 1, j + 1), b);
      }
  }

  Vertex vertex(const Corners& corners, const std::size_t i, const std::size_t j)
  {
    Weights weights;
    const std::array<std::size_t, 3> numbers = {m_parts - i - j, i, j};
    for(std::size_t k = 0; k < 3; ++k)
      if(numbers[k] > 0)
        weights[corners[k]] = numbers[k];
    const auto known = m_vertices.find(weights);
    if(known != m_vertices.end())
      return known->second;
    Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
    for(const auto& [corner, number] : weights)
      sum += double(number) * (m_icosahedron.point(corner) - CGAL::ORIGIN);
    const Vertex result = m_mesh.add_vertex(CGAL::ORIGIN + sum / std::sqrt(sum.squared_length()));
    return m_vertices[std::move(weights)] = result;
  }

  std::size_t m_parts;
  Mesh m_icosahedron, m_mesh;
  std::map<Weights, Vertex> m_vertices;
};

inline Mesh sphere(const std::size_t parts) { return Sphere_builder(parts).mesh(); }

#endif // BENCHMARK_SPHERE_H
