// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "meshes/Cut_mesh.h"
#include "meshes/steiner_meshes.h"
#include "oracles/straight_lines.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

// Distances where edges are barriers.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

constexpr double few_epsilons[] = {0.5, 0.1, 0.02};
constexpr std::size_t few_nested_numbers[] = {0, 1, 3, 7};

template <typename Placement>
Basic_mesh_search<Steiner_graph<Placement>> search(const Mesh& mesh,
                                                   const Weights& weights,
                                                   const Barriers& barriers,
                                                   const Placement& placement)
{
  const auto np = with_weights(weights).edge_is_constrained_map(barrier_map(barriers));
  return {mesh, Steiner_graph<Placement>(Triangulation(mesh, np), placement)};
}

template <typename Placement>
std::vector<double> distances(const Mesh& mesh,
                              const Barriers& barriers,
                              const Placement& placement,
                              const Vertex source)
{
  return search(mesh, Weights(mesh.num_faces(), 1), barriers, placement).distances({source});
}

// Those edges of which `is_barrier(p, q)` says so for their ends.
template <typename F>
Barriers barriers_by_place(const Mesh& mesh, F is_barrier)
{
  Barriers result(mesh.num_edges());
  for(const Edge e : mesh.edges())
    result[e.idx()] = is_barrier(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  return result;
}

// ----- walls in the plane

constexpr std::size_t grid_columns = 13, grid_rows = 11;

Vertex at(const std::size_t i, const std::size_t j)
{
  return Vertex(static_cast<Mesh::size_type>(i + j * grid_columns));
}

// on the line x = 6, from y = low to y = high
struct Wall
{
  bool contains(const Point& p) const { return p.x() == 6 && p.y() >= low && p.y() <= high; }

  // The length of a taut string. Where the border of the plane is beyond an end, there is no way.
  double length_around(const Point& p, const Point& q) const
  {
    if((p.x() - 6) * (q.x() - 6) >= 0)
      return distance_in_space(p, q);
    const double y = p.y() + (q.y() - p.y()) * (6 - p.x()) / (q.x() - p.x());
    if(y <= low || y >= high)
      return distance_in_space(p, q);
    double result = infinity;
    for(const double end : {low, high})
      if(end > 0 && end < grid_rows - 1)
        result = (std::min)(result, distance_in_space(p, Point(6, end, 0)) +
                                        distance_in_space(Point(6, end, 0), q));
    return result;
  }

  double low, high;
};

// Attached to a border, or to none, or to both, and as short as can be. Sources are next to the
// wall, far from it, and on it: at its ends, and between them, from where both sides are in sight.
TEST(Barriers, make_paths_go_around_their_ends)
{
  const Mesh mesh = to_mesh(flat_grid(grid_columns, grid_rows));
  for(const Wall& wall : {Wall{0, 7}, Wall{3, 10}, Wall{2, 8}, Wall{5, 6}, Wall{0, 10}})
    for(const Vertex source : {at(2, 2), at(5, 6), at(9, 3), at(6, 0), at(6, 5), at(6, 10)})
    {
      const Barriers barriers = barriers_by_place(mesh, [&](const Point& p, const Point& q) {
        return wall.contains(p) && wall.contains(q);
      });
      std::vector<double> exact;
      for(const Vertex v : mesh.vertices())
        exact.push_back(wall.length_around(mesh.point(source), mesh.point(v)));
      const Weights weights(mesh.num_faces(), 1);
      for(const double e : few_epsilons)
      {
        auto s = search(mesh, weights, barriers, Geometric_points(e));
        EXPECT_EQ(s.graph().epsilon(), e);
        expect_within_bound(s.distances({source}), exact, e);
      }
      for(const std::size_t m : few_nested_numbers)
      {
        const std::vector<double> found =
            distances(mesh, barriers, Fixed_number_of_points(m), source);
        expect_within_bound(found, exact, infinity);
        for(std::size_t i = 0; i < exact.size(); ++i)
          EXPECT_EQ(found[i] == infinity, exact[i] == infinity);
      }
    }
}

// The two sides of a wall cost what the faces there do.
TEST(Barriers, have_two_sides_with_weights_of_their_own)
{
  const Mesh mesh = to_mesh(flat_grid(grid_columns, grid_rows));
  const Wall wall{0, grid_rows - 1};
  const Barriers barriers = barriers_by_place(
      mesh, [&](const Point& p, const Point& q) { return wall.contains(p) && wall.contains(q); });
  const double left = 1, right = 10;
  const Weights weights =
      weights_by_place(mesh, [&](const Point& p) { return p.x() < 6 ? left : right; });
  for(const std::size_t m : {0u, 1u, 15u, 40u})
  {
    auto s = search(mesh, weights, barriers, Fixed_number_of_points(m));
    const std::vector<double> from_wall = s.distances({at(6, 4)});
    const std::vector<double> from_right = s.distances({at(8, 4)});
    for(const Vertex v : mesh.vertices())
    {
      const Point& p = mesh.point(v);
      const double d = distance_in_space(p, mesh.point(at(6, 4)));
      const double weight = p.x() > 6 ? right : left;
      EXPECT_GE(from_wall[v], weight * d * (1 - 1e-12));
      if(p.x() == 6 || p.y() == 4) // along edges
      {
        EXPECT_NEAR(from_wall[v], weight * d, weight * d * 1e-12);
      }
      EXPECT_EQ(from_right[v] == infinity, p.x() < 6);
      if(p.x() >= 6) // not the cheap way along the other side
      {
        EXPECT_GE(from_right[v], right * distance_in_space(p, mesh.point(at(8, 4))) * (1 - 1e-12));
      }
    }
  }
}

TEST(Barriers, keep_in_what_they_enclose)
{
  const Mesh mesh = to_mesh(flat_grid(grid_columns, grid_rows));
  const auto from_middle = [](const Point& p) {
    return (std::max)(std::abs(p.x() - 6), std::abs(p.y() - 5));
  };
  const Barriers barriers = barriers_by_place(mesh, [&](const Point& p, const Point& q) {
    return from_middle(p) == 2 && from_middle(q) == 2 && (p.x() == q.x() || p.y() == q.y());
  });
  const Weights weights(mesh.num_faces(), 1);
  const auto expect = [&](auto s) {
    const std::vector<double> outside = s.distances({at(0, 0)}), inside = s.distances({at(6, 5)});
    const std::vector<double> wall = s.distances({at(6, 7)});
    for(const Vertex v : mesh.vertices())
    {
      EXPECT_EQ(outside[v] == infinity, from_middle(mesh.point(v)) < 2);
      EXPECT_EQ(inside[v] == infinity, from_middle(mesh.point(v)) > 2);
      EXPECT_LT(wall[v], infinity);
    }
  };
  for(const std::size_t m : few_nested_numbers)
    expect(search(mesh, weights, barriers, Fixed_number_of_points(m)));
  expect(search(mesh, weights, barriers, Geometric_points(0.1)));

  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<>> paths(mesh, with_barriers(barriers));
  paths.add_source_point(at(0, 0));
  EXPECT_LT(paths.shortest_distance_to_source_points(at(6, 5)).first, 0);
  std::vector<Point> points;
  EXPECT_EQ(CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), at(0, 0), at(6, 5),
                                            with_barriers(barriers).number_of_points_per_edge(2)),
            infinity);
  EXPECT_TRUE(points.empty());
}

// Spokes of a wheel: from the hub everything can be reached, but nothing through it.
TEST(Barriers, do_not_leak_where_they_meet)
{
  const std::size_t valence = 12;
  const Mesh mesh = to_mesh(fan(valence));
  const Vertex hub(0);
  const auto frontier = [](const std::size_t i) {
    return Vertex(1 + Mesh::size_type(i % valence));
  };
  for(const std::size_t number_of_walls : {1u, 2u, 3u, 4u, 6u, 12u})
  {
    const std::size_t width = valence / number_of_walls;
    Barriers barriers(mesh.num_edges());
    for(std::size_t i = 0; i < valence; i += width)
      barriers[mesh.edge(mesh.halfedge(hub, frontier(i))).idx()] = true;
    for(const std::size_t m : {0u, 1u, 4u})
    {
      const std::vector<double> from_hub =
          distances(mesh, barriers, Fixed_number_of_points(m), hub);
      const std::vector<double> from_first =
          distances(mesh, barriers, Fixed_number_of_points(m), frontier(0));
      const std::vector<double> from_wedge =
          distances(mesh, barriers, Fixed_number_of_points(m), frontier(width / 2));
      EXPECT_DOUBLE_EQ(from_wedge[hub], 1);
      for(std::size_t i = 0; i < valence; ++i)
      {
        EXPECT_DOUBLE_EQ(from_hub[frontier(i)], 1);
        // at the end of a wall, both wedges beside it are in reach
        const std::size_t steps = (std::min)(i, valence - i);
        EXPECT_EQ(from_first[frontier(i)] < infinity, steps <= width) << i;
        if(width > 1)
        {
          EXPECT_EQ(from_wedge[frontier(i)] < infinity, i <= width || number_of_walls == 1) << i;
        }
      }
    }
  }
}

// The arms of a cross: the way leads around their ends, not through the middle.
TEST(Barriers, may_cross_each_other)
{
  const Mesh mesh = to_mesh(flat_grid(grid_columns, grid_rows));
  const auto is_on_cross = [](const Point& p) {
    const double dx = std::abs(p.x() - 6), dy = std::abs(p.y() - 5);
    return (std::min)(dx, dy) == 0 && (std::max)(dx, dy) <= 3;
  };
  const Barriers barriers = barriers_by_place(mesh, [&](const Point& p, const Point& q) {
    return is_on_cross(p) && is_on_cross(q) && (p.x() == q.x() || p.y() == q.y());
  });
  const Point s(5, 4, 0), t(7, 6, 0), end(6, 8, 0), side(3, 5, 0);
  const double exact =
      distance_in_space(s, side) + distance_in_space(side, end) + distance_in_space(end, t);
  for(const double e : few_epsilons)
  {
    const double found = distances(mesh, barriers, Geometric_points(e), at(5, 4))[at(7, 6)];
    EXPECT_GE(found, exact * (1 - 1e-12));
    EXPECT_LE(found, exact * (1 + e));
  }
}

TEST(Barriers, change_nothing_at_the_border)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    Barriers border(mesh.num_edges());
    for(const Edge e : mesh.edges())
      border[e.idx()] = mesh.is_border(e);
    const Vertex source = random_vertex(mesh, random);
    const Barriers none(mesh.num_edges());
    EXPECT_TRUE(have_same_bits(distances(mesh, border, Fixed_number_of_points(3), source),
                               distances(mesh, none, Fixed_number_of_points(3), source)));
  });
}

// ----- cutting a mesh open

TEST(Barriers, do_the_same_as_cuts)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
    for(const double share : {0.02, 0.2, 0.4, 1.})
    {
      SCOPED_TRACE(named.name + ", barriers " + std::to_string(share));
      const Mesh& mesh = named.mesh;
      const Barriers barriers = random_barriers(mesh, share, random);
      const Cut_mesh cut(mesh, barriers);
      for(const Weights& weights :
          {Weights(mesh.num_faces(), 1), random_weights(mesh, random, 0.1, 100, 0.05)})
        for(const std::size_t m : {0u, 1u, 3u})
        {
          const Vertex source = random_vertex(mesh, random);
          auto before = search(mesh, weights, barriers, Fixed_number_of_points(m));
          const std::vector<double> after =
              costs(cut.mesh(), weights, Fixed_number_of_points(m), cut.copies(source));
          expect_about_the_same(before.distances({source}), cut.nearest(after), 1e-12);
        }
    }
}

// Where edges have many points, most arcs are not looked at.
TEST(Barriers, do_the_same_as_cuts_with_many_points)
{
  Random random(test_seed());
  for(const Soup& soup : {terrain(9, 7, random), sphere(8, 5), fan(15, 1)})
    for(const double share : {0.1, 0.3})
    {
      const Mesh mesh = to_mesh(soup);
      const Barriers barriers = random_barriers(mesh, share, random);
      const Cut_mesh cut(mesh, barriers);
      const Weights weights = random_weights(mesh, random, 0.1, 100, 0.05);
      const Vertex source = random_vertex(mesh, random);
      auto before = search(mesh, weights, barriers, Fixed_number_of_points(33));
      const std::vector<double> after =
          costs(cut.mesh(), weights, Fixed_number_of_points(33), cut.copies(source));
      expect_about_the_same(before.distances({source}), cut.nearest(after), 1e-12);
    }
}

// Two triangles that touch at a vertex, and a square somewhere else: a barrier there changes
// nothing here.
TEST(Barriers, do_not_divide_vertices_that_have_none)
{
  Mesh mesh;
  const auto vertex = [&](const double x, const double y) {
    return mesh.add_vertex(Point(x, y, 0));
  };
  const Vertex c = vertex(0, 0), a = vertex(-1, 0), b = vertex(-1, 1), d = vertex(1, 0);
  mesh.add_face(c, b, a);
  mesh.add_face(c, d, vertex(1, 1));
  const Vertex p = vertex(5, 0), q = vertex(6, 1);
  mesh.add_face(p, vertex(6, 0), q);
  mesh.add_face(p, q, vertex(5, 1));
  Barriers barriers(mesh.num_edges());
  barriers[mesh.edge(mesh.halfedge(p, q)).idx()] = true;
  std::vector<Point> points;
  EXPECT_NEAR(CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), a, d,
                                              with_barriers(barriers).number_of_points_per_edge(2)),
              2, 1e-12);
}

} // namespace
