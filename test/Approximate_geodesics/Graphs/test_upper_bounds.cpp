// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Upper_bounds.h>

#include "checks/graphs_of_all_kinds.h"
#include "checks/test_random.h"
#include "meshes/test_meshes.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Search/Propagation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Upper bounds of exact searches: those along edges from the sources, and those that are continued
// from labels. The same distances are found with both.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Bounds = AG::internal::Upper_bounds;
using Exact_search_with_bounds = AG::Propagation<AG::Saddle_vertex_graph>;

constexpr double no_bound = std::numeric_limits<double>::infinity();

// Surfaces of all degrees of roughness, without needles: lengths of two paths differ by more than
// rounding errors, or the paths are the same.
std::vector<std::pair<std::string, Soup>> surfaces_with_bounds(Random& random)
{
  const auto ground = [&](const double noise, const double step) {
    return grid(40, 37, [&, noise, step](const double i, const double j) {
      const double hills = 3 * std::sin(i / 5) * std::cos(j / 7) + noise * random.between(-1, 1);
      const double height = step > 0 ? step * std::round(hills / step) : hills;
      return Point(i + random.between(-0.2, 0.2), j + random.between(-0.2, 0.2), height);
    });
  };
  Soup noisy_ball = sphere(40, 25);
  for(Point& p : noisy_ball.points)
  {
    const double radius = 1 + random.between(-0.04, 0.04);
    p = Point(radius * p.x(), radius * p.y(), radius * p.z());
  }
  return {{"smooth", ground(0, 0)},         {"rough", ground(0.4, 0)},
          {"very rough", ground(1.5, 0)},   {"in steps", ground(0, 0.5)},
          {"noisy sphere", noisy_ball},     {"sphere", sphere(40, 25)},
          {"coarse", terrain(9, 8, random)}};
}

void expect_same_bits_with_either_bounds(const AG::Saddle_vertex_graph& graph,
                                         const std::vector<AG::Seed>& seeds,
                                         const AG::Stop_rule& rule)
{
  Exact_search_with_bounds continued(graph), from_sources(graph);
  continued.run(seeds, rule);
  // with a heuristic, bounds are not continued
  from_sources.run_toward(seeds, rule, [](const Node) { return 0.; });
  for(Node node = 0; node < graph.number_of_nodes() && rule.targets.empty(); ++node)
    EXPECT_EQ(continued.distance(node), from_sources.distance(node)) << node;
  for(const Node target : rule.targets)
    EXPECT_EQ(continued.distance(target), from_sources.distance(target)) << target;
}

TEST(Upper_bounds, change_no_bit)
{
  Random random(test_seed());
  for(const auto& [name, soup] : surfaces_with_bounds(random))
  {
    SCOPED_TRACE(name);
    const AG::Saddle_vertex_graph graph{Triangulation(to_mesh(soup))};
    const auto node = [&] { return static_cast<Node>(random.below(graph.number_of_nodes())); };
    const double edge = graph.unit() * graph.arc_lengths().mean;
    const std::vector<AG::Seed> one{{node()}}, several{{node(), 0, 0},
                                                       {node(), 2.5 * edge, 1},
                                                       {node(), 400.3 * edge, 2},
                                                       {node(), edge / 3, 3}};
    for(const auto& seeds : {one, several})
    {
      expect_same_bits_with_either_bounds(graph, seeds, {});
      expect_same_bits_with_either_bounds(graph, seeds, {9.3 * edge, {}, {}});
      expect_same_bits_with_either_bounds(graph, seeds, {no_bound, {node()}, {}});
    }
  }
}

// A run may leave bounds behind only where it forgets them.
TEST(Upper_bounds, are_forgotten_with_their_run)
{
  Random random(test_seed());
  for(const auto& [name, soup] : surfaces_with_bounds(random))
  {
    SCOPED_TRACE(name);
    const AG::Saddle_vertex_graph graph{Triangulation(to_mesh(soup))};
    const double edge = graph.unit() * graph.arc_lengths().mean;
    Exact_search_with_bounds reused(graph);
    for(int round = 0; round < 8; ++round)
    {
      const auto node = [&] { return static_cast<Node>(random.below(graph.number_of_nodes())); };
      const AG::Stop_rule rule = round % 2 == 0
                                     ? AG::Stop_rule{random.between(0, 12) * edge, {}, {}}
                                     : AG::Stop_rule{no_bound, {node()}, {}};
      reused.run({{node()}}, rule);
      const Node source = node();
      Exact_search_with_bounds fresh(graph);
      reused.run_from(source);
      fresh.run_from(source);
      for(Node v = 0; v < graph.number_of_nodes(); ++v)
        ASSERT_EQ(reused.distance(v), fresh.distance(v)) << round << ' ' << v;
    }
  }
}

// Between distances and lengths of paths along edges.
TEST(Upper_bounds, are_continued_along_edges)
{
  Random random(test_seed());
  const Triangulation triangulation(to_mesh(terrain(20, 20, random)));
  const Node source = static_cast<Node>(random.below(triangulation.number_of_vertices()));
  const AG::Edge_graph edges(triangulation);
  AG::Propagation<AG::Edge_graph> search(edges);
  search.run_from(source);
  const auto n = static_cast<Node>(triangulation.number_of_vertices());
  Bounds bounds(n);
  bounds.start(true);
  constexpr double loose = 1.1;
  const Node unknown = source == 0 ? 1 : 0;
  for(Node v = 0; v < n; ++v)
    if(v != unknown)
      bounds.start_with(v, loose * search.labels().distance(v) + 1);
  bounds.lower(source, 0);
  bounds.spread(triangulation, 3, 3); // up to 6
  bool is_any_beyond = false;
  for(Node v = 0; v < n; ++v)
  {
    const double along_edges = search.labels().distance(v);
    if(v == unknown)
      EXPECT_EQ(bounds[v], no_bound);
    else if(along_edges <= 6 && search.predecessor(v) != unknown)
      EXPECT_GE(bounds[v], along_edges);
    else
      is_any_beyond = is_any_beyond || bounds[v] == loose * along_edges + 1;
  }
  EXPECT_EQ(bounds[source], 0);
  for(Triangulation::Index h = triangulation.first_halfedge(source);
      h < triangulation.beyond_halfedge(source); ++h)
  {
    const Node v = triangulation.target(h);
    EXPECT_EQ(bounds[v], v == unknown ? no_bound : search.labels().distance(v));
  }
  EXPECT_TRUE(is_any_beyond);
  bounds.forget({source});
  for(Node v = 0; v < n; ++v)
    EXPECT_EQ(bounds[v], no_bound);
}

} // namespace
