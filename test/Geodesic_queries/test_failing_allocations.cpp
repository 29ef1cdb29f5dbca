// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/test_weights.h"

#include <CGAL/Geodesic_queries/Portal_labels.h>

#include <gtest/gtest.h>

#include <ios>
#include <sstream>
#include <string>
#include <type_traits>

// Every allocation fails once. What was going on ends with an exception, loses no memory, and can
// be done again.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

Weights small_weights(const Mesh& mesh)
{
  Random random(test_seed());
  return random_weights(mesh, random, 0.5, 2);
}

template <typename GeodesicGraph>
Values distances_in(const GeodesicGraph& graph)
{
  AG::Propagation<GeodesicGraph> search(graph);
  search.run_from(Node(3));
  return distances_of_nodes(search);
}

// ----- triangulations and graphs

TEST(Interrupted_construction, of_a_triangulation)
{
  const Mesh mesh = small_terrain();
  const Weights weights = small_weights(mesh);
  Random random(test_seed());
  const Barriers barriers = random_barriers(mesh, 0.1, random);
  expect_survival([&] { return Triangulation(mesh).lengths(); });
  expect_survival([&] {
    const Triangulation t(mesh, parameters::face_weight_map(weight_map(weights))
                                    .edge_is_constrained_map(barrier_map(barriers)));
    Values result;
    for(Node h = 0; h < t.number_of_halfedges(); ++h)
      result.push_back(t.weight(h) + (t.is_barrier(h) ? 1e9 : 0));
    return result;
  });
}

TEST(Interrupted_construction, of_graphs)
{
  const Mesh mesh = small_terrain();
  for_each_graph(1, [&](const auto& kind) {
    expect_survival([&] { return distances_in(kind.make(Triangulation(mesh))); });
  });
}

TEST(Interrupted_construction, of_labels_at_portals)
{
  const AG::Edge_graph graph{Triangulation(to_mesh(flat_grid(15, 10)))};
  expect_survival([&] {
    const AG::Portal_labels<AG::Edge_graph> labels(graph);
    Values result;
    for(Node v = 0; v < 150; ++v)
      result.push_back(labels.distance_interval(7, v).second);
    return result;
  });
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Interrupted_construction, of_a_graph_by_several_threads)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(40, 30, random)); // two blocks
  expect_survival([&] {
    return distances_in(Discrete_geodesic_graph(
        Triangulation(mesh), parameters::epsilon(1.).concurrency_tag(CGAL::Parallel_tag())));
  });
}

// From all vertices of a side, so that there is enough for several threads to do.
TEST(Interrupted_search, by_several_threads)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(100, 5, random));
  const auto np = parameters::epsilon(1.).concurrency_tag(CGAL::Parallel_tag());
  const Lazy_discrete_geodesic_graph graph(Triangulation(mesh), np);
  std::vector<CGAL::Approximate_geodesics::Seed> seeds;
  for(Node v = 0; v < 100; ++v)
    seeds.push_back({v, 0});
  expect_survival([&] {
    CGAL::Approximate_geodesics::Propagation<Lazy_discrete_geodesic_graph> search(graph);
    search.run(seeds);
    return distances_of_nodes(search);
  });
}
#endif

class Interrupted_file : public testing::Test
{
protected:
  Interrupted_file()
    : m_mesh(small_terrain()), m_graph(discrete_geodesic_graph(0.1).make(Triangulation(m_mesh)))
  {
    std::ostringstream out(std::ios::binary);
    m_graph.save(out);
    m_file = out.str();
  }

  const Mesh m_mesh;
  const Discrete_geodesic_graph m_graph;
  std::string m_file;
};

TEST_F(Interrupted_file, is_read)
{
  expect_survival([&] {
    std::istringstream in(m_file, std::ios::binary);
    return distances_in(Discrete_geodesic_graph::load(in, Triangulation(m_mesh)));
  });
}

TEST_F(Interrupted_file, is_written_without_allocations)
{
  std::ostringstream out(std::string(m_file.size(), 'x'), std::ios::binary); // with room
  EXPECT_TRUE(needs_no_allocation([&] { m_graph.save(out); }));
  EXPECT_EQ(out.str(), m_file);
}

TEST(Interrupted_exchange_of_weights, has_changed_nothing)
{
  const Mesh mesh = small_terrain();
  const Weights before = small_weights(mesh), after(mesh.num_faces(), 3);
  for_each_graph_with_points(1, [&](const auto& kind) {
    using Steiner = typename std::decay_t<decltype(kind)>::Graph;
    const auto make = [&] { return kind.make(Triangulation(mesh, with_weights(before))); };
    const Values costs = distances_in(make());
    expect_survival<Steiner>(
        {make,
         [&](Steiner& graph) {
           graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(after)));
         },
         [](Steiner& graph) { return distances_in(graph); },
         [&](Steiner& graph) { EXPECT_TRUE(have_same_bits(distances_in(graph), costs)); }});
  });
}

} // namespace
