// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_queries/Exact_landmarks.h>

#include "checks/distance_matrices.h"
#include "checks/expect_exact_distances.h"
#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/sample_meshes.h"
#include "oracles/exact_distances.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

// Exact searches that stay in a corridor find what those of the whole surface do.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Exact_landmarks = AG::Exact_landmarks<Saddle_vertex_graph>;
using Guided_search = AG::Guided_search<Saddle_vertex_graph>;

struct Pair_subject
{
  Pair_subject(const Mesh& m, const std::size_t number_of_landmarks)
    : mesh(m),
      graph(Triangulation(mesh)),
      landmarks(graph, number_of_landmarks),
      whole(graph),
      limited(graph)
  {
    limited.use_landmarks(landmarks);
  }

  std::vector<Intrinsic_point> points(const std::size_t number, Random& random) const
  {
    std::vector<Surface_point> result = some_vertices(mesh);
    for(const Surface_point& p : some_points(mesh))
      result.push_back(p);
    if(mesh.number_of_faces() > 0 && !mesh.has_garbage())
      for(const Surface_point& p : random_surface_points(mesh, number, random))
        result.push_back(p);
    return intrinsic_points(mesh, graph.triangulation(), result);
  }

  // Expects the same distance, to the last bit where `rounding` is 0, and a path of that length.
  void expect_same(const Intrinsic_point& source,
                   const Intrinsic_point& target,
                   const double rounding = 0)
  {
    constexpr double smallest = 4 * std::numeric_limits<double>::denorm_min();
    whole.run({{source}}, {infinity, {target}});
    limited.run_to(target, {{source}});
    const auto expected = whole.nearest(target), found = limited.nearest(target);
    if(rounding == 0 || std::isinf(expected.distance))
    {
      EXPECT_EQ(found.distance, expected.distance);
    }
    else
      EXPECT_NEAR(found.distance, expected.distance, rounding * expected.distance + smallest);
    EXPECT_EQ(found.is_reached(), expected.is_reached());
    if(found.is_reached())
    {
      const double length = limited.find_path(target).length, wanted = found.distance;
      EXPECT_NEAR(length, wanted,
                  1e-11 * wanted + rounding_of_places(graph.triangulation()) + smallest);
    }
  }

  void expect_same(const std::vector<Intrinsic_point>& points, const double rounding = 0)
  {
    for(const Intrinsic_point& source : points)
      for(const Intrinsic_point& target : points)
        expect_same(source, target, rounding);
  }

  const Mesh mesh;
  const Saddle_vertex_graph graph;
  const Exact_landmarks landmarks;
  Exact_search whole;
  Guided_search limited;
};

TEST(Far_pairs, have_the_same_bits_on_generated_meshes)
{
  Random random(test_seed());
  for(const std::uint64_t seed : seeds_of_small_soups())
  {
    SCOPED_TRACE(seed);
    const Mesh mesh = to_mesh(random_small_soup(seed));
    Pair_subject subject(mesh, 1 + random.below(5));
    subject.expect_same(subject.points(6, random), has_flat_faces(mesh) ? 1e-12 : 0);
  }
}

TEST(Far_pairs, have_the_same_bits_on_larger_meshes)
{
  Random random(test_seed());
  for(const std::uint64_t seed : seeds_of_large_soups())
  {
    SCOPED_TRACE(seed);
    Pair_subject subject(to_mesh(random_large_soup(seed)), 8);
    subject.expect_same(subject.points(8, random));
  }
}

// Needles and the like: distances differ by what rounding makes of them.
TEST(Far_pairs, have_the_same_distances_on_hostile_meshes)
{
  Random random(test_seed());
  for(const Hostile_mesh& row : accepted_meshes())
  {
    if(!row.refusal_across_faces.empty())
      continue;
    SCOPED_TRACE(row.name);
    Pair_subject subject(row.mesh, 2);
    subject.expect_same(subject.points(2, random), 1e-9);
  }
}

TEST(Far_pairs, have_the_same_bits_on_a_scan)
{
  Random random(test_seed());
  Pair_subject subject(sample_mesh("elephant.off"), 16);
  const auto points = subject.points(24, random);
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    subject.expect_same(points[i], points[i + 1]);
}

TEST(Far_pairs, are_those_of_the_exact_class)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(16, 14, random));
  const AG::Surface_mesh_shortest_path<Mesh, Saddle_vertex_graph> paths(mesh);
  AG::Pair_queries pairs(paths);
  pairs.prepare();
  for(int i = 0; i < 3; ++i)
  {
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> expected = exact_distances(mesh, source);
    for(const Vertex target : mesh.vertices())
      EXPECT_NEAR(pairs.shortest_distance(source, target), expected[target.idx()],
                  1e-9 * expected[target.idx()]);
  }
}

// Few nodes are reached that are not near the path, from and to points of all kinds.
TEST(Far_pairs, reach_few_nodes)
{
  Pair_subject subject(to_mesh(flat_grid(60, 60)), 8);
  const auto points_near = [&](const Vertex v) {
    const Halfedge h = subject.mesh.halfedge(v); // not on the border
    return intrinsic_points(
        subject.mesh, subject.graph.triangulation(),
        {v, Edge_location(h, 0.7), Face_location(subject.mesh.face(h), {0.3, 0.4, 0.3})});
  };
  const auto number_settled = [](const Exact_search& search) {
    return search.search().statistics().settled_nodes;
  };
  subject.whole.collect_statistics(true);
  subject.limited.collect_statistics(true);
  for(const Intrinsic_point& source : points_near(Vertex(60 * 40 + 5)))
    for(const Intrinsic_point& target : points_near(Vertex(3 * 60 + 50)))
    {
      subject.expect_same(source, target);
      EXPECT_LT(number_settled(subject.limited), number_settled(subject.whole) / 8);
    }
}

TEST(Far_pairs, of_parts_that_are_not_connected_take_no_search)
{
  Soup soup = flat_grid(8, 8);
  soup.append(flat_grid(9, 9));
  Pair_subject subject(to_mesh(soup), 2);
  const Triangulation& t = subject.graph.triangulation();
  subject.limited.collect_statistics(true);
  subject.limited.run_to(Intrinsic_point::at_vertex(t.vertex(70)),
                         {{Intrinsic_point::at_vertex(t.vertex(3))}});
  EXPECT_EQ(subject.limited.distance(Intrinsic_point::at_vertex(t.vertex(70))), infinity);
  EXPECT_LE(subject.limited.search().statistics().settled_nodes, 1u);
}

TEST(Far_pairs, heed_the_maximum_distance)
{
  Random random(test_seed());
  Pair_subject subject(to_mesh(terrain(12, 10, random)), 4);
  const auto points = subject.points(6, random);
  for(const Intrinsic_point& source : points)
    for(const Intrinsic_point& target : points)
    {
      subject.limited.run_to(target, {{source}});
      const double d = subject.limited.distance(target);
      subject.limited.run_to(target, {{source}}, {}, d);
      EXPECT_EQ(subject.limited.distance(target), d);
      subject.limited.run_to(target, {{source}}, {}, 0.999 * d);
      EXPECT_EQ(subject.limited.distance(target), d > 0 ? infinity : 0);
    }
}

// Runs of other kinds do not stay in the corridor of the last one.
TEST(Far_pairs, do_not_limit_other_runs)
{
  Random random(test_seed());
  Pair_subject subject(to_mesh(terrain(12, 10, random)), 4);
  const auto points = subject.points(6, random);
  for(const Intrinsic_point& source : points)
  {
    subject.limited.run_to(points.front(), {{points.back()}});
    subject.limited.run({{source}});
    subject.whole.run({{source}});
    for(const Intrinsic_point& target : points)
      EXPECT_EQ(subject.limited.distance(target), subject.whole.distance(target));
    const std::vector<AG::Source_point> sources = {{source, 0.5}, {points.front(), 0.25}};
    subject.whole.run(sources);
    for(const Intrinsic_point& target : points)
    {
      subject.limited.run_to(target, sources);
      EXPECT_EQ(subject.limited.distance(target), subject.whole.distance(target));
    }
  }
}

TEST(Far_pairs, in_lists_and_of_the_class)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  const AG::Surface_mesh_shortest_path<Mesh, Saddle_vertex_graph> paths(mesh);
  AG::Pair_queries queries(paths);
  const auto points = random_surface_points(mesh, 12, random);
  std::vector<std::pair<Surface_point, Surface_point>> pairs;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(const Surface_point& target : points)
      if(i == 0 || random.below(3) == 0) // the first source has more targets than others
        pairs.emplace_back(points[i], target);
  const std::vector<double> expected = queries.distances(pairs);
  queries.prepare(4);
  EXPECT_EQ(queries.distances(pairs), expected);
  const auto found = queries.paths(pairs);
  ASSERT_EQ(found.size(), pairs.size());
  for(std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto& [source, target] = pairs[i];
    EXPECT_EQ(queries.shortest_distance(source, target), expected[i]);
    double length = 0;
    for(std::size_t j = 1; j < found[i].size(); ++j)
      length += std::sqrt(CGAL::squared_distance(found[i][j - 1], found[i][j]));
    EXPECT_NEAR(length, expected[i], 1e-11 * expected[i] + 1e-11);
    std::vector<Point> straightened;
    const double length_of_path = queries.shortest_path_points(
        source, target, std::back_inserter(straightened), CGAL::parameters::straighten(true));
    EXPECT_NEAR(length_of_path, expected[i], 1e-11 * expected[i] + 1e-11);
  }
}

TEST(Far_pairs, need_landmarks_of_the_graph)
{
  const Mesh mesh = quiet_mesh();
  const Saddle_vertex_graph graph{Triangulation(mesh)}, other{Triangulation(mesh)};
  const Exact_landmarks landmarks(graph, 2);
  Guided_search search(other);
  EXPECT_FALSE(search.uses_landmarks());
  expect_message<std::invalid_argument>([&] { search.use_landmarks(landmarks); },
                                        "the landmarks are those of another graph");
  expect_message<std::invalid_argument>([&] { Exact_landmarks(graph, 0); }, "number of landmarks");
  const Saddle_vertex_graph empty;
  EXPECT_GT(Exact_landmarks(empty).memory(), 0u);
}

TEST(Far_pairs, that_are_refused_leave_the_last_one)
{
  Random random(test_seed());
  Pair_subject subject(quiet_mesh(), 2);
  const auto points = subject.points(2, random);
  subject.limited.run_to(points[1], {{points[0]}});
  const double d = subject.limited.distance(points[1]);
  const auto nowhere = Intrinsic_point::at_vertex(10000);
  EXPECT_THROW(subject.limited.run_to(nowhere, {{points[0]}}), std::invalid_argument);
  EXPECT_THROW(subject.limited.run_to(points[1], {{nowhere}}), std::invalid_argument);
  EXPECT_THROW(subject.limited.run_to(points[1], {{points[0]}}, {}, -1), std::invalid_argument);
  EXPECT_EQ(subject.limited.distance(points[1]), d);
}

// The last run is forgotten then, as it refers to what is gone.
TEST(Far_pairs, with_other_landmarks_begin_anew)
{
  Random random(test_seed());
  Pair_subject subject(to_mesh(terrain(12, 10, random)), 4);
  const auto points = subject.points(4, random);
  const Exact_landmarks others(subject.graph, 2);
  for(const Intrinsic_point& target : points)
  {
    subject.expect_same(points.front(), target);
    subject.limited.use_landmarks(others);
    EXPECT_FALSE(subject.limited.nearest(target).is_reached());
    EXPECT_TRUE(subject.limited.sources().empty());
    subject.expect_same(points.front(), target);
    subject.limited.use_landmarks(subject.landmarks);
  }
}

// The corridor of the last run moves along with it. Two workspaces cannot share one.
TEST(Far_pairs, move_with_their_workspace)
{
  static_assert(!std::is_copy_constructible_v<Guided_search>);
  Random random(test_seed());
  Pair_subject subject(to_mesh(terrain(12, 10, random)), 4);
  const auto points = subject.points(4, random);
  for(const Intrinsic_point& target : points)
  {
    subject.limited.run_to(target, {{points.front()}});
    const double expected = subject.limited.distance(target);
    Guided_search other = std::move(subject.limited);
    EXPECT_EQ(other.distance(target), expected);
    subject.limited = std::move(other);
    EXPECT_EQ(subject.limited.distance(target), expected);
    subject.expect_same(points.front(), target);
  }
}

} // namespace
