// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_queries/Point_pairs.h>

#include "checks/distance_matrices.h"
#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Paths/Path.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

// Lists of pairs, in any graph, are what a search for each of them finds, to the last bit.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Pairs = std::vector<AG::Point_pair>;
using Numbers = std::vector<double>;

// Each point with several others and with itself, in random order, and some pairs twice.
Pairs pairs_of(const std::vector<Intrinsic_point>& points, Random& random)
{
  Pairs result;
  for(const Intrinsic_point& p : points)
  {
    result.emplace_back(p, p);
    for(std::size_t i = 0; i < 4; ++i)
      result.emplace_back(p, points[random.below(points.size())]);
  }
  result.insert(result.end(), result.begin(),
                result.begin() + static_cast<std::ptrdiff_t>(result.size() / 4));
  random.shuffle(result);
  return result;
}

Pairs random_pairs(const Mesh& mesh, const Triangulation& triangulation, Random& random)
{
  std::vector<Surface_point> points = some_vertices(mesh);
  for(const Surface_point& p : some_points(mesh))
    points.push_back(p);
  if(mesh.number_of_faces() > 0 && !mesh.has_garbage())
    for(const Surface_point& p : random_surface_points(mesh, 6, random))
      points.push_back(p);
  return pairs_of(intrinsic_points(mesh, triangulation, points), random);
}

void append_path(const AG::Path& path, Numbers& result)
{
  result.push_back(path.length);
  result.push_back(double(path.points.size()));
  for(const Intrinsic_point& p : path.points)
    result.insert(result.end(), {double(p.vertex), double(p.halfedge), p.t, p.s});
}

// The distances and the paths of all pairs.
struct Findings
{
  Numbers distances, paths;
};

template <typename Queue, typename GeodesicGraph>
Findings found_together(const GeodesicGraph& graph, const Pairs& pairs, const double limit)
{
  AG::Surface_search<GeodesicGraph, Queue> search(graph);
  Findings result{AG::pair_distances(search, pairs, limit), {}};
  for(const AG::Path& path : AG::pair_paths(search, pairs, limit))
    append_path(path, result.paths);
  return result;
}

// By a workspace for each pair: that of a bucket queue adapts to earlier runs.
template <typename Queue, typename GeodesicGraph>
Findings found_one_by_one(const GeodesicGraph& graph, const Pairs& pairs, const double limit)
{
  Findings result;
  for(auto [start, end] : pairs)
  {
    const bool is_reversed = AG::internal::leads_to_sources(graph);
    if(is_reversed)
      std::swap(start, end);
    AG::Surface_search<GeodesicGraph, Queue> search(graph);
    search.run({{start}}, {limit, {end}});
    result.distances.push_back(search.distance(end));
    AG::Path path = search.find_path(end);
    if(!is_reversed)
      std::reverse(path.points.begin(), path.points.end());
    append_path(path, result.paths);
  }
  return result;
}

// Of paths that are equally long, any may be found where edges vanish by rounding.
template <typename Queue, typename GeodesicGraph>
void expect_same_distances(const GeodesicGraph& graph, const Pairs& pairs, const double deviation)
{
  const Numbers found = found_together<Queue>(graph, pairs, infinity).distances;
  const Numbers expected = found_one_by_one<Queue>(graph, pairs, infinity).distances;
  for(std::size_t i = 0; i < pairs.size(); ++i)
  {
    EXPECT_LE(found[i], (1 + deviation) * expected[i]);
    EXPECT_GE(found[i], (1 - deviation) * expected[i]);
  }
}

template <typename Queue, typename GeodesicGraph>
void expect_same(const GeodesicGraph& graph, const Pairs& pairs, const double limit = infinity)
{
  const Findings found = found_together<Queue>(graph, pairs, limit);
  const Findings expected = found_one_by_one<Queue>(graph, pairs, limit);
  EXPECT_TRUE(have_same_bits(found.distances, expected.distances));
  EXPECT_TRUE(have_same_bits(found.paths, expected.paths));
  for(std::size_t i = 0; i < pairs.size(); ++i)
    if(pairs[i].first.is_same(pairs[i].second, graph.triangulation()))
    {
      EXPECT_EQ(found.distances[i], 0);
    }
}

template <typename Kind>
void expect_same_on(const Mesh& mesh, const Kind& kind, Random& random)
{
  using Geodesic_graph = typename Kind::Graph;
  const Geodesic_graph graph = kind.make(Triangulation(mesh));
  const Pairs pairs = random_pairs(mesh, graph.triangulation(), random);
  expect_same<AG::Binary_heap_queue>(graph, pairs);
  expect_same<AG::Binary_heap_queue>(graph, pairs, size(mesh) / 3);
  if constexpr(!std::is_same_v<Geodesic_graph, Lazy_discrete_geodesic_graph>)
    expect_same<AG::Adaptive_bucket_queue>(graph, pairs);
}

TEST(Point_pairs, are_those_of_single_searches)
{
  Random random(test_seed());
  for(std::uint64_t i = 0; i < number_of_kinds_of_soups; ++i)
  {
    const Mesh mesh = to_mesh(random_small_soup(test_seed() + i));
    for_each_small_graph(0.3, [&](const auto& kind) { expect_same_on(mesh, kind, random); });
  }
}

TEST(Point_pairs, are_those_of_single_searches_on_hostile_meshes)
{
  Random random(test_seed());
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    const auto expect = [&](const auto& kind) {
      const auto graph = kind.make(Triangulation(row.mesh));
      const Pairs pairs = random_pairs(row.mesh, graph.triangulation(), random);
      // exact distances depend on where a search ends if faces are degenerate
      const double deviation = kind.epsilon == 0 ? 1e-13 : 0;
      expect_same_distances<AG::Binary_heap_queue>(graph, pairs, deviation);
    };
    if(!row.refusal_across_faces.empty())
      expect(edge_graph());
    else
      for_each_small_graph(0.5, expect);
  }
}

TEST(Point_pairs, heed_weights_and_barriers)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(7, 6, random));
  const Weights weights = random_weights(mesh, random, 0.5, 2, 0.1);
  const Barriers barriers = random_barriers(mesh, 0.2, random);
  const Triangulation triangulation(
      mesh, with_weights(weights).edge_is_constrained_map(barrier_map(barriers)));
  const Pairs pairs = random_pairs(mesh, triangulation, random);
  expect_same<AG::Binary_heap_queue>(graph_with_spaced_points(2).make(triangulation), pairs);
  expect_same<AG::Binary_heap_queue>(
      graph_with_points("geometric points", Geometric_points(1.), 1).make(triangulation), pairs);
}

TEST(Point_pairs, keep_their_direction)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(6, 5, random));
  const auto slants = random_slants(mesh, random, 0.8);
  const Dense_graph graph = dense_graph(mesh, cost_of_faces(slants), 2);
  const Dense_graph reversed = graph.reversed();
  const Pairs pairs = random_pairs(mesh, graph.triangulation(), random);
  expect_same<AG::Binary_heap_queue>(graph, pairs);
  expect_same<AG::Binary_heap_queue>(reversed, pairs);
  AG::Surface_search<Dense_graph> forward(graph), backward(reversed);
  const Numbers there = AG::pair_distances(forward, pairs);
  const Numbers from_the_end = AG::pair_distances(backward, pairs);
  for(std::size_t i = 0; i < pairs.size(); ++i)
  {
    const double larger = (std::max)(there[i], from_the_end[i]);
    EXPECT_GE((std::min)(there[i], from_the_end[i]), (1 - 1e-12) * larger);
  }
}

class Point_pairs_on_two_grids : public testing::Test
{
protected:
  static Mesh two_grids()
  {
    Soup soup = flat_grid(5, 4);
    soup.append(flat_grid(3, 3));
    return to_mesh(soup);
  }

  Intrinsic_point vertex(const Mesh::size_type i) const
  {
    return Intrinsic_point::at_vertex(m_graph.triangulation().vertex(i));
  }

  const Mesh m_mesh = two_grids();
  const Graph m_graph{Triangulation(m_mesh)};
  AG::Surface_search<Graph> m_search{m_graph};
};

TEST_F(Point_pairs_on_two_grids, are_infinite_where_there_is_no_path)
{
  const Pairs pairs{{vertex(0), vertex(22)}, {vertex(0), vertex(4)}, {vertex(22), vertex(22)}};
  EXPECT_EQ(AG::pair_distances(m_search, pairs), (Numbers{infinity, 4, 0}));
  const auto paths = AG::pair_paths(m_search, pairs);
  EXPECT_TRUE(paths[0].points.empty());
  EXPECT_EQ(paths[1].points.front().vertex, vertex(0).vertex);
  EXPECT_EQ(paths[1].points.back().vertex, vertex(4).vertex);
  EXPECT_EQ(paths[2].points.size(), 1u);
  EXPECT_EQ(AG::pair_distances(m_search, pairs, 3), (Numbers{infinity, infinity, 0}));
}

TEST_F(Point_pairs_on_two_grids, may_be_none)
{
  EXPECT_TRUE(AG::pair_distances(m_search, {}).empty());
  EXPECT_TRUE(AG::pair_paths(m_search, {}).empty());
}

TEST_F(Point_pairs_on_two_grids, share_a_search)
{
  m_search.collect_statistics(true);
  AG::pair_distances(m_search,
                     {{vertex(0), vertex(1)}, {vertex(0), vertex(19)}, {vertex(0), vertex(0)}});
  EXPECT_EQ(m_search.sources().size(), 1u);
  for(const auto target : {vertex(1), vertex(19), vertex(0)}) // all are known to the last search
    EXPECT_LT(m_search.distance(target), infinity);
  AG::pair_distances(m_search, {{vertex(0), vertex(1)}});
  EXPECT_LT(m_search.search().statistics().settled_nodes, 10u); // it stops at the target
}

TEST_F(Point_pairs_on_two_grids, are_refused_by_their_number)
{
  const Intrinsic_point wrong = Intrinsic_point::at_vertex(99);
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  expect_message<std::invalid_argument>(
      [&] {
        AG::pair_distances(m_search, {{vertex(0), vertex(1)}, {vertex(0), wrong}});
      },
      "pair 1", "target");
  expect_message<std::invalid_argument>(
      [&] {
        AG::pair_paths(m_search, {{Intrinsic_point::on_edge(0, not_a_number), vertex(0)}});
      },
      "pair 0", "source");
  EXPECT_EQ(AG::pair_distances(m_search, {{vertex(0), vertex(1)}}), Numbers{1});
}

} // namespace
