// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_of_all_kinds.h"
#include "meshes/surface_points.h"
#include "threads/same_from_all_threads.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <thread>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST(Threads, may_share_a_graph_of_any_kind)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(10, 8, random));
  for_each_graph(1, [&](const auto& kind) {
    const auto graph = kind.make(Triangulation(mesh));
    expect_same_from_all_threads(
        [&](const std::size_t i) { return distances_for_thread(graph, i); });
  });
}

// Arcs that nobody has asked for before are computed by several threads at the same time.
TEST(Threads, may_share_a_graph_that_keeps_its_arcs)
{
  const Mesh mesh = mesh_for_threads();
  const auto kind = lazy_graph(0.1, Lazy_discrete_geodesic_graph::Arcs::KEPT);
  const auto built = discrete_geodesic_graph(0.1).make(Triangulation(mesh));
  const auto graph = kind.make(Triangulation(mesh));
  std::vector<std::thread> threads;
  std::vector<Values> found(number_of_threads);
  for(std::size_t i = 0; i < number_of_threads; ++i)
    threads.emplace_back([&, i] { found[i] = distances_for_thread(graph, i); });
  for(std::thread& thread : threads)
    thread.join();
  for(std::size_t i = 0; i < number_of_threads; ++i)
    EXPECT_TRUE(have_same_bits(found[i], distances_for_thread(built, i)));
}

TEST(Threads, may_share_the_graph_of_an_object)
{
  expect_graph_to_be_shared(edge_graph());
  expect_graph_to_be_shared(discrete_geodesic_graph(0.2));
}

TEST(Threads, may_have_an_object_each)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>;
  const Mesh mesh = mesh_for_threads();
  const Discrete_geodesic_graph graph = discrete_geodesic_graph(0.2).make(Triangulation(mesh));
  expect_same_from_all_threads([&](const std::size_t i) {
    Paths paths(mesh, graph); // a copy
    paths.add_source_point(Vertex(static_cast<Mesh::size_type>(i)));
    Values result;
    for(const Vertex v : mesh.vertices())
      result.push_back(
          paths
              .shortest_path_points_to_source_points(v, CGAL::Emptyset_iterator(),
                                                     parameters::straighten(v.idx() % 9 == 0))
              .first);
    return result;
  });
}

// ----- functions

TEST_F(Threads_with_a_mesh, may_find_distances)
{
  expect_same_from_all_threads([&](const std::size_t i) {
    Values result;
    if(i == 0)
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i));
    else if(i == 1)
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i), parameters::epsilon(0));
    else
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i),
                                           parameters::epsilon(0.1));
    return result;
  });
}

TEST_F(Threads_with_a_mesh, may_find_paths)
{
  expect_same_from_all_threads([&](const std::size_t i) {
    std::vector<Point> points;
    Values result = {CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), vertex(i),
                                                     vertex(499),
                                                     parameters::epsilon(0.1).straighten(true))};
    for(const Point& p : points)
      result.insert(result.end(), {p.x(), p.y(), p.z()});
    return result;
  });
}

// ----- graphs that are built by several threads

#ifdef CGAL_LINKED_WITH_TBB

Discrete_geodesic_graph built_in_parallel(const Mesh& mesh)
{
  return Discrete_geodesic_graph(Triangulation(mesh),
                                 parameters::epsilon(1.).concurrency_tag(CGAL::Parallel_tag()));
}

TEST(Parallel_build, may_take_place_in_two_threads_at_a_time)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(50, 45, random)); // several blocks
  const auto graph = discrete_geodesic_graph(1).make(Triangulation(mesh));
  Values found;
  std::thread other([&] { found = distances_for_thread(built_in_parallel(mesh), 1); });
  EXPECT_TRUE(have_same_bits(distances_for_thread(built_in_parallel(mesh), 0),
                             distances_for_thread(graph, 0)));
  other.join();
  EXPECT_TRUE(have_same_bits(found, distances_for_thread(graph, 1)));
}

TEST(Parallel_build, gives_the_class_the_same_graph)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>;
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(50, 45, random));
  const auto graph = discrete_geodesic_graph(1).make(Triangulation(mesh));
  const Paths paths(mesh, parameters::epsilon(1.).concurrency_tag(CGAL::Parallel_tag()));
  EXPECT_TRUE(
      have_same_bits(distances_for_thread(paths.graph(), 0), distances_for_thread(graph, 0)));
}

TEST(Parallel_build, reads_the_same_triangulation)
{
  Random random(test_seed());
  for(const Mesh& mesh : {to_mesh(terrain(70, 65, random)), to_mesh(sphere(90, 60))})
  {
    const Triangulation alone(mesh);
    const Triangulation together(mesh, parameters::concurrency_tag(CGAL::Parallel_tag()));
    EXPECT_EQ(together.targets(), alone.targets());
    EXPECT_TRUE(have_same_bits(together.lengths(), alone.lengths()));
    EXPECT_TRUE(together.is_valid());
  }
}

// Threads that search from one source.
TEST(Parallel_search, gives_the_same_distances)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(50, 45, random));
  const AG::Saddle_vertex_graph alone{Triangulation(mesh)};
  const AG::Saddle_vertex_graph together(Triangulation(mesh),
                                         parameters::concurrency_tag(CGAL::Parallel_tag()));
  const Values expected = distances_for_thread(alone, 0), found = distances_for_thread(together, 0);
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-12 * expected[i]);
  EXPECT_TRUE(have_same_bits(found, distances_for_thread(together, 0)));
}

// Many sources make long fronts, which keep threads busy.
TEST(Parallel_search, gives_the_same_distances_across_faces)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(70, 65, random)); // more than one block
  std::vector<AG::Seed> seeds;
  for(Node v = 0; v < 100; ++v)
    seeds.push_back({v, 0.01 * v});
  const auto find = [&](const auto& np, const Lazy_discrete_geodesic_graph::Arcs arcs) {
    const Lazy_discrete_geodesic_graph graph(Triangulation(mesh, np), np, arcs);
    AG::Propagation<Lazy_discrete_geodesic_graph> search(graph);
    search.run(seeds);
    return distances_of_nodes(search);
  };
  const auto alone = parameters::epsilon(0.1);
  const auto together = alone.concurrency_tag(CGAL::Parallel_tag());
  using Arcs = Lazy_discrete_geodesic_graph::Arcs;
  EXPECT_TRUE(have_same_bits(find(together, Arcs::KEPT), find(alone, Arcs::KEPT)));
  const Values found = find(together, Arcs::FORGOTTEN);
  EXPECT_TRUE(have_same_bits(found, find(together, Arcs::FORGOTTEN)));
  const Values expected = find(alone, Arcs::FORGOTTEN);
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 0.1 * expected[i]);
}

#endif

} // namespace
