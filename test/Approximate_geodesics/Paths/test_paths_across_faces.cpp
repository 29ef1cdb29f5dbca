// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "checks/expect_message.h"
#include "meshes/sample_meshes.h"
#include "meshes/steiner_meshes.h"
#include "oracles/exact_distances.h"
#include "oracles/straight_lines.h"
#include "paths/Path_recorder.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

// Paths that run across faces: that they cost what they say, and that refining them helps.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// ----- through points on edges

// Knows what a path costs.
struct Weighted_path : Path_recorder
{
  // infinity where the path leaves the surface
  double cost() const
  {
    double result = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      double weight = infinity;
      for(const Face f : faces[i])
        if(f != Mesh::null_face() && faces[i - 1].count(f) > 0)
          weight = (std::min)(weight, weights[f.idx()]);
      if(points[i] != points[i - 1])
        result += weight * distance_in_space(points[i - 1], points[i]);
    }
    return result;
  }

  const Weights& weights;
};

TEST(Weighted_paths, cost_what_they_say)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    const std::size_t m = 3;
    using Graph = Steiner_graph<Fixed_number_of_points>;
    AG::Surface_mesh_shortest_path<Mesh, Graph> paths(
        mesh, steiner_graph(mesh, weights, Fixed_number_of_points(m)));
    const Vertex source = random_vertex(mesh, random);
    paths.add_source_point(source);
    for(const Vertex v : mesh.vertices())
    {
      Weighted_path path{{mesh}, weights};
      std::vector<Point> points;
      const double cost = paths.shortest_path_sequence_to_source_points(v, path).first;
      paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
      EXPECT_EQ(points.empty(), cost < 0);
      ASSERT_EQ(points.size(), path.points.size());
      if(points.empty())
        continue;
      EXPECT_EQ(points.front(), mesh.point(v));
      EXPECT_EQ(points.back(), mesh.point(source));
      EXPECT_EQ(points, path.points);
      EXPECT_NEAR(path.cost(), cost, cost * 1e-9) << "to " << v;
    }
    const Vertex target = random_vertex(mesh, random);
    std::vector<Point> points, backward;
    const double cost =
        CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, target,
                                        with_weights(weights).number_of_points_per_edge(m));
    const double expected =
        paths.shortest_path_points_to_source_points(target, std::back_inserter(backward)).first;
    if(expected < 0)
      EXPECT_EQ(cost, infinity);
    else
      EXPECT_NEAR(cost, expected, expected * rounding_of_costs);
    EXPECT_EQ(points.empty(), backward.empty());
    if(!points.empty())
    {
      EXPECT_EQ(points.front(), mesh.point(source));
      EXPECT_EQ(points.back(), mesh.point(target));
    }
  });
}

// Every vertex is told the one that its path comes through last.
TEST(Weighted_paths, lead_from_predecessor_to_vertex)
{
  for_weighted_meshes([](const Mesh& const_mesh, const Weights& weights, Random& random) {
    Mesh mesh = const_mesh;
    auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
    auto predecessor = mesh.add_property_map<Vertex, Vertex>("v:predecessor").first;
    const Vertex source = random_vertex(mesh, random);
    CGAL::approximate_geodesic_distances(
        mesh, distance, source,
        with_weights(weights).predecessor_map(predecessor).number_of_points_per_edge(2));
    Basic_mesh_search<Steiner_graph<Fixed_number_of_points>> search(
        mesh, steiner_graph(mesh, weights, Fixed_number_of_points(2)));
    EXPECT_EQ(predecessor[source], source);
    EXPECT_EQ(distance[source], 0);
    std::size_t number_of_checks = 0;
    for(const Vertex v : mesh.vertices())
    {
      const Vertex p = predecessor[v];
      EXPECT_EQ(p == Mesh::null_vertex(), distance[v] == infinity);
      if(p == Mesh::null_vertex() || v == source)
        continue;
      EXPECT_NE(p, v);
      EXPECT_LE(distance[p], distance[v]);
      if(++number_of_checks % 37 == 1)
      {
        EXPECT_NEAR(distance[p] + search.distances({p})[v], distance[v], distance[v] * 1e-9);
      }
      Vertex root = v;
      for(std::size_t steps = 0; root != source && steps <= mesh.num_vertices(); ++steps)
        root = predecessor[root];
      EXPECT_EQ(root, source);
    }
  });
}

// ----- refined

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
