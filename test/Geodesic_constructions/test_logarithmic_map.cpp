// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/karcher_mean.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include "checks/expect_message.h"
#include "meshes/hostile_meshes.h"
#include "meshes/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

// The logarithmic map, which is the inverse of walks, and means of points.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Tangent_vector;

// Exact results for one point.
struct Log_field
{
  template <typename Point, typename... NamedParameters>
  Log_field(const Mesh& mesh, const Point& source, const NamedParameters&... np)
    : logs(mesh.num_vertices()), distances(mesh.num_vertices()), before(mesh.num_vertices())
  {
    const auto index = get(boost::vertex_index, mesh);
    const auto map = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), index);
    };
    AG::logarithmic_map(mesh, map(logs), source, np...);
    CGAL::approximate_geodesic_distances(mesh, map(distances), source,
                                         CGAL::parameters::predecessor_map(map(before)).epsilon(0));
  }

  double length(const Vertex v) const { return std::hypot(logs[v].x, logs[v].y); }

  std::vector<Tangent_vector> logs;
  std::vector<double> distances;
  std::vector<Vertex> before;
};

bool passes_vertex(const std::vector<Surface_point>& points)
{
  return std::count_if(points.begin() + 1, points.end() - 1, [](const Surface_point& p) {
           return std::holds_alternative<Vertex>(p);
         }) > 0;
}

// Walks with the logarithms of vertices end there, if shortest paths pass no other vertex. Returns
// how many these are.
template <typename Source>
std::size_t expect_round_trips(const Mesh& mesh, const Source& source)
{
  const Log_field field(mesh, source);
  const AG::Geodesic_tracer tracer(mesh);
  std::size_t result = 0;
  for(const Vertex v : mesh.vertices())
  {
    const double distance = field.distances[v];
    if(std::isinf(distance))
      EXPECT_EQ(field.length(v), distance);
    else
      EXPECT_NEAR(field.length(v), distance, 1e-14 * distance);
    const bool is_direct =
        Surface_point(field.before[v]) == Surface_point(source) || field.before[v] == v;
    if(!is_direct || distance == 0 || std::isinf(distance))
      continue;
    const auto walk = tracer.trace(source, field.logs[v], field.length(v));
    if(passes_vertex(walk.points))
      continue;
    ++result;
    const Point end = position(mesh, walk.points.back());
    EXPECT_LT(std::sqrt(CGAL::squared_distance(end, mesh.point(v))), 1e-9 * size(mesh))
        << v << " at " << distance;
  }
  return result;
}

TEST(LogarithmicMap, is_the_inverse_of_walks)
{
  const std::uint64_t seed = test_seed();
  for(const Named_mesh& named : generated_meshes(seed))
  {
    SCOPED_TRACE(named.name);
    if(named.name == "edges of length zero" || // no direction determines a path
       named.name.rfind("strip", 0) == 0)      // paths as good as along its border
      continue;
    Random random(seed);
    for(int i = 0; i < 4; ++i)
    {
      expect_round_trips(named.mesh, random_vertex(named.mesh, random));
      expect_round_trips(named.mesh, Surface_point(random_face_location(named.mesh, random)));
      expect_round_trips(named.mesh,
                         Surface_point(Edge_location(random_halfedge(named.mesh, random), 0.37)));
    }
  }
}

TEST(LogarithmicMap, is_the_inverse_of_walks_on_sample_meshes)
{
  for(const char* const name : {"bunny00.off", "cactus.off", "eight.off", "anchor.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    Random random(1);
    EXPECT_GT(expect_round_trips(mesh, random_vertex(mesh, random)), mesh.num_vertices() / 100);
  }
}

TEST(LogarithmicMap, of_a_plane_is_the_plane)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(
      grid(12, 9, [&](const double i, const double j) {
        return Point(i + random.between(-0.2, 0.2), j + random.between(-0.2, 0.2), 0);
      }).transformed([](const Point& p) { return Point(p.x() * 1e200, p.y() * 1e200, 0); }));
  const AG::Geodesic_tracer tracer(mesh);
  const Face_location source = random_face_location(mesh, random);
  const Log_field field(mesh, source);
  for(const Vertex v : mesh.vertices())
    if(field.before[v] == v) // the border is not convex
    {
      const auto way = tracer.vector_3(source, field.logs[v]) / 1e200,
                 expected = (mesh.point(v) - position(mesh, source)) / 1e200;
      EXPECT_LT(std::sqrt((way - expected).squared_length()), 1e-12);
    }
}

// All vectors behind a vertex where paths bend have the direction of that vertex.
TEST(LogarithmicMap, starts_as_the_path_to_the_first_vertex)
{
  const Mesh mesh = sample_mesh("cactus.off");
  const Log_field field(mesh, Vertex(7));
  std::size_t number_of_bends = 0;
  for(const Vertex v : mesh.vertices())
    if(const Vertex before = field.before[v]; before != v && before != Vertex(7))
    {
      const Tangent_vector &a = field.logs[v], &b = field.logs[before];
      EXPECT_NEAR(a.x * b.y - a.y * b.x, 0, 1e-14 * field.length(v) * field.length(before));
      ++number_of_bends;
    }
  EXPECT_GT(number_of_bends, 0u);
}

TEST(LogarithmicMap, ends_at_the_maximum_distance)
{
  const Mesh mesh = to_mesh(flat_grid(9, 6));
  const Log_field field(mesh, Vertex(20), CGAL::parameters::maximum_distance(2));
  for(const Vertex v : mesh.vertices())
    if(field.distances[v] <= 2)
      EXPECT_NEAR(field.length(v), field.distances[v], 1e-15);
    else
      EXPECT_EQ(field.length(v), std::numeric_limits<double>::infinity());
}

TEST(LogarithmicMap, on_hostile_meshes_has_the_distances)
{
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    if(!row.refusal_across_faces.empty())
      continue;
    for(const std::vector<Surface_point>& sources :
        {some_vertices(row.mesh), some_points(row.mesh)})
      for(const Surface_point& source : sources)
      {
        const Log_field field(row.mesh, source);
        for(const Vertex v : row.mesh.vertices())
        {
          EXPECT_FALSE(std::isnan(field.logs[v].x) || std::isnan(field.logs[v].y));
          const double distance = field.distances[v];
          EXPECT_TRUE(std::isinf(distance)
                          ? std::isinf(field.length(v))
                          : std::abs(field.length(v) - distance) <= 1e-14 * distance + 2e-323);
        }
      }
  }
}

TEST(LogarithmicMap, rejects_bad_input)
{
  const Mesh mesh = quiet_mesh();
  std::vector<Tangent_vector> logs(mesh.num_vertices());
  const auto map = boost::make_iterator_property_map(logs.begin(), get(boost::vertex_index, mesh));
  expect_message<std::invalid_argument>([&] { AG::logarithmic_map(mesh, map, Vertex(99)); },
                                        "source: vertex 99 is not in the mesh");
}

// ----- means

double distance_between(const Mesh& mesh, const Surface_point& p, const Surface_point& q)
{
  std::vector<Point> points;
  return CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), p, q,
                                         CGAL::parameters::epsilon(0));
}

TEST(KarcherMean, of_two_points_is_the_middle_of_a_path)
{
  const std::uint64_t seed = test_seed();
  for(const Named_mesh& named : generated_meshes(seed))
  {
    SCOPED_TRACE(named.name);
    if(named.name == "edges of length zero")
      continue;
    Random random(seed);
    for(int i = 0; i < 4; ++i)
    {
      const std::vector<Surface_point> points{random_face_location(named.mesh, random),
                                              random_face_location(named.mesh, random)};
      const double distance = distance_between(named.mesh, points[0], points[1]);
      if(std::isinf(distance))
        continue;
      const auto mean = AG::karcher_mean(named.mesh, points, std::vector<int>{3, 3});
      EXPECT_TRUE(mean.has_converged) << mean.number_of_iterations;
      for(const Surface_point& p : points)
        EXPECT_NEAR(distance_between(named.mesh, mean.point, p), distance / 2, 1e-9 * distance);
      EXPECT_NEAR(mean.deviation, distance / 2, 1e-9 * distance);
    }
  }
}

TEST(KarcherMean, in_a_plane_is_the_weighted_mean)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(12, 9));
  for(std::size_t number = 1; number < 8; ++number)
  {
    const std::vector<Surface_point> points = random_surface_points(mesh, number, random);
    std::vector<double> weights;
    CGAL::Vector_3<Kernel> expected(0, 0, 0);
    double sum = 0;
    for(const Surface_point& p : points)
    {
      weights.push_back(random.between(0, 1e307));
      sum += weights.back() / 1e307;
      expected += weights.back() / 1e307 * (position(mesh, p) - CGAL::ORIGIN);
    }
    const auto mean = AG::karcher_mean(mesh, points, weights);
    EXPECT_TRUE(mean.has_converged);
    const auto gap = position(mesh, mean.point) - (CGAL::ORIGIN + expected / sum);
    EXPECT_LT(std::sqrt(gap.squared_length()), 1e-10);
  }
}

// Two points at the same place, or nearly so: the Hessian counts both.
TEST(KarcherMean, is_a_point_that_has_nearly_all_of_the_weight)
{
  const Mesh mesh = quiet_mesh();
  const std::vector<Surface_point> points{Face_location(Face(2), {0.25, 0.5, 0.25}), Vertex(7),
                                          Vertex(13)};
  const auto mean = AG::karcher_mean(mesh, points, std::vector<double>{1, 1e-30, 1e-30});
  EXPECT_TRUE(mean.has_converged);
  EXPECT_EQ(position(mesh, mean.point), position(mesh, points[0]));
}

// No point close to it is better; farther ones may be, beyond lines where distances have kinks.
TEST(KarcherMean, of_many_points_is_a_local_minimum)
{
  const Mesh mesh = sample_mesh("bunny00.off");
  Random random(test_seed());
  const AG::Geodesic_tracer tracer(mesh);
  for(int i = 0; i < 3; ++i)
  {
    const Surface_point center = random_face_location(mesh, random);
    std::vector<Surface_point> points;
    for(int k = 0; k < 5; ++k)
      points.push_back(tracer
                           .trace(center, Tangent_vector{std::cos(k + 0.1), std::sin(k + 0.1)},
                                  0.2 * size(mesh) * random.between(0.3, 1))
                           .points.back());
    const auto mean = AG::karcher_mean(mesh, points, std::vector<double>(5, 1));
    EXPECT_TRUE(mean.has_converged) << mean.number_of_iterations;
    const auto sum_of_squares = [&](const Surface_point& p) {
      double result = 0;
      for(const Surface_point& q : points)
        result += std::pow(distance_between(mesh, p, q), 2);
      return result;
    };
    const double best = sum_of_squares(mean.point);
    EXPECT_NEAR(std::sqrt(best / 5), mean.deviation, 1e-9 * mean.deviation);
    for(const double angle : {0., 1.5, 3., 4.5})
    {
      const auto walk = tracer.trace(mean.point, Tangent_vector{std::cos(angle), std::sin(angle)},
                                     1e-5 * mean.deviation);
      EXPECT_GE(sum_of_squares(walk.points.back()), best * (1 - 1e-12));
    }
  }
}

TEST(KarcherMean, on_hostile_meshes_ends)
{
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    if(!row.refusal_across_faces.empty())
      continue;
    for(const std::vector<Surface_point>& points : {some_vertices(row.mesh), some_points(row.mesh)})
    {
      if(points.empty())
        continue;
      try
      {
        const auto mean = AG::karcher_mean(row.mesh, points, std::vector<double>(points.size(), 1));
        EXPECT_FALSE(std::isnan(mean.deviation));
      }
      catch(const std::invalid_argument& e)
      {
        EXPECT_NE(std::string(e.what()).find("cannot be reached"), std::string::npos) << e.what();
      }
    }
  }
}

TEST(KarcherMean, rejects_bad_input)
{
  const Mesh mesh = quiet_mesh();
  const std::vector<Vertex> points{Vertex(0), Vertex(3)};
  const auto expect = [&](const std::vector<Vertex>& vertices, const std::vector<double>& weights,
                          const std::string& text) {
    expect_message<std::invalid_argument>([&] { AG::karcher_mean(mesh, vertices, weights); }, text);
  };
  expect({}, {}, "there are 0 points");
  expect(points, {1}, "there are 2 points, and 1 weights");
  expect(points, {0, 0}, "one that is not 0");
  expect(points, {1, -1}, "weight 1 (counted from 0) is -1");
  expect(points, {std::nan(""), 1}, "weight 0 (counted from 0) is nan");
  expect({Vertex(0), Vertex(99)}, {1, 1}, "point 1 (counted from 0): vertex 99 is not in the mesh");
  expect_message<std::invalid_argument>(
      [&] {
        AG::karcher_mean(mesh, points, std::vector<double>{1, 1},
                         CGAL::parameters::number_of_iterations(-1));
      },
      "the number of iterations is -1; it must not be negative");
  Mesh parts = to_mesh(many_triangles(2));
  expect_message<std::invalid_argument>(
      [&] {
        AG::karcher_mean(parts, points, std::vector<double>{1, 1});
      },
      "cannot be reached from others");
}

} // namespace
