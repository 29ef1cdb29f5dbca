// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/test_meshes.h"
#include "paths/straightened_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Paths that are made locally shortest, where the shortest ones are known.

namespace {

using namespace geodesics_test;

// ----- closed forms

TEST(Path_straightener, finds_straight_lines_in_the_plane)
{
  const std::size_t columns = 13, rows = 11;
  const Surface surface(to_mesh(flat_grid(columns, rows)));
  const Graph graph{surface.triangulation()};
  for(const std::size_t source : {0u, 5u, 70u, 142u})
    for(const Path& path : paths_from(graph, surface.place(source).vertex, 1))
    {
      const Path straight = surface.shortened(path.points);
      const Point p = surface.point(straight.points.front());
      const Point q = surface.point(straight.points.back());
      EXPECT_NEAR(straight.length, norm(q - p), 1e-12 * norm(q - p));
      for(const Intrinsic_point& place : straight.points)
        EXPECT_NEAR(norm(CGAL::cross_product(surface.point(place) - p, q - p)), 0, 1e-9);
      expect_idempotent(surface.triangulation(), straight);
    }
}

Soup tetrahedron()
{
  return {{Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

TEST(Path_straightener, unfolds_cubes)
{
  const Surface surface(to_mesh(cube()));
  EXPECT_NEAR(surface.shortened({0, 1, 2, 6}).length, std::sqrt(5.), 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1, 6}).length, std::sqrt(5.), 1e-12);
  EXPECT_NEAR(surface.shortened({3, 0, 1}).length, std::sqrt(2.), 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1}).length, 1, 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1, 2, 3}).length, 1, 1e-12);
  EXPECT_NEAR(surface.shortened({0, 1, 0, 1}).length, 1, 1e-12); // to and fro
  EXPECT_EQ(surface.shortened({0, 1, 0}).length, 0);
  EXPECT_EQ(surface.shortened({0, 1, 2, 0}).length, 0);
}

// From the middle of a face to that of the face beside it, by way of the third vertex.
TEST(Path_straightener, unfolds_tetrahedra)
{
  const Surface surface(to_mesh(tetrahedron()));
  const double third = 1. / 3;
  const Intrinsic_point p = Intrinsic_point::in_face(surface.halfedge(0, 1), third, third);
  const Intrinsic_point q = Intrinsic_point::in_face(surface.halfedge(0, 2), third, third);
  const double side = std::sqrt(8.), height = side * std::sqrt(3.) / 2;
  for(const std::size_t by : {0u, 2u})
    EXPECT_NEAR(surface.shortened({p, surface.place(by), q}).length, 2 * height / 3, 1e-12);
  // by way of the vertex that is farthest: first along one edge, then over another face
  const Path path = surface.shortened({p, surface.place(1), surface.place(3), q});
  EXPECT_NEAR(path.length, 2 * height / 3, 1e-12);
}

// A path that turns around a vertex more than once, where the angle there is 360 degrees, or less.
TEST(Path_straightener, unwinds_paths_around_a_vertex)
{
  constexpr std::size_t degree = 6;
  for(const double height : {0., 1.})
  {
    Soup soup{{Point(0, 0, height)}, {}};
    for(std::size_t i = 0; i < degree; ++i)
    {
      const double a = 2 * pi * static_cast<double>(i) / degree;
      soup.points.push_back(Point(std::cos(a), std::sin(a), 0));
      soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % degree});
    }
    const Surface surface(to_mesh(soup));
    const double side = std::sqrt(1 + height * height);
    const double corner = 2 * std::asin(0.5 / side); // at the vertex, in a face
    for(const std::size_t number_of_faces : {7u, 8u, 9u, 13u, 14u, 15u, 20u})
      for(const bool is_clockwise : {false, true})
      {
        std::vector<Intrinsic_point> points;
        for(std::size_t i = 0; i <= number_of_faces; ++i)
        {
          const std::size_t j = i % degree;
          points.push_back(Intrinsic_point::on_edge(
              surface.halfedge(0, 1 + (is_clockwise ? (degree - j) % degree : j)), 0.5));
        }
        const std::size_t turn = number_of_faces % degree;
        const double angle = corner * static_cast<double>((std::min)(turn, degree - turn));
        EXPECT_NEAR(surface.shortened(points).length, side * std::sin(angle / 2), 1e-12)
            << number_of_faces << " faces";
      }
  }
}

// The shortest path around a cylinder from a vertex back to it.
TEST(Path_straightener, keeps_loops_that_are_the_whole_path)
{
  constexpr std::size_t size = 8;
  Soup soup;
  for(std::size_t i = 0; i < 3 * size; ++i)
  {
    const double a = 2 * pi * static_cast<double>(i % size) / size;
    soup.points.push_back(Point(std::cos(a), std::sin(a), static_cast<double>(i / size)));
  }
  for(std::size_t i = 0; i < 2 * size; ++i)
  {
    const std::size_t j = i + 1 - (i % size == size - 1 ? size : 0);
    soup.triangles.push_back({i, j, i + size});
    soup.triangles.push_back({j, j + size, i + size});
  }
  const Surface surface(to_mesh(soup));
  std::vector<Intrinsic_point> points;
  for(std::size_t i = 0; i <= size; ++i)
    points.push_back(surface.place(size + i % size));
  const Path path = surface.shortened(points);
  EXPECT_NEAR(path.length, 2 * size * std::sin(pi / size), 1e-12);
  EXPECT_TRUE(path.points.back().is_vertex() &&
              path.points.back().vertex == path.points.front().vertex);
}

TEST(Path_straightener, unrolls_cylinders)
{
  const std::size_t columns = 25, rows = 9;
  const double step = pi / 20, chord = 2 * std::sin(step / 2);
  const Surface surface(to_mesh(grid(columns, rows, [&](const double i, const double j) {
    return Point(std::cos(step * i), std::sin(step * i), 0.1 * j);
  })));
  const Graph graph{surface.triangulation()};
  for(const Path& path : paths_from(graph, surface.place(0).vertex, 1))
  {
    const Path straight = surface.shortened(path.points);
    const std::size_t source = surface.triangulation().index(path.points.front().vertex);
    const auto i = static_cast<double>(source % columns), j = static_cast<double>(source / columns);
    const double expected = std::hypot(chord * i, 0.1 * j);
    EXPECT_NEAR(straight.length, expected, 1e-12 * expected);
  }
}

// A cone of several rings, with the apex 0.
Soup ringed_cone(const std::size_t meridians, const std::size_t rings, const double height)
{
  Soup result{{Point(0, 0, height)}, {}};
  for(std::size_t j = 1; j <= rings; ++j)
    for(std::size_t i = 0; i < meridians; ++i)
    {
      const double r = static_cast<double>(j) / static_cast<double>(rings);
      const double a = 2 * pi * static_cast<double>(i) / static_cast<double>(meridians);
      result.points.push_back(Point(r * std::cos(a), r * std::sin(a), height * (1 - r)));
    }
  for(std::size_t i = 0; i < meridians; ++i)
  {
    std::size_t a = 1 + i, b = 1 + (i + 1) % meridians;
    result.triangles.push_back({0, a, b});
    for(std::size_t j = 1; j < rings; ++j, a += meridians, b += meridians)
    {
      result.triangles.push_back({a, a + meridians, b + meridians});
      result.triangles.push_back({a, b + meridians, b});
    }
  }
  return result;
}

// A path that goes round the apex, for once or more often, gets to one of the two ways that are
// straight in the unrolled cone.
TEST(Path_straightener, unrolls_cones)
{
  const std::size_t meridians = 12, rings = 4;
  const double height = 1.5, slant = std::hypot(1, height) * 3 / 4;
  const Surface surface(to_mesh(ringed_cone(meridians, rings, height)));
  const double chord = 2 * std::sin(pi / meridians) * 3 / 4;
  const double step = 2 * std::asin(chord / 2 / slant);
  const auto length = [&](const std::size_t steps) {
    return 2 * slant * std::sin(static_cast<double>(steps) * step / 2);
  };
  for(std::size_t steps = 1; steps < 4 * meridians; ++steps)
  {
    SCOPED_TRACE(steps);
    std::vector<std::size_t> vertices;
    for(std::size_t i = 0; i <= steps; ++i)
      vertices.push_back(1 + 2 * meridians + i % meridians);
    const double found = surface.shortened(vertices).length;
    const double one = length(steps % meridians), other = length(meridians - steps % meridians);
    EXPECT_LE((std::min)(std::abs(found - one), std::abs(found - other)), 1e-12);
    std::reverse(vertices.begin(), vertices.end());
    EXPECT_NEAR(surface.shortened(vertices).length, found, 1e-12);
  }
}

// ----- borders, saddles

constexpr std::size_t side_of_l = 13, corner_of_l = 6;

// a square without its quarter where both coordinates are above 6
Mesh l_shape()
{
  Soup soup = flat_grid(side_of_l, side_of_l);
  const auto is_outside = [&](const auto& t) {
    const Point center = CGAL::centroid(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    return center.x() > corner_of_l && center.y() > corner_of_l;
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_outside),
                       soup.triangles.end());
  return to_mesh(soup);
}

double length_in_l_shape(const Point& p, const Point& q)
{
  const Point corner(corner_of_l, corner_of_l, 0);
  const Point &low = p.y() < q.y() ? p : q, &high = p.y() < q.y() ? q : p;
  const bool is_around = CGAL::cross_product(high - low, corner - low).z() > 0 &&
                         low.x() > corner.x() && high.y() > corner.y();
  return is_around ? norm(corner - p) + norm(q - corner) : norm(q - p);
}

TEST(Path_straightener, goes_round_the_corners_of_a_border)
{
  const Surface surface(l_shape());
  const Graph graph{surface.triangulation()};
  for(const std::size_t source : {3 + 12 * side_of_l, 12 + 2 * side_of_l, 0 * side_of_l,
                                  12 + 6 * side_of_l, 6 + 12 * side_of_l})
    for(const Path& path : paths_from(graph, surface.place(source).vertex, 1))
    {
      const Path straight = surface.shortened(path.points);
      const double expected = length_in_l_shape(surface.point(straight.points.front()),
                                                surface.point(straight.points.back()));
      EXPECT_NEAR(straight.length, expected, 1e-12 * expected);
    }
}

TEST(Path_straightener, follows_a_border)
{
  const Surface surface(l_shape());
  std::vector<std::size_t> vertices;
  for(std::size_t j = 12; j > corner_of_l; --j)
    vertices.push_back(corner_of_l + j * side_of_l);
  for(std::size_t i = corner_of_l; i <= 12; ++i)
    vertices.push_back(i + corner_of_l * side_of_l);
  const Path path = surface.shortened(vertices);
  EXPECT_NEAR(path.length, 12, 1e-12);
  EXPECT_EQ(path.points.size(), 13u);
}

// A hub whose neighbors are high and low by turns.
TEST(Path_straightener, goes_through_saddles)
{
  Soup soup = fan(12);
  for(std::size_t i = 1; i < soup.points.size(); ++i)
    soup.points[i] = soup.points[i] + Vector(0, 0, i % 2 == 0 ? 0.5 : -0.5);
  const Surface surface(to_mesh(soup));
  const Path through_hub = surface.shortened({1, 0, 7});
  EXPECT_EQ(through_hub.points.size(), 3u);
  EXPECT_NEAR(through_hub.length, 2 * std::sqrt(1.25), 1e-12);
  EXPECT_NEAR(surface.shortened({1, 2, 3, 4, 5, 6, 7}).length, 2 * std::sqrt(1.25), 1e-12);
  EXPECT_LT(surface.shortened({1, 0, 3}).length, 2 * std::sqrt(1.25) - 0.01);
}

} // namespace
