// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>

#include "checks/parts_of_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Paths that are found in a part of a mesh are those of the mesh.

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;

TEST(Part_of_mesh, has_the_shortest_paths)
{
  for_each_random_pair([&](const Mesh& mesh, const auto& source, const auto& target) {
    const double exact = length_of_path(mesh, source, target, without_part(0));
    const double along_edges = length_of_path(mesh, source, target, parameters::default_values());
    expect_same_length(length_of_path(mesh, source, target, parameters::epsilon(0)), exact, mesh);
    expect_same_length(
        length_of_path(mesh, source, target, parameters::epsilon(0).straighten(true)), exact, mesh);
    for(const double epsilon : {0.02, 0.5})
    {
      const double length = length_of_path(mesh, source, target, parameters::epsilon(epsilon));
      const double straight =
          length_of_path(mesh, source, target, parameters::epsilon(epsilon).straighten(true));
      const double tolerance = rounding_of_lengths * (exact + size(mesh));
      EXPECT_GE(length, exact - tolerance);
      EXPECT_LE(length, (1 + epsilon) * exact + tolerance);
      EXPECT_LE(length, along_edges + tolerance); // so that it ends nowhere but the mesh does
      EXPECT_GE(straight, exact - tolerance);
      EXPECT_LE(straight, length + tolerance);
    }
  });
}

TEST(Part_of_mesh, has_the_shortest_paths_along_edges)
{
  const AG::Geodesic_visitor_base visitor;
  for_each_random_pair([&](const Mesh& mesh, const auto& source, const auto& target) {
    expect_same_length(length_of_path(mesh, source, target, parameters::default_values()),
                       length_of_path(mesh, source, target, parameters::visitor(visitor)), mesh);
  });
}

TEST(Part_of_mesh, has_the_path_from_the_nearest_of_several_sources)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : large_meshes())
  {
    SCOPED_TRACE(name);
    for(int i = 0; i < 8; ++i)
    {
      std::vector<Surface_point> sources = random_surface_points(mesh, 4, random);
      const Surface_point target = random_target(mesh, sources[2], random);
      expect_same_length(length_of_path(mesh, sources, target, parameters::epsilon(0)),
                         length_of_path(mesh, sources, target, without_part(0)), mesh);
    }
  }
}

TEST(Part_of_mesh, ends_at_the_maximum_distance)
{
  for_each_random_pair([&](const Mesh& mesh, const auto& source, const auto& target) {
    const double exact = length_of_path(mesh, source, target, without_part(0));
    for(const double part : {0.5, 0.999, 1.001})
    {
      const auto np = parameters::epsilon(0).maximum_distance(part * exact);
      const bool is_reached = std::isfinite(exact) && (exact == 0 || part > 1);
      expect_same_length(length_of_path(mesh, source, target, np), is_reached ? exact : infinity,
                         mesh);
    }
  });
}

TEST(Part_of_mesh, has_points_that_are_the_same)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : large_meshes())
    for(int i = 0; i < 20; ++i)
    {
      SCOPED_TRACE(name);
      const Surface_point p = random_surface_point(mesh, random);
      for(const double epsilon : {0., 0.1})
        EXPECT_EQ(length_of_path(mesh, p, p, parameters::epsilon(epsilon)), 0);
      EXPECT_EQ(length_of_path(mesh, p, p, parameters::default_values()), 0);
      EXPECT_EQ(length_of_path(mesh, p, p, parameters::maximum_distance(0)), 0);
    }
}

TEST(Part_of_mesh, has_points_in_one_face)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : large_meshes())
    for(int i = 0; i < 20; ++i)
    {
      SCOPED_TRACE(name);
      const Face_location a = random_face_location(mesh, random);
      const Face_location b(a.first, random_face_location(mesh, random).second);
      const double expected =
          std::sqrt(CGAL::squared_distance(position(mesh, a), position(mesh, b)));
      for(const double epsilon : {0., 0.1})
        expect_same_length(length_of_path(mesh, a, b, parameters::epsilon(epsilon)), expected,
                           mesh);
      expect_same_length(length_of_path(mesh, a, b, parameters::default_values()), expected, mesh);
    }
}

TEST(Part_of_mesh, has_no_path_between_components)
{
  Random random(test_seed());
  Soup soup = terrain(40, 30, random);
  const std::size_t small = soup.points.size();
  soup.append(fan(7, 1));
  const std::size_t isolated = soup.points.size();
  soup.points.push_back(Point(3, 3, 3));
  const Mesh mesh = to_mesh(soup);
  const auto v = [](const std::size_t i) { return Vertex(static_cast<Mesh::size_type>(i)); };
  ASSERT_TRUE(part_between(mesh, v(small), v(5), parameters::epsilon(0)));
  ASSERT_TRUE(part_between(mesh, v(isolated), v(5), parameters::epsilon(0)));
  for(const std::size_t a : {std::size_t(5), small, isolated})
    for(const std::size_t b : {std::size_t(5), small, isolated})
    {
      const double expected = a == b ? 0 : infinity;
      EXPECT_EQ(length_of_path(mesh, v(a), v(b), parameters::default_values()), expected);
      EXPECT_EQ(length_of_path(mesh, v(a), v(b), parameters::epsilon(0.1)), expected);
      EXPECT_EQ(length_of_path(mesh, v(a), v(b), parameters::epsilon(0)), expected);
    }
}

// The strip is small enough to be near the straight line as a whole, along which the path is far
// longer.
TEST(Part_of_mesh, has_the_path_in_a_small_component_that_is_folded)
{
  Random random(test_seed());
  Soup soup = terrain(60, 50, random);
  const std::size_t first = soup.points.size(), number_of_folds = 59;
  for(std::size_t i = 0; i <= number_of_folds; ++i)
  {
    const double x = 0.1 * static_cast<double>(i), z = i % 2 == 0 ? 0.5 : -0.5;
    soup.points.emplace_back(x, 100, z);
    soup.points.emplace_back(x, 100.3, z);
  }
  for(std::size_t i = first; i + 2 < soup.points.size(); i += 2)
  {
    soup.triangles.push_back({i, i + 2, i + 1});
    soup.triangles.push_back({i + 1, i + 2, i + 3});
  }
  const Mesh mesh = to_mesh(soup);
  const Vertex s(static_cast<Mesh::size_type>(first)),
      t(static_cast<Mesh::size_type>(soup.points.size() - 2));
  const double expected = number_of_folds * std::sqrt(0.01 + 1);
  ASSERT_TRUE(part_between(mesh, s, t, parameters::epsilon(0)));
  EXPECT_NEAR(length_of_path(mesh, s, t, parameters::default_values()), expected, 1e-9);
  EXPECT_NEAR(length_of_path(mesh, s, t, parameters::epsilon(0.1)), expected, 1e-9);
  EXPECT_NEAR(length_of_path(mesh, s, t, parameters::epsilon(0)), expected, 1e-9);
  EXPECT_EQ(length_of_path(mesh, s, t, parameters::maximum_distance(50)), infinity);
  EXPECT_NEAR(length_of_path(mesh, s, t, parameters::maximum_distance(60)), expected, 1e-9);
}

// Two sheets that have nothing but a corner in common, so that the only way is through it.
TEST(Part_of_mesh, has_paths_through_a_vertex_between_fans)
{
  const std::size_t n = 60;
  Soup soup = flat_grid(n, n);
  const Soup other = soup.transformed([](const Point& p) { return Point(-p.x(), -p.y(), 0); });
  const std::size_t shift = soup.points.size();
  soup.append(other);
  for(auto& t : soup.triangles)
    for(std::size_t& i : t)
      i = i == shift ? 0 : i;
  const Mesh mesh = to_mesh_with_fans(soup);
  const Vertex a(5 + 4 * n), b(static_cast<Mesh::size_type>(shift + 3 + 6 * n));
  ASSERT_TRUE(part_between(mesh, a, b, parameters::epsilon(0)));
  expect_same_length(length_of_path(mesh, a, b, parameters::epsilon(0)),
                     std::hypot(5, 4) + std::hypot(3, 6), mesh);
  EXPECT_LE(length_of_path(mesh, b, a, parameters::epsilon(0.1)),
            1.1 * (std::hypot(5, 4) + std::hypot(3, 6)));
}

} // namespace
