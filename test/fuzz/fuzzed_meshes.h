// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_FUZZED_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_FUZZED_MESHES_H

#include "Fuzzed_data.h"
#include "meshes/test_meshes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <array>
#include <cstddef>
#include <set>

namespace geodesics_test {

using Size = Mesh::size_type;

inline Size size_below(Fuzzed_data& data, const std::size_t size)
{
  return static_cast<Size>(data.below(size));
}

inline Point fuzzed_point(Fuzzed_data& data)
{
  const double x = data.number(), y = data.number();
  return Point(x, y, data.number());
}

// A mesh in which everything points anywhere: to elements that exist, and no more can be said.
inline Mesh mesh_of_arrays(Fuzzed_data& data)
{
  Mesh mesh;
  const Size v = 1 + size_below(data, 8), e = 1 + size_below(data, 16), f = size_below(data, 8);
  for(Size i = 0; i < v; ++i)
    mesh.add_vertex(fuzzed_point(data));
  for(Size i = 0; i < e; ++i)
    mesh.add_edge();
  for(Size i = 0; i < f; ++i)
    mesh.add_face();
  const auto any_halfedge = [&] { return Halfedge(size_below(data, 2 * e)); };
  for(Size i = 0; i < 2 * e; ++i)
  {
    mesh.set_target(Halfedge(i), Vertex(size_below(data, v)));
    mesh.set_next(Halfedge(i), any_halfedge());
    const Size face = size_below(data, f + 1);
    mesh.set_face(Halfedge(i), face == f ? Mesh::null_face() : Face(face));
  }
  for(Size i = 0; i < v; ++i)
    mesh.set_halfedge(Vertex(i), any_halfedge());
  for(Size i = 0; i < f; ++i)
    mesh.set_halfedge(Face(i), any_halfedge());
  return mesh;
}

// A mesh of triangles between any points, without those that would make it no mesh.
inline Mesh mesh_of_triangles(Fuzzed_data& data)
{
  Mesh mesh;
  const Size v = 1 + size_below(data, 12);
  for(Size i = 0; i < v; ++i)
    mesh.add_vertex(fuzzed_point(data));
  const std::size_t number_of_triangles = data.below(24);
  for(std::size_t i = 0; i < number_of_triangles; ++i)
  {
    const Vertex a(size_below(data, v)), b(size_below(data, v)), c(size_below(data, v));
    if(a != b && b != c && c != a)
      mesh.add_face(a, b, c); // which refuses what does not fit
  }
  return mesh;
}

// A grid of triangles, whose points and connections were then tampered with here and there.
inline Mesh mesh_with_flaws(Fuzzed_data& data)
{
  const std::size_t columns = 2 + data.below(4), rows = 2 + data.below(4);
  Soup soup =
      grid(columns, rows, [&](const double i, const double j) { return Point(i, j, data.part()); });
  for(std::size_t moves = data.below(8); moves > 0; --moves)
  {
    Point& p = soup.points[data.below(soup.points.size())];
    p = data.coin() ? fuzzed_point(data) : soup.points[data.below(soup.points.size())];
  }
  Mesh mesh = to_mesh(soup);
  const auto any_halfedge = [&] { return Halfedge(size_below(data, mesh.num_halfedges())); };
  for(std::size_t edits = data.byte() < 128 ? 0 : data.below(4); edits > 0; --edits)
    switch(data.below(4))
    {
    case 0:
      mesh.set_next(any_halfedge(), any_halfedge());
      break;
    case 1:
      mesh.set_target(any_halfedge(), Vertex(size_below(data, mesh.num_vertices())));
      break;
    case 2:
      mesh.set_face(any_halfedge(), Mesh::null_face());
      break;
    default:
      mesh.set_halfedge(Vertex(size_below(data, mesh.num_vertices())), any_halfedge());
    }
  return mesh;
}

inline Mesh fuzzed_mesh(Fuzzed_data& data)
{
  switch(data.below(3))
  {
  case 0:
    return mesh_with_flaws(data);
  case 1:
    return mesh_of_triangles(data);
  default:
    return mesh_of_arrays(data);
  }
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_FUZZED_MESHES_H
