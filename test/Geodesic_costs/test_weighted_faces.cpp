// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "meshes/Convex_obstacle.h"
#include "meshes/test_weights.h"
#include "oracles/cost_across.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

// Costs on meshes with weights, next to what they have to be.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

constexpr double steiner_epsilons[] = {0.5, 0.2, 0.1, 0.02};
constexpr std::size_t nested_numbers[] = {1, 3, 7, 15};

// ----- closed forms in the plane

constexpr std::size_t field_columns = 13, field_rows = 11;
constexpr double line = 5; // a line of the grid

enum class Grid
{
  REGULAR,
  SHAKEN
};

// A rectangle; vertices at its border and on the lines y = 5 and y = 6 stay there.
Mesh rectangle(const Grid kind, Random& random)
{
  const Soup soup = flat_grid(field_columns, field_rows).transformed([&](const Point& p) {
    const bool is_inside =
        p.x() > 0 && p.x() < field_columns - 1 && p.y() > 0 && p.y() < field_rows - 1;
    if(kind == Grid::REGULAR || !is_inside)
      return p;
    const double dx = random.between(-0.3, 0.3), dy = random.between(-0.3, 0.3);
    const bool is_on_line = p.y() == line || p.y() == line + 1;
    return Point(p.x() + dx, is_on_line ? p.y() : p.y() + dy, 0);
  });
  return to_mesh(soup);
}

// Expects the bound of geometric points, and that equally spaced ones are never too short, get
// better when there are more of them, and come close to what is exact.
void expect_truth(const Mesh& mesh,
                  const Weights& weights,
                  const Vertex source,
                  const std::vector<double>& exact)
{
  for(const double e : steiner_epsilons)
  {
    SCOPED_TRACE("epsilon " + std::to_string(e));
    const auto graph = steiner_graph(mesh, weights, Geometric_points(e));
    EXPECT_EQ(graph.epsilon(), e);
    expect_within_bound(costs(mesh, weights, Geometric_points(e), {source}), exact, e);
  }
  std::vector<double> errors;
  std::vector<double> last(exact.size(), infinity);
  for(const std::size_t m : nested_numbers)
  {
    SCOPED_TRACE(m);
    const std::vector<double> found = costs(mesh, weights, Fixed_number_of_points(m), {source});
    expect_within_bound(found, exact, infinity);
    double error = 0;
    for(std::size_t i = 0; i < exact.size(); ++i)
    {
      EXPECT_LE(found[i], last[i] * (1 + rounding_of_costs));
      error += found[i] - exact[i];
    }
    errors.push_back(error);
    last = found;
  }
  // spaces shrink to an eighth, and errors at least in proportion, but for what is exact anyway
  EXPECT_LE(errors.back(), errors.front() / 4 + 1e-9);
}

// The plane has one weight below a line and another one above. On the expensive side, paths may go
// to the line and along it.
TEST(Weighted_faces, refract_paths_at_a_line)
{
  Random random(test_seed());
  for(const Grid kind : {Grid::REGULAR, Grid::SHAKEN})
    for(const double ratio : {1.1, 2., 10., 1000.})
      for(const bool is_cheap_above : {false, true})
      {
        SCOPED_TRACE(ratio);
        const Mesh mesh = rectangle(kind, random);
        const double below = is_cheap_above ? ratio : 1, above = is_cheap_above ? 1 : ratio;
        const Vertex source(2 + 2 * field_columns);
        const Point s = mesh.point(source);
        const auto weight = [&](const Point& p) { return p.y() < line ? below : above; };
        std::vector<double> exact;
        for(const Vertex v : mesh.vertices())
        {
          const Point p = mesh.point(v);
          const double shift = std::abs(p.x() - s.x()), depth = line - s.y();
          if(p.y() > line)
            exact.push_back(cost_across({{depth, below}, {p.y() - line, above}}, shift));
          else
            exact.push_back((std::min)(
                below * std::sqrt(CGAL::squared_distance(p, s)),
                cost_across({{depth, below}, {0, above}, {line - p.y(), below}}, shift)));
        }
        expect_truth(mesh, weights_by_place(mesh, weight), source, exact);
      }
}

// A strip between two lines of the grid is cheap, or even free. Beside it, a path may go to it, at
// the critical angle, along it, and away from it again.
TEST(Weighted_faces, make_paths_use_roads)
{
  Random random(test_seed());
  for(const Grid kind : {Grid::REGULAR, Grid::SHAKEN})
    for(const double road : {0.7, 0.1, 1e-3, 0.})
    {
      SCOPED_TRACE(road);
      const Mesh mesh = rectangle(kind, random);
      const Vertex source(1 + 3 * field_columns);
      const Point s = mesh.point(source);
      const auto is_on_road = [](const Point& p) { return p.y() > line && p.y() < line + 1; };
      const auto weight = [&](const Point& p) { return is_on_road(p) ? road : 1; };
      std::vector<double> exact;
      for(const Vertex v : mesh.vertices())
      {
        const Point p = mesh.point(v);
        const double shift = std::abs(p.x() - s.x()), depth = line - s.y();
        const double beyond = (std::max)(p.y() - line - 1, 0.);
        if(p.y() > line)
          exact.push_back(cost_across({{depth, 1}, {1, road}, {beyond, 1}}, shift));
        else
          exact.push_back(
              (std::min)(std::sqrt(CGAL::squared_distance(p, s)),
                         cost_across({{depth, 1}, {0, road}, {line - p.y(), 1}}, shift)));
      }
      expect_truth(mesh, weights_by_place(mesh, weight), source, exact);
    }
}

TEST(Weighted_faces, refract_paths_in_layers)
{
  Random random(test_seed());
  for(const double range : {2., 30., 1000.})
  {
    SCOPED_TRACE(range);
    const Mesh mesh = to_mesh(flat_grid(field_columns, field_rows));
    std::vector<Layer> layers;
    for(std::size_t i = 0; i + 1 < field_rows; ++i)
      layers.push_back({1, std::pow(range, random.between(0, 1))});
    const Weights weights = weights_by_place(
        mesh, [&](const Point& p) { return layers[static_cast<std::size_t>(p.y())].weight; });
    const Vertex source(2);
    for(const double e : steiner_epsilons)
    {
      const std::vector<double> found = costs(mesh, weights, Geometric_points(e), {source});
      for(std::size_t i = 0; i < field_columns; ++i) // those at the far border
      {
        const double exact = cost_across(layers, std::abs(static_cast<double>(i) - 2));
        const double cost = found[i + (field_rows - 1) * field_columns];
        EXPECT_GE(cost, exact * (1 - rounding_of_costs));
        EXPECT_LE(cost, exact * (1 + e));
      }
    }
  }
}

// ----- forbidden and free ground

using Point_2 = Kernel::Point_2;

Point_2 in_plane(const Point& p) { return Point_2(p.x(), p.y()); }

// whose edges are edges of the grid
const Convex_obstacle hexagon({Point_2(3, 3), Point_2(5, 3), Point_2(9, 7), //
                               Point_2(9, 8), Point_2(7, 8), Point_2(3, 4)});

Weights weights_of_hexagon(const Mesh& mesh, const double inside)
{
  return weights_by_place(
      mesh, [&](const Point& p) { return hexagon.contains(in_plane(p)) ? inside : 1.; });
}

TEST(Weighted_faces, make_paths_walk_around_forbidden_ones)
{
  const Mesh mesh = to_mesh(flat_grid(field_columns, field_rows));
  const Vertex source(1 + 2 * field_columns);
  const Weights weights = weights_of_hexagon(mesh, infinity);
  std::vector<double> exact;
  bool has_hidden = false;
  for(const Vertex v : mesh.vertices())
  {
    const Point_2 s = in_plane(mesh.point(source)), p = in_plane(mesh.point(v));
    exact.push_back(hexagon.contains(p) ? infinity : hexagon.length_around(s, p));
    has_hidden = has_hidden || exact.back() > std::sqrt(CGAL::squared_distance(s, p)) * 1.05;
  }
  ASSERT_TRUE(has_hidden);
  for(const double e : steiner_epsilons)
    expect_within_bound(costs(mesh, weights, Geometric_points(e), {source}), exact, e);
  for(const std::size_t m : nested_numbers)
    expect_within_bound(costs(mesh, weights, Fixed_number_of_points(m), {source}), exact, infinity);

  // with expensive ground in place of it, nothing changes but that its inside can be reached
  const Weights expensive = weights_of_hexagon(mesh, 1e6);
  for(const double e : steiner_epsilons)
  {
    std::vector<double> found = costs(mesh, expensive, Geometric_points(e), {source});
    for(const Vertex v : mesh.vertices())
      if(hexagon.contains(in_plane(mesh.point(v))))
      {
        EXPECT_GT(found[v.idx()], 1e5);
        EXPECT_LT(found[v.idx()], infinity);
        found[v.idx()] = infinity;
      }
    expect_within_bound(found, exact, e);
  }
}

TEST(Weighted_faces, are_passed_at_no_cost_if_they_are_free)
{
  const Mesh mesh = to_mesh(flat_grid(field_columns, field_rows));
  const Weights weights = weights_of_hexagon(mesh, 0);
  for(const Vertex source : {Vertex(1 + 2 * field_columns), Vertex(5 + 4 * field_columns)})
  {
    const Point_2 s = in_plane(mesh.point(source));
    std::vector<double> exact;
    for(const Vertex v : mesh.vertices())
    {
      const Point_2 p = in_plane(mesh.point(v));
      exact.push_back((std::min)(std::sqrt(CGAL::squared_distance(s, p)),
                                 hexagon.distance(s) + hexagon.distance(p)));
    }
    expect_truth(mesh, weights, source, exact);
  }
}

TEST(Weighted_faces, have_their_inside_unreachable_if_forbidden_ones_surround_it)
{
  const Mesh mesh = to_mesh(flat_grid(9, 9));
  const auto is_in_ring = [](const Point& p) {
    const double r = (std::max)(std::abs(p.x() - 4), std::abs(p.y() - 4));
    return r > 1 && r < 2;
  };
  const Weights weights =
      weights_by_place(mesh, [&](const Point& p) { return is_in_ring(p) ? infinity : 1; });
  const Vertex outside(0), inside(4 + 4 * 9);
  for(const std::size_t m : {0u, 1u, 5u})
  {
    const std::vector<double> found = costs(mesh, weights, Fixed_number_of_points(m), {outside});
    for(const Vertex v : mesh.vertices())
    {
      const Point& p = mesh.point(v);
      const bool is_enclosed = std::abs(p.x() - 4) <= 1 && std::abs(p.y() - 4) <= 1;
      EXPECT_EQ(found[v] == infinity, is_enclosed);
    }
    AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>> paths(
        mesh, steiner_graph(mesh, weights, Fixed_number_of_points(m)));
    paths.add_source_point(outside);
    EXPECT_LT(paths.shortest_distance_to_source_points(inside).first, 0);
    std::vector<Point> points;
    paths.shortest_path_points_to_source_points(inside, std::back_inserter(points));
    EXPECT_TRUE(points.empty());
    EXPECT_EQ(CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), outside, inside,
                                              with_weights(weights).epsilon(0.2)),
              infinity);
    EXPECT_TRUE(points.empty());
  }
}

// ----- many points in place of a closed form

// Many points on every edge find no path that is cheaper than the bound allows, and any path of
// theirs is one on the surface.
TEST(Weighted_faces, are_crossed_about_as_cheaply_as_with_many_points)
{
  Random random(test_seed());
  const auto shake = [&](const Point& p) {
    return Point(p.x() + random.between(-0.3, 0.3), p.y() + random.between(-0.3, 0.3),
                 random.between(0, 1));
  };
  for(const double range : {1.5, 20., 1000.})
    for(const double extreme : {0., 0.1})
      for(const Soup& soup : {flat_grid(6, 5).transformed(shake), sphere(6, 4), fan(9, 1)})
      {
        SCOPED_TRACE(range);
        const Mesh mesh = to_mesh(soup);
        const Weights weights = random_weights(mesh, random, 1, range, extreme);
        const Vertex source = random_vertex(mesh, random);
        const std::vector<double> dense =
            costs(mesh, weights, Fixed_number_of_points(64), {source});
        for(const double e : steiner_epsilons)
        {
          const auto graph = steiner_graph(mesh, weights, Geometric_points(e));
          const std::vector<double> found = costs(mesh, weights, Geometric_points(e), {source});
          ASSERT_EQ(graph.epsilon(), e);
          for(std::size_t i = 0; i < dense.size(); ++i)
          {
            EXPECT_LE(found[i], dense[i] * (1 + e) * (1 + rounding_of_costs));
            // a path that crosses all edges a 130th of their length from the best place
            EXPECT_LE(dense[i], found[i] * 1.1 + rounding_of_costs);
          }
        }
      }
}

} // namespace
