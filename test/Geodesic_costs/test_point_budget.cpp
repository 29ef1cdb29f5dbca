// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/internal/Steiner/Steiner_nodes.h>

#include "checks/expect_costs.h"
#include "checks/expect_message.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"

#include <CGAL/Geodesic_costs/equal_parts.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// How many points there may be on all edges together: more are refused before there is memory for
// them.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using AG::Points_at_interval;

// Needles of length 1 side by side.
Mesh strip(const std::size_t number, const double width)
{
  Soup result;
  for(std::size_t i = 0; i < number + 2; ++i)
    result.points.emplace_back(double(i) * width / 2, double(i % 2), 0);
  for(std::size_t i = 0; i < number; ++i)
    result.triangles.push_back({i, i + 1 + i % 2, i + 2 - i % 2});
  return to_mesh(result);
}

Weights alternating_weights(const Mesh& mesh)
{
  Weights result;
  for(const Face f : mesh.faces())
    result.push_back(double(1 + f.idx() % 3));
  return result;
}

// Refuses one point less than there are, and says how many there are; takes as many.
template <typename Graph, typename... NamedParameters>
void expect_limit(const Triangulation& triangulation, const NamedParameters&... np)
{
  const auto graph = [&](const std::size_t limit) {
    return Graph(triangulation,
                 parameters::combine(parameters::maximum_number_of_points(limit), np...));
  };
  const std::size_t number = graph(1000000).number_of_points();
  ASSERT_GT(number, 1u);
  expect_message<std::length_error>(
      [&] { graph(number - 1); }, "needs " + std::to_string(number) + " points on edges",
      " of them between vertices ", "maximum_number_of_points is " + std::to_string(number - 1));
  EXPECT_EQ(number, graph(number).number_of_points());
}

TEST(Budget_of_points, is_kept_by_all_placements)
{
  const Mesh mesh = strip(40, 0.1);
  const Weights weights = alternating_weights(mesh);
  const Triangulation t(mesh, with_weights(weights));
  expect_limit<Steiner_graph<>>(t, parameters::epsilon(0.1));
  expect_limit<Steiner_graph<Fixed_number_of_points>>(t, parameters::number_of_points_per_edge(7));
  expect_limit<Steiner_graph<Points_at_interval>>(
      t, parameters::number_of_points_per_distance_unit(9.5));
  const auto slant = with_cost(cost_everywhere(Slant{1, Vector(0.3, 0.2, 0)}));
  const Triangulation directional(mesh, slant);
  expect_limit<Directional_graph<>>(directional, parameters::epsilon(0.5));
  expect_limit<Directional_graph<Fixed_number_of_points>>(directional,
                                                          parameters::number_of_points_per_edge(7));
}

TEST(Budget_of_points, counts_both_sides_of_barriers)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Barriers barriers(mesh.num_edges(), true);
  expect_limit<Steiner_graph<Fixed_number_of_points>>(Triangulation(mesh, with_barriers(barriers)),
                                                      parameters::number_of_points_per_edge(2));
}

TEST(Budget_of_points, grows_with_the_mesh_by_default)
{
  const auto number = [](const Mesh& mesh) {
    return AG::internal::maximum_number_of_points(Triangulation(mesh), 0);
  };
  EXPECT_EQ(1000000u, number(to_mesh(octahedron())));
  const Mesh grid = to_mesh(flat_grid(40, 40));
  EXPECT_EQ(1000 * grid.number_of_edges(), number(grid));
  EXPECT_EQ(7u, AG::internal::maximum_number_of_points(Triangulation(grid), 7));
}

// Each edge alone has fewer than it may have.
TEST(Budget_of_points, ends_needles_that_would_fill_memory)
{
  const Mesh needles = strip(40, 1e-3), many = to_mesh(fan(30000));
  for(const Mesh& mesh : {needles, many})
  {
    const Weights weights = alternating_weights(mesh);
    const Triangulation t(mesh, with_weights(weights));
    expect_message<std::length_error>([&] { Steiner_graph<>(t, parameters::epsilon(0.1)); },
                                      "points on edges", "maximum_number_of_points is ");
    expect_message<std::length_error>(
        [&] { Steiner_graph<Fixed_number_of_points>(t, Fixed_number_of_points(1000000)); },
        "points on edges", "maximum_number_of_points is ");
  }
}

TEST(Budget_of_points, ends_needles_with_directional_costs)
{
  const auto np = with_cost(cost_everywhere(Slant{1, Vector(0.3, 0.2, 0)})).epsilon(0.1);
  const Triangulation t(strip(300, 4e-3), np);
  expect_message<std::length_error>([&] { Directional_graph<>(t, np); }, "points on edges",
                                    "maximum_number_of_points is ");
  const Directional_graph<> weak(
      t, parameters::epsilon(0.1).accept_weaker_bound(true).maximum_number_of_points(20000));
  EXPECT_LE(weak.number_of_points(), 20000u);
  EXPECT_EQ(infinity, weak.epsilon());
}

TEST(Budget_of_points, is_kept_by_a_weaker_bound)
{
  const Mesh mesh = strip(30, 0.02); // convex
  std::size_t last = std::size_t(-1);
  for(const std::size_t limit : {1000000u, 20000u, 5000u, 1000u, 200u})
  {
    SCOPED_TRACE(limit);
    Basic_mesh_search<Steiner_graph<>> search(
        mesh, parameters::epsilon(0.1).accept_weaker_bound(true).maximum_number_of_points(limit));
    const Steiner_graph<>& graph = search.graph();
    EXPECT_LE(graph.number_of_points(), limit);
    EXPECT_LE(graph.number_of_points(), last);
    last = graph.number_of_points();
    EXPECT_EQ(limit == 1000000u, graph.epsilon() == 0.1);
    const auto found = search.distances({Vertex(0)});
    for(const Vertex v : mesh.vertices())
    {
      const double exact = std::sqrt(CGAL::squared_distance(mesh.point(Vertex(0)), mesh.point(v)));
      EXPECT_GE(found[v], exact * (1 - 1e-9));
      EXPECT_LE(found[v], exact * (1 + graph.epsilon()) * (1 + 1e-9));
    }
  }
  expect_message<std::length_error>( // fewer than one per edge
      [&] {
        Steiner_graph<>(
            Triangulation(mesh),
            parameters::epsilon(0.1).accept_weaker_bound(true).maximum_number_of_points(3));
      },
      "maximum_number_of_points is 3");
}

// What a weaker bound was accepted for is not advised again, nor what a placement does not read.
TEST(Budget_of_points, gives_advice_only_if_it_helps)
{
  const Mesh mesh = strip(30, 0.02);
  const Weights weights = alternating_weights(mesh);
  const Triangulation t(mesh, with_weights(weights));
  const Triangulation directional(mesh, with_cost(cost_everywhere(Slant{1, Vector(0.3, 0.2, 0)})));
  const auto np = parameters::epsilon(0.5).maximum_number_of_points(3);
  const auto weak = np.accept_weaker_bound(true);
  const auto advises = [](const auto& build) {
    try
    {
      build();
    }
    catch(const std::length_error& error)
    {
      return std::string(error.what()).find("accept_weaker_bound") != std::string::npos;
    }
    ADD_FAILURE() << "points were not refused";
    return false;
  };
  EXPECT_TRUE(advises([&] { Steiner_graph<>(t, np); }));
  EXPECT_TRUE(advises([&] { Directional_graph<>(directional, np); }));
  EXPECT_FALSE(advises([&] { Steiner_graph<>(t, weak); }));
  EXPECT_FALSE(advises([&] { Directional_graph<>(directional, weak); }));
  EXPECT_FALSE(
      advises([&] { Steiner_graph<Fixed_number_of_points>(t, Fixed_number_of_points(7), 3); }));
}

// A placement that had to give up edges for one triangulation starts afresh for the next.
TEST(Budget_of_points, does_not_remember_another_triangulation)
{
  const Triangulation t(strip(300, 4e-3),
                        with_cost(cost_everywhere(Slant{1, Vector(0.3, 0.2, 0)})));
  const auto np = parameters::epsilon(0.5).accept_weaker_bound(true);
  AG::Directional_points used(np), fresh(np);
  used.prepare(t, 2000);
  used.prepare(t, 1000000);
  fresh.prepare(t, 1000000);
  for(Triangulation::Index h = 0; h < t.number_of_halfedges(); ++h)
    ASSERT_EQ(fresh.number_of_points(t, h), used.number_of_points(t, h)) << "halfedge " << h;
}

TEST(Budget_of_points, is_one_of_functions)
{
  const Mesh mesh = to_mesh(flat_grid(5, 5));
  std::vector<double> found(mesh.number_of_vertices());
  const auto map = boost::make_iterator_property_map(found.begin(), get(boost::vertex_index, mesh));
  const auto np = parameters::maximum_number_of_points(100).number_of_points_per_edge(4);
  expect_message<std::length_error>(
      [&] { CGAL::approximate_geodesic_distances(mesh, map, Vertex(0), np); },
      "needs 224 points on edges, 4 of them", "maximum_number_of_points is 100");
  EXPECT_NO_THROW(
      CGAL::approximate_geodesic_distances(mesh, map, Vertex(0), np.maximum_number_of_points(224)));
}

// ... as a node has a number below 2^32.
TEST(Budget_of_points, is_limited_by_the_number_of_nodes)
{
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  soup.triangles = {{0, 1, 2}};
  const Triangulation t(to_mesh(soup));
  const std::size_t number = 1431655765; // (2^32 - 1) / 3
  expect_message<std::length_error>(
      [&] { Steiner_graph<Fixed_number_of_points>(t, Fixed_number_of_points(number), 3 * number); },
      "needs 4294967295 points on edges", "2^32 - 1 nodes");
}

TEST(Budget_of_points, is_refused_if_it_is_none)
{
  const Triangulation t(to_mesh(octahedron()));
  for(const double limit : {0., -1., 2.5, 1e10, not_a_number, infinity})
    expect_message<std::invalid_argument>(
        [&] { Steiner_graph<>(t, parameters::maximum_number_of_points(limit)); },
        "maximum_number_of_points is ");
}

} // namespace
