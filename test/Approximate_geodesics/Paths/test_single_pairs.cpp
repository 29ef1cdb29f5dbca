// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Single_pairs.h"
#include "meshes/test_soup.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

using Of_the_core =
    testing::Types<Graph_and_queue<AG::Edge_graph, AG::Adaptive_bucket_queue>,
                   Graph_and_queue<AG::Edge_graph, AG::Binary_heap_queue>,
                   Graph_and_queue<AG::Edge_graph, AG::Radix_heap_queue>,
                   Graph_and_queue<AG::Discrete_geodesic_graph, AG::Adaptive_bucket_queue>,
                   Graph_and_queue<AG::Discrete_geodesic_graph, AG::Binary_heap_queue>>;
INSTANTIATE_TYPED_TEST_SUITE_P(On_edges_and_lines, Single_pairs, Of_the_core, );

// A search is led to a goal beside whose distance all other lengths vanish by rounding, so that all
// keys are the same. Returns how often it expanded nodes; only since it gave up being led, if it
// did.
template <typename Queue>
std::size_t expansions_on_the_way_to_a_far_goal(const std::size_t size)
{
  constexpr double length = 1e-20; // of the edges of the grid
  Soup soup = flat_grid(size, size).transformed([](const Point& p) {
    return Point(p.x() * length, p.y() * length, 0);
  });
  const std::size_t far = soup.points.size();
  soup.points.push_back(Point(0, -1, 0));
  soup.triangles.push_back({1, 0, far});
  const AG::Edge_graph graph{Triangulation(to_mesh(soup))};
  const Node goal = graph.triangulation().vertex(far);

  AG::Propagation<AG::Edge_graph, Queue> search(graph);
  search.run_toward({{graph.triangulation().vertex(far - 1)}}, {infinity, {goal}},
                    [&](const Node n) { return n == goal ? 0 : 1 / graph.unit(); });
  EXPECT_EQ(search.distance(goal), 1);
  return search.reached_nodes().size();
}

TEST(Led_search, does_not_expand_nodes_again_and_again)
{
  constexpr std::size_t size = 40, limit = 3 * (size * size + 2);
  EXPECT_LE(expansions_on_the_way_to_a_far_goal<AG::Adaptive_bucket_queue>(size), limit);
  EXPECT_LE(expansions_on_the_way_to_a_far_goal<AG::Binary_heap_queue>(size), limit);
  EXPECT_LE(expansions_on_the_way_to_a_far_goal<AG::Radix_heap_queue>(size), limit);
}

TEST(Single_pair, is_written_from_its_source_to_its_target)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  AG::Surface_mesh_shortest_path<Mesh> paths(mesh);
  std::vector<Point> points;
  const double length =
      paths.shortest_path_points(Vertex(2), Vertex(12), std::back_inserter(points));
  ASSERT_FALSE(points.empty());
  EXPECT_EQ(points.front(), mesh.point(Vertex(2)));
  EXPECT_EQ(points.back(), mesh.point(Vertex(12)));
  EXPECT_GT(length, 0);
  EXPECT_LT(paths.shortest_distance(Vertex(2), Vertex(12),
                                    CGAL::parameters::maximum_distance(length / 2)),
            0);
}

} // namespace
