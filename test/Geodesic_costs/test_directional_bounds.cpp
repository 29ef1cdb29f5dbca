// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/Directional_points.h>

#include "checks/expect_message.h"
#include "meshes/test_costs.h"

#include <CGAL/Geodesic_costs/Directional_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

// The bound of costs that depend on the direction, next to costs by many points.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

template <typename G>
std::vector<double> costs_from_first(const Mesh& mesh, const G& graph)
{
  return Basic_mesh_search<G>(mesh, graph).distances({Vertex(0)});
}

TEST(Directional_bounds, hold_on_terrain)
{
  Random random(test_seed());
  for(const Soup& soup : {terrain(6, 5, random), flat_grid(5, 5), sphere(6, 4)})
  {
    const Mesh mesh = to_mesh(soup);
    const auto slants = random_slants(mesh, random, 0.7);
    const auto cost = cost_of_faces(slants);
    const auto reference = costs_from_first(mesh, dense_graph(mesh, cost, 40));
    for(const double epsilon : {0.4, 0.1})
    {
      const auto found = costs_from_first(mesh, bounded_graph(mesh, cost, epsilon));
      for(const Vertex v : mesh.vertices())
        EXPECT_LE(found[v], (1 + 1e-9) * (1 + epsilon) * reference[v]);
    }
  }
}

TEST(Directional_bounds, hold_with_corners)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(5, 4, random));
  const auto cost = [](const Face f, const Vector& d) {
    return std::abs(d.x()) + (1 + f.idx() % 3) * std::abs(d.y()) + std::abs(d.z() + 0.1 * d.x()) +
           0.1;
  };
  const double epsilon = 0.5;
  const auto found = costs_from_first(mesh, bounded_graph(mesh, cost, epsilon));
  const auto reference = costs_from_first(mesh, dense_graph(mesh, cost, 60));
  for(const Vertex v : mesh.vertices())
    EXPECT_LE(found[v], (1 + 1e-9) * (1 + epsilon) * reference[v]);
}

TEST(Directional_bounds, hold_with_polyhedral_norms)
{
  Random random(test_seed());
  for(const Soup& soup : {terrain(5, 4, random), sphere(5, 4)})
  {
    const Mesh mesh = to_mesh(soup);
    std::vector<Half_planes> norms;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      norms.push_back(Half_planes::random(random, 3 + int(f % 4)));
    const auto cost = [&](const Face f, const Vector& d) {
      return norms[f.idx()].cost(d) + 0.3 * std::abs(d.z());
    };
    const double epsilon = 0.4;
    const auto found = costs_from_first(mesh, bounded_graph(mesh, cost, epsilon));
    const auto reference = costs_from_first(mesh, dense_graph(mesh, cost, 60));
    for(const Vertex v : mesh.vertices())
      EXPECT_LE(found[v], (1 + 1e-9) * (1 + epsilon) * reference[v]);
  }
}

// Each face has a gauge of another kind: with corners and flat pieces, narrow, smooth, or such that
// one direction costs up to forty times as much as the opposite one.
std::function<double(Face, const Vector&)> mixed_gauges(const Mesh& mesh, Random& random)
{
  std::vector<std::function<double(const Vector&)>> gauges;
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
  {
    const Half_planes norm = Half_planes::random(random, 3 + int(f % 5));
    const double stretch = std::pow(10., random.between(-0.7, 0.7)), size = random.between(0.3, 1);
    const double angle = random.between(0, 7), drift = random.between(0.5, 0.95);
    const Wind wind{drift * Vector(std::cos(angle), std::sin(angle), 0), 1};
    const auto stretched = [=](const Vector& v) {
      return norm.cost(Vector(stretch * v.x(), v.y(), v.z())) + 0.2 * std::abs(v.z());
    };
    const auto length = [](const Vector& v) { return std::sqrt(v.squared_length()); };
    switch(f % 4)
    {
    case 0:
      gauges.emplace_back(stretched);
      break;
    case 1:
      gauges.emplace_back([=](const Vector& v) { return wind.cost(v); });
      break;
    case 2:
      gauges.emplace_back(
          [=](const Vector& v) { return (std::max)(stretched(v), size * length(v)); });
      break;
    default:
      gauges.emplace_back([=](const Vector& v) { return stretched(v) + size * length(v); });
    }
  }
  return [gauges](const Face f, const Vector& d) { return gauges[f.idx()](d); };
}

TEST(Directional_bounds, hold_with_random_gauges)
{
  Random random(test_seed());
  for(const Soup& soup : {terrain(5, 4, random), flat_grid(4, 4), sphere(5, 4), fan(7, 1)})
  {
    const Mesh mesh = to_mesh(soup);
    const auto cost = mixed_gauges(mesh, random);
    const auto dense = dense_graph(mesh, cost, 60);
    const auto reference = costs_from_first(mesh, dense);
    const auto reference_back = costs_from_first(mesh, dense.reversed());
    for(const double epsilon : {1., 0.3, 0.1})
    {
      const auto graph = bounded_graph(mesh, cost, epsilon);
      const auto found = costs_from_first(mesh, graph);
      const auto back = costs_from_first(mesh, graph.reversed());
      for(const Vertex v : mesh.vertices())
      {
        EXPECT_LE(found[v], (1 + 1e-9) * (1 + epsilon) * reference[v]);
        EXPECT_LE(back[v], (1 + 1e-9) * (1 + epsilon) * reference_back[v]);
      }
    }
  }
}

// Small surfaces: most paths pass near vertices.
TEST(Directional_bounds, hold_on_a_hundred_surfaces)
{
  Random random(test_seed());
  for(std::size_t i = 0; i < 100; ++i)
  {
    SCOPED_TRACE(i);
    const Mesh mesh = to_mesh(i % 4 == 0   ? fan(3 + i % 9, random.between(0, 2)) // first: its tip
                              : i % 4 == 1 ? sphere(4, 3)
                                           : terrain(4, 3, random));
    const auto cost = mixed_gauges(mesh, random);
    const double epsilon = std::pow(10., random.between(-1, 0));
    const auto found = costs_from_first(mesh, bounded_graph(mesh, cost, epsilon));
    const auto reference = costs_from_first(mesh, dense_graph(mesh, cost, 40));
    for(const Vertex v : mesh.vertices())
      EXPECT_LE(found[v], (1 + 1e-9) * (1 + epsilon) * reference[v]);
  }
}

TEST(Directional_bounds, include_the_errors_of_samples)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  for(const double epsilon : {1., 0.1, 0.01})
  {
    const auto graph = bounded_graph(mesh, cost_everywhere(Wind{Vector(0.6, 0, 0), 1}), epsilon);
    EXPECT_GT(graph.sampling_error(), 0);
    EXPECT_LE(graph.sampling_error(), 0.1 * epsilon);
    EXPECT_EQ(epsilon, graph.epsilon());
  }
}

// Costs that differ so much that more directions cannot be told apart.
TEST(Directional_bounds, are_refused_for_narrow_gauges)
{
  const double epsilon = 0.1;
  const auto narrow = [](const Face, const Vector& d) { return std::hypot(d.x(), 1e-6 * d.y()); };
  const auto np = with_cost(narrow).epsilon(epsilon);
  const Triangulation triangulation(to_mesh(flat_grid(3, 3)), np);
  expect_message<std::invalid_argument>([&] { Directional_graph<>(triangulation, np); },
                                        "sampled in too few directions");
  const Directional_graph<> graph(triangulation, np.accept_weaker_bound(true));
  EXPECT_GT(graph.sampling_error(), 0.1 * epsilon);
  EXPECT_EQ(infinity, graph.epsilon());
}

} // namespace
