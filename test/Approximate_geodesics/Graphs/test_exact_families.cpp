// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include "checks/expect_exact_distances.h"
#include "meshes/developed_surfaces.h"
#include "meshes/random_soups.h"
#include "oracles/boxes.h"
#include "oracles/long_double_distances.h"
#include "oracles/polygonal_domain.h"
#include "oracles/straight_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Exact distances where borders and corners decide, by oracles of their own.

namespace {

using namespace geodesics_test;

// ----- borders

std::vector<Polygonal_domain> polygonal_domains()
{
  return {
      {8, 8, {{4, 4, 9, 9}}},                                                // an L
      {15, 8, {{2, -1, 3, 6}, {5, 2, 6, 9}, {8, -1, 9, 7}, {11, 1, 12, 9}}}, // a comb
      {9, 9, {{3, 3, 6, 6}}},                                                // a hole
      {12, 10, {{1, 1, 4, 3}, {6, 2, 8, 8}, {2, 5, 5, 9}, {9, 1, 11, 4}}},   // several
      {13, 13, {{2, 2, 14, 3}, {2, 2, 3, 11}, {2, 10, 11, 11}, {10, 5, 11, 11}, {5, 5, 11, 6}}},
  };
}

TEST(Saddle_vertex_graph, is_exact_around_corners_of_the_border)
{
  Random random(test_seed());
  for(const Polygonal_domain& domain : polygonal_domains())
    for(const double jitter : {0., 0.2})
    {
      SCOPED_TRACE(testing::Message() << domain.columns() << " columns, jitter " << jitter);
      Exactness(surface_of(domain, jitter, random)).expect_all(random, 6);
    }
}

// Paths do not bend where the border is straight or convex, so that no sight starts there. The
// search from a corner finds the lines to all vertices, and no other ones.
TEST(Saddle_vertex_graph, looks_from_no_vertex_of_a_convex_border)
{
  const auto arch = [](const double i, const double j) {
    return Point(i, j * (2 + std::sqrt(1001 - i)), 0); // convex
  };
  for(const Soup& soup : {flat_grid(1000, 2), grid(1000, 2, arch), fan(1000)})
  {
    const Mesh mesh = to_mesh(soup);
    Basic_mesh_search<Saddle_vertex_graph> search(mesh);
    search.search().collect_statistics(true);
    const std::vector<double> found = search.distances({Vertex(1)});
    for(const Vertex v : mesh.vertices())
    {
      const double expected = distance_in_space(mesh.point(Vertex(1)), mesh.point(v));
      EXPECT_NEAR(found[v.idx()], expected, tolerance_of_exact_distances * expected);
    }
    EXPECT_LE(search.search().statistics().relaxations, 2 * mesh.num_vertices());
  }
}

// ----- boxes

TEST(Saddle_vertex_graph, is_exact_on_boxes)
{
  Random random(test_seed());
  for(const Box::Triple& size : {Box::Triple{2, 2, 2}, Box::Triple{3, 3, 3}, Box::Triple{2, 2, 4},
                                 Box::Triple{2, 3, 7}, Box::Triple{2, 9, 9}, Box::Triple{12, 2, 2}})
    for(const double jitter : {0., 0.2})
    {
      SCOPED_TRACE(testing::Message() << size[0] << ' ' << size[1] << ' ' << size[2]);
      Exactness(surface_of(Box(size), jitter, random)).expect_all(random, 5);
    }
}

// ----- any small mesh, in `long double`

void expect_distances_of_oracle(const Mesh& mesh, const std::size_t number_of_sources)
{
  const Long_graph lines = Lines_of_sight(mesh).graph();
  Basic_mesh_search<Saddle_vertex_graph> search(mesh);
  const double rounding = rounding_of_places(search.graph().triangulation());
  for(std::size_t i = 0; i < number_of_sources; ++i)
  {
    const auto step = mesh.num_vertices() / number_of_sources;
    const Vertex s(static_cast<Mesh::size_type>(i * step));
    const std::vector<double> found = search.distances({s});
    const std::vector<Long> expected = lines.distances(s.idx());
    for(const Vertex v : mesh.vertices())
      if(expected[v.idx()] == infinity)
      {
        EXPECT_EQ(found[v.idx()], infinity);
      }
      else
      {
        const auto d = static_cast<double>(expected[v.idx()]);
        EXPECT_NEAR(found[v.idx()], d, tolerance_of_exact_distances * d + rounding)
            << s << " to " << v;
      }
  }
}

TEST(Saddle_vertex_graph, is_exact_on_small_meshes)
{
  for(const std::uint64_t seed : seeds_of_small_soups())
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Soup soup = random_small_soup(seed);
    if(soup.triangles.size() <= 80)
      expect_distances_of_oracle(to_mesh(soup), 6);
  }
}

// Each face in four.
Soup with_midpoints(const Soup& soup)
{
  Soup result{soup.points, {}};
  std::map<std::set<std::size_t>, std::size_t> known;
  const auto middle = [&](const std::size_t a, const std::size_t b) {
    const auto [it, is_new] = known.insert({{a, b}, result.points.size()});
    if(is_new)
      result.points.push_back(CGAL::midpoint(soup.points[a], soup.points[b]));
    return it->second;
  };
  for(const auto& [a, b, c] : soup.triangles)
  {
    const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    result.triangles.insert(result.triangles.end(),
                            {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return result;
}

Soup icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Soup result;
  for(const double u : {-1., 1.})
    for(const double v : {-g, g})
      result.points.insert(result.points.end(), {Point(0, u, v), Point(u, v, 0), Point(v, 0, u)});
  for(std::size_t a = 0; a < 12; ++a)
    for(std::size_t b = a + 1; b < 12; ++b)
      for(std::size_t c = b + 1; c < 12; ++c)
      {
        const auto &p = result.points[a], &q = result.points[b], &r = result.points[c];
        const auto is_edge = [](const Point& x, const Point& y) {
          return CGAL::squared_distance(x, y) < 5;
        };
        if(is_edge(p, q) && is_edge(q, r) && is_edge(r, p))
        {
          if(CGAL::determinant(p - CGAL::ORIGIN, q - CGAL::ORIGIN, r - CGAL::ORIGIN) > 0)
            result.triangles.push_back({a, b, c});
          else
            result.triangles.push_back({a, c, b});
        }
      }
  return result;
}

// There are several shortest paths to most of the vertices on the other side.
TEST(Saddle_vertex_graph, is_exact_on_symmetric_meshes)
{
  for(Soup soup : {octahedron(), icosahedron()})
  {
    expect_distances_of_oracle(to_mesh(soup), 3);
    soup = with_midpoints(soup);
    expect_distances_of_oracle(to_mesh(soup), 3);
  }
  expect_distances_of_oracle(to_mesh(with_midpoints(with_midpoints(octahedron()))), 3);
}

// ----- faces without area, and edges without length, in a plane

// Distances are those in the plane, whatever the faces are.
void expect_distances_in_plane(const Mesh& mesh, Random& random)
{
  Basic_mesh_search<Saddle_vertex_graph> search(mesh);
  const double rounding = rounding_of_places(search.graph().triangulation());
  for(int i = 0; i < 4; ++i)
  {
    const Vertex s = random_vertex(mesh, random);
    const std::vector<double> found = search.distances({s});
    for(const Vertex v : mesh.vertices())
    {
      const auto line =
          static_cast<double>(long_distance(long_point(mesh.point(s)), long_point(mesh.point(v))));
      EXPECT_NEAR(found[v.idx()], line, tolerance_of_exact_distances * line + rounding)
          << s << " to " << v;
    }
  }
}

TEST(Saddle_vertex_graph, is_exact_with_faces_without_area)
{
  Random random(test_seed());
  for(const std::size_t size : {3u, 6u, 14u})
  {
    SCOPED_TRACE(size);
    const auto middle = [] { return 0.5; };
    expect_distances_in_plane(to_mesh(with_caps(flat_grid(size, size), middle)), random);
    expect_distances_in_plane(
        to_mesh(with_caps(flat_grid(size, size + 1), [&] { return random.between(0.1, 0.9); })),
        random);
    for(const auto& [width, height] : {std::pair(2., 1.), std::pair(3., 2.)})
    {
      const auto step = [w = width, h = height](const Point& p) {
        return Point(std::floor(p.x() / w), std::floor(p.y() / h), 0);
      };
      expect_distances_in_plane(to_mesh(flat_grid(size, size).transformed(step)), random);
    }
  }
}

TEST(Saddle_vertex_graph, is_exact_on_fans_of_needles)
{
  Random random(test_seed());
  for(const std::size_t valence : {3u, 100u, 1000u, 3000u})
    expect_distances_in_plane(to_mesh(fan(valence)), random);
}

TEST(Saddle_vertex_graph, is_exact_on_strips_that_grow)
{
  Random random(test_seed());
  expect_distances_in_plane(to_mesh(growing_strip(200, 1e-6, 1e3)), random);
}

} // namespace
