// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_HUBS_H
#define BENCHMARK_HUBS_H

#include "meshes/Mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Meshes with one or two vertices of high degree.

// Connects a closed chain of halfedges to a new vertex by faces. `CGAL::Euler::add_face()` would
// take quadratic time.
inline void add_hub(Mesh& mesh, const std::vector<Mesh::Halfedge_index>& rim, const Mesh::Point& p)
{
  const Vertex hub = mesh.add_vertex(p);
  std::vector<Mesh::Halfedge_index> spokes;
  for(const Mesh::Halfedge_index h : rim)
    spokes.push_back(mesh.add_edge(mesh.source(h), hub));
  mesh.set_halfedge(hub, spokes[0]);
  for(std::size_t i = 0; i < rim.size(); ++i)
  {
    const auto first = mesh.opposite(spokes[i]), last = spokes[(i + 1) % rim.size()];
    const auto face = mesh.add_face();
    mesh.set_halfedge(face, first);
    mesh.set_next(first, rim[i]);
    mesh.set_next(rim[i], last);
    mesh.set_next(last, first);
    for(const auto h : {first, rim[i], last})
      mesh.set_face(h, face);
  }
}

// A ring of vertices; vertex i is at `place(angle, i)`. Halfedges run counterclockwise.
template <typename F>
std::vector<Mesh::Halfedge_index> add_rim(Mesh& mesh, const std::size_t size, F place)
{
  const double step = 2 * std::acos(-1.) / double(size);
  std::vector<Vertex> vertices;
  for(std::size_t i = 0; i < size; ++i)
    vertices.push_back(mesh.add_vertex(place(step * double(i), i)));
  std::vector<Mesh::Halfedge_index> result;
  for(std::size_t i = 0; i < size; ++i)
    result.push_back(mesh.add_edge(vertices[i], vertices[(i + 1) % size]));
  for(std::size_t i = 0; i < size; ++i)
  {
    mesh.set_halfedge(vertices[i], mesh.opposite(result[i]));
    mesh.set_next(mesh.opposite(result[(i + 1) % size]), mesh.opposite(result[i]));
  }
  return result;
}

template <typename F>
Mesh fan(const std::size_t size, const double height, F place)
{
  Mesh mesh;
  add_hub(mesh, add_rim(mesh, size, place), Mesh::Point(0, 0, height));
  return mesh;
}

inline Mesh::Point on_circle(const double angle, const double radius = 1, const double z = 0)
{
  return Mesh::Point(radius * std::cos(angle), radius * std::sin(angle), z);
}

inline Mesh flat_fan(const std::size_t size)
{
  return fan(size, 0, [](const double angle, std::size_t) { return on_circle(angle); });
}

inline Mesh cone(const std::size_t size)
{
  return fan(size, 1, [](const double angle, std::size_t) { return on_circle(angle); });
}

inline Mesh saddle(const std::size_t size)
{
  return fan(size, 0, [](const double angle, std::size_t) {
    return on_circle(angle, 1, 0.7 * std::sin(2 * angle));
  });
}

inline Mesh square_fan(const std::size_t size)
{
  return fan(size, 0, [](const double angle, std::size_t) {
    return on_circle(angle, 1 / (std::max)(std::abs(std::cos(angle)), std::abs(std::sin(angle))));
  });
}

inline Mesh star(const std::size_t size)
{
  return fan(size, 0, [](const double angle, const std::size_t i) {
    return on_circle(angle, i % 2 == 0 ? 1 : 2);
  });
}

inline Mesh two_hubs(const std::size_t size)
{
  Mesh mesh;
  const auto place = [](const double angle, std::size_t) { return on_circle(angle); };
  std::vector<Mesh::Halfedge_index> rim = add_rim(mesh, size, place);
  add_hub(mesh, rim, Mesh::Point(0, 0, 1));
  for(auto& h : rim)
    h = mesh.opposite(h);
  std::reverse(rim.begin(), rim.end());
  add_hub(mesh, rim, Mesh::Point(0, 0, -1));
  return mesh;
}

#endif // BENCHMARK_HUBS_H
