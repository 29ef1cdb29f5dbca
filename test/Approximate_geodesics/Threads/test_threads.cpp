// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/surface_points.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <iterator>
#include <thread>
#include <vector>

// What several threads may do at the same time gives what one thread gives alone. The thread
// sanitizer says whether they may.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Values = std::vector<double>;

constexpr std::size_t number_of_threads = 4;

// Calls `task(i)` for `i` below the number of threads in one thread after the other, and then in
// all of them at the same time.
template <typename Task>
void expect_same_from_all_threads(Task task)
{
  std::vector<Values> expected, found(number_of_threads);
  for(std::size_t i = 0; i < number_of_threads; ++i)
    expected.push_back(task(i));
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < number_of_threads; ++i)
    threads.emplace_back([&, i] { found[i] = task(i); });
  for(std::thread& thread : threads)
    thread.join();
  for(std::size_t i = 0; i < number_of_threads; ++i)
    EXPECT_TRUE(have_same_bits(found[i], expected[i])) << "thread " << i;
}

Mesh small_terrain()
{
  Random random(test_seed());
  return to_mesh(terrain(25, 20, random));
}

// Distances from a few sources that are different in each thread, and that others have, too.
template <typename GeodesicGraph>
Values distances(const GeodesicGraph& graph, const std::size_t thread)
{
  Values result;
  for(const std::size_t source : {3 * thread, std::size_t(77), 13 + 20 * thread})
  {
    AG::Propagation<GeodesicGraph> search(graph);
    search.run_from(static_cast<typename GeodesicGraph::Node>(source));
    const Values found = distances_of_nodes(search);
    result.insert(result.end(), found.begin(), found.end());
    result.push_back(static_cast<double>(search.source(7)));
  }
  return result;
}

TEST(Threads, may_share_a_graph_of_any_kind)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(10, 8, random));
  for_each_graph(1, [&](const auto& kind) {
    const auto graph = kind.make(Triangulation(mesh));
    expect_same_from_all_threads([&](const std::size_t i) { return distances(graph, i); });
  });
}

// Arcs that nobody has asked for before are computed by several threads at the same time.
TEST(Threads, may_share_a_graph_that_keeps_its_arcs)
{
  const Mesh mesh = small_terrain();
  const auto kind = lazy_graph(0.1, Lazy_discrete_geodesic_graph::Arcs::KEPT);
  const auto built = discrete_geodesic_graph(0.1).make(Triangulation(mesh));
  const auto graph = kind.make(Triangulation(mesh));
  std::vector<std::thread> threads;
  std::vector<Values> found(number_of_threads);
  for(std::size_t i = 0; i < number_of_threads; ++i)
    threads.emplace_back([&, i] { found[i] = distances(graph, i); });
  for(std::thread& thread : threads)
    thread.join();
  for(std::size_t i = 0; i < number_of_threads; ++i)
    EXPECT_TRUE(have_same_bits(found[i], distances(built, i)));
}

// The first thread uses the object, and the others its graph.
template <typename GeodesicGraph>
void expect_graph_to_be_shared(const Kind_of_graph<GeodesicGraph>& kind)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph>;
  const Mesh mesh = small_terrain();
  Random random(test_seed());
  const Face_location source = random_face_location(mesh, random);
  Paths paths(mesh, kind.make(Triangulation(mesh)));
  const auto ask = [&] {
    paths.remove_all_source_points();
    paths.add_source_point(source);
    Values result;
    for(const Vertex v : {Vertex(5), Vertex(499)})
    {
      std::vector<Point> points;
      result.push_back(
          paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first);
      result.push_back(paths.shortest_distance(v, source));
      result.push_back(static_cast<double>(points.size()));
    }
    return result;
  };
  expect_same_from_all_threads(
      [&](const std::size_t i) { return i == 0 ? ask() : distances(paths.graph(), i); });
}

TEST(Threads, may_share_the_graph_of_an_object)
{
  expect_graph_to_be_shared(edge_graph());
  expect_graph_to_be_shared(discrete_geodesic_graph(0.2));
  expect_graph_to_be_shared(graph_with_spaced_points(1));
}

TEST(Threads, may_have_an_object_each)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>;
  const Mesh mesh = small_terrain();
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

class Threads_with_a_mesh : public testing::Test
{
protected:
  auto map(Values& distances) const
  {
    distances.resize(m_mesh.number_of_vertices());
    return boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
  }

  static Vertex vertex(const std::size_t i) { return Vertex(static_cast<Mesh::size_type>(i)); }

  const Mesh m_mesh = small_terrain();
};

TEST_F(Threads_with_a_mesh, may_find_distances)
{
  const Weights weights(m_mesh.number_of_faces(), 2);
  expect_same_from_all_threads([&](const std::size_t i) {
    Values result;
    if(i == 0)
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i));
    else if(i == 1)
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i),
                                           parameters::face_weight_map(weight_map(weights)));
    else
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i),
                                           parameters::epsilon(0.1));
    return result;
  });
}

TEST_F(Threads_with_a_mesh, may_find_paths_and_samples)
{
  expect_same_from_all_threads([&](const std::size_t i) {
    std::vector<Point> points;
    std::vector<Vertex> samples;
    Values result = {
        CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), vertex(i), vertex(499),
                                        parameters::epsilon(0.1).straighten(true)),
        AG::farthest_point_sampling(m_mesh, std::back_inserter(samples), 5, vertex(i))};
    for(const Point& p : points)
      result.insert(result.end(), {p.x(), p.y(), p.z()});
    for(const Vertex v : samples)
      result.push_back(v.idx());
    return result;
  });
}

TEST_F(Threads_with_a_mesh, may_evaluate_a_field)
{
  Values field;
  const auto field_map = map(field);
  CGAL::approximate_geodesic_distances(m_mesh, field_map, vertex(3));
  expect_same_from_all_threads([&](const std::size_t i) {
    std::vector<std::vector<Point>> polylines;
    AG::isolines(m_mesh, field_map, std::vector<double>{3, 5 + double(i)},
                 std::back_inserter(polylines));
    Values result(m_mesh.number_of_faces());
    AG::voronoi_partition(
        m_mesh, boost::make_iterator_property_map(result.begin(), get(CGAL::face_index, m_mesh)),
        std::vector<Vertex>{vertex(0), vertex(30 * i + 60)});
    for(const auto& polyline : polylines)
      for(const Point& p : polyline)
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
  std::thread other([&] { found = distances(built_in_parallel(mesh), 1); });
  EXPECT_TRUE(have_same_bits(distances(built_in_parallel(mesh), 0), distances(graph, 0)));
  other.join();
  EXPECT_TRUE(have_same_bits(found, distances(graph, 1)));
}

TEST(Parallel_build, gives_the_class_the_same_graph)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>;
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(50, 45, random));
  const auto graph = discrete_geodesic_graph(1).make(Triangulation(mesh));
  const Paths paths(mesh, parameters::epsilon(1.).concurrency_tag(CGAL::Parallel_tag()));
  EXPECT_TRUE(have_same_bits(distances(paths.graph(), 0), distances(graph, 0)));
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
  const Values expected = distances(alone, 0), found = distances(together, 0);
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-12 * expected[i]);
  EXPECT_TRUE(have_same_bits(found, distances(together, 0)));
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

// Rows that threads compute, for a sink and for a function object.
TEST(Parallel_matrix, has_the_same_rows)
{
  const Mesh mesh = small_terrain();
  const auto graph = discrete_geodesic_graph(0.5).make(Triangulation(mesh));
  std::vector<std::size_t> sources;
  for(std::size_t i = 0; i < 200; ++i)
    sources.push_back(7 * i % mesh.number_of_vertices());
  const auto find = [&](const auto& np) {
    Dense_rows<> dense;
    Radius_rows<> within_radius;
    Matrix rows;
    const auto append = [&](std::size_t, const Distance_row& row) {
      rows.emplace_back(row.begin(), row.end());
    };
    CGAL::approximate_geodesic_distance_matrix(graph, dense, sources, np);
    CGAL::approximate_geodesic_distance_matrix(graph, within_radius, sources,
                                               np.maximum_distance(5));
    CGAL::approximate_geodesic_distance_matrix(graph, append, sources, np);
    EXPECT_TRUE(are_the_same(rows, matrix_of(dense)));
    EXPECT_TRUE(are_the_same(entries_of(within_radius), within(5, rows)));
    return rows;
  };
  EXPECT_TRUE(are_the_same(find(parameters::concurrency_tag(CGAL::Parallel_tag())),
                           find(parameters::concurrency_tag(CGAL::Sequential_tag()))));
}

// While they are asked whether to go on, and another thread says no.
TEST(Parallel_matrix, may_be_ended_by_another_thread)
{
  struct Visitor : AG::Distance_matrix_visitor_base
  {
    bool go_further() { return !is_canceled; }
    std::atomic<bool> is_canceled{false};
  };
  const Mesh mesh = small_terrain();
  Visitor visitor;
  std::size_t number = 0;
  const auto count = [&](const std::size_t row, const Distance_row&) {
    number = row + 1;
    if(row == 100)
      std::thread([&] { visitor.is_canceled = true; }).join();
  };
  const std::vector<Vertex> sources(10000, Vertex(3));
  EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(
      mesh, count, sources,
      parameters::concurrency_tag(CGAL::Parallel_tag()).visitor(std::ref(visitor))));
  EXPECT_GT(number, 100u);
  EXPECT_LT(number, sources.size());
}

#endif

} // namespace
