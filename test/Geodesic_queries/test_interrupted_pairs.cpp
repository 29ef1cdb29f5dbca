// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "checks/failing_allocation.h"
#include "checks/graphs_of_all_kinds.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>
#include <CGAL/Geodesic_queries/Point_pairs.h>
#include <CGAL/approximate_geodesic_pair_distances.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

// Lists of pairs that end for want of memory: nothing was written then.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

class Interrupted_pairs : public testing::Test
{
protected:
  using Pairs = std::vector<std::pair<Surface_point, Surface_point>>;

  Pairs pairs()
  {
    Random random(test_seed());
    const auto points = random_surface_points(m_mesh, 4, random);
    return {{points[0], points[1]},
            {Vertex(3), Vertex(40)},
            {points[0], Vertex(9)},
            {points[2], points[3]},
            {Vertex(3), Vertex(3)}};
  }

  std::vector<AG::Point_pair> pairs_of(const Triangulation& triangulation) const
  {
    std::vector<AG::Point_pair> result;
    for(const auto& [source, target] : m_pairs)
    {
      const auto ends = intrinsic_points(m_mesh, triangulation, {source, target});
      result.emplace_back(ends[0], ends[1]);
    }
    return result;
  }

  template <typename NamedParameters>
  void expect_survival_with(const NamedParameters& np) const
  {
    expect_survival<Values>(
        {[&] { return Values(m_pairs.size(), -1); },
         [&](Values& values) {
           CGAL::approximate_geodesic_pair_distances(m_mesh, m_pairs, values.begin(), np);
         },
         [](Values& values) { return values; },
         [&](Values& values) { EXPECT_EQ(values, Values(m_pairs.size(), -1)); }});
  }

  const Mesh m_mesh = small_terrain();
  const Pairs m_pairs = pairs();
};

TEST_F(Interrupted_pairs, along_edges) { expect_survival_with(parameters::maximum_distance(5)); }

TEST_F(Interrupted_pairs, across_faces) { expect_survival_with(parameters::epsilon(1.)); }

#ifdef CGAL_LINKED_WITH_TBB
TEST_F(Interrupted_pairs, of_several_threads)
{
  expect_survival_with(parameters::concurrency_tag(CGAL::Parallel_tag()));
}
#endif

TEST_F(Interrupted_pairs, with_paths)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>;
  const Paths paths(m_mesh, parameters::epsilon(0.5));
  const AG::Pair_queries queries(paths);
  expect_survival([&] {
    Values result;
    for(const auto& path : queries.paths(m_pairs, parameters::straighten(true)))
      for(const Point& p : path)
        result.insert(result.end(), {p.x(), p.y(), p.z()});
    return result;
  });
}

// A workspace can be used again.
TEST_F(Interrupted_pairs, of_a_search)
{
  const Graph graph{Triangulation(m_mesh)};
  const auto pairs = pairs_of(graph.triangulation());
  AG::Surface_search<Graph> search(graph);
  expect_survival([&] { return AG::pair_distances(search, pairs); });
}

// So can landmarks, and the workspaces of two graphs.
TEST_F(Interrupted_pairs, that_are_exact_and_prepared)
{
  using Search = AG::Guided_search<Saddle_vertex_graph>;
  const Saddle_vertex_graph graph{Triangulation(m_mesh)};
  const auto pairs = pairs_of(graph.triangulation());
  expect_survival([&] {
    const AG::Exact_landmarks<Saddle_vertex_graph> landmarks(graph, 2);
    Search search(graph);
    search.use_landmarks(landmarks);
    return AG::pair_distances(search, pairs);
  });
  const AG::Exact_landmarks<Saddle_vertex_graph> landmarks(graph, 2);
  Search search(graph);
  search.use_landmarks(landmarks);
  // buckets adapt to it: the next run may fill others, which keep memory
  AG::pair_distances(search, pairs);
  expect_survival([&] { return AG::pair_distances(search, pairs); });
}

// After a failure, nothing counts as reached, whether the search was guided or not.
TEST_F(Interrupted_pairs, that_are_led_around_barriers)
{
  using Search = AG::Guided_search<Steiner_graph<Fixed_number_of_points>>;
  Random random(test_seed());
  const Barriers barriers = random_barriers(m_mesh, 0.3, random);
  const Steiner_graph<Fixed_number_of_points> graph(Triangulation(m_mesh, with_barriers(barriers)),
                                                    Fixed_number_of_points(0));
  const AG::Landmarks<Steiner_graph<Fixed_number_of_points>> landmarks(graph, 2);
  const auto pairs = pairs_of(graph.triangulation());
  Search search(graph);
  search.use_landmarks(landmarks);
  const auto is_forgotten = [&](Values&) {
    for(Node n = 0; n < graph.number_of_nodes(); ++n)
      EXPECT_EQ(search.source(n), Search::null_source);
  };
  for(const auto& [source, target] : pairs)
    expect_survival<Values>({[] { return Values(); },
                             [&, s = source, t = target](Values& values) {
                               search.run({{t}});
                               search.run_to(t, {{s}});
                               values = {search.distance(t)};
                             },
                             [](Values& values) { return values; }});
  search.run({});
  for(const auto& [source, target] : pairs)
    expect_survival<Values>({[] { return Values(); },
                             [&, s = source, t = target](Values&) { search.run_to(t, {{s}}); },
                             [&, t = target](Values&) {
                               const Values result = {search.distance(t)};
                               search.run({});
                               return result;
                             },
                             is_forgotten});
}

} // namespace
