// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include "checks/solvers.h"
#include "meshes/test_meshes.h"
#include "meshes/test_soup.h"

#include <CGAL/approximate_geodesic_distances.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Points on edges, predecessors, and sampled costs of solvers.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

TEST(Solver_points, are_on_edges)
{
  const Soup_arrays arrays(flat_grid(6, 5));
  const Solver_of solver(arrays, bound(0));
  const auto& mesh = solver.mesh();
  for(const auto e : edges(mesh))
  {
    const auto from = source(e, mesh), to = target(e, mesh);
    const Point p = CGAL::barycenter(mesh.point(from), 0.75, mesh.point(to), 0.25);
    const auto distances = solver_distances(solver, {Solver_point::on_edge(from, to, 0.25)});
    for(const auto v : vertices(mesh))
      EXPECT_NEAR(distances[v], std::sqrt(CGAL::squared_distance(p, mesh.point(v))), 1e-12);
    EXPECT_EQ(solver_distances(solver, {Solver_point::on_edge(to, from, 0.75)}), distances);
    EXPECT_EQ(solver_distances(solver, {Solver_point::on_edge(from, to, 0)}),
              solver_distances(solver, {Solver_point::at_vertex(from)}));
  }
}

TEST(Solver_points, that_are_not_on_edges_are_named)
{
  const Solver_of solver{Soup_arrays(flat_grid(6, 5))};
  const auto refuse = [&](const std::string& message, const Solver_point& p) {
    expect_refused(message, [&] { solver_distances(solver, {p}); });
  };
  const std::size_t last = solver.number_of_vertices() - 1;
  refuse("source 0 is not on an edge: no face has both vertex 0 and vertex " + std::to_string(last),
         Solver_point::on_edge(0, static_cast<std::int64_t>(last), 0.5));
  refuse("source 0 is on an edge of vertex -1", Solver_point::on_edge(-1, 0, 0.5));
  refuse("from 0 to 1", Solver_point::on_edge(0, 1, 1.5));
  refuse("from 0 to 1", Solver_point::on_edge(0, 1, std::numeric_limits<double>::quiet_NaN()));
}

TEST(Solver_points, have_the_predecessors_of_the_function)
{
  const Soup soup = sphere(12, 9);
  const Mesh mesh = to_mesh(soup);
  const Solver_of solver{Soup_arrays(soup), bound(0)};
  std::vector<double> distances(solver.number_of_vertices()), expected_distances(distances);
  std::vector<std::int64_t> predecessors(distances.size());
  std::vector<Vertex> expected(distances.size());
  AG::Solver_search_options near;
  near.maximum_distance = 1;
  solver.find_distances({Solver_point::at_vertex(3)}, distances.data(), nullptr,
                        predecessors.data(), near);
  CGAL::approximate_geodesic_distances(
      mesh, CGAL::make_property_map(expected_distances), Vertex(3),
      CGAL::parameters::epsilon(0).maximum_distance(1).predecessor_map(
          CGAL::make_property_map(expected)));
  EXPECT_EQ(distances, expected_distances);
  std::size_t number_of_reached = 0;
  for(const Vertex v : mesh.vertices())
    if(predecessors[v] >= 0)
    {
      EXPECT_EQ(Vertex(static_cast<Mesh::size_type>(predecessors[v])), expected[v]);
      ++number_of_reached;
    }
    else
      EXPECT_EQ(expected[v], Mesh::null_vertex());
  EXPECT_EQ(predecessors[3], 3);
  EXPECT_GT(number_of_reached, 10u);
  EXPECT_LT(number_of_reached, distances.size());
}

// Samples of `cost(angle)` for all faces of a mesh in the xy-plane.
template <typename Cost>
AG::Solver_cost
sampled(const std::size_t number_of_faces, const std::size_t directions, const Cost& cost)
{
  std::vector<double> samples;
  for(std::size_t f = 0; f < number_of_faces; ++f)
  {
    samples.insert(samples.end(), {1, 0, 0, 0, 1, 0});
    for(std::size_t i = 0; i < directions; ++i)
    {
      const double angle = 2 * std::acos(-1.) * (double(i) / double(directions) - 0.5);
      samples.insert(samples.end(), {angle, cost(angle)});
    }
  }
  return AG::Solver_cost::sampled_cost(std::move(samples), directions);
}

Solver_options with_samples(AG::Solver_cost cost, const std::optional<double> epsilon)
{
  Solver_options result = bound(epsilon);
  result.directional_cost = std::move(cost);
  return result;
}

TEST(Solver_samples, have_the_costs_of_the_function)
{
  const Soup_arrays arrays(flat_grid(6, 5));
  const auto drift = [](const double angle) { return 1 / (2 + std::cos(angle)); };
  const Solver_of own(arrays, with_samples(sampled(arrays.number_of_faces(), 64, drift), 0.1));
  EXPECT_EQ(own.error_bound(), 0.1);
  const auto from_left = solver_distances(own, {Solver_point::at_vertex(0)});
  const auto from_right = solver_distances(own, {Solver_point::at_vertex(5)});
  EXPECT_NEAR(from_left[5], 5. / 3, 1e-6); // with the drift
  EXPECT_NEAR(from_right[0], 5, 1e-6);
  std::stringstream file;
  own.save(file);
  EXPECT_EQ(solver_distances(Solver(file)), solver_distances(own));

  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto to_right = [](const double angle) { return std::abs(angle) < 1.6 ? 1. : infinite; };
  const Solver_of ways(arrays,
                       with_samples(sampled(arrays.number_of_faces(), 64, to_right), std::nullopt));
  EXPECT_NEAR(solver_distances(ways, {Solver_point::at_vertex(0)})[5], 5, 1e-6);
  EXPECT_EQ(solver_distances(ways, {Solver_point::at_vertex(5)})[0], infinite);
}

TEST(Solver_samples, that_cannot_be_right_are_named)
{
  const Soup_arrays arrays(flat_grid(6, 5));
  const std::size_t faces = arrays.number_of_faces();
  const auto one = [](double) { return 1.; };
  const auto refuse = [&](const std::string& message, const AG::Solver_cost& cost) {
    expect_refused(message, [&] { Solver_of(arrays, with_samples(cost, 0.5)); });
  };
  const auto refuse_change = [&](const std::string& message, const std::size_t i, const double x) {
    AG::Solver_cost cost = sampled(faces, 8, one);
    cost.of_faces[2 * (6 + 2 * 8) + i] = x; // of face 2
    refuse(message, cost);
  };
  refuse("sampled in 2 directions", sampled(faces, 2, one));
  refuse("sampled in 0 directions", {AG::Solver_cost::SAMPLED_COST, {}, {}});
  refuse("there must be 22 per face", sampled(faces - 1, 8, one));
  refuse_change("face 2 has the number nan", 0, std::numeric_limits<double>::quiet_NaN());
  refuse_change("face 2 has the number -1 in its sampled cost", 7, -1);
  refuse_change("face 2 has sampled directions that are not in the order", 8, 3);
  refuse_change("face 2 has the angle -3.2 in its sampled cost", 6, -3.2);
  refuse_change("face 2 has the angle 3.2 in its sampled cost", 6 + 2 * 7, 3.2);
  refuse_change("axes of the lengths 0 and 1, and the scalar product 0", 0, 0);
  refuse_change("axes of the lengths 1 and 1.0001, and the scalar product 0", 4, 1.0001);
  refuse_change("face 2 has, in its sampled cost, axes of the lengths", 5, 1e200);
  refuse_change("and the scalar product 1e-05", 3, 1e-5);
  refuse("half a circle apart", [&] {
    AG::Solver_cost cost = sampled(faces, 8, one);
    for(std::size_t i = 6; i < cost.of_faces.size(); i += 2)
      if(i % 22 >= 6)
        cost.of_faces[i] = -3;
    return cost;
  }());
}

} // namespace
