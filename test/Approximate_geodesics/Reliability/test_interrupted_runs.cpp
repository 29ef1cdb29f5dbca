// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"
#include "checks/graphs_of_all_kinds.h"
#include "checks/test_recorder.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <new>
#include <type_traits>
#include <vector>

// Runs that end for want of memory.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

template <typename Search>
void expect_nothing_reached(const Search& search)
{
  EXPECT_TRUE(search.reached_nodes().empty());
  for(Node n = 0; n < search.graph().number_of_nodes(); ++n)
  {
    EXPECT_EQ(search.distance(n), infinity);
    EXPECT_EQ(search.predecessor(n), Search::null_node);
    EXPECT_EQ(search.source(n), Search::null_source);
  }
}

// Which of the seeds' sources is nearest, too.
Values distances_and_sources(const Search& search)
{
  Values result = distances_of_nodes(search);
  for(Node n = 0; n < search.graph().number_of_nodes(); ++n)
    result.push_back(static_cast<double>(search.source(n)));
  return result;
}

template <typename Search>
std::vector<typename Search::Seed> two_seeds()
{
  return {{3, 0, 0}, {40, 0.5, 1}};
}

template <typename Search>
typename Search::Stop_rule early_stop()
{
  return {infinity, {20, 30}, {{{25, 0.1}, {26, 0.2}}}};
}

// What else is reached depends on what the queue has learned.
template <typename Search>
Values distances_of_targets(const Search& search)
{
  Values result;
  for(const Node target : early_stop<Search>().targets)
    result.push_back(search.distance(target));
  return result;
}

template <typename Search>
void expect_survival_of_runs(const typename Search::Graph& graph, const double deviation)
{
  const auto make = [&] { return Search(graph); };
  const auto check = [](Search& search) { expect_nothing_reached(search); };
  const auto seeds = two_seeds<Search>();
  const auto stop = early_stop<Search>();
  expect_survival<Search>({make, [&](Search& search) { search.run(seeds); },
                           [](Search& search) { return distances_of_nodes(search); }, check,
                           deviation});
  expect_survival<Search>({make, [&](Search& search) { search.run(seeds, stop); },
                           [](Search& search) { return distances_of_targets(search); }, check,
                           deviation});
}

template <typename Queue>
class Interrupted_runs_with : public testing::Test
{
};

using Queues = testing::Types<AG::Adaptive_bucket_queue,
                              AG::Array_queue,
                              AG::Binary_heap_queue,
                              AG::D_ary_heap_queue<>,
                              AG::Fibonacci_heap_queue,
                              AG::Pairing_heap_queue,
                              AG::Published_bucket_queue,
                              AG::Radix_heap_queue>;
TYPED_TEST_SUITE(Interrupted_runs_with, Queues, );

TYPED_TEST(Interrupted_runs_with, queue)
{
  const Mesh mesh = small_terrain();
  expect_survival_of_runs<AG::Propagation<Graph, TypeParam>>(Graph(Triangulation(mesh)), 0);
}

TEST(Interrupted_runs, in_every_graph)
{
  const Mesh mesh = small_terrain();
  for_each_graph(1, [&](const auto& kind) {
    using Kind = std::decay_t<decltype(kind)>;
    expect_survival_of_runs<AG::Propagation<typename Kind::Graph>>(kind.make(Triangulation(mesh)),
                                                                   kind.deviation);
  });
}

std::vector<std::function<void(Search&)>> runs_of_all_kinds()
{
  const auto seeds = two_seeds<Search>();
  const auto stop = early_stop<Search>();
  return {[=](Search& search) { search.run(seeds); },
          [=](Search& search) { search.run(seeds, stop); },
          [=](Search& search) { search.run(seeds, {}, Recorder<Node>()); },
          [=](Search& search) {
            search.collect_statistics(true);
            search.run(seeds, {2, {}});
          },
          [=](Search& search) { search.run_toward(seeds, stop, [](Node) { return 0.; }); }};
}

TEST(Interrupted_runs, of_all_kinds_forget_the_run_before)
{
  const Mesh mesh = small_terrain();
  const Graph graph{Triangulation(mesh)};
  const auto make = [&] {
    Search search(graph);
    search.run_from(Node(7));
    search.source(9);
    return search;
  };
  for(const auto& run : runs_of_all_kinds())
    expect_survival<Search>({make, run, [](Search& search) { return distances_of_targets(search); },
                             [](Search& search) { expect_nothing_reached(search); }});
}

// Seeds of the run that failed do not come back.
TEST(Interrupted_runs, can_be_followed_by_further_seeds)
{
  const Mesh mesh = small_terrain();
  const Graph graph{Triangulation(mesh)};
  expect_survival<Search>({[&] { return Search(graph); },
                           [&](Search& search) {
                             search.run({{3, 0, 5}});
                           },
                           [](Search& search) { return distances_of_nodes(search); },
                           [](Search& search) {
                             search.run_further({{3, 0, 8}});
                             EXPECT_EQ(search.source(3), 8u);
                           }});
}

TEST(Interrupted_further_run, has_forgotten_the_run_before)
{
  const Mesh mesh = small_terrain();
  const Graph graph{Triangulation(mesh)};
  const auto seeds = two_seeds<Search>();
  const std::vector<Search::Seed> first = {seeds[0]}, second = {seeds[1]};
  expect_survival<Search>({[&] {
                             Search search(graph);
                             search.run(first);
                             return search;
                           },
                           [&](Search& search) { search.run_further(second); },
                           [&](Search& search) { return distances_and_sources(search); },
                           [&](Search& search) {
                             expect_nothing_reached(search);
                             search.run(first);
                           }});
}

TEST(Interrupted_questions_for_sources, can_be_repeated)
{
  const Mesh mesh = small_terrain();
  const Graph graph{Triangulation(mesh)};
  const auto make = [&] {
    Search search(graph);
    search.run(two_seeds<Search>());
    return search;
  };
  expect_survival<Search>({make, [](Search& search) { search.source(17); },
                           [](Search& search) { return distances_and_sources(search); }});
}

// An entry that there was no memory for is forgotten, too; or else the heap would look, when there
// are none, at the last one that it had, whose memory may be another queue's.
TEST(Interrupted_push, does_not_outlast_clear)
{
  AG::Fibonacci_heap_queue queue(3), other(3);
  queue.push(0, 1);
  {
    const Failing_allocation failing(1);
    EXPECT_THROW(queue.push(1, 2), std::bad_alloc);
  }
  queue.clear();
  other.push(2, 0);
  queue.push(1, 5);
  EXPECT_EQ(queue.extract_min().begin()->node, 1u);
}

} // namespace
