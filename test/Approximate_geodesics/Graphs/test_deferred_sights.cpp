// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include "checks/graphs_of_all_kinds.h"
#include "checks/test_recorder.h"
#include "measuring/Sight_counting_graph.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// Searches of rough surfaces, where sights wait for the search: they find what searches find in
// which none waits, those with a heuristic.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Seeds = std::vector<AG::Seed>;

constexpr double rounding_of_sights = 1e-12;

const auto no_heuristic_at_all = [](const Node) { return 0.; };

// Where the mean edge, and so the horizon, is far from the size of some faces, or of all.
std::vector<Soup> rough_surfaces(Random& random)
{
  const auto rough = [&](const std::size_t size, const auto& place) {
    return grid(size, size, [&](const double i, const double j) {
      const auto [x, unit] = place(i);
      return Point(x, unit * j, unit * random.between(0, 1.5));
    });
  };
  const auto pair = [](const double a, const double b) { return std::make_pair(a, b); };
  return {terrain(21, 20, random),
          rough(20, [=](const double i) { return pair(1e-150 * i, 1e-150); }),
          rough(20, [=](const double i) { return pair(1e150 * i, 1e150); }),
          rough(20, [=](const double i) { return pair(1e-9 * i, 1.); }), // needles
          rough(20, [=](const double i) { return pair(i < 17 ? i : 1e3 * (i - 16), 1.); }),
          rough(20, [=](const double i) { return pair(i < 19 ? i : 1e9, 1.); }), // huge faces
          rough(20, [=](const double i) { return pair(std::floor(i / 2), 1.); }),
          grid(20, 20, [&](const double i, const double j) { // edges of length zero
            return Point(std::floor(i / 2), std::floor(j / 3), std::fmod(3 * i + 7 * j, 5) / 3);
          })};
}

// Two searches: in one of them, sights wait.
template <typename Queue>
class Waiting
{
public:
  using Search = AG::Propagation<Saddle_vertex_graph, Queue>;

  explicit Waiting(const Saddle_vertex_graph& graph)
    : m_number(graph.number_of_nodes()), m_search(graph), m_expected(graph)
  {
  }

  void expect_all(const Seeds& seeds, const Seeds& further)
  {
    Seeds both = seeds;
    both.insert(both.end(), further.begin(), further.end());
    m_search.run(seeds);
    m_search.run_further(further);
    m_expected.run_toward(both, {}, no_heuristic_at_all);
    expect_all_nearer_than(infinity);
    m_search.run(seeds);
    m_expected.run_toward(seeds, {}, no_heuristic_at_all);
    expect_all_nearer_than(infinity);
  }

  void expect_same_before_end(const Seeds& seeds, Random& random)
  {
    for(const double part : {0., 0.01, 0.2, 0.6})
    {
      const double maximum = part * farthest();
      m_search.run(seeds, {maximum, {}, {}});
      expect_all_nearer_than(maximum);
    }
    for(const std::size_t number : {std::size_t{1}, std::size_t{3}})
    {
      std::vector<Node> targets(number);
      for(Node& target : targets)
        target = static_cast<Node>(random.below(m_number));
      m_search.run(seeds, {infinity, targets, {}});
      for(const Node target : targets)
      {
        expect_near(m_search.distance(target), m_expected.distance(target));
        expect_all_nearer_than(m_expected.distance(target));
      }
    }
    for(const std::size_t number : {std::size_t(1), m_number / 3})
    {
      Recorder<Node> recorder;
      recorder.stop_at = number;
      m_search.run(seeds, {}, recorder);
      double last = 0;
      for(const auto& [node, distance] : recorder.settled)
      {
        expect_near(distance, m_expected.distance(node));
        EXPECT_GE(distance, last);
        last = distance;
      }
      expect_all_nearer_than(last);
    }
  }

private:
  static void expect_near(const double found, const double expected)
  {
    if(std::isinf(expected))
      EXPECT_EQ(found, expected);
    else
      EXPECT_NEAR(found, expected, rounding_of_sights * expected);
  }

  // Whether all nodes before this distance were reached, and none with a wrong distance.
  void expect_all_nearer_than(const double distance) const
  {
    for(Node node = 0; node < m_number; ++node)
      if(m_search.is_reached(node) ||
         m_expected.distance(node) < distance * (1 - rounding_of_sights))
        expect_near(m_search.distance(node), m_expected.distance(node));
  }

  double farthest() const
  {
    double result = 0;
    for(const double distance : distances_of_nodes(m_expected))
      result = distance < infinity ? (std::max)(result, distance) : result;
    return result;
  }

  std::size_t m_number;
  Search m_search, m_expected;
};

template <typename Queue>
class Deferred_sights_with : public testing::Test
{
};

using Queues_with_waiting_sights = testing::Types<AG::Adaptive_bucket_queue,
                                                  AG::Array_queue,
                                                  AG::Binary_heap_queue,
                                                  AG::Fibonacci_heap_queue,
                                                  AG::Radix_heap_queue>;
TYPED_TEST_SUITE(Deferred_sights_with, Queues_with_waiting_sights, );

TYPED_TEST(Deferred_sights_with, queue_change_no_distance)
{
  Random random(test_seed());
  for(const Soup& soup : rough_surfaces(random))
  {
    SCOPED_TRACE(soup.points.back());
    const Saddle_vertex_graph graph{Triangulation(to_mesh(soup))};
    Waiting<TypeParam> waiting(graph);
    for(std::size_t number = 1; number < 4; ++number)
    {
      const double far = 2 * graph.unit() * graph.arc_lengths().mean;
      Seeds seeds, further;
      for(Seeds* s : {&seeds, &further})
        for(std::size_t i = 0; i < number; ++i)
          s->push_back({static_cast<Node>(random.below(graph.number_of_nodes())),
                        static_cast<double>(i) * random.between(0, far), i});
      waiting.expect_all(seeds, further);
      waiting.expect_same_before_end(seeds, random);
    }
  }
}

// The horizon only moves when the search gets there, however many stale entries there are.
TEST(Deferred_sights, wait_for_every_queue)
{
  Random random(test_seed());
  const Sight_counting_graph graph{Triangulation(to_mesh(terrain(70, 70, random)))};
  const auto number_of_sights = [&](auto&& run) {
    Sight_counting_graph::reset();
    run();
    return Sight_counting_graph::number_of_sights();
  };
  AG::Propagation<Sight_counting_graph, AG::Adaptive_bucket_queue> in_buckets(graph);
  AG::Propagation<Sight_counting_graph, AG::Binary_heap_queue> in_order(graph);
  AG::Propagation<Sight_counting_graph, AG::Radix_heap_queue> with_stale_entries(graph);
  const std::size_t expected = number_of_sights([&] { in_order.run_from(0); });
  EXPECT_LT(2 * expected,
            number_of_sights([&] { in_order.run_toward({{0}}, {}, no_heuristic_at_all); }));
  EXPECT_EQ(number_of_sights([&] { with_stale_entries.run_from(0); }), expected);
  EXPECT_LT(number_of_sights([&] { in_buckets.run_from(0); }), expected + expected / 8);
}

TEST(Deferred_sights, take_no_more_memory_from_run_to_run)
{
  Random random(test_seed());
  const Saddle_vertex_graph graph{Triangulation(to_mesh(terrain(30, 30, random)))};
  AG::Propagation<Saddle_vertex_graph> search(graph);
  std::vector<std::size_t> memory;
  for(int i = 0; i < 8; ++i)
  {
    search.run({{17}}, {7, {}, {}});
    search.run_from(5);
    memory.push_back(search.graph_run().memory());
  }
  EXPECT_EQ(memory.back(), memory[3]);
}

// The label that a sight waits for must not exceed the labels of what it sees: keys never decrease.
TEST(Sight, knows_a_lower_bound_of_distances)
{
  using AG::internal::Plane_vector;
  Random random(test_seed());
  for(int i = 0; i < 10000; ++i)
  {
    const double far = std::pow(10, random.between(0, 12)), near = random.between(0.5, 1);
    const Plane_vector left{far, random.between(0, 1e-3)}, right{near, random.between(-1e-3, 0)};
    const AG::internal::Sight sight{
        0, 0, 0, 0, left, right, right - left, length(left), length(right)};
    EXPECT_LE(sight.smallest_distance(), length(right)) << far;
  }
}

} // namespace
