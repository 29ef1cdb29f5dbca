// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_grids/Grid_graph.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

// Runs that continue others, whose labels were kept elsewhere.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Grid_graph;

Grid_graph random_grid(Random& random)
{
  const AG::Grid_shape shape{100, 60, 1, 1, {}};
  std::vector<double> friction;
  for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
    friction.push_back(random.between(1, 2));
  return Grid_graph(shape, friction);
}

template <typename Search>
void expect_same_results(const Search& found, const Search& expected)
{
  for(Grid_graph::Node node = 0; node < expected.graph().number_of_nodes(); ++node)
  {
    EXPECT_EQ(found.distance(node), expected.distance(node));
    EXPECT_EQ(found.predecessor(node), expected.predecessor(node));
  }
}

template <typename Queue>
class Resumed_run : public testing::Test
{
};

using Queues_of_resumed_runs = testing::Types<AG::Adaptive_bucket_queue, AG::Binary_heap_queue>;
TYPED_TEST_SUITE(Resumed_run, Queues_of_resumed_runs, );

TYPED_TEST(Resumed_run, has_the_results_of_one_that_did_not_end_early)
{
  Random random(test_seed());
  for(int i = 0; i < 10; ++i)
  {
    const Grid_graph graph = random_grid(random);
    using Search = AG::Propagation<Grid_graph, TypeParam>;
    Search expected(graph), first(graph), second(graph);
    const auto source = static_cast<Grid_graph::Node>(random.below(graph.number_of_nodes()));
    expected.run_from(source);
    const double radius = random.between(0, 150);
    constexpr double longest_arc = 45;
    first.run({{source}}, {radius});
    second.run_from(0); // which is forgotten
    second.resume([&](const auto& set) {
      for(const Grid_graph::Node node : first.reached_nodes())
        set(node, first.distance(node), first.predecessor(node),
            first.distance(node) > radius - longest_arc);
    });
    expect_same_results(second, expected);
    for(Grid_graph::Node node = 0; node < graph.number_of_nodes(); ++node)
      EXPECT_EQ(second.source(node), source);
    first.run_from(0);
    second.run_from(0);
    expect_same_results(second, first);
  }
}

TYPED_TEST(Resumed_run, follows_arcs_from_open_nodes_only)
{
  Random random(test_seed());
  const Grid_graph graph = random_grid(random);
  AG::Propagation<Grid_graph, TypeParam> search(graph);
  const auto null_node = search.null_node;
  search.resume([&](const auto& set) { set(7, 1.5, null_node, false); });
  EXPECT_EQ(search.distance(7), 1.5);
  EXPECT_FALSE(search.is_reached(8));
  search.resume([&](const auto& set) { set(7, 1.5, null_node, true); });
  EXPECT_TRUE(search.is_reached(8));
  search.resume([](const auto& /* set */) {});
  EXPECT_FALSE(search.is_reached(7));
}

TYPED_TEST(Resumed_run, refuses_bad_labels)
{
  Random random(test_seed());
  const Grid_graph graph = random_grid(random);
  AG::Propagation<Grid_graph, TypeParam> search(graph);
  const auto resume = [&](const Grid_graph::Node node, const double distance) {
    search.resume([&](const auto& set) {
      set(0, 1, search.null_node, true);
      set(node, distance, 0, false);
    });
  };
  for(const double distance :
      {-1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    expect_message<std::invalid_argument>([&] { resume(5, distance); }, "node 5");
  expect_message<std::invalid_argument>([&] { resume(6000, 1); }, "node 6000 does not exist");
  EXPECT_FALSE(search.is_reached(0));
  search.run_from(0);
  EXPECT_TRUE(search.is_reached(5));
}

} // namespace
