// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_fields.h"
#include "checks/expect_message.h"
#include "meshes/sample_meshes.h"
#include "oracles/exact_distances.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_queries/distance_intervals.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <ratio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Exact distances in all functions, by `epsilon(0)`, and intervals that contain them.

namespace {

using namespace geodesics_test;
using Interval = std::pair<double, double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding_of_sums = 1e-12;

template <typename Sources, typename NamedParameters>
std::vector<double> distances(const Mesh& mesh, const Sources& sources, const NamedParameters& np)
{
  std::vector<double> result(mesh.num_vertices());
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(result.begin(), get(CGAL::vertex_index, mesh)),
      sources, np);
  return result;
}

template <typename Sources, typename NamedParameters>
std::vector<Interval> intervals(const Mesh& mesh, const Sources& sources, const NamedParameters& np)
{
  std::vector<Interval> result(mesh.num_vertices());
  AG::distance_intervals(
      mesh, boost::make_iterator_property_map(result.begin(), get(CGAL::vertex_index, mesh)),
      sources, np);
  return result;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], rounding_of_sums * expected[i]) << "vertex " << i;
}

void expect_in(const std::vector<double>& values, const std::vector<Interval>& found)
{
  ASSERT_EQ(found.size(), values.size());
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_LE(found[i].first, values[i]) << "vertex " << i;
    EXPECT_GE(found[i].second, values[i]) << "vertex " << i;
  }
}

class Exact_queries : public testing::Test
{
protected:
  void SetUp() override
  {
    SKIP_WITHOUT_SAMPLE_MESHES();
    mesh = sample_mesh("elephant.off");
    exact = exact_distances(mesh, source);
  }

  Mesh mesh;
  const Vertex source{17}, target{1200};
  std::vector<double> exact;
};

TEST_F(Exact_queries, distances_are_those_of_the_exact_class)
{
  expect_near(distances(mesh, source, parameters::epsilon(0)), exact);
  expect_near(distances(mesh, source, parameters::epsilon(0.)), exact);
}

// So that only one kind of search is compiled.
TEST_F(Exact_queries, may_be_known_when_the_program_is_compiled)
{
  EXPECT_EQ(distances(mesh, source, parameters::epsilon(std::ratio<0>())),
            distances(mesh, source, parameters::epsilon(0)));
  EXPECT_EQ(distances(mesh, source, parameters::epsilon(std::ratio<1, 10>())),
            distances(mesh, source, parameters::epsilon(0.1)));
}

TEST_F(Exact_queries, path_has_the_length_of_the_distance)
{
  std::vector<Point> points;
  const double length = CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source,
                                                        target, parameters::epsilon(0));
  EXPECT_NEAR(length, exact[target.idx()], rounding_of_sums * length);
  EXPECT_NEAR(geodesics_test::length({points}), length, rounding_of_sums * length);
  EXPECT_EQ(points.front(), mesh.point(source));
  EXPECT_EQ(points.back(), mesh.point(target));
}

TEST_F(Exact_queries, class_needs_another_graph_only)
{
  AG::Surface_mesh_shortest_path<Mesh, AG::Saddle_vertex_graph> paths(mesh);
  paths.add_source_point(source);
  std::vector<double> found;
  for(const Vertex v : mesh.vertices())
    found.push_back(paths.shortest_distance_to_source_points(v).first);
  expect_near(found, exact);
  EXPECT_NEAR(paths.shortest_distance(source, target), exact[target.idx()], rounding_of_sums);
}

TEST_F(Exact_queries, several_sources)
{
  const std::vector<Vertex> sources{source, target, source};
  const std::vector<double> offsets{0.1, 0., 0.2};
  const std::vector<double> other = exact_distances(mesh, target);
  std::vector<double> expected;
  for(std::size_t i = 0; i < exact.size(); ++i)
    expected.push_back((std::min)(exact[i] + 0.1, other[i]));
  expect_near(distances(mesh, sources, parameters::epsilon(0).initial_distances(offsets)),
              expected);
}

// Rounded to labels as large, all lines would be short enough, and searches would not end. A second
// source that is nearer everywhere leaves nothing to reject.
TEST_F(Exact_queries, reject_initial_distances_that_lengths_vanish_beside)
{
  const auto run = [&](const std::vector<Vertex>& sources, const std::vector<double>& offsets) {
    return distances(mesh, sources, parameters::epsilon(0).initial_distances(offsets));
  };
  for(const double offset : {1e12, 1e160})
    expect_message<std::invalid_argument>([&] { run({source}, {offset}); },
                                          "an initial distance is so large");
  expect_near(run({source, target}, {0., 1e160}), exact);
  std::vector<double> moved = run({source}, {1e5});
  for(double& distance : moved)
    distance -= 1e5;
  for(std::size_t i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(moved[i], exact[i], 1e-9);
}

TEST_F(Exact_queries, farthest_points_are_those_of_searches_from_all)
{
  std::vector<Vertex> points;
  const double radius =
      AG::farthest_point_sampling(mesh, std::back_inserter(points), 6, parameters::epsilon(0));
  const std::vector<double> found = distances(mesh, points, parameters::epsilon(0));
  EXPECT_NEAR(*std::max_element(found.begin(), found.end()), radius, rounding_of_sums * radius);
}

TEST_F(Exact_queries, intervals_contain_exact_distances)
{
  for(const double epsilon : {0., 1e-6, 0.1, 1.})
  {
    SCOPED_TRACE(epsilon);
    const auto found = intervals(mesh, source, parameters::epsilon(epsilon));
    expect_in(exact, found);
    for(const auto& [lower, upper] : found)
      EXPECT_LE(upper, lower * (1 + epsilon) * (1 + 4 * rounding_of_sums));
  }
}

TEST_F(Exact_queries, intervals_are_open_beyond_the_maximum_distance)
{
  const double limit = 0.3;
  const auto found = intervals(mesh, source, parameters::epsilon(0.1).maximum_distance(limit));
  expect_in(exact, found);
  std::size_t number_of_open_ones = 0;
  for(const auto& [lower, upper] : found)
    if(upper == infinity)
    {
      EXPECT_NEAR(lower, limit / 1.1, rounding_of_sums);
      ++number_of_open_ones;
    }
  EXPECT_GT(number_of_open_ones, 0u);
  EXPECT_LT(number_of_open_ones, found.size());
}

TEST_F(Exact_queries, intervals_contain_costs)
{
  const auto weights = boost::make_function_property_map<Face, double>([](Face) { return 2.; });
  std::vector<double> costs;
  for(const double distance : exact)
    costs.push_back(2 * distance);
  const auto found = intervals(mesh, source, parameters::epsilon(0.5).face_weight_map(weights));
  expect_in(costs, found);
}

TEST_F(Exact_queries, weights_and_barriers_are_refused)
{
  const auto weights = boost::make_function_property_map<Face, double>([](Face) { return 2.; });
  const auto barriers = boost::make_function_property_map<CGAL::SM_Edge_index, bool>(
      [](CGAL::SM_Edge_index) { return false; });
  expect_message<std::invalid_argument>(
      [&] { distances(mesh, source, parameters::epsilon(0).face_weight_map(weights)); },
      "supports neither weights nor barriers");
  expect_message<std::invalid_argument>(
      [&] {
        distances(mesh, source,
                  parameters::combine(parameters::epsilon(0),
                                      parameters::edge_is_constrained_map(barriers)));
      },
      "supports neither weights nor barriers");
}

TEST(Exact_queries_alone, other_parts_are_infinitely_far)
{
  Mesh mesh;
  const auto add = [&](const double x) {
    const Vertex a = mesh.add_vertex(Point(x, 0, 0)), b = mesh.add_vertex(Point(x + 1, 0, 0));
    mesh.add_face(a, b, mesh.add_vertex(Point(x, 1, 0)));
  };
  add(0);
  add(10);
  const auto found = intervals(mesh, Vertex(0), parameters::epsilon(0));
  EXPECT_EQ(found[0], Interval(0, 0));
  EXPECT_NEAR(found[1].first, 1, 2 * rounding_of_sums);
  EXPECT_EQ(found[4], Interval(infinity, infinity));
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_F(Exact_queries, threads_find_the_same)
{
  const auto np = parameters::epsilon(0);
  const auto in_parallel = np.concurrency_tag(CGAL::Parallel_tag());
  expect_near(distances(mesh, source, in_parallel), exact);
  EXPECT_EQ(distances(mesh, source, in_parallel), distances(mesh, source, in_parallel));
}

// Where nearly all vertices divide what is seen, threads share what one source sees.
TEST(Exact_queries_alone, threads_find_the_same_in_the_plane)
{
  const Mesh mesh = to_mesh(flat_grid(140, 140));
  const std::vector<double> found =
      distances(mesh, Vertex(0), parameters::epsilon(0).concurrency_tag(CGAL::Parallel_tag()));
  std::vector<double> expected;
  for(const Vertex v : mesh.vertices())
    expected.push_back(std::sqrt(CGAL::squared_distance(mesh.point(Vertex(0)), mesh.point(v))));
  expect_near(found, expected);
}
#endif

} // namespace
