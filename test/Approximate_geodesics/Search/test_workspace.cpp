// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_recorder.h"
#include "oracles/test_oracles.h"
#include "peers/Published_bucket_queue.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

// A workspace that is used again and again, its figures, and threads.

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::Propagation;
using CGAL::Approximate_geodesics::Propagation_statistics;

class Workspace : public testing::Test
{
protected:
  // A run of a kind chosen at random; most end early, and some with an exception.
  static void disturb(Mesh_search& search, Random& random)
  {
    Recorder<Node> recorder;
    Search::Stop_rule stop;
    switch(random.below(4))
    {
    case 0:
      stop.maximum_distance = random.between(0, 20);
      break;
    case 1:
      stop.targets = {search.node(random_vertex(search.mesh(), random))};
      break;
    case 2:
      recorder.stop_at = random.below(search.mesh().number_of_vertices());
      break;
    default:
      recorder.throw_at = random.below(search.mesh().number_of_vertices());
    }
    const auto seeds =
        search.seeds({random_vertex(search.mesh(), random), random_vertex(search.mesh(), random)});
    try
    {
      search.search().run(seeds, stop, recorder);
    }
    catch(const std::runtime_error&)
    {
      EXPECT_EQ(recorder.settled.size(), recorder.throw_at);
      for(Node n = 0; n < search.mesh().number_of_vertices(); ++n)
      {
        EXPECT_FALSE(search.search().is_reached(n));
        EXPECT_EQ(search.search().distance(n), infinity);
        EXPECT_EQ(search.search().predecessor(n), Search::null_node);
        EXPECT_EQ(search.search().source(n), Search::null_source);
      }
      EXPECT_TRUE(search.search().reached_nodes().empty());
    }
  }
};

TEST_F(Workspace, remembers_nothing_of_earlier_runs)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    Mesh_search used(named.mesh);
    for(std::size_t run = 0; run < 25; ++run)
    {
      disturb(used, random);
      const std::vector<Vertex> sources = {random_vertex(named.mesh, random)};
      Search::Stop_rule stop;
      if(run % 2 == 0)
        stop.maximum_distance = random.between(0, 30);
      Mesh_search fresh(named.mesh);
      const Field expected = fresh.run(sources, stop), found = used.run(sources, stop);
      EXPECT_TRUE(have_same_bits(found.distance, expected.distance));
    }
  }
}

TEST_F(Workspace, gives_the_same_with_every_width_of_buckets)
{
  Random random(test_seed());
  // half the mean edge is far too wide a bucket where most edges are short
  const Mesh mesh = to_mesh(flat_grid(60, 60).transformed([&](const Point& p) {
    return Point(std::pow(p.x() + random.between(0, 0.5), 5),
                 std::pow(p.y() + random.between(0, 0.5), 5), 0);
  }));
  const std::vector<double> lengths = edge_lengths(mesh);
  Mesh_search search(mesh);
  std::set<double> widths;
  for(std::size_t run = 0; run < 30; ++run)
  {
    const Vertex source = random_vertex(mesh, random);
    const Field field = search.run({source});
    widths.insert(search.search().queue().statistics().width);
    EXPECT_TRUE(have_same_bits(field.distance, boost_distances(mesh, lengths, source)));
    EXPECT_TRUE(is_optimal(mesh, lengths, field, {source}));
  }
  EXPECT_GT(widths.size(), 1u); // or nothing was tested
}

void expect_identities(Mesh_search& search, const bool is_complete)
{
  const Propagation_statistics& s = search.search().statistics();
  const auto queue = search.search().queue().statistics();
  std::size_t degrees = 0;
  for(const Node n : search.search().reached_nodes())
    degrees += search.graph().triangulation().degree(n);
  EXPECT_EQ(s.settled_nodes, search.search().reached_nodes().size());
  EXPECT_EQ(s.settled_nodes + s.stale_pops + s.repeated_pops(), s.pops);
  EXPECT_LE(s.settled_nodes + s.stale_pops, s.pops); // so that the difference has not wrapped
  EXPECT_GE(s.relaxations, degrees);
  EXPECT_LE(s.improvements, s.relaxations);
  EXPECT_GE(queue.entries, s.pops);
  const std::size_t last_batch = CGAL::Approximate_geodesics::Adaptive_bucket_queue::LARGEST_BATCH;
  EXPECT_LE(queue.entries, s.pops + (is_complete ? 0 : last_batch)); // which ended the run
  EXPECT_LE(queue.late_entries, queue.entries);
  EXPECT_LE(queue.used_buckets, queue.visited_buckets);
  if(is_complete)
  {
    EXPECT_LE(s.pops, s.improvements + 1); // what was entered came out; the source was, too
    if(queue.comparisons == 0)             // or keys were lowered in place
    {
      EXPECT_EQ(s.pops, s.improvements + 1);
    }
    if(s.repeated_pops() == 0)
    {
      EXPECT_EQ(s.relaxations, degrees);
    }
  }
}

TEST(Statistics, fulfil_their_identities_and_change_nothing)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    Mesh_search counted(named.mesh), plain(named.mesh);
    counted.search().collect_statistics(true);
    for(std::size_t run = 0; run < 6; ++run)
    {
      const Vertex source = random_vertex(named.mesh, random);
      const Field field = plain.run({source});
      EXPECT_EQ(plain.search().statistics().pops, 0u);
      EXPECT_TRUE(have_same_bits(counted.run({source}).distance, field.distance));
      expect_identities(counted, true);
      const Search::Stop_rule stop{infinity, {plain.node(random_vertex(named.mesh, random))}};
      EXPECT_TRUE(
          have_same_bits(counted.run({source}, stop).distance, plain.run({source}, stop).distance));
      expect_identities(counted, false);
    }
    counted.search().collect_statistics(false);
    counted.run({Vertex(0)});
    EXPECT_EQ(counted.search().statistics().pops, 0u);
  }
}

// A tetrahedron has 4 vertices and 6 edges.
TEST(Statistics, count_comparisons_as_published)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const Graph graph{Triangulation(mesh)};
  Propagation<Graph, CGAL::Approximate_geodesics::Published_bucket_queue> published(graph);
  Propagation<Graph, CGAL::Approximate_geodesics::Binary_heap_queue> heap(graph);
  published.collect_statistics(true);
  heap.collect_statistics(true);
  const auto right_angle = graph.triangulation().vertex(0);
  published.run_from(right_angle);
  heap.run_from(right_angle);
  EXPECT_EQ(published.statistics().edges(), 6u);
  EXPECT_EQ(published.statistics().settled_nodes, 4u);
  // bucket 0 has the source; then come empty ones, and one with three vertices at distance 1
  const auto buckets = published.queue().statistics();
  EXPECT_EQ(buckets.used_buckets, 2u);
  EXPECT_EQ(buckets.comparisons, 2u + 1);
  EXPECT_EQ(published.statistics().queue_comparisons, buckets.visited_buckets + 3);
  EXPECT_EQ(published.statistics().comparisons(), 10 + buckets.visited_buckets + 3);
  EXPECT_EQ(heap.statistics().queue_comparisons, 0u);
}

// The node that came out last before the run was ended was neither settled nor expanded.
TEST(Statistics, do_not_call_a_pop_repeated_that_was_not)
{
  const Mesh mesh = to_mesh(flat_grid(30, 30));
  Mesh_search search(mesh);
  search.search().collect_statistics(true);
  Recorder<Node> recorder;
  recorder.stop_at = 0;
  search.search().run(search.seeds({Vertex(0)}), {}, recorder);
  EXPECT_EQ(search.search().statistics().settled_nodes, 1u);
  EXPECT_EQ(search.search().statistics().repeated_pops(), 0u);
}

// A chain of tiny edges lowers the distance of a hub at every step, and the hub has many neighbors:
// each time it is expanded, all of them are entered again. The idle sources keep the bucket
// patient.
TEST(Effort, is_bounded_around_a_hub_that_is_lowered_again_and_again)
{
  constexpr std::size_t chain = 2000, frontier = 22000, number_idle = 1000;
  Mesh mesh;
  const Vertex hub = mesh.add_vertex(Point(0, 0, 0));
  std::vector<Vertex> around;
  for(std::size_t i = 0; i < frontier; ++i)
    around.push_back(mesh.add_vertex(Point(double(i), 1, 0)));
  for(std::size_t i = 0; i + 1 < frontier; ++i)
    mesh.add_face(hub, around[i + 1], around[i]);
  for(const Vertex v : around)
    mesh.set_halfedge(v, mesh.halfedge(hub, v)); // the hub is the first neighbor looked at
  const auto length = mesh.add_property_map<Mesh::Edge_index, double>("length", 0.5).first;
  for(std::size_t i = 0; i < chain; ++i)
  {
    length[mesh.edge(mesh.halfedge(hub, around[i]))] = 0.2 - 0.1 * double(i) / chain;
    length[mesh.edge(mesh.halfedge(around[i], around[i + 1]))] = 1e-9;
  }
  std::vector<Vertex> sources{around[0]};
  for(std::size_t i = 0; i < number_idle; ++i)
    sources.push_back(mesh.add_vertex(Point(0, 0, 1)));

  Mesh_search search(mesh, CGAL::parameters::edge_length_map(length));
  auto seeds = search.seeds(sources);
  for(auto& seed : seeds)
    seed.distance = 0.47;
  search.search().collect_statistics(true);
  search.search().run(seeds);
  const std::size_t number_of_arcs = 2 * mesh.num_edges();
  EXPECT_LT(search.search().statistics().improvements, 20 * number_of_arcs);
  EXPECT_LT(search.search().memory(), 16u << 20); // a page of entries for every arc would be 250 MB
}

// Sources are there before the first bucket is drained: they do not make the next run's buckets
// narrower.
TEST(Effort, does_not_grow_from_run_to_run_with_many_sources)
{
  const Mesh mesh = to_mesh(flat_grid(100, 100));
  Mesh_search search(mesh);
  std::vector<Vertex> sources;
  for(const Vertex v : mesh.vertices())
    if(v.idx() % 3 == 0)
      sources.push_back(v);
  const auto seeds = search.seeds(sources);
  search.search().run(seeds);
  const double first_width = search.search().queue().statistics().width;
  for(int i = 0; i < 30; ++i)
    search.search().run(seeds);
  EXPECT_GT(search.search().queue().statistics().width, first_width / 8);
}

TEST(Effort, is_bounded_where_lengths_differ_by_many_orders_of_magnitude)
{
  const Mesh mesh = to_mesh(growing_strip(20000, 1, 1e12));
  const std::size_t n = mesh.number_of_vertices();
  Mesh_search search(mesh);
  search.search().collect_statistics(true);
  for(const Vertex source : {Vertex(0), Vertex(20000), Vertex(40001), Vertex(0), Vertex(0)})
  {
    const Field field = search.run({source});
    EXPECT_TRUE(is_optimal(mesh, edge_lengths(mesh), field, {source}));
    const Propagation_statistics& s = search.search().statistics();
    EXPECT_EQ(s.settled_nodes, n);
    // a sorted queue would pop a node up to as often as it was improved, hence at most six times
    EXPECT_LE(s.pops, 6 * n);
    EXPECT_LE(search.search().queue().statistics().visited_buckets, 10 * n);
    // a limited circle, and for an entry not more than a few times its size
    EXPECT_LE(search.search().queue().memory(), 100000 + 16 * 16 * n);
  }
}

TEST(Effort, of_a_run_that_stays_near_is_small)
{
  const Mesh mesh = to_mesh(flat_grid(1000, 300));
  Mesh_search search(mesh);
  search.search().collect_statistics(true);
  for(std::size_t run = 0; run < 3; ++run)
  {
    search.search().run(search.seeds({Vertex(150500)}), {5, {}});
    const Propagation_statistics& s = search.search().statistics();
    EXPECT_LE(s.settled_nodes, 11u * 11u);
    EXPECT_EQ(search.search().reached_nodes().size(), s.settled_nodes);
    EXPECT_LE(s.relaxations, 2 * 6 * 11 * 11u);
    EXPECT_LE(search.search().queue().statistics().visited_buckets, 100u);
    EXPECT_LE(search.search().queue().memory(), 100000u);
  }
}

TEST(Threads, may_share_a_graph)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(80, 60, random));
  const Graph graph{Triangulation(mesh)};
  constexpr Node runs = 20;
  const auto distances_from = [&](Search& search, const Node source) {
    search.run_from(source);
    return distances_of_nodes(search);
  };
  std::vector<std::vector<double>> expected;
  Search sequential(graph);
  for(Node i = 0; i < 4 * runs; ++i)
    expected.push_back(distances_from(sequential, 7 * i));

  std::vector<std::vector<double>> found(expected.size());
  std::vector<std::thread> threads;
  for(Node t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      Search search(graph);
      for(Node i = t * runs; i < (t + 1) * runs; ++i)
        found[i] = distances_from(search, 7 * i);
    });
  for(std::thread& thread : threads)
    thread.join();
  for(std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_TRUE(have_same_bits(found[i], expected[i]));
}

TEST(Workspace_of_little, copes)
{
  for(Mesh mesh : {Mesh(), to_mesh({{Point(1, 2, 3)}, {}})})
  {
    Mesh_search search(mesh);
    search.search().run(std::vector<Search::Seed>());
    EXPECT_TRUE(search.search().reached_nodes().empty());
    if(mesh.number_of_vertices() > 0)
    {
      search.search().run_from(Node(0));
      EXPECT_EQ(search.search().distance(0), 0);
      EXPECT_EQ(search.search().predecessor(0), Search::null_node);
      EXPECT_EQ(search.search().source(0), 0u);
    }
  }
}

TEST(Workspace_memory, is_what_it_says)
{
  const Mesh mesh = to_mesh(sphere(100, 100));
  const std::size_t n = mesh.number_of_vertices();
  Mesh_search search(mesh);
  // distance and predecessor, and a queue that is empty
  EXPECT_GE(search.search().memory(), 12 * n);
  EXPECT_LE(search.search().memory(), 12 * n + 100000);
  search.run({Vertex(0)});
  // the order in which nodes came out, in an array that doubles, and a front in the queue
  EXPECT_LE(search.search().memory(), (12 + 12) * n + 200000);
}

} // namespace
