// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "meshes/steiner_meshes.h"
#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

// Paths between points of a surface whose lengths can be said beforehand.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

double bounded_distance(const Mesh& mesh, const Point& from, const Point& to, const double epsilon)
{
  std::vector<Point> points;
  return CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), location_at(mesh, from),
                                         location_at(mesh, to), parameters::epsilon(epsilon));
}

// ----- unfolded

TEST(Surface_paths, are_straight_in_the_plane)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(9, 9));
  for(int i = 0; i < 100; ++i)
  {
    const Surface_point p = random_surface_point(mesh, random);
    const Surface_point q = random_surface_point(mesh, random);
    const double straight = distance_in_space(position(mesh, p), position(mesh, q));
    for(const double epsilon : {0.1, 1e-3})
    {
      std::vector<Point> points;
      const double found = CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), p, q,
                                                           parameters::epsilon(epsilon));
      EXPECT_GE(found, straight * (1 - rounding_of_costs) - 1e-15);
      EXPECT_LE(found, straight * (1 + epsilon) + 1e-15);
    }
  }
}

TEST(Surface_paths, are_straight_in_a_face)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph> on_edges(mesh);
    AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>> on_points(mesh);
    for(int i = 0; i < 20; ++i)
    {
      const Face_location p = random_face_location(mesh, random);
      const Face_location q(p.first, random_face_location(mesh, random).second);
      const double straight = distance_in_space(position(mesh, p), position(mesh, q));
      const Halfedge h = mesh.halfedge(p.first);
      const bool has_area = !CGAL::collinear(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                             mesh.point(mesh.target(mesh.next(h))));
      const auto expect_straight = [&](auto& paths) {
        paths.remove_all_source_points();
        paths.add_source_point(p);
        std::vector<Point> points;
        const double found = paths
                                 .shortest_path_points_to_source_points(q.first, q.second,
                                                                        std::back_inserter(points))
                                 .first;
        EXPECT_NEAR(found, straight, 1e-12 * size(mesh));
        EXPECT_TRUE(points.size() == 2 || !has_area); // a way over a corner may be as short there
      };
      expect_straight(on_edges);
      expect_straight(on_points);
    }
  });
}

Soup box(const double x, const double y, const double z)
{
  Soup result;
  for(const double c : {0., z})
    for(const double b : {0., y})
      for(const double a : {0., x})
        result.points.push_back(Point(a, b, c));
  result.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return result;
}

TEST(Surface_paths, go_around_a_cube)
{
  const Mesh mesh = to_mesh(box(1, 1, 1));
  const Point left(0, 0.5, 0.5), right(1, 0.5, 0.5), top(0.5, 0.5, 1), low(0, 0.5, 0.25);
  for(const auto& [p, q, expected] :
      {std::tuple(left, right, 2.), std::tuple(left, top, 1.), std::tuple(low, top, 1.25),
       std::tuple(low, Point(1, 0.5, 0.75), 2.), std::tuple(left, Point(0, 0, 0), std::sqrt(0.5))})
    for(const double epsilon : {0.5, 0.1, 1e-2, 1e-4})
    {
      const double found = bounded_distance(mesh, p, q, epsilon);
      EXPECT_GE(found, expected * (1 - rounding_of_costs));
      EXPECT_LE(found, expected * (1 + epsilon));
    }
}

// The spider and the fly in a room of 30 by 12 by 12 feet, which are 40 feet apart, over five of
// its six sides.
TEST(Surface_paths, solve_an_old_puzzle)
{
  const Mesh room = to_mesh(box(30, 12, 12));
  const double found = bounded_distance(room, Point(0, 6, 11), Point(30, 6, 1), 1e-4);
  EXPECT_GE(found, 40 * (1 - rounding_of_costs));
  EXPECT_LE(found, 40 * (1 + 1e-4));
}

TEST(Surface_paths, go_around_a_tetrahedron)
{
  const Point a(1, 1, 1), b(1, -1, -1), c(-1, 1, -1), d(-1, -1, 1);
  const Mesh mesh = to_mesh({{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}});
  const double edge = std::sqrt(8);
  const auto middle = [](const Point& p, const Point& q) { return CGAL::midpoint(p, q); };
  for(const auto& [p, q, expected] :
      {std::tuple(middle(a, b), middle(c, d), 1.),
       std::tuple(CGAL::centroid(a, b, c), CGAL::centroid(b, c, d), 1 / std::sqrt(3)),
       std::tuple(a, CGAL::centroid(b, c, d), 2 / std::sqrt(3)),
       std::tuple(a, middle(c, d), std::sqrt(0.75))})
    for(const double epsilon : {0.5, 0.1, 1e-2, 1e-4})
    {
      const double found = bounded_distance(mesh, p, q, epsilon);
      EXPECT_GE(found, edge * expected * (1 - rounding_of_costs));
      EXPECT_LE(found, edge * expected * (1 + epsilon));
    }
}

// ----- along edges

// The corners of the faces that a point is in, with their distances from it.
std::vector<std::pair<Vertex, double>> corners(const Mesh& mesh, const Surface_point& p)
{
  std::vector<std::pair<Vertex, double>> result;
  if(const Vertex* corner = std::get_if<Vertex>(&p))
    result.emplace_back(*corner, 0);
  else
    for(const Face f : faces_of(mesh, p))
      for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        result.emplace_back(v, distance_in_space(mesh.point(v), position(mesh, p)));
  return result;
}

TEST(Surface_paths, along_edges_start_and_end_straight)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    Mesh_search search(mesh);
    AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph> paths(mesh);
    const Surface_point source = random_surface_point(mesh, random);
    paths.add_source_point(source);
    std::vector<std::vector<double>> from_corners;
    for(const auto& [v, first] : corners(mesh, source))
      from_corners.push_back(search.distances({v}));
    for(const Surface_point& target : random_surface_points(mesh, 50, random))
    {
      double expected = infinity;
      std::size_t i = 0;
      for(const auto& [v, first] : corners(mesh, source))
      {
        for(const auto& [w, last] : corners(mesh, target))
          expected = (std::min)(expected, first + from_corners[i][w.idx()] + last);
        ++i;
      }
      if(share_a_face(mesh, source, target))
        expected =
            (std::min)(expected, distance_in_space(position(mesh, source), position(mesh, target)));
      const double found = paths.shortest_distance_to_source_points(target).first;
      if(expected == infinity)
        EXPECT_EQ(found, -1);
      else
        EXPECT_NEAR(found, expected, 1e-12 * size(mesh));
    }
  });
}

// ----- with weights

// From the middle of a costly face one goes to a side of it, and further along that.
TEST(Surface_paths, leave_costly_faces_soon)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Point middle(4. / 3, 5. / 3, 0), corner(1, 2, 0);
  const Face_location source = location_at(mesh, middle);
  Weights weights(mesh.num_faces(), 1);
  weights[source.first.idx()] = 3;
  double expected = infinity;
  for(double y = 1; y <= 2; y += 1e-5)
    expected = (std::min)(expected, 3 * std::hypot(1. / 3, 5. / 3 - y) + 2 - y);
  for(const double epsilon : {0.5, 0.1, 0.01})
  {
    std::vector<Point> points;
    const double found = CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source,
                                                         location_at(mesh, corner),
                                                         with_weights(weights).epsilon(epsilon));
    EXPECT_GE(found, expected * (1 - 1e-8));
    EXPECT_LE(found, expected * (1 + epsilon));
  }
}

TEST(Surface_paths, cost_nothing_in_free_faces_and_do_not_enter_forbidden_ones)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Face_location in_free = location_at(mesh, Point(0.7, 0.4, 0));
  const Face_location in_forbidden = location_at(mesh, Point(1.7, 1.4, 0));
  Weights weights(mesh.num_faces(), 1);
  weights[in_free.first.idx()] = 0;
  weights[in_forbidden.first.idx()] = infinity;
  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>> paths(
      mesh, with_weights(weights).number_of_points_per_edge(3));
  paths.add_source_point(in_free);
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(0)).first, 0);
  EXPECT_EQ(paths.shortest_distance_to_source_points(in_forbidden).first, -1);
  const Face_location beside = location_at(mesh, Point(1.5, 1, 0)); // on an edge of the former
  EXPECT_NEAR(paths.shortest_distance_to_source_points(beside).first, 0.5, rounding_of_costs);
  paths.remove_all_source_points();
  paths.add_source_point(in_forbidden);
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(0)).first, -1);
}

// ----- with barriers

// A grid of 6 by 6 cells, whose edges on the line x = 3 are barriers up to a height.
class Wall_in_grid : public testing::Test
{
protected:
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Geometric_points>>;

  static constexpr double EPSILON = 0.02;

  auto parameters_for_wall(const double height)
  {
    m_barriers.assign(m_mesh.num_edges(), false);
    for(const Edge e : m_mesh.edges())
    {
      const Point &p = m_mesh.point(m_mesh.vertex(e, 0)), &q = m_mesh.point(m_mesh.vertex(e, 1));
      m_barriers[e.idx()] = p.x() == 3 && q.x() == 3 && (std::max)(p.y(), q.y()) <= height;
    }
    return parameters::epsilon(EPSILON).edge_is_constrained_map(barrier_map(m_barriers));
  }

  Face_location at(const double x, const double y) const
  {
    return location_at(m_mesh, Point(x, y, 0));
  }

  const Mesh m_mesh = to_mesh(flat_grid(7, 7));
  Barriers m_barriers;
};

TEST_F(Wall_in_grid, lets_nothing_through)
{
  Paths paths(m_mesh, parameters_for_wall(6));
  paths.add_source_point(at(2.2, 3.4));
  EXPECT_EQ(paths.shortest_distance_to_source_points(at(3.3, 3.4)).first, -1);
  EXPECT_EQ(paths.shortest_distance_to_source_points(at(3 + 1e-12, 3.4)).first, -1);
  EXPECT_GT(paths.shortest_distance_to_source_points(at(3, 3.4)).first, 0);
}

// A point of the wall is on both sides of it.
TEST_F(Wall_in_grid, is_reached_from_both_sides)
{
  Paths paths(m_mesh, parameters_for_wall(6));
  const Face_location on_wall = at(3, 3.4);
  for(const Face_location& beside : {at(2.5, 3.2), at(3.5, 3.8), at(3, 3.9)})
  {
    const double straight = distance_in_space(position(m_mesh, on_wall), position(m_mesh, beside));
    const auto expect_straight = [&](const Face_location& from, const Face_location& to) {
      paths.remove_all_source_points();
      paths.add_source_point(from);
      EXPECT_NEAR(paths.shortest_distance_to_source_points(to).first, straight, rounding_of_costs);
    };
    expect_straight(on_wall, beside);
    expect_straight(beside, on_wall);
  }
}

TEST_F(Wall_in_grid, is_gone_around)
{
  Paths paths(m_mesh, parameters_for_wall(5));
  const Point end(3, 5, 0);
  for(const Point& p : {Point(1.3, 2.6, 0), Point(2.9, 3.2, 0), Point(2.5, 4.5, 0)})
    for(const Point& q : {Point(4.4, 1.3, 0), Point(3.01, 3.2, 0), Point(5.5, 0.5, 0)})
    {
      paths.remove_all_source_points();
      paths.add_source_point(location_at(m_mesh, p));
      const double expected = distance_in_space(p, end) + distance_in_space(end, q);
      const double found =
          paths.shortest_distance_to_source_points(Surface_point(location_at(m_mesh, q))).first;
      EXPECT_GE(found, expected * (1 - rounding_of_costs));
      EXPECT_LE(found, expected * (1 + EPSILON));
    }
}

// A source at a vertex of the wall starts on both sides of it, even if another source, on one side,
// is nearer to the vertex.
TEST_F(Wall_in_grid, divides_what_starts_on_it)
{
  Paths paths(m_mesh, parameters_for_wall(6));
  const Vertex on_wall(3 + 3 * 7), left(2 + 3 * 7), right(4 + 3 * 7), far_left(0 + 3 * 7);
  const auto from_wall = paths.add_source_point(on_wall, 2);
  const auto from_left = paths.add_source_point(left);
  const auto expect = [&](const Surface_point& p, const double distance, const auto source) {
    const auto [found, it] = paths.shortest_distance_to_source_points(p);
    EXPECT_NEAR(found, distance, rounding_of_costs);
    EXPECT_TRUE(it == source);
    std::vector<Surface_point> points;
    paths.shortest_path_surface_points_to_source_points(p, std::back_inserter(points));
    ASSERT_FALSE(points.empty());
    EXPECT_EQ(position(m_mesh, points.back()), m_mesh.point(source == from_wall ? on_wall : left));
  };
  expect(left, 0, from_left);
  expect(far_left, 2, from_left);
  expect(on_wall, 1, from_left);
  expect(right, 3, from_wall);
  expect(at(3.5, 3.5), 2 + std::sqrt(0.5), from_wall);
  expect(at(2.5, 2.5), std::sqrt(0.5), from_left);
}

} // namespace
