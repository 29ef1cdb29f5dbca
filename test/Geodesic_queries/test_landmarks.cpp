// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_queries/Landmarks.h>

#include "checks/distance_matrices.h"
#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/test_costs.h"
#include "meshes/test_meshes.h"
#include "meshes/test_weights.h"
#include "oracles/One_way_graph.h"

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// Landmarks give lower bounds, and searches that they lead find the same distances.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

std::vector<Intrinsic_point>
landmark_goals(const Mesh& mesh, const Triangulation& triangulation, Random& random)
{
  std::vector<Surface_point> points = some_vertices(mesh);
  for(const Surface_point& p : some_points(mesh))
    points.push_back(p);
  if(mesh.number_of_faces() > 0 && !mesh.has_garbage())
    for(const Surface_point& p : random_surface_points(mesh, 4, random))
      points.push_back(p);
  return intrinsic_points(mesh, triangulation, points);
}

// Expects lower bounds of the distances from all nodes.
template <typename GeodesicGraph>
void expect_lower_bounds(const GeodesicGraph& graph,
                         const AG::Landmarks<GeodesicGraph>& landmarks,
                         const Intrinsic_point& goal)
{
  const auto bound = landmarks.to(goal);
  AG::Propagation<GeodesicGraph> search(graph);
  for(std::uint32_t node = 0; node < graph.number_of_nodes(); ++node)
  {
    search.run_from(node);
    double distance = infinity;
    AG::internal::attach_target(graph, goal).for_each_node([&](const auto n, const double length) {
      distance = (std::min)(distance, search.labels().distance(n) + length);
    });
    EXPECT_LE(bound(node), distance) << node;
    EXPECT_GE(bound(node), 0);
  }
}

template <typename GeodesicGraph>
void expect_same_distances_with_landmarks(const GeodesicGraph& graph,
                                          const AG::Landmarks<GeodesicGraph>& landmarks,
                                          const std::vector<Intrinsic_point>& points)
{
  constexpr double rounding = 1e-13; // arcs that are left out can be as good as others
  AG::Surface_search<GeodesicGraph> search(graph);
  AG::Guided_search<GeodesicGraph> led(graph);
  led.use_landmarks(landmarks);
  ASSERT_TRUE(led.uses_landmarks());
  for(const Intrinsic_point& source : points)
    for(const Intrinsic_point& target : points)
    {
      search.run({{source}}, {infinity, {target}});
      const double expected = search.distance(target);
      led.run_to(target, {{source}});
      const double found = led.distance(target);
      EXPECT_EQ(std::isinf(found), std::isinf(expected));
      if(std::isinf(expected))
        continue;
      constexpr double smallest = std::numeric_limits<double>::denorm_min();
      EXPECT_NEAR(found, expected, rounding * expected + 2 * smallest);
      const double length = led.find_path(target).length;
      EXPECT_NEAR(length, search.find_path(target).length, 1e-6 * expected + 1e-9);
    }
}

template <typename GeodesicGraph>
void expect_use(const Mesh& mesh, const GeodesicGraph& graph, Random& random)
{
  const auto points = landmark_goals(mesh, graph.triangulation(), random);
  for(const std::size_t number : {1u, 5u})
  {
    const AG::Landmarks<GeodesicGraph> landmarks(graph, number);
    EXPECT_EQ(landmarks.nodes().size(), number);
    expect_same_distances_with_landmarks(graph, landmarks, points);
    if(graph.number_of_nodes() < 500 && !points.empty())
      expect_lower_bounds(graph, landmarks, points[random.below(points.size())]);
  }
}

TEST(Landmarks, change_no_distance)
{
  Random random(test_seed());
  for(std::uint64_t i = 0; i < number_of_kinds_of_soups; ++i)
  {
    const Mesh mesh = to_mesh(random_small_soup(test_seed() + i));
    SCOPED_TRACE(test_seed() + i);
    const Triangulation triangulation(mesh);
    expect_use(mesh, edge_graph().make(triangulation), random);
    expect_use(mesh, discrete_geodesic_graph(0.3).make(triangulation), random);
    expect_use(mesh, graph_with_spaced_points(2).make(triangulation), random);
  }
}

TEST(Landmarks, change_no_distance_on_hostile_meshes)
{
  Random random(test_seed());
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    expect_use(row.mesh, edge_graph().make(Triangulation(row.mesh)), random);
    if(row.refusal_across_faces.empty())
      expect_use(row.mesh, graph_with_spaced_points(1).make(Triangulation(row.mesh)), random);
  }
}

void expect_use_with_weights_and_barriers(const int number_of_terrains)
{
  Random random(test_seed());
  for(int i = 0; i < number_of_terrains; ++i)
  {
    const Mesh mesh = to_mesh(terrain(7, 6, random));
    const Weights weights = random_weights(mesh, random, 0.5, 2, 0.1);
    const Barriers barriers = random_barriers(mesh, 0.3, random);
    const Triangulation triangulation(
        mesh, with_weights(weights).edge_is_constrained_map(barrier_map(barriers)));
    expect_use(mesh, graph_with_spaced_points(1).make(triangulation), random);
    expect_use(mesh, Steiner_graph<>(triangulation, lenient_points(1)), random);
  }
}

TEST(Landmarks, heed_weights_and_barriers) { expect_use_with_weights_and_barriers(1); }

TEST(Landmarks, heed_weights_and_barriers_on_many_terrains)
{
  expect_use_with_weights_and_barriers(10);
}

TEST(Landmarks, heed_extreme_weights)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(6, 6, random));
  for(const double factor : {1e-290, 1., 1e200})
  {
    Weights weights = random_weights(mesh, random, factor, 1e9 * factor, 0.1);
    expect_use(mesh, steiner_graph(mesh, weights, Fixed_number_of_points(1)), random);
  }
  expect_use(mesh, steiner_graph(mesh, Weights(mesh.num_faces()), Fixed_number_of_points(1)),
             random); // all free
}

TEST(Landmarks, heed_directions)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(6, 5, random));
  const Dense_graph graph = dense_graph(mesh, cost_of_faces(random_slants(mesh, random, 0.8)), 1);
  expect_use(mesh, graph, random);
  expect_use(mesh, graph.reversed(), random);
}

// Arcs go one way only, or paths do not lead through a node, whatever the graph says.
TEST(Landmarks, heed_one_way_arcs)
{
  Random random(test_seed());
  for(int i = 0; i < 20; ++i)
  {
    const Mesh mesh = to_mesh(terrain(5, 5, random));
    for(const double asymmetry : {0., 1., infinity})
      expect_use(mesh, One_way_graph(Triangulation(mesh), asymmetry, random), random);
  }
}

// Rooms behind doors: paths do not lead through the vertices of walls. A run that left the label of
// one behind made a later distance too short, or ended the program.
class Floor_plan : public testing::Test
{
protected:
  static constexpr std::size_t size = 31, size_of_room = 10;
  using Rooms = Steiner_graph<Fixed_number_of_points>;

  static bool is_in_wall(const Mesh& mesh, const Edge e)
  {
    const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    const auto is_wall = [](const double a, const double b) {
      return a == b && a > 0 && a < size - 1 && std::fmod(a, double(size_of_room)) == 0;
    };
    const auto is_door = [](const double a, const double b) {
      const double middle = std::fmod((a + b) / 2, double(size_of_room));
      return middle > 4 && middle < 6;
    };
    return (is_wall(p.x(), q.x()) && !is_door(p.y(), q.y())) ||
           (is_wall(p.y(), q.y()) && !is_door(p.x(), q.x()));
  }

  Rooms rooms(const std::size_t number_of_points) const
  {
    Barriers walls(m_mesh.num_edges());
    for(const Edge e : m_mesh.edges())
      walls[e.idx()] = is_in_wall(m_mesh, e);
    return Rooms(Triangulation(m_mesh, with_barriers(walls)),
                 Fixed_number_of_points(number_of_points));
  }

  // Pairs, every other one of which ends at a wall.
  static std::vector<AG::Point_pair> pairs(const Rooms& graph, Random& random)
  {
    const Triangulation& t = graph.triangulation();
    std::vector<std::uint32_t> at_walls;
    for(std::uint32_t h = 0; h < t.number_of_halfedges(); ++h)
      if(t.is_barrier(h))
        at_walls.push_back(t.source(h));
    const auto vertex = [&] {
      return static_cast<std::uint32_t>(random.below(t.number_of_vertices()));
    };
    std::vector<AG::Point_pair> result;
    for(std::size_t i = 0; i < 80; ++i)
    {
      const auto target = i % 2 == 0 ? vertex() : at_walls[random.below(at_walls.size())];
      result.emplace_back(Intrinsic_point::at_vertex(vertex()), Intrinsic_point::at_vertex(target));
    }
    return result;
  }

  const Mesh m_mesh = to_mesh(flat_grid(size, size));
};

TEST_F(Floor_plan, has_the_distances_of_a_new_search_for_each_pair)
{
  Random random(test_seed());
  for(const std::size_t number_of_points : {0u, 1u})
  {
    const Rooms graph = rooms(number_of_points);
    const auto list = pairs(graph, random);
    std::vector<double> expected;
    for(const AG::Point_pair& pair : list)
    {
      AG::Surface_search<Rooms> search(graph);
      expected.push_back(AG::pair_distances(search, {pair})[0]);
    }
    for(const std::size_t number : {1u, 16u})
    {
      const AG::Landmarks<Rooms> landmarks(graph, number);
      AG::Guided_search<Rooms> search(graph);
      search.use_landmarks(landmarks);
      for(std::size_t i = 0; i < list.size(); ++i)
        EXPECT_NEAR(AG::pair_distances(search, {list[i]})[0], expected[i], 1e-13 * expected[i])
            << i;
    }
  }
}

// The ways that were wrong first: on closed surfaces with many walls, and up to a largest distance.
TEST(Landmarks, leave_no_label_behind)
{
  using Rooms = Steiner_graph<Fixed_number_of_points>;
  Random random(test_seed());
  for(int i = 0; i < 60; ++i)
  {
    const Mesh mesh = to_mesh(i % 2 == 0 ? sphere(7, 6) : terrain(7, 6, random));
    const Barriers walls = random_barriers(mesh, 0.45, random);
    const Rooms graph(Triangulation(mesh, with_barriers(walls)), Fixed_number_of_points(0));
    const AG::Landmarks<Rooms> landmarks(graph, 1);
    AG::Guided_search<Rooms> search(graph);
    search.use_landmarks(landmarks);
    const auto point = [&] {
      return Intrinsic_point::at_vertex(
          static_cast<std::uint32_t>(random.below(mesh.num_vertices())));
    };
    for(int k = 0; k < 10; ++k)
    {
      const double limit = i % 3 == 0 ? infinity : random.between(0, 4);
      const std::vector<AG::Point_pair> pair = {{point(), point()}};
      AG::Surface_search<Rooms> other(graph);
      const double expected = AG::pair_distances(other, pair, limit)[0];
      const double found = AG::pair_distances(search, pair, limit)[0];
      EXPECT_TRUE(found == expected || std::abs(found - expected) <= 1e-13 * expected)
          << found << " for " << expected;
    }
  }
}

// Far fewer nodes are expanded, although the cheap way is not the straight one.
TEST(Landmarks, lead_to_the_target)
{
  Random random(test_seed());
  const std::size_t columns = 40;
  const Mesh mesh = to_mesh(terrain(columns, columns, random));
  const Weights weights = weights_by_place(mesh, [](const Point& p) {
    const bool is_wall = p.x() > 20 && p.x() < 21 && p.y() > 3;
    return is_wall ? infinity : p.y() > 20 ? 3. : 1.;
  });
  const auto graph = steiner_graph(mesh, weights, Fixed_number_of_points(2));
  const AG::Landmarks<Steiner_graph<Fixed_number_of_points>> landmarks(graph);
  AG::Guided_search<Steiner_graph<Fixed_number_of_points>, AG::Binary_heap_queue> search(graph);
  const auto vertex = [&](const std::size_t x, const std::size_t y) {
    return Intrinsic_point::at_vertex(graph.triangulation().vertex(x + columns * y));
  };
  search.collect_statistics(true);
  const auto number_settled = [&] {
    search.run_to(vertex(32, 30), {{vertex(8, 24)}});
    return search.search().statistics().settled_nodes;
  };
  const std::size_t number = number_settled();
  search.use_landmarks(landmarks);
  EXPECT_LT(number_settled(), number / 4);
}

TEST(Landmarks, lead_lists_of_pairs)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  const Weights weights = random_weights(mesh, random, 1, 3);
  const auto graph = steiner_graph(mesh, weights, Fixed_number_of_points(1));
  const AG::Landmarks<Steiner_graph<Fixed_number_of_points>> landmarks(graph, 8);
  AG::Surface_search<Steiner_graph<Fixed_number_of_points>> search(graph);
  AG::Guided_search<Steiner_graph<Fixed_number_of_points>> led(graph);
  led.use_landmarks(landmarks);
  std::vector<AG::Point_pair> pairs;
  for(std::uint32_t i = 0; i < 20; ++i)
    pairs.emplace_back(Intrinsic_point::at_vertex(17 * i),
                       Intrinsic_point::at_vertex(13 * i + 100));
  pairs.emplace_back(pairs[3].first, pairs[4].first); // two with the same source
  const auto expected = AG::pair_distances(search, pairs), found = AG::pair_distances(led, pairs);
  for(std::size_t i = 0; i < pairs.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-13 * expected[i]);
  for(std::size_t i = 0; i < pairs.size(); ++i) // whatever the others are
    EXPECT_EQ(AG::pair_distances(led, {pairs[i]})[0], found[i]);
  const auto limited = AG::pair_distances(led, pairs, expected[0]),
             wanted = AG::pair_distances(search, pairs, expected[0]);
  for(std::size_t i = 1; i < pairs.size(); ++i)
    EXPECT_EQ(std::isinf(limited[i]), std::isinf(wanted[i]));
}

TEST(Landmarks, lead_the_class)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  const Weights weights = random_weights(mesh, random, 1, 3);
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>>;
  Paths paths(mesh, steiner_graph(mesh, weights, Fixed_number_of_points(1)));
  AG::Pair_queries queries(paths);
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for(Mesh::size_type i = 0; i < 20; ++i)
    pairs.emplace_back(Vertex(17 * i), Vertex(13 * i + 100));
  const auto expect = [&](const std::vector<double>& expected) {
    const std::vector<double> found = queries.distances(pairs);
    for(std::size_t i = 0; i < pairs.size(); ++i)
    {
      EXPECT_NEAR(found[i], expected[i], 1e-13 * expected[i]);
      EXPECT_NEAR(queries.shortest_distance(pairs[i].first, pairs[i].second), expected[i],
                  1e-13 * expected[i]);
    }
  };
  const std::vector<double> expected = queries.distances(pairs);
  queries.prepare();
  expect(expected);
  std::vector<std::pair<Face, double>> changes;
  for(Mesh::size_type i = 0; i < 100; ++i)
    changes.emplace_back(Face(7 * i), 0.1);
  paths.set_weights(changes);
  AG::Surface_search<Steiner_graph<Fixed_number_of_points>> search(paths.graph());
  std::vector<AG::Point_pair> changed;
  for(const auto& [source, target] : pairs)
    changed.emplace_back(
        Intrinsic_point::at_vertex(paths.graph().triangulation().vertex(source.idx())),
        Intrinsic_point::at_vertex(paths.graph().triangulation().vertex(target.idx())));
  expect(AG::pair_distances(search, changed));
  queries.prepare(4);
  expect(AG::pair_distances(search, changed));
}

// After weights have changed, bounds need not hold.
TEST(Landmarks, are_not_used_after_changes)
{
  const Mesh mesh = to_mesh(flat_grid(12, 12));
  auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 4), Fixed_number_of_points(1));
  using Graph_with_points = Steiner_graph<Fixed_number_of_points>;
  const AG::Landmarks<Graph_with_points> landmarks(graph, 4);
  AG::Surface_search<Graph_with_points> search(graph);
  AG::Guided_search<Graph_with_points> led(graph);
  led.use_landmarks(landmarks);
  std::vector<AG::Weight_change> changes;
  const Triangulation& triangulation = graph.triangulation();
  for(std::uint32_t h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(!triangulation.is_border(h) && triangulation.source(h) % 3 == 0)
      changes.push_back({h, 1});
  graph.set_weights(changes);
  EXPECT_FALSE(landmarks.are_valid());
  EXPECT_FALSE(led.uses_landmarks());
  const auto source = Intrinsic_point::at_vertex(0);
  for(std::uint32_t v = 0; v < triangulation.number_of_vertices(); ++v)
  {
    const auto target = Intrinsic_point::at_vertex(v);
    search.run({{source}}, {infinity, {target}});
    led.run_to(target, {{source}});
    EXPECT_EQ(led.distance(target), search.distance(target));
  }
}

// Doors that open make new ways, for which bounds do not hold; when they are closed again, the
// graph still is another one.
TEST(Landmarks, are_not_used_after_barriers_were_lifted)
{
  const Mesh mesh = to_mesh(flat_grid(12, 12));
  Barriers barriers(mesh.num_edges());
  std::vector<std::pair<Edge, bool>> open, closed;
  for(const Edge e : mesh.edges())
    if(mesh.point(mesh.vertex(e, 0)).x() == 6 && mesh.point(mesh.vertex(e, 1)).x() == 6)
    {
      barriers[e.idx()] = true;
      open.emplace_back(e, false);
      closed.emplace_back(e, true);
    }
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>>;
  const auto graph = [&] {
    return Steiner_graph<Fixed_number_of_points>(Triangulation(mesh, with_barriers(barriers)),
                                                 Fixed_number_of_points(1));
  };
  Paths paths(mesh, graph()), others(mesh, graph());
  AG::Pair_queries led(paths);
  const auto expect_same = [&](const double rounding) {
    for(Mesh::size_type i = 0; i < mesh.num_vertices(); i += 5)
    {
      const double expected = others.shortest_distance(Vertex(14), Vertex(i));
      EXPECT_NEAR(led.shortest_distance(Vertex(14), Vertex(i)), expected, rounding);
    }
  };
  led.prepare(4);
  for(const bool is_closed : {false, true})
  {
    paths.set_barriers(is_closed ? closed : open);
    others.set_barriers(is_closed ? closed : open);
    expect_same(0);
    EXPECT_EQ(led.shortest_distance(Vertex(14), Vertex(10)) < 0, is_closed);
  }
  paths.set_barriers(open);
  others.set_barriers(open);
  led.prepare(4);
  expect_same(1e-12);
}

// Expects that pairs are at most 1.1 times as far as in a graph that is much finer.
void expect_bound_of_pairs(const Mesh& mesh,
                           const Weights& weights,
                           const std::vector<Intrinsic_point>& sources,
                           const double epsilon_of_fine_graph)
{
  const auto graph = steiner_graph(mesh, weights, Geometric_points(0.1));
  const auto fine = steiner_graph(mesh, weights, Geometric_points(epsilon_of_fine_graph));
  const AG::Landmarks<Steiner_graph<>> landmarks(graph);
  AG::Guided_search<Steiner_graph<>> led(graph);
  AG::Surface_search<Steiner_graph<>> all(fine);
  led.use_landmarks(landmarks);
  double largest = 0;
  for(const Intrinsic_point& source : sources)
  {
    all.run({{source}});
    for(std::uint32_t v = 0; v < mesh.num_vertices(); ++v)
    {
      const auto target = Intrinsic_point::at_vertex(v);
      led.run_to(target, {{source}});
      const double found = led.distance(target), expected = all.distance(target);
      ASSERT_GE(found * (1 + epsilon_of_fine_graph), expected * (1 - 1e-12));
      ASSERT_LE(found, 1.1 * expected);
      if(expected > 0 && expected < infinity)
        largest = (std::max)(largest, found / expected - 1);
    }
  }
  std::cout << "at most " << 100 * largest << " % longer, of "
            << sources.size() * mesh.num_vertices() << " pairs" << std::endl;
}

// Ground of four kinds, with holes.
void expect_bound_on_terrain(const std::size_t side, const std::size_t number_of_sources)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(side, side, random));
  const Weights weights = weights_by_place(mesh, [&](const Point& p) {
    constexpr std::array<double, 4> kinds = {1, 1.5, 2.5, 4};
    const auto column = static_cast<std::size_t>(p.x()), row = static_cast<std::size_t>(p.y());
    return column % 4 == 2 && row % 4 == 2 ? infinity : kinds[(column / 5 + 3 * (row / 5)) % 4];
  });
  std::vector<Intrinsic_point> sources;
  for(std::size_t i = 0; i < number_of_sources; ++i)
    sources.push_back(
        Intrinsic_point::at_vertex(static_cast<std::uint32_t>(random.below(mesh.num_vertices()))));
  expect_bound_of_pairs(mesh, weights, sources, 0.02);
}

TEST(Pairs_with_landmarks, keep_the_bound) { expect_bound_on_terrain(12, 8); }

TEST(Pairs_with_landmarks, keep_the_bound_very_often) { expect_bound_on_terrain(21, 250); }

// Thousands of points on their sides, and many arcs that are left out.
TEST(Pairs_with_landmarks, keep_the_bound_beside_thin_faces)
{
  Random random(test_seed());
  for(const double angle : {0.05, 0.005})
    for(const double range : {1.2, 30.})
      for(const Soup& soup : thin_soups(angle))
      {
        const Mesh mesh = to_mesh(soup);
        std::vector<Intrinsic_point> sources;
        for(std::uint32_t v = 0; v < mesh.num_vertices(); ++v)
          sources.push_back(Intrinsic_point::at_vertex(v));
        expect_bound_of_pairs(mesh, random_weights(mesh, random, 1, range), sources, 0.03);
      }
}

TEST(Landmarks, are_in_the_largest_part)
{
  Soup soup = flat_grid(3, 3);
  soup.append(flat_grid(6, 6));
  soup.append(flat_grid(4, 4));
  const Mesh mesh = to_mesh(soup);
  const Graph graph{Triangulation(mesh)};
  const AG::Landmarks<Graph> landmarks(graph, 4);
  for(const auto node : landmarks.nodes())
  {
    const std::size_t i = graph.triangulation().index(node);
    EXPECT_GE(i, 9u);
    EXPECT_LT(i, 9u + 36u);
  }
}

TEST(Landmarks, are_those_of_the_graph)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const AG::Edge_graph graph{Triangulation(mesh)}, other{Triangulation(mesh)};
  const AG::Landmarks<AG::Edge_graph> landmarks(graph, 2);
  AG::Guided_search<AG::Edge_graph> search(other);
  expect_message<std::invalid_argument>([&] { search.use_landmarks(landmarks); },
                                        "the landmarks are those of another graph");
}

TEST(Landmarks, are_at_least_one)
{
  const Graph graph{Triangulation(to_mesh(flat_grid(3, 3)))};
  expect_message<std::invalid_argument>([&] { AG::Landmarks<Graph>(graph, 0); },
                                        "number of landmarks");
  const AG::Landmarks<Graph> many(graph, 100); // more than nodes
  EXPECT_EQ(many.nodes().size(), 100u);
  const Graph empty;
  EXPECT_EQ(AG::Landmarks<Graph>(empty).nodes().size(), AG::Landmarks<Graph>::DEFAULT_NUMBER);
}

} // namespace
