// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver_walks.h>

#include "checks/expect_message.h"
#include "checks/solvers.h"
#include "meshes/surface_points.h"
#include "paths/closed_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

// Walks and loops of a solver are those of the functions.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Solver_walks;
using AG::Tangent_vector;

TEST(SolverWalks, are_those_of_the_functions)
{
  const Solver_of solver(Soup_arrays(torus(24, 15, 3, 1)));
  const auto& mesh = solver.mesh();
  const Solver_walks walks(solver);
  const Solver_point start = Solver_point::in_face(17, {0.2, 0.3, 0.5});
  const AG::Face_location<AG::Solver::Mesh> place(AG::Solver::Mesh::Face_index(17),
                                                  {0.2, 0.3, 0.5});

  const Solver_walks::Walk walk = walks.trace(start, Solver_walks::Vector{1, 2, 3}, 5);
  const auto same = AG::trace_geodesic(mesh, place, Kernel::Vector_3(1, 2, 3), 5);
  EXPECT_EQ(walk.coordinates.size(), 3 * same.points.size());
  EXPECT_EQ(walk.length, 5);
  EXPECT_FALSE(walk.meets_border);
  EXPECT_NEAR(std::hypot(walk.direction[0], walk.direction[1], walk.direction[2]), 1, 1e-12);
  EXPECT_EQ(walks.trace(start, Tangent_vector{1, 0}, 2).length, 2);

  std::vector<double> logarithms(2 * mesh.number_of_vertices());
  walks.find_logarithms(start, logarithms.data());
  std::vector<Tangent_vector> vectors(mesh.number_of_vertices());
  AG::logarithmic_map(
      mesh, boost::make_iterator_property_map(vectors.begin(), get(boost::vertex_index, mesh)),
      place);
  for(std::size_t v = 0; v < vectors.size(); ++v)
  {
    EXPECT_EQ(logarithms[2 * v], vectors[v].x);
    EXPECT_EQ(logarithms[2 * v + 1], vectors[v].y);
  }
}

TEST(SolverWalks, have_directions_that_leave_the_surface_at_border_vertices)
{
  const Solver_of solver(Soup_arrays(flat_grid(9, 9)));
  const Solver_walks walks(solver);
  for(const Solver_walks::Vector direction : {Solver_walks::Vector{0, 1, 0}, {-1, -1, 0}})
  {
    const auto walk = walks.trace(Solver_point::at_vertex(10), direction, 100); // from (1, 1)
    EXPECT_TRUE(walk.meets_border);
    const double length = std::hypot(direction[0], direction[1]);
    for(const std::size_t i : {0u, 1u, 2u})
      EXPECT_NEAR(walk.direction[i], direction[i] / length, 1e-9);
  }
  const Solver_point at_border = Solver_point::at_vertex(4);
  const Tangent_vector v =
      walks.transport(Solver_point::at_vertex(40), at_border, Solver_walks::Vector{0, -1, 0});
  EXPECT_NEAR(walks.vector_3(at_border, v)[1], -1, 1e-9);
}

TEST(SolverWalks, transport_vectors_and_find_means_in_a_plane)
{
  const Solver_of solver(Soup_arrays(flat_grid(9, 7)));
  const Solver_walks walks(solver);
  const Solver_point p = Solver_point::at_vertex(10),
                     q = Solver_point::in_face(40, {0.2, 0.3, 0.5});
  const Tangent_vector v = walks.transport(p, q, Solver_walks::Vector{3, 4, 0});
  const Solver_walks::Vector in_space = walks.vector_3(q, v);
  EXPECT_NEAR(in_space[0], 3, 1e-12);
  EXPECT_NEAR(in_space[1], 4, 1e-12);
  EXPECT_NEAR(in_space[2], 0, 1e-12);

  const std::vector<Solver_point> corners{Solver_point::at_vertex(0), Solver_point::at_vertex(8)};
  const Solver_walks::Mean mean = walks.find_mean(corners, {1, 1});
  EXPECT_TRUE(mean.has_converged);
  EXPECT_NEAR(mean.deviation, 4, 1e-12);
  const Solver_walks::Mean other = walks.find_mean(corners, {1, 3});
  EXPECT_NEAR(other.deviation, std::sqrt(12.), 1e-12);
}

// The vector of the nearest source, after the same transport.
TEST(SolverWalks, extend_vectors)
{
  const Solver_of solver(Soup_arrays(torus(24, 15, 3, 1)), bound(0));
  const Solver_walks walks(solver);
  const std::vector<Solver_point> sources{Solver_point::in_face(17, {0.2, 0.3, 0.5}),
                                          Solver_point::at_vertex(200)};
  const std::vector<Tangent_vector> vectors{{3, 4}, {0, -1}};
  std::vector<double> extended(2 * solver.number_of_vertices()), distances(extended.size() / 2);
  std::vector<std::int64_t> nearest(distances.size());
  walks.extend_vectors(sources, vectors, extended.data());
  solver.find_distances(sources, distances.data(), nearest.data());
  for(std::size_t v = 0; v < nearest.size(); ++v)
  {
    const auto i = static_cast<std::size_t>(nearest[v]);
    const Tangent_vector expected = walks.transport(
        sources[i], Solver_point::at_vertex(static_cast<std::int64_t>(v)), vectors[i]);
    EXPECT_NEAR(extended[2 * v], expected.x, 1e-9);
    EXPECT_NEAR(extended[2 * v + 1], expected.y, 1e-9);
  }
}

TEST(SolverWalks, extend_no_vectors_to_other_components)
{
  Soup soup = flat_grid(3, 3);
  soup.points.insert(soup.points.end(), {Point(9, 0, 0), Point(9, 1, 0), Point(9, 0, 1)});
  soup.triangles.push_back({9, 10, 11});
  soup.points.emplace_back(0, 0, 9); // in no face
  const Solver_of solver{Soup_arrays(soup)};
  const Solver_walks walks(solver);
  std::vector<double> extended(26, -1);
  walks.extend_vectors({Solver_point::at_vertex(9)}, {{1, 0}}, extended.data());
  for(std::size_t v = 0; v < 13; ++v)
    EXPECT_NEAR(std::hypot(extended[2 * v], extended[2 * v + 1]), v < 9 || v == 12 ? 0 : 1, 1e-15);
}

TEST(SolverWalks, can_be_interrupted)
{
  const Solver_of solver(Soup_arrays(torus(300, 200, 3, 1)));
  const Solver_walks walks(solver);
  const auto expect = [](const auto& f) { EXPECT_THROW(f(), AG::Solver_interrupted); };
  const AG::Solver_watch watch = impatient_watch();
  std::vector<double> vectors(2 * solver.number_of_vertices());
  const Solver_point p = Solver_point::at_vertex(7);
  std::vector<Solver_point> curve;
  for(std::int64_t i = 0; i < 1000; ++i)
    curve.push_back(Solver_point::at_vertex(i * 7919 % 60000));
  expect([&] { Solver_walks(solver, watch); });
  expect([&] { walks.trace(p, Tangent_vector{1, 2}, 1e5, watch); });
  expect([&] { walks.find_logarithms(p, vectors.data(), watch); });
  expect([&] { walks.extend_vectors({p}, {{1, 0}}, vectors.data(), watch); });
  expect([&] { walks.find_mean(curve, std::vector<double>(1000, 1), watch); });
  expect([&] { walks.shorten_loop(curve, watch); });
  expect([&] { walks.shorten_curve(curve, watch); });
  expect([&] { walks.shortest_loop_through(p, watch); });
}

TEST(SolverWalks, give_orthonormal_frames)
{
  const Solver_of solver(Soup_arrays(torus(24, 15, 3, 1)));
  const Solver_walks walks(solver);
  const std::size_t size = 3 * solver.number_of_vertices();
  std::vector<double> x(size), y(size), z(size);
  walks.find_frames(x.data(), y.data(), z.data());
  for(std::size_t i = 0; i < size; i += 3)
  {
    const Kernel::Vector_3 a(x[i], x[i + 1], x[i + 2]), b(y[i], y[i + 1], y[i + 2]),
        c(z[i], z[i + 1], z[i + 2]);
    EXPECT_NEAR(CGAL::scalar_product(CGAL::cross_product(a, b), c), 1, 1e-12);
    EXPECT_NEAR(a.squared_length(), 1, 1e-12);
    EXPECT_NEAR(b.squared_length(), 1, 1e-12);
  }
}

TEST(SolverLoops, join_points_that_are_apart)
{
  const Solver_of solver(Soup_arrays(torus(24, 16, 3, 1)));
  const Solver_walks walks(solver);
  std::vector<Solver_point> points; // every other one on the outside
  for(std::int64_t v = 0; v < 384; v += 32)
    points.push_back(Solver_point::at_vertex(v));
  const Solver_walks::Curve loop = walks.shorten_loop(points);
  EXPECT_NEAR(loop.length, 96 * std::sin(4 * std::atan(1.) / 24), 1e-11); // the inner polygon
  EXPECT_TRUE(std::equal(loop.coordinates.begin(), loop.coordinates.begin() + 3,
                         loop.coordinates.end() - 3));
  const Solver_walks::Curve through = walks.shortest_loop_through(points[0]);
  EXPECT_LE(through.length, 32 * std::sin(4 * std::atan(1.) / 16) + 1e-12);
  points.resize(1);
  EXPECT_EQ(walks.shorten_loop(points).coordinates.size(), 3u);
  EXPECT_EQ(walks.shorten_curve(points).coordinates.size(), 3u);
}

// Around the hole, to the inside of the torus, where the ends are.
TEST(SolverCurves, are_shortened_between_their_ends)
{
  const Solver_of solver(Soup_arrays(torus(24, 16, 3, 1)));
  const Solver_walks walks(solver);
  const double side = 4 * std::sin(4 * std::atan(1.) / 24); // of the inner polygon
  const auto at = [](const std::int64_t v) { return Solver_point::at_vertex(v); };
  for(const std::int64_t sides : {3, 12, 17, 24, 30})
  {
    std::vector<Solver_point> points;
    for(std::int64_t i = 0; i < sides; ++i)
      points.push_back(at(i % 24 * 16 + (i == 0 ? 8 : 2)));
    points.push_back(at(sides % 24 * 16 + 8));
    const Solver_walks::Curve curve = walks.shorten_curve(points);
    EXPECT_NEAR(curve.length, static_cast<double>(sides) * side, 1e-11);
  }
  EXPECT_EQ(walks.shorten_curve({at(7), at(100), at(7)}).coordinates.size(), 3u);
}

TEST(SolverWalks, reject_bad_input)
{
  const Solver_of solver(Soup_arrays(flat_grid(4, 4)));
  const Solver_walks walks(solver);
  const auto expect = [](const auto& f, const char* const text) {
    expect_message<std::invalid_argument>(f, text);
  };
  const Solver_point p = Solver_point::at_vertex(5), none = Solver_point::at_vertex(99);
  expect([&] { walks.trace(none, Tangent_vector{1, 0}, 1); }, "start is vertex 99");
  expect([&] { walks.trace(p, Tangent_vector{1, 0}, -1); }, "the length is -1");
  expect([&] { walks.shorten_loop({}); }, "a curve has no points");
  expect([&] { walks.shorten_loop({p, none}); }, "point 1 is vertex 99");
  expect([&] { walks.shorten_curve({p, none}); }, "point 1 is vertex 99");
  std::vector<double> vectors(32);
  expect([&] { walks.extend_vectors({p}, {}, vectors.data()); },
         "there are 1 sources, and 0 vectors");
  expect(
      [&] {
        walks.extend_vectors({p}, {{std::nan(""), 0}}, vectors.data());
      },
      "vector 0 is nan, 0");
  expect([&] { walks.find_mean({}, {}); }, "there are no points");
  expect([&] { walks.find_mean({p}, {}); }, "there are 1 points, and 0 weights");
  EXPECT_TRUE(std::isinf(walks.shortest_loop_through(p).length));
}

} // namespace
