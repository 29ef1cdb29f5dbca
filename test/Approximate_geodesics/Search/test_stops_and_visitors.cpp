// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_recorder.h"
#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

// Runs that end early, and visitors.

namespace {

using namespace geodesics_test;
using Node_recorder = Recorder<Node>;

// Every mesh with a source, and the field of a full run from it.
template <typename F>
void for_each_run(F f)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    Mesh_search search(named.mesh);
    const Vertex source = random_vertex(named.mesh, random);
    f(search, source, search.run({source}), random);
  }
}

// What was reached has the values of the full run.
void expect_part_of(const Field& part, const Field& full)
{
  for(std::size_t i = 0; i < full.distance.size(); ++i)
    if(part.distance[i] < infinity)
    {
      EXPECT_EQ(part.distance[i], full.distance[i]);
    }
}

double random_distance(const Field& field, Random& random)
{
  double result = infinity;
  while(result == infinity)
    result = field.distance[random.below(field.distance.size())];
  return result;
}

TEST(Maximum_distance, reaches_exactly_what_is_not_farther)
{
  for_each_run([](Mesh_search& search, const Vertex source, const Field& full, Random& random) {
    for(const double factor : {1., 1 - 0x1p-52, 0.37, 0.})
    {
      const double limit = random_distance(full, random) * factor;
      Node_recorder recorder;
      search.search().run(search.seeds({source}), {limit, {}}, recorder);
      const Field part = search.field();
      std::size_t number_within = 0;
      for(std::size_t i = 0; i < full.distance.size(); ++i)
      {
        EXPECT_EQ(part.distance[i], full.distance[i] <= limit ? full.distance[i] : infinity);
        number_within += full.distance[i] <= limit ? 1 : 0;
      }
      EXPECT_EQ(recorder.settled.size(), number_within);
      const Field unwatched = search.run({source}, {limit, {}});
      EXPECT_TRUE(have_same_bits(unwatched.distance, part.distance));
      EXPECT_EQ(unwatched.predecessor, part.predecessor);
    }
  });
}

TEST(Maximum_distance, may_be_infinite_or_zero)
{
  for_each_run([](Mesh_search& search, const Vertex source, const Field& full, Random&) {
    EXPECT_TRUE(have_same_bits(search.run({source}, {infinity, {}}).distance, full.distance));
    EXPECT_EQ(search.run({source}, {0, {}}).distance[source.idx()], 0);
    search.search().run({{search.node(source), 1.5, 0}}, {1, {}}); // starts beyond it
    EXPECT_TRUE(search.search().reached_nodes().empty());
  });
}

TEST(Targets, are_settled_and_not_much_else)
{
  for_each_run([](Mesh_search& search, const Vertex source, const Field& full, Random& random) {
    for(const std::size_t number_of_targets : {1u, 2u, 5u})
    {
      Search::Stop_rule stop;
      double farthest = 0;
      for(std::size_t i = 0; i < number_of_targets; ++i)
      {
        const Vertex target = random_vertex(search.mesh(), random);
        stop.targets.push_back(search.node(target));
        farthest = (std::max)(farthest, full.distance[target.idx()]);
      }
      Node_recorder recorder;
      search.search().run(search.seeds({source}), stop, recorder);
      const Field part = search.field();
      expect_part_of(part, full);
      for(const Node target : stop.targets)
        EXPECT_EQ(search.search().distance(target), full.distance[search.vertex(target).idx()]);

      // a bucket is settled as a whole; a rounding of the bucket's number for the tolerance
      const double width =
          search.search().queue().statistics().width * search.graph().triangulation().unit();
      for(const auto& [node, distance] : recorder.settled)
        EXPECT_LE(distance, (farthest + width) * (1 + 4 * 0x1p-52));
      const auto is_reached = [](const double d) { return d < infinity; };
      EXPECT_EQ(std::size_t(std::count_if(part.distance.begin(), part.distance.end(), is_reached)),
                recorder.settled.size());
    }
  });
}

TEST(Targets, end_the_run_early)
{
  const Mesh mesh = to_mesh(flat_grid(200, 200));
  Mesh_search search(mesh);
  search.search().collect_statistics(true);
  search.run({Vertex(100 + 100 * 200)}, {infinity, {search.node(Vertex(103 + 100 * 200))}});
  // distances up to 3, and a bucket of half a mean arc: within a square of side 8 or so
  EXPECT_LT(search.search().statistics().settled_nodes, 100u);
  EXPECT_LT(search.search().statistics().pops, 150u);
}

TEST(Targets, that_are_sources_or_cannot_be_reached_do_no_harm)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  Mesh_search search(mesh);
  const Vertex isolated(0), inside(20);
  ASSERT_TRUE(mesh.is_isolated(isolated));
  const Field full = search.run({inside});
  EXPECT_TRUE(have_same_bits(search.run({inside}, {infinity, {search.node(isolated)}}).distance,
                             full.distance));
  EXPECT_EQ(search.run({inside}, {infinity, {search.node(inside)}}).distance[inside.idx()], 0);
  const Field alone = search.run({isolated}, {infinity, {search.node(isolated)}});
  EXPECT_EQ(alone.distance[isolated.idx()], 0);
  EXPECT_EQ(std::count(alone.distance.begin(), alone.distance.end(), infinity),
            std::ptrdiff_t(mesh.num_vertices() - 1));
  // one that the maximum distance excludes
  const Field near = search.run({inside}, {1, {search.node(Vertex(100)), search.node(isolated)}});
  expect_part_of(near, full);
}

TEST(Visitor, sees_every_node_once_by_distance)
{
  for_each_run([](Mesh_search& search, const Vertex source, const Field& full, Random&) {
    Node_recorder recorder;
    search.search().run(search.seeds({source}), {}, recorder);
    EXPECT_TRUE(have_same_bits(search.field().distance, full.distance));
    EXPECT_EQ(search.field().predecessor, full.predecessor);

    std::set<Node> seen;
    double last = 0;
    for(const auto& [node, distance] : recorder.settled)
    {
      EXPECT_TRUE(seen.insert(node).second) << "node " << node << " twice";
      EXPECT_GE(distance, last);
      EXPECT_EQ(distance, full.distance[search.vertex(node).idx()]);
      last = distance;
    }
    const auto is_reached = [](const double d) { return d < infinity; };
    EXPECT_EQ(std::size_t(std::count_if(full.distance.begin(), full.distance.end(), is_reached)),
              recorder.settled.size());
    std::vector<Node> order;
    for(const auto& settled : recorder.settled)
      order.push_back(settled.first);
    EXPECT_EQ(search.search().reached_nodes(), order);
  });
}

TEST(Visitor, sees_progress_that_never_falls)
{
  for_each_run([](Mesh_search& search, const Vertex source, const Field&, Random&) {
    Node_recorder recorder;
    search.search().run(search.seeds({source}), {}, recorder);
    ASSERT_FALSE(recorder.progress.empty());
    std::size_t last = 0;
    for(const auto& [settled, all] : recorder.progress)
    {
      EXPECT_GE(settled, last);
      EXPECT_EQ(all, search.mesh().number_of_vertices());
      last = settled;
    }
    EXPECT_EQ(last, recorder.settled.size());
  });
}

TEST(Visitor, can_end_the_run)
{
  for_each_run([](Mesh_search& search, const Vertex source, const Field& full, Random& random) {
    Node_recorder recorder;
    recorder.stop_at = 1 + random.below(search.mesh().number_of_vertices() / 2);
    search.search().run(search.seeds({source}), {}, recorder);
    const Field part = search.field();
    expect_part_of(part, full);
    // exactly what was said to be settled is reached
    std::set<Node> seen;
    for(const auto& settled : recorder.settled)
      seen.insert(settled.first);
    for(Node n = 0; n < search.mesh().number_of_vertices(); ++n)
      EXPECT_EQ(search.search().is_reached(n), seen.count(n) == 1) << "node " << n;
    for(const Vertex v : search.mesh().vertices()) // paths are complete
      if(part.predecessor[v.idx()] != Mesh::null_vertex())
      {
        EXPECT_LT(part.distance[part.predecessor[v.idx()].idx()], infinity);
      }
  });
}

TEST(Visitor, is_not_asked_again_after_it_said_no)
{
  const Mesh mesh = to_mesh(flat_grid(50, 50));
  Mesh_search search(mesh);
  Node_recorder recorder;
  recorder.stop_at = 0;
  search.search().run(search.seeds({Vertex(0)}), {}, recorder);
  EXPECT_EQ(recorder.questions, 1u);
  EXPECT_LT(recorder.settled.size(), 10u); // the first bucket
  EXPECT_FALSE(recorder.settled.empty());
}

struct Settled_counter : CGAL::Approximate_geodesics::Geodesic_visitor_base
{
  void on_settled(Node, double) { ++count; }
  std::size_t count = 0;
};

TEST(Visitor, may_leave_out_what_it_does_not_need)
{
  const Mesh mesh = to_mesh(flat_grid(5, 5));
  Mesh_search search(mesh);
  Settled_counter counter;
  search.search().run(search.seeds({Vertex(0)}), {}, counter);
  EXPECT_EQ(counter.count, 25u);
  search.search().run(search.seeds({Vertex(0)}), {}, Settled_counter()); // a temporary one
  search.search().run(search.seeds({}), {}, counter);
  EXPECT_EQ(counter.count, 25u); // there was nothing to see
}

struct Progress_counter : Settled_counter
{
  static constexpr bool is_told_of_nodes = false;

  void on_progress(const std::size_t number_settled, const std::size_t number)
  {
    EXPECT_GE(number_settled, largest);
    EXPECT_EQ(number, 2500u);
    largest = number_settled;
  }

  bool go_further() { return largest < stop_at; }

  std::size_t largest = 0;
  std::size_t stop_at = (std::numeric_limits<std::size_t>::max)();
};

TEST(Visitor, need_not_be_told_of_nodes)
{
  const Mesh mesh = to_mesh(flat_grid(50, 50));
  Mesh_search search(mesh);
  search.search().run(search.seeds({Vertex(0)}));
  const Field full = search.field();
  Progress_counter counter;
  search.search().run(search.seeds({Vertex(0)}), {}, counter);
  EXPECT_EQ(counter.count, 0u);
  EXPECT_GE(counter.largest, 2500u);
  EXPECT_EQ(search.field().distance, full.distance);

  counter.largest = 0;
  search.search().collect_statistics(true);
  search.search().run(search.seeds({Vertex(0)}), {}, counter);
  EXPECT_EQ(search.search().statistics().settled_nodes, 2500u);
  EXPECT_EQ(counter.largest, 2500u);

  search.search().collect_statistics(false);
  counter.largest = 0;
  counter.stop_at = 100;
  search.search().run(search.seeds({Vertex(0)}), {}, counter);
  expect_part_of(search.field(), full);
  EXPECT_LT(search.search().reached_nodes().size(), 2500u);
}

} // namespace
