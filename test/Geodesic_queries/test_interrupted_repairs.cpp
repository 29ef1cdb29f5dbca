// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/test_weights.h"

#include <CGAL/Geodesic_queries/Guided_search.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

// Repairs, and runs that landmarks guide, that end for want of memory.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

using Points_graph = Steiner_graph<Fixed_number_of_points>;
using Points_search = AG::Propagation<Points_graph>;

// A graph that changes, and its search, which refers to it.
struct Changed_search
{
  std::unique_ptr<Points_graph> graph;
  std::unique_ptr<Points_search> search;
};

const std::vector<AG::Seed> seeds_before = {{3}, {40, 0.5}}, seeds_after = {{3}, {20, 0.25}};

// The search knows the field before the changes.
Changed_search changed_search(const Mesh& mesh)
{
  Random random(test_seed());
  const Weights weights = random_weights(mesh, random, 0.5, 2);
  Changed_search result;
  result.graph =
      std::make_unique<Points_graph>(steiner_graph(mesh, weights, Fixed_number_of_points(2)));
  result.search = std::make_unique<Points_search>(*result.graph);
  result.search->run(seeds_before);
  std::vector<AG::Weight_change> changes;
  const Triangulation& t = result.graph->triangulation();
  for(Node h = 0; h < t.number_of_halfedges() && changes.size() < 3; h += 29)
    if(!t.is_border(h))
      changes.push_back({h, h % 2 == 0 ? 0.1 : 5});
  result.graph->set_weights(changes);
  return result;
}

void expect_nothing_is_reached(const Points_search& search)
{
  EXPECT_TRUE(search.reached_nodes().empty());
  for(Node n = 0; n < search.graph().number_of_nodes(); ++n)
    EXPECT_EQ(search.distance(n), infinity);
}

TEST(Interrupted_repair, leaves_nothing_that_was_reached)
{
  const Mesh mesh = small_terrain();
  expect_survival<Changed_search>(
      {[&] { return changed_search(mesh); },
       [](Changed_search& s) { s.search->repair(seeds_after); },
       [](Changed_search& s) { return distances_of_nodes(*s.search); },
       [](Changed_search& s) { expect_nothing_is_reached(*s.search); }});
}

// The second repair has its memory.
TEST(Interrupted_repair, can_be_one_after_others)
{
  const Mesh mesh = small_terrain();
  const auto make = [&] {
    Changed_search result = changed_search(mesh);
    result.search->repair(seeds_after);
    result.graph->set_weights({{result.graph->triangulation().first_halfedge(30) + 1, 3}});
    return result;
  };
  std::size_t number_of_failures = 0;
  for(std::ptrdiff_t number = 1; number < 50; ++number)
  {
    Changed_search changed = make();
    try
    {
      const Failing_allocation failing(number);
      changed.search->repair(seeds_before);
    }
    catch(const std::bad_alloc&)
    {
      ++number_of_failures;
      expect_nothing_is_reached(*changed.search);
      changed.search->repair(seeds_before);
    }
    Points_search fresh(*changed.graph);
    fresh.run(seeds_before);
    EXPECT_TRUE(have_same_bits(distances_of_nodes(*changed.search), distances_of_nodes(fresh)));
  }
  EXPECT_GT(number_of_failures, 0u);
}

TEST(Interrupted_change, has_changed_nothing_or_all)
{
  const Mesh mesh = small_terrain();
  const Triangulation without_weights(mesh);
  const std::vector<AG::Weight_change> changes = {{without_weights.first_halfedge(30) + 1, 3}};
  expect_survival<Points_graph>(
      {[&] { return Points_graph(without_weights, Fixed_number_of_points(2)); },
       [&](Points_graph& graph) { graph.set_weights(changes); },
       [](Points_graph& graph) {
         Points_search search(graph);
         search.run_from(Node(3));
         return distances_of_nodes(search);
       }});
}

TEST(Interrupted_landmarks, can_be_made_again)
{
  const Mesh mesh = small_terrain();
  const Points_graph graph(Triangulation(mesh), Fixed_number_of_points(1));
  expect_survival([&] {
    const AG::Landmarks<Points_graph> landmarks(graph, 3);
    Values result;
    for(Node n = 0; n < graph.number_of_nodes(); ++n)
      result.push_back(landmarks.to(AG::Intrinsic_point::at_vertex(5))(n));
    return result;
  });
}

// The queue of a guided run keeps its entries in order, and afterwards does as before.
TEST(Interrupted_guided_run, leaves_nothing_that_was_reached)
{
  using Guided = AG::Guided_search<Points_graph>;
  const Mesh mesh = small_terrain();
  const Points_graph graph(Triangulation(mesh), Fixed_number_of_points(1));
  const AG::Landmarks<Points_graph> landmarks(graph, 3);
  const auto source = AG::Intrinsic_point::at_vertex(3),
             target = AG::Intrinsic_point::at_vertex(50);
  expect_survival<Guided>({[&] {
                             Guided search(graph);
                             search.use_landmarks(landmarks);
                             return search;
                           },
                           [&](Guided& search) { search.run_to(target, {{source}}); },
                           [&](Guided& search) {
                             const double found = search.distance(target);
                             search.run({{source}});
                             Values result = distances_of_nodes(search.search());
                             result.push_back(found);
                             return result;
                           },
                           [&](Guided& search) { expect_nothing_is_reached(search.search()); }});
}

} // namespace
