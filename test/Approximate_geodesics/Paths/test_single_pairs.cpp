// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_random.h"
#include "meshes/test_soup.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_costs/equal_parts.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// Searches that are led to their goal find what complete ones do.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

template <typename Graph, typename Queue>
struct Subject
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Graph, Queue>;
};

template <typename Subject>
class Single_pairs : public testing::Test
{
protected:
  using Paths = typename Subject::Paths;

  // Distances from some vertices to others and to points in faces, found in both ways.
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  static void compare(const Mesh& mesh,
                      const NamedParameters& np = CGAL::parameters::default_values())
  {
    Random random(test_seed());
    Paths complete(mesh, np), back(mesh, np), led(mesh, np);
    for(std::size_t i = 0; i < 12; ++i)
    {
      const Vertex source = random_vertex(mesh, random);
      complete.remove_all_source_points();
      complete.add_source_point(source);
      for(std::size_t j = 0; j < 12; ++j)
      {
        const Vertex v = random_vertex(mesh, random);
        expect_equal(led.shortest_distance(source, v),
                     complete.shortest_distance_to_source_points(v).first);
        const Face f(static_cast<Mesh::size_type>(random.below(mesh.number_of_faces())));
        const typename Paths::Face_location place(f, {0.5, 0.25, 0.25});
        expect_equal(led.shortest_distance(source, place),
                     complete.shortest_distance_to_source_points(place.first, place.second).first);
        back.remove_all_source_points(); // which need not be as long in a discrete geodesic graph
        back.add_source_point(place);
        expect_equal(led.shortest_distance(place, source),
                     back.shortest_distance_to_source_points(source).first);
      }
    }
  }

  // Sums can be rounded in another order.
  static void expect_equal(const double distance, const double expected)
  {
    EXPECT_NEAR(distance, expected, 1e-7 * std::abs(expected)); // arcs are in single precision
  }
};
using Subjects =
    testing::Types<Subject<AG::Edge_graph, AG::Adaptive_bucket_queue>,
                   Subject<AG::Edge_graph, AG::Binary_heap_queue>,
                   Subject<AG::Edge_graph, AG::Radix_heap_queue>,
                   Subject<AG::Discrete_geodesic_graph, AG::Adaptive_bucket_queue>,
                   Subject<AG::Discrete_geodesic_graph, AG::Binary_heap_queue>,
                   Subject<AG::Steiner_graph<AG::Fixed_number_of_points>, AG::Radix_heap_queue>>;
TYPED_TEST_SUITE(Single_pairs, Subjects, );

// Many paths are equally long, and the keys of their nodes the same but for rounding.
TYPED_TEST(Single_pairs, on_a_grid) { this->compare(to_mesh(flat_grid(9, 8))); }

TYPED_TEST(Single_pairs, on_a_grid_far_away)
{
  Mesh mesh = to_mesh(flat_grid(9, 8));
  for(const Vertex v : mesh.vertices())
    mesh.point(v) = Point(mesh.point(v).x() / 3 + 1e8, mesh.point(v).y() / 7 - 1e8, 1e8);
  this->compare(mesh);
}

// Lengths that are not those of the points: the straight line through space leads nowhere.
TYPED_TEST(Single_pairs, with_lengths_of_another_surface)
{
  const Mesh mesh = to_mesh(flat_grid(9, 8));
  const auto length = [&mesh](const Mesh::Edge_index e) {
    const auto h = mesh.halfedge(e);
    const auto way = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    return std::hypot(1.9 * way.x(), way.y() / 4);
  };
  const auto lengths = boost::make_function_property_map<Mesh::Edge_index, double>(length);
  this->compare(mesh, CGAL::parameters::edge_length_map(lengths));
}

// Beside the length of the way, that of the shortest edges vanishes by rounding.
TYPED_TEST(Single_pairs, on_a_strip_that_grows_by_orders_of_magnitude)
{
  this->compare(to_mesh(growing_strip(30, 1e-20, 1)));
}

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

TYPED_TEST(Single_pairs, between_subnormal_coordinates)
{
  const double step = 2e-323; // four times the smallest number
  this->compare(to_mesh(flat_grid(5, 4).transformed(
      [&](const Point& p) { return Point(p.x() * step, p.y() * step, 0); })));
}

TYPED_TEST(Single_pairs, are_not_found_in_other_components)
{
  Soup soup = flat_grid(3, 3);
  soup.append(flat_grid(2, 2));
  const Mesh mesh = to_mesh(soup);
  typename TestFixture::Paths paths(mesh);
  std::vector<Point> points;
  const Vertex last(mesh.num_vertices() - 1);
  EXPECT_LT(paths.shortest_distance(Vertex(0), last), 0);
  EXPECT_LT(paths.shortest_path_points(Vertex(0), last, std::back_inserter(points)), 0);
  EXPECT_TRUE(points.empty());
}

TYPED_TEST(Single_pairs, do_not_change_sources)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  typename TestFixture::Paths paths(mesh);
  paths.add_source_point(Vertex(0));
  const double before = paths.shortest_distance_to_source_points(Vertex(7)).first;
  paths.shortest_distance(Vertex(3), Vertex(9));
  EXPECT_FALSE(paths.changed_since_last_build());
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(7)).first, before);
  EXPECT_EQ(paths.number_of_source_points(), 1u);
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
