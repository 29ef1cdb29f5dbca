// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/test_weights.h"
#include "oracles/known_distances.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <variant>
#include <vector>

// Every queue on meshes that are as bad as they get gives the same distances.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// How much distances may depend on the order in which nodes are expanded.
template <typename GeodesicGraph>
double tolerance(const GeodesicGraph& graph)
{
  if constexpr(std::is_same_v<GeodesicGraph, AG::Lazy_discrete_geodesic_graph>)
    return graph.epsilon();
  else if constexpr(std::is_same_v<GeodesicGraph, AG::Edge_graph> ||
                    std::is_same_v<GeodesicGraph, AG::Discrete_geodesic_graph>)
    return 0;
  else
    return 1e-13; // arcs that are as good as others are left out
}

template <typename Queue, typename GeodesicGraph>
std::vector<double> distances(const GeodesicGraph& graph, const std::vector<Vertex>& sources)
{
  AG::Propagation<GeodesicGraph, Queue> search(graph);
  std::vector<typename AG::Propagation<GeodesicGraph, Queue>::Seed> seeds;
  for(const Vertex v : sources)
    seeds.push_back({graph.triangulation().vertex(v.idx())});
  for(int run = 0; run < 2; ++run) // queues learn
    search.run(seeds);
  return distances_of_nodes(search);
}

void expect_same(const std::vector<double>& found,
                 const std::vector<double>& expected,
                 const double tolerance)
{
  if(tolerance == 0)
  {
    EXPECT_TRUE(have_same_bits(found, expected));
    return;
  }
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    if(found[i] != expected[i])
    {
      EXPECT_LE(found[i], expected[i] * (1 + tolerance));
      EXPECT_GE(found[i] * (1 + tolerance), expected[i]);
    }
}

template <typename... Queues, typename GeodesicGraph>
void expect_same_distances(const GeodesicGraph& graph, const std::vector<Vertex>& sources)
{
  const std::vector<double> expected = distances<AG::Adaptive_bucket_queue>(graph, sources);
  (expect_same(distances<Queues>(graph, sources), expected, tolerance(graph)), ...);
}

// Calls `f(triangulation)` to make a graph for every mesh, with weights or without.
template <typename F>
void expect_same_distances_on_all_meshes(const F& make_graph)
{
  for(const Hostile_mesh& row : accepted_meshes())
  {
    if(!row.refusal_across_faces.empty())
      continue;
    SCOPED_TRACE(row.name);
    const auto graph = make_graph(row.mesh);
    std::vector<std::vector<Vertex>> lists(1);
    for(const Surface_point& p : some_vertices(row.mesh))
    {
      lists.push_back({std::get<Vertex>(p)});
      lists.front().push_back(std::get<Vertex>(p)); // all of them
    }
    for(const std::vector<Vertex>& sources : lists)
      expect_same_distances<AG::Binary_heap_queue, AG::D_ary_heap_queue<4>,
                            AG::Fibonacci_heap_queue, AG::Pairing_heap_queue, AG::Radix_heap_queue,
                            AG::Published_bucket_queue, AG::Array_queue>(graph, sources);
  }
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_along_edges)
{
  expect_same_distances_on_all_meshes([](const Mesh& mesh) { return Graph(Triangulation(mesh)); });
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_in_discrete_geodesic_graphs)
{
  expect_same_distances_on_all_meshes([](const Mesh& mesh) {
    return AG::Discrete_geodesic_graph(Triangulation(mesh), parameters::epsilon(0.1));
  });
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_in_lazy_graphs)
{
  expect_same_distances_on_all_meshes([](const Mesh& mesh) {
    return AG::Lazy_discrete_geodesic_graph(Triangulation(mesh), parameters::epsilon(0.1));
  });
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_among_points)
{
  expect_same_distances_on_all_meshes([](const Mesh& mesh) {
    return Steiner_graph<Fixed_number_of_points>(Triangulation(mesh), Fixed_number_of_points(2));
  });
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_among_points_with_weights)
{
  expect_same_distances_on_all_meshes([](const Mesh& mesh) {
    Weights weights(mesh.num_faces());
    for(std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = i % 5 == 0 ? 0 : i % 5 == 1 ? infinity : 1e-30 * double(i);
    return Steiner_graph<Fixed_number_of_points>(Triangulation(mesh, with_weights(weights)),
                                                 Fixed_number_of_points(2));
  });
}

} // namespace
