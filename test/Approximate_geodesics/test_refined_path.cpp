// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exact_distances.h"
#include "expect_message.h"
#include "sample_meshes.h"
#include "test_meshes.h"
#include "test_oracles.h"

#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/refined_geodesic_path.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

double length_of(const std::vector<Point>& points)
{
  double result = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    result += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return result;
}

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
      const double length =
          CGAL::refined_geodesic_path(mesh, source, target, std::back_inserter(points));
      const double coarse_length =
          CGAL::approximate_geodesic_path(mesh, source, target, std::back_inserter(coarse),
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
    lengths.push_back(CGAL::refined_geodesic_path(
        mesh, source, target, std::back_inserter(points),
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
  const double found = CGAL::refined_geodesic_path(
      mesh, Vertex(0), Vertex(120), std::back_inserter(points),
      parameters::face_weight_map(boost::make_assoc_property_map(weight)).relative_tolerance(1e-7));
  EXPECT_GE(found, cost(low) * (1 - 1e-12));
  EXPECT_LE(found, cost(low) * (1 + 1e-6));
}

TEST(Refined_path, is_a_point_or_nothing_in_the_extreme)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  std::vector<Point> points;
  const Vertex v(10), isolated(0);
  EXPECT_EQ(CGAL::refined_geodesic_path(mesh, v, v, std::back_inserter(points)), 0);
  EXPECT_EQ(points, std::vector<Point>{mesh.point(v)});
  points.clear();
  EXPECT_EQ(CGAL::refined_geodesic_path(mesh, v, isolated, std::back_inserter(points)), infinity);
  EXPECT_TRUE(points.empty());
}

TEST(Refined_path, needs_a_sensible_tolerance)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  std::vector<Point> points;
  for(const double tolerance : {-1., std::nan("")})
    expect_message<std::invalid_argument>(
        [&] {
          CGAL::refined_geodesic_path(mesh, Vertex(0), Vertex(8), std::back_inserter(points),
                                      parameters::relative_tolerance(tolerance));
        },
        "tolerance");
  EXPECT_TRUE(points.empty());
}

} // namespace
