// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_MESHES_H
#define APPROXIMATE_GEODESICS_TEST_MESHES_H

#include "checks/test_random.h"
#include "meshes/test_soup.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_test {

// Vertex i + j * columns is point(i, j); all diagonals go from (i, j) to (i + 1, j + 1).
template <typename F>
Soup grid(const std::size_t columns, const std::size_t rows, F point)
{
  Soup result;
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
      result.points.push_back(point(static_cast<double>(i), static_cast<double>(j)));
  for(std::size_t j = 0; j + 1 < rows; ++j)
    for(std::size_t i = 0; i + 1 < columns; ++i)
    {
      const std::size_t a = i + j * columns, b = a + columns;
      result.triangles.push_back({a, a + 1, b + 1});
      result.triangles.push_back({a, b + 1, b});
    }
  return result;
}

inline Soup flat_grid(const std::size_t columns, const std::size_t rows)
{
  return grid(columns, rows, [](const double i, const double j) { return Point(i, j, 0); });
}

// One that gives no trouble by itself.
inline Mesh quiet_mesh() { return to_mesh(flat_grid(5, 4)); }

// Random heights, and points moved at random in the plane.
inline Soup terrain(const std::size_t columns, const std::size_t rows, Random& random)
{
  return grid(columns, rows, [&](const double i, const double j) {
    const double x = i + random.between(-0.4, 0.4), y = j + random.between(-0.4, 0.4);
    return Point(x, y, random.between(0, 2));
  });
}

// Needles in a row, from one tip and to another one, with a large face on either side: in a convex
// part of the plane.
inline Soup thin_needles(const std::size_t number, const double angle)
{
  Soup result;
  result.points = {Point(0, 0, 0), Point(2, 0, 0), Point(0.4, -0.8, 0), Point(0.4, 0.8, 0)};
  for(std::size_t i = 0; i <= number; ++i)
  {
    const double direction = (double(i) - 0.5 * double(number)) * angle;
    result.points.emplace_back(std::cos(direction), std::sin(direction), 0);
  }
  const std::size_t first = 4, last = 4 + number;
  result.triangles = {{0, 2, first}, {2, 1, first}, {0, last, 3}, {last, 1, 3}};
  for(std::size_t i = first; i < last; ++i)
  {
    result.triangles.push_back({0, i, i + 1});
    result.triangles.push_back({i, 1, i + 1});
  }
  return result;
}

// A face with two such angles and a large one, between large faces.
inline Soup thin_cap(const double angle)
{
  Soup result;
  result.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0.45, 0.45 * std::tan(angle), 0),
                   Point(0.5, -0.7, 0), Point(0.6, 0.8, 0)};
  result.triangles = {{0, 1, 2}, {0, 2, 4}, {2, 1, 4}, {1, 0, 3}};
  return result;
}

inline std::vector<Soup> thin_soups(const double angle)
{
  return {thin_needles(3, angle), thin_cap(angle)};
}

// The hub is vertex 0; a cone if it is lifted out of the plane.
inline Soup fan(const std::size_t valence, const double height = 0)
{
  Soup result;
  result.points.push_back(Point(0, 0, height));
  for(std::size_t i = 0; i < valence; ++i)
  {
    const double angle = 8 * std::atan(1.) * static_cast<double>(i) / static_cast<double>(valence);
    result.points.push_back(Point(std::cos(angle), std::sin(angle), 0));
    result.triangles.push_back({0, i + 1, (i + 1) % valence + 1});
  }
  return result;
}

// Meridians and parallels of the unit sphere; the poles come first.
inline Soup sphere(const std::size_t meridians, const std::size_t parallels)
{
  const double pi = 4 * std::atan(1.);
  Soup result{{Point(0, 0, 1), Point(0, 0, -1)}, {}};
  for(std::size_t j = 0; j < parallels; ++j)
    for(std::size_t i = 0; i < meridians; ++i)
    {
      const double t = pi * static_cast<double>(j + 1) / static_cast<double>(parallels + 1);
      const double s = 2 * pi * static_cast<double>(i) / static_cast<double>(meridians);
      result.points.push_back(
          Point(std::sin(t) * std::cos(s), std::sin(t) * std::sin(s), std::cos(t)));
    }
  for(std::size_t i = 0; i < meridians; ++i)
  {
    const std::size_t a = 2 + i, b = 2 + (i + 1) % meridians;
    const std::size_t last = (parallels - 1) * meridians;
    result.triangles.push_back({0, a, b});
    result.triangles.push_back({1, b + last, a + last});
    for(std::size_t shift = 0; shift < last; shift += meridians)
    {
      result.triangles.push_back({a + shift, a + shift + meridians, b + shift});
      result.triangles.push_back({b + shift, a + shift + meridians, b + shift + meridians});
    }
  }
  return result;
}

// Two pyramids with a common base.
inline Soup octahedron()
{
  return {{Point(1, 0, 0), Point(0, 1, 0), Point(-1, 0, 0), Point(0, -1, 0), Point(0, 0, 1),
           Point(0, 0, -1)},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}

// A strip whose cells grow by a constant factor, from `shortest` to `longest`.
inline Soup growing_strip(const std::size_t cells, const double shortest, const double longest)
{
  const double factor = std::pow(longest / shortest, 1 / static_cast<double>(cells));
  std::vector<Point> lower;
  double x = 0, step = shortest;
  for(std::size_t i = 0; i <= cells; ++i, x += step, step *= factor)
    lower.push_back(Point(x, 0, step));
  return grid(cells + 1, 2, [&](const double i, const double j) {
    const Point& p = lower[static_cast<std::size_t>(i)];
    return Point(p.x(), j * p.z(), 0);
  });
}

// Puts a vertex on one edge of every other triangle, and a face without area between the two parts
// of the edge and the whole of it.
template <typename F>
Soup with_caps(Soup soup, F part)
{
  const std::size_t number_of_triangles = soup.triangles.size();
  for(std::size_t i = 0; i < number_of_triangles; i += 2)
  {
    const auto [a, b, c] = soup.triangles[i];
    const std::size_t m = soup.points.size();
    soup.points.push_back(CGAL::barycenter(soup.points[a], part(), //
                                           soup.points[b]));
    soup.triangles[i] = {a, m, c};
    soup.triangles.push_back({m, b, c});
    soup.triangles.push_back({b, m, a});
  }
  return soup;
}

// Triangles between random points; most points are in many of them, and most edges at a border.
inline Soup random_soup(const std::size_t points, const std::size_t triangles, Random& random)
{
  Soup result;
  for(std::size_t i = 0; i < points; ++i)
  {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    result.points.push_back(Point(x, y, random.between(-1, 1)));
  }
  std::set<std::set<std::size_t>> known;
  while(known.size() < triangles)
  {
    const std::size_t a = random.below(points), b = random.below(points), c = random.below(points);
    if(a != b && b != c && c != a && known.insert({a, b, c}).second)
      result.triangles.push_back({a, b, c});
  }
  CGAL::Polygon_mesh_processing::orient_polygon_soup(result.points, result.triangles);
  return result;
}

// Isolated vertices, some at the same place, and two components that do not touch.
inline Soup scattered_parts(Random& random)
{
  Soup result{{Point(5, 5, 5), Point(5, 5, 5)}, {}};
  result.append(terrain(12, 9, random));
  result.append(fan(7, 1));
  result.points.push_back(Point(-1, -1, -1));
  return result;
}

// Two vertices, joined by `strands` parallel edges, and between two of these in each case a vertex
// of degree two: a closed mesh, by hand since it has no description as a soup. With one strand it
// is a sphere of two triangles.
inline Mesh necklace(const std::size_t strands)
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, -1)), b = mesh.add_vertex(Point(0, 0, 1));
  std::vector<Halfedge> strand; // from a to b
  for(std::size_t i = 0; i < strands; ++i)
    strand.push_back(mesh.add_edge(a, b));
  const auto add_face = [&](const std::array<Halfedge, 3>& h) {
    const Face f = mesh.add_face();
    mesh.set_halfedge(f, h[0]);
    for(std::size_t i = 0; i < 3; ++i)
    {
      mesh.set_face(h[i], f);
      mesh.set_next(h[i], h[(i + 1) % 3]);
      mesh.set_halfedge(mesh.target(h[i]), h[i]);
    }
  };
  for(std::size_t i = 0; i < strands; ++i)
  {
    const Vertex c = mesh.add_vertex(Point(1 + static_cast<double>(i), 0, 0));
    const Halfedge up = mesh.add_edge(b, c), down = mesh.add_edge(c, a);
    add_face({strand[i], up, down});
    add_face({mesh.opposite(strand[(i + 1) % strands]), mesh.opposite(down), mesh.opposite(up)});
  }
  return mesh;
}

struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

// One of each kind, small enough to be searched many times.
inline std::vector<Named_mesh> generated_meshes(const std::uint64_t seed)
{
  Random random(seed);
  Soup flat_zero = flat_grid(9, 9).transformed(
      [](const Point& p) { return Point(std::floor(p.x() / 3), std::floor(p.y() / 2), 0); });
  std::vector<Named_mesh> result;
  const auto add = [&](const std::string& name, const Soup& soup) {
    result.push_back({name, to_mesh(soup)});
  };
  add("single triangle", {{Point(0, 0, 0), Point(3, 0, 0), Point(0, 4, 0)}, {{0, 1, 2}}});
  add("flat grid", flat_grid(30, 20));
  add("terrain", terrain(40, 30, random));
  add("sphere", sphere(24, 15));
  add("cone", fan(50, 3));
  add("fan", fan(400));
  add("strip from 1e-6 to 1e6", growing_strip(300, 1e-6, 1e6));
  add("strip from 1 to 1e12", growing_strip(300, 1, 1e12));
  add("random soup", random_soup(60, 250, random));
  add("another random soup", random_soup(400, 500, random));
  add("scattered parts", scattered_parts(random));
  add("edges of length zero", flat_zero);
  result.push_back({"two triangles", necklace(1)});
  result.push_back({"parallel edges", necklace(5)});
  return result;
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_MESHES_H
