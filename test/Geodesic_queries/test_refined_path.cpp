// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_queries/refined_path.h>

#include "checks/expect_message.h"
#include "meshes/sample_meshes.h"
#include "meshes/test_meshes.h"
#include "oracles/exact_distances.h"
#include "oracles/straight_lines.h"

#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

// Paths across faces that are refined, and what is known of their costs.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST(Refined_path, is_close_to_the_exact_one)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  for(const char* name : {"mesh_with_border.off", "elephant.off"})
  {
    const Mesh mesh = sample_mesh(name);
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> exact = exact_distances(mesh, source);
    for(int i = 0; i < 10; ++i)
    {
      const Vertex target = random_vertex(mesh, random);
      std::vector<Point> points, coarse;
      const double length = AG::refined_path(mesh, std::back_inserter(points), source, target);
      const double coarse_length =
          CGAL::approximate_geodesic_path(mesh, std::back_inserter(coarse), source, target,
                                          parameters::number_of_points_per_edge(3));
      const double d = exact[target.idx()];
      EXPECT_GE(length, d * (1 - 1e-12)) << name;
      EXPECT_LE(length, d * 1.01) << name; // some take another way round than the exact one
      EXPECT_LE(length, coarse_length * (1 + 1e-14)) << name;
      EXPECT_NEAR(length, length_of(points), 1e-12 * length) << name;
      EXPECT_EQ(points.front(), mesh.point(source));
      EXPECT_EQ(points.back(), mesh.point(target));
    }
  }
}

TEST(Refined_path, gets_shorter_with_the_tolerance)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  const Vertex source(0), target(399);
  double last = std::numeric_limits<double>::infinity();
  std::vector<double> lengths;
  for(const double tolerance : {1., 1e-2, 1e-4, 1e-6})
  {
    std::vector<Point> points;
    lengths.push_back(
        AG::refined_path(mesh, std::back_inserter(points), source, target,
                         parameters::relative_tolerance(tolerance).number_of_points_per_edge(1)));
    EXPECT_LE(lengths.back(), last);
    last = lengths.back();
  }
  EXPECT_LT(lengths.back(), lengths.front() * (1 - 1e-4));
}

// Two half planes: by Snell's law, or at least cost over the points of the boundary.
TEST(Refined_path, is_refracted)
{
  const Mesh mesh = to_mesh(flat_grid(11, 11));
  std::map<Face, double> weight;
  for(const Face f : mesh.faces())
  {
    double x = 0;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      x += mesh.point(v).x() / 3;
    weight[f] = x < 5 ? 1 : 4;
  }
  const auto cost = [](const double y) { return std::hypot(5, y) + 4 * std::hypot(5, 10 - y); };
  double low = 0, high = 10;
  for(int i = 0; i < 200; ++i) // a convex function of where the boundary is crossed
  {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if(cost(a) < cost(b))
      high = b;
    else
      low = a;
  }
  std::vector<Point> points;
  const double found = AG::refined_path(
      mesh, std::back_inserter(points), Vertex(0), Vertex(120),
      parameters::face_weight_map(boost::make_assoc_property_map(weight)).relative_tolerance(1e-7));
  EXPECT_GE(found, cost(low) * (1 - 1e-12));
  EXPECT_LE(found, cost(low) * (1 + 1e-6));
}

TEST(Refined_path, tells_an_interval_that_contains_the_exact_distance)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  const Mesh mesh = sample_mesh("elephant.off");
  const Vertex source = random_vertex(mesh, random);
  const std::vector<double> exact = exact_distances(mesh, source);
  for(const double epsilon : {0.5, 0.05})
  {
    const AG::Intrinsic_triangulation triangulation(mesh);
    const AG::Steiner_graph<> graph(triangulation, AG::Geometric_points(epsilon));
    for(int i = 0; i < 5; ++i)
    {
      const Vertex target = random_vertex(mesh, random);
      std::vector<Point> points;
      const auto [lower, length] = AG::refined_path_interval(
          mesh, std::back_inserter(points), source, target, parameters::epsilon(epsilon));
      EXPECT_LE(lower, exact[target.idx()]);
      EXPECT_GE(length, exact[target.idx()] * (1 - 1e-12));
      EXPECT_NEAR(length, length_of(points), 1e-12 * length);
      EXPECT_LE(length, lower * (1 + graph.epsilon()) * (1 + 2e-12)); // infinity if faces are thin
    }
  }
}

// Along the edges of a plane, where the cost is known, and the first path is a cheapest one.
TEST(Refined_path, tells_a_lower_bound_that_follows_from_epsilon)
{
  const Mesh mesh = to_mesh(flat_grid(5, 5));
  std::map<Face, double> weight;
  for(const Face f : mesh.faces())
    weight[f] = 3;
  const auto map = boost::make_assoc_property_map(weight);
  for(const double epsilon : {1., 0.1, 0.01})
  {
    std::vector<Point> points;
    const auto [lower, cost] =
        AG::refined_path_interval(mesh, std::back_inserter(points), Vertex(0), Vertex(4),
                                  parameters::epsilon(epsilon).face_weight_map(map));
    EXPECT_NEAR(cost, 12, 1e-11);
    EXPECT_NEAR(lower, 12 / (1 + epsilon), 1e-10);
  }
}

TEST(Refined_path, tells_an_interval_where_there_is_no_path)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  std::vector<Point> points;
  const auto [lower, length] = AG::refined_path_interval(
      mesh, std::back_inserter(points), Vertex(10), Vertex(0), parameters::epsilon(0.1));
  EXPECT_EQ(lower, infinity);
  EXPECT_EQ(length, infinity);
}

TEST(Refined_path, is_a_point_or_nothing_in_the_extreme)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  std::vector<Point> points;
  const Vertex v(10), isolated(0);
  EXPECT_EQ(AG::refined_path(mesh, std::back_inserter(points), v, v), 0);
  EXPECT_EQ(points, std::vector<Point>{mesh.point(v)});
  points.clear();
  EXPECT_EQ(AG::refined_path(mesh, std::back_inserter(points), v, isolated), infinity);
  EXPECT_TRUE(points.empty());
}

TEST(Refined_path, needs_a_sensible_tolerance)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  std::vector<Point> points;
  for(const double tolerance : {-1., std::nan("")})
    expect_message<std::invalid_argument>(
        [&] {
          AG::refined_path(mesh, std::back_inserter(points), Vertex(0), Vertex(8),
                           parameters::relative_tolerance(tolerance));
        },
        "tolerance");
  EXPECT_TRUE(points.empty());
}

} // namespace
