// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/fixed_bucket_width.h"
#include "oracles/Implicit_square.h"
#include "oracles/test_oracles.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

// Models of the concepts that have nothing more than these ask for.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using CGAL::Approximate_geodesics::Adaptive_bucket_queue;
using CGAL::Approximate_geodesics::Arc_lengths;
using CGAL::Approximate_geodesics::Basic_adaptive_bucket_queue;
using CGAL::Approximate_geodesics::Propagation;

// A sorted set, in which a key is final when a larger one has come out.
class Set_queue
{
public:
  using Node = std::uint32_t;
  using Key = double;
  using Entry = std::pair<Key, Node>;
  using Batch = std::array<Entry, 1>;

  Set_queue(std::size_t /* number_of_nodes */, const Arc_lengths&) {}

  bool is_empty() const { return m_entries.empty(); }
  void push(const Node node, const Key key) { m_entries.insert({key, node}); }

  Batch extract_min()
  {
    const Entry result = *m_entries.begin();
    m_entries.erase(m_entries.begin());
    m_last = result.first;
    return {result};
  }

  bool is_final(const Key key) const { return key < m_last; }

  template <typename F>
  void for_each_node(F f) const
  {
    for(const Entry& e : m_entries)
      f(e.second);
  }

  void clear()
  {
    m_entries.clear();
    m_last = 0;
  }

  std::size_t memory() const { return m_entries.size() * sizeof(Entry); }

private:
  std::set<Entry> m_entries;
  Key m_last = 0;
};

template <typename Queue>
class Queues : public testing::Test
{
};
using All_queues = testing::Types<Adaptive_bucket_queue,
                                  Basic_adaptive_bucket_queue<Fixed_bucket_width>,
                                  Set_queue,
                                  AG::Array_queue,
                                  AG::Binary_heap_queue,
                                  AG::D_ary_heap_queue<4>,
                                  AG::Fibonacci_heap_queue,
                                  AG::Pairing_heap_queue,
                                  AG::Radix_heap_queue,
                                  AG::Published_bucket_queue,
                                  AG::Basic_published_bucket_queue<Fixed_bucket_width>,
                                  AG::Basic_adaptive_bucket_queue<AG::Published_bucket_width>>;
TYPED_TEST_SUITE(Queues, All_queues, );

TYPED_TEST(Queues, search_a_graph_of_implicit_arcs)
{
  const Implicit_square graph(60);
  Propagation<Implicit_square, TypeParam> search(graph);
  for(const std::uint32_t source : {0u, 61u, 1830u})
  {
    search.run_from(source);
    for(std::uint32_t n = 0; n < 3600; ++n)
    {
      const double x = std::abs(double(n % 60) - double(source % 60));
      const double y = std::abs(double(n / 60) - double(source / 60));
      ASSERT_EQ(search.distance(n), x * Implicit_square::dx + y * Implicit_square::dy);
      EXPECT_EQ(search.source(n), 0u);
    }
  }
}

// All queues give the same bits, in full runs and in those that end early.
TYPED_TEST(Queues, give_the_same_distances)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    Mesh_search reference(named.mesh);
    Propagation<Graph, TypeParam> search(reference.graph());
    for(std::size_t run = 0; run < 8; ++run)
    {
      const auto seeds =
          reference.seeds({random_vertex(named.mesh, random), random_vertex(named.mesh, random)});
      typename Propagation<Graph, TypeParam>::Stop_rule stop;
      if(run % 3 == 1)
        stop.maximum_distance = random.between(0, 40);
      if(run % 3 == 2)
        stop.targets = {reference.node(random_vertex(named.mesh, random))};
      std::vector<typename Propagation<Graph, TypeParam>::Seed> same_seeds;
      for(const auto& seed : seeds)
        same_seeds.push_back({seed.node, seed.distance, seed.source});
      search.run(same_seeds, stop);
      reference.search().run(seeds, {stop.maximum_distance, {}});
      for(Node n = 0; n < named.mesh.number_of_vertices(); ++n)
        if(stop.targets.empty() || search.is_reached(n))
        {
          ASSERT_EQ(search.distance(n), reference.search().distance(n)) << "node " << n;
        }
      for(const Node n : stop.targets)
        EXPECT_EQ(search.distance(n), reference.search().distance(n));
    }
  }
}

TYPED_TEST(Queues, end_early_with_final_distances_only)
{
  const Implicit_square graph(60);
  using Square_search = Propagation<Implicit_square, TypeParam>;
  Square_search full(graph), part(graph);
  full.run({{1830, 0, 0}});
  typename Square_search::Stop_rule stop;
  stop.targets = {1845, 1810};
  part.run({{1830, 0, 0}}, stop);
  std::size_t number_reached = 0;
  for(std::uint32_t n = 0; n < 3600; ++n)
    if(part.is_reached(n))
    {
      ++number_reached;
      EXPECT_EQ(part.distance(n), full.distance(n));
    }
  EXPECT_EQ(part.distance(1810), 20 * Implicit_square::dx);
  EXPECT_LT(number_reached, 1000u);
  EXPECT_GT(number_reached, 30u);
}

// The class takes any of them, too.
template <typename Queue>
class Queues_of_the_class : public testing::Test
{
};
using Two_queues = testing::Types<Set_queue, AG::Binary_heap_queue>;
TYPED_TEST_SUITE(Queues_of_the_class, Two_queues, );

TYPED_TEST(Queues_of_the_class, give_the_same_distances)
{
  Mesh mesh = to_mesh(flat_grid(20, 30));
  AG::Surface_mesh_shortest_path<Mesh, Graph> expected(mesh);
  AG::Surface_mesh_shortest_path<Mesh, Graph, TypeParam> shortest_paths(mesh);
  const auto distance = mesh.add_property_map<Vertex, double>("distance").first;
  for(const Vertex source : {Vertex(0), Vertex(333)})
  {
    expected.remove_all_source_points();
    shortest_paths.remove_all_source_points();
    expected.add_source_point(source);
    shortest_paths.add_source_point(source);
    CGAL::approximate_geodesic_distances(mesh, distance, source);
    for(const Vertex v : mesh.vertices())
    {
      const double d = expected.shortest_distance_to_source_points(v).first;
      EXPECT_EQ(shortest_paths.shortest_distance_to_source_points(v).first, d);
      EXPECT_EQ(distance[v], d);
    }
    std::vector<Point> path;
    EXPECT_EQ(CGAL::approximate_geodesic_path(mesh, std::back_inserter(path), source, Vertex(77)),
              distance[Vertex(77)]);
    EXPECT_GT(path.size(), 1u);
  }
}

} // namespace
