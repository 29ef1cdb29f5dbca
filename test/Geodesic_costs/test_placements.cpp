// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "checks/expect_message.h"
#include "meshes/steiner_meshes.h"
#include "peers/Published_geometric_points.h"

#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/equal_parts.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Where placements put points on edges, and the numbers of points that they refuse.

namespace {

namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using CGAL::Approximate_geodesics::Points_at_interval;

// ----- where points are

// Calls `f(halfedge, parts)` for all edges with points, with the places of these.
template <typename Graph, typename F>
void for_each_row(const Graph& graph, F f)
{
  Node n = graph.triangulation().number_of_vertices();
  while(n < graph.number_of_nodes())
  {
    const Node h = graph.position(n).halfedge;
    std::vector<double> parts;
    for(; n < graph.number_of_nodes() && graph.position(n).halfedge == h; ++n)
      parts.push_back(graph.position(n).t);
    f(h, parts);
  }
}

TEST(Points_at_interval, are_as_dense_as_asked_for_and_not_denser)
{
  Random random(test_seed());
  for(const Soup& soup : small_soups(random))
    for(const double density : {0.3, 2., 7.})
    {
      const Mesh mesh = to_mesh(soup);
      const Steiner_graph<Points_at_interval> graph(
          Triangulation(mesh), parameters::number_of_points_per_distance_unit(density));
      std::size_t smallest = 0, largest = 0, found = 0;
      for(const double length : edge_lengths(mesh)) // which can be multiples of the spacing
      {
        const double parts = length * density;
        smallest += static_cast<std::size_t>(std::ceil(parts * (1 - rounding_of_costs))) - 1;
        largest += static_cast<std::size_t>(std::ceil(parts * (1 + rounding_of_costs))) - 1;
      }
      for_each_row(graph, [&](const Node h, const std::vector<double>& parts) {
        const double length = graph.triangulation().length(h) * graph.triangulation().unit();
        found += parts.size();
        double last = 0;
        for(const double part : parts)
        {
          EXPECT_GT(part, last);
          EXPECT_LE((part - last) * length, (1 + 1e-6) / density);
          last = part;
        }
        EXPECT_LE((1 - last) * length, (1 + 1e-6) / density);
      });
      EXPECT_GE(found, smallest);
      EXPECT_LE(found, largest);
      EXPECT_EQ(graph.number_of_points(), found);
    }
}

TEST(Fixed_number_of_points, divide_edges_into_equal_parts)
{
  const Mesh mesh = to_mesh(sphere(7, 5));
  for(const std::size_t m : {1u, 2u, 7u, 40u})
  {
    const auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 1), Fixed_number_of_points(m));
    EXPECT_EQ(graph.number_of_points(), m * mesh.num_edges());
    for_each_row(graph, [&](const Node, const std::vector<double>& parts) {
      ASSERT_EQ(parts.size(), m);
      for(std::size_t i = 0; i < m; ++i)
        EXPECT_NEAR(parts[i], double(i + 1) / double(m + 1), 1e-7);
    });
  }
}

TEST(Geometric_points, ascend_and_are_not_at_the_border)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random&) {
    std::size_t last_number = 0;
    for(const double e : {0.5, 0.1, 0.03})
    {
      const auto graph = steiner_graph(mesh, weights, lenient_points(e));
      const Triangulation& t = graph.triangulation();
      for_each_row(graph, [&](const Node h, const std::vector<double>& parts) {
        EXPECT_FALSE(t.is_border(h) || t.is_border(t.opposite(h)));
        EXPECT_GT(parts.front(), 0);
        EXPECT_LE(parts.back(), 1);
        for(std::size_t i = 1; i < parts.size(); ++i)
          EXPECT_GE(parts[i], parts[i - 1]);
      });
      if(graph.epsilon() > e) // some have got few
        break;
      EXPECT_GE(graph.number_of_points(), last_number);
      last_number = graph.number_of_points();
    }
  });
}

bool has_edge_of_length_zero(const Mesh& mesh)
{
  const std::vector<double> lengths = edge_lengths(mesh);
  return std::find(lengths.begin(), lengths.end(), 0.) != lengths.end();
}

// Such an edge has no points.
TEST(Geometric_points, may_meet_edges_of_length_zero)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    if(!has_edge_of_length_zero(mesh))
      return;
    const Weights weights = random_weights(mesh, random, 0.1, 10, 0.05);
    const std::vector<double> found = costs(mesh, weights, lenient_points(0.1), {Vertex(0)});
    const std::vector<double> along_edges =
        costs(mesh, weights, Fixed_number_of_points(0), {Vertex(0)});
    for(std::size_t i = 0; i < found.size(); ++i)
      EXPECT_LE(found[i], along_edges[i] * (1 + rounding_of_costs));
  });
}

// ----- bad parameters

TEST(Bad_parameters, are_refused)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Triangulation triangulation(mesh);
  const Weights weights(mesh.num_faces(), 1);
  for(const double e : {0., -0.1, not_a_number, infinity, -infinity})
  {
    const auto np = parameters::epsilon(e);
    expect_message<std::invalid_argument>([&] { Geometric_points points(e); }, "epsilon");
    expect_message<std::invalid_argument>([&] { Steiner_graph<> g(triangulation, np); }, "epsilon");
    expect_message<std::invalid_argument>(
        [&] {
          std::vector<Point> points;
          CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                                          with_weights(weights).epsilon(e));
        },
        "epsilon");
  }
  using Spaced_graph = Steiner_graph<Fixed_number_of_points>;
  for(const int m : {-1, std::numeric_limits<int>::min()})
    expect_message<std::invalid_argument>(
        [&] { Spaced_graph g(triangulation, parameters::number_of_points_per_edge(m)); },
        "points per edge", std::to_string(m));
  for(const double m : {-1., 2.5, not_a_number, infinity})
    expect_message<std::invalid_argument>(
        [&] { Spaced_graph g(triangulation, parameters::number_of_points_per_edge(m)); },
        "points per edge");
  using Dense_graph = Steiner_graph<Points_at_interval>;
  for(const double d : {0., -1., not_a_number})
  {
    expect_message<std::invalid_argument>([&] { Points_at_interval points(d); }, "spacing");
    expect_message<std::invalid_argument>(
        [&] { Dense_graph g(triangulation, parameters::number_of_points_per_distance_unit(d)); },
        "points per distance unit");
  }
  expect_message<std::invalid_argument>(
      [&] {
        Dense_graph g(triangulation, parameters::number_of_points_per_distance_unit(infinity));
      },
      "points per distance unit");
}

// Counting comes first: there is no memory for so many.
TEST(Bad_parameters, are_refused_if_there_would_be_too_many_points)
{
  const Triangulation triangulation(to_mesh(flat_grid(4, 4)));
  for(const std::size_t m :
      {std::size_t(1) << 31, std::size_t(1) << 32, (std::numeric_limits<std::size_t>::max)()})
    expect_message<std::length_error>(
        [&] { Steiner_graph<Fixed_number_of_points> g(triangulation, Fixed_number_of_points(m)); },
        "points");
  for(const double spacing : {1e-9, 1e-300})
    expect_message<std::length_error>(
        [&] { Steiner_graph<Points_at_interval> g(triangulation, Points_at_interval(spacing)); },
        "points");
  for(const double e : {1e-18, 1e-300})
    expect_message<std::length_error>(
        [&] { Steiner_graph<> g(triangulation, Geometric_points(e)); }, "points");
}

// Its square would not fit a double.
template <typename Placement>
void expect_that_a_huge_bound_is_cut_off()
{
  const Triangulation triangulation(to_mesh(flat_grid(4, 4)));
  const Steiner_graph<Placement> large(triangulation, Placement(1e6));
  const Steiner_graph<Placement> huge(triangulation, Placement(1e300));
  EXPECT_EQ(huge.number_of_points(), large.number_of_points());
  EXPECT_EQ(huge.epsilon(), large.epsilon());
}

TEST(Placements, take_a_huge_bound_for_the_largest_of_use)
{
  expect_that_a_huge_bound_is_cut_off<Geometric_points>();
  expect_that_a_huge_bound_is_cut_off<CGAL::Approximate_geodesics::Published_geometric_points>();
}

} // namespace
