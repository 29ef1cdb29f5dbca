// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_RANDOM_SOUPS_H
#define APPROXIMATE_GEODESICS_TEST_RANDOM_SOUPS_H

#include "meshes/surface_points.h"
#include "meshes/test_meshes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesics_test {

// Without some of its triangles, and with vertices doubled where that leaves them not manifold.
inline Soup with_holes(Soup soup, const double share, Random& random)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const auto& t : soup.triangles)
    if(random.between(0, 1) >= share)
      triangles.push_back(t);
  soup.triangles = triangles;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.triangles);
  return soup;
}

// Heights are integers, so that many paths are equally long.
inline Soup integer_terrain(const std::size_t columns, const std::size_t rows, Random& random)
{
  return grid(columns, rows, [&](const double i, const double j) {
    return Point(i, j, static_cast<double>(random.below(3)));
  });
}

// Some edges have no length, and some faces no area.
inline Soup terrain_with_steps(const std::size_t columns, const std::size_t rows, Random& random)
{
  Soup result = terrain(columns, rows, random);
  for(Point& p : result.points)
    p = Point(std::floor(p.x() / 2), std::floor(p.y()), std::floor(p.z()));
  return result;
}

constexpr std::size_t number_of_kinds_of_soups = 10;

// A small one, of the kind that the seed says.
inline Soup random_small_soup(const std::uint64_t seed)
{
  Random random(seed);
  switch(seed % number_of_kinds_of_soups)
  {
  case 0:
    return terrain(7, 6, random);
  case 1:
    return random_soup(14, 40, random);
  case 2:
    return random_soup(40, 60, random);
  case 3:
    return sphere(8, 5);
  case 4:
    return growing_strip(20, 1e-3, 1e3);
  case 5:
    return with_holes(terrain(8, 7, random), 0.3, random);
  case 6:
    return integer_terrain(7, 6, random);
  case 7:
    return terrain_with_steps(7, 6, random);
  case 8:
    return scattered_parts(random);
  default:
    return with_caps(terrain(5, 4, random), [&] { return random.between(0.2, 0.8); });
  }
}

// Three meshes of each kind.
inline std::vector<std::uint64_t> seeds_of_small_soups()
{
  const std::uint64_t first = test_seed();
  std::vector<std::uint64_t> result;
  for(std::uint64_t i = 0; i < 3 * number_of_kinds_of_soups; ++i)
    result.push_back(first + i);
  return result;
}

// A larger one, of the kind that the seed says.
inline Soup random_large_soup(const std::uint64_t seed)
{
  Random random(seed);
  switch(seed % 5)
  {
  case 0:
    return terrain(25, 20, random);
  case 1:
    return sphere(16, 11);
  case 2:
    return growing_strip(200, 1e-6, 1e6);
  case 3:
    return random_soup(80, 250, random);
  default:
    return with_holes(terrain(20, 15, random), 0.2, random);
  }
}

inline std::vector<std::uint64_t> seeds_of_large_soups()
{
  const std::uint64_t first = test_seed();
  return {first, first + 1, first + 2, first + 3, first + 4};
}

// Whether the area of a face is rounding, or little more: its height is the root of that.
inline bool has_flat_faces(const Mesh& mesh)
{
  const auto is_flat = [&](const Face f) {
    const Halfedge h = mesh.halfedge(f);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                &c = mesh.point(mesh.target(mesh.next(h)));
    const double square = CGAL::squared_distance(a, b) + CGAL::squared_distance(b, c);
    return CGAL::squared_area(a, b, c) <= 1e-24 * square * square;
  };
  return std::any_of(mesh.faces_begin(), mesh.faces_end(), is_flat);
}

// ----- edges of length zero

// Vertices of a mesh move to where others are; faces stay.
class Vertex_merger
{
public:
  Vertex_merger(Mesh& mesh, Random& random) : m_mesh(mesh), m_random(random) {}

  // the ends of an edge
  void merge_edge() { merge_chain(1); }

  // the vertices along some edges
  void merge_chain(const std::size_t number_of_edges)
  {
    Halfedge h = random_halfedge(m_mesh, m_random);
    for(std::size_t i = 0; i < number_of_edges; ++i)
    {
      m_mesh.point(m_mesh.target(h)) = m_mesh.point(m_mesh.source(h));
      h = m_mesh.next(h);
      for(std::size_t turns = m_random.below(4); turns > 0; --turns)
        h = m_mesh.next(m_mesh.opposite(h));
    }
  }

  // the corners of a face
  void merge_face()
  {
    const Halfedge h = random_halfedge(m_mesh, m_random);
    m_mesh.point(m_mesh.target(h)) = m_mesh.point(m_mesh.source(h));
    m_mesh.point(m_mesh.target(m_mesh.next(h))) = m_mesh.point(m_mesh.source(h));
  }

  // a vertex and its neighbors
  void merge_star()
  {
    const Halfedge h = random_halfedge(m_mesh, m_random);
    for(const Vertex v : m_mesh.vertices_around_target(h))
      m_mesh.point(v) = m_mesh.point(m_mesh.target(h));
  }

  // two vertices that need not have an edge
  void merge_any()
  {
    const Vertex v = random_vertex(m_mesh, m_random);
    m_mesh.point(v) = m_mesh.point(random_vertex(m_mesh, m_random));
  }

private:
  Mesh& m_mesh;
  Random& m_random;
};

inline Mesh with_coincident_vertices(Mesh mesh, const std::size_t number, Random& random)
{
  Vertex_merger merger(mesh, random);
  for(std::size_t i = 0; i < number; ++i)
    switch(random.below(8))
    {
    case 0:
      merger.merge_chain(2 + random.below(3));
      break;
    case 1:
      merger.merge_face();
      break;
    case 2:
      merger.merge_star();
      break;
    case 3:
      merger.merge_any();
      break;
    default:
      merger.merge_edge();
    }
  return mesh;
}

// Vertices are off by up to a part of the mesh's size: what was degenerate is so but for rounding.
inline Mesh with_moved_vertices(Mesh mesh, const double part, Random& random)
{
  const double by = part * size(mesh);
  for(const Vertex v : mesh.vertices())
  {
    const double x = random.between(-by, by), y = random.between(-by, by);
    mesh.point(v) += Kernel::Vector_3(x, y, random.between(-by, by));
  }
  return mesh;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_RANDOM_SOUPS_H
