// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver_cells.h>

#include "checks/expect_message.h"
#include "checks/solvers.h"
#include "meshes/test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using AG::Solver_cells;
using AG::Solver_point;

// A square of two triangles.
AG::Solver square()
{
  const std::vector<double> coordinates{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::vector<std::int64_t> corners{0, 1, 2, 0, 2, 3};
  return {coordinates.data(), 4, corners.data(), 2};
}

std::vector<Solver_point> opposite_corners()
{
  return {Solver_point::at_vertex(0), Solver_point::at_vertex(2)};
}

// They divide it by its other diagonal.
TEST(SolverCells, divide_a_square)
{
  const AG::Solver solver = square();
  const Solver_cells cells(solver, opposite_corners());
  ASSERT_EQ(cells.areas().size(), 2u);
  EXPECT_NEAR(cells.areas()[0], 0.5, 1e-12);
  EXPECT_NEAR(cells.areas()[1], 0.5, 1e-12);
  ASSERT_EQ(cells.borders().size(), 1u);
  const Solver_cells::Border& border = cells.borders()[0];
  EXPECT_FALSE(border.is_closed);
  EXPECT_EQ(border.sources, (std::array<std::size_t, 2>{0, 1}));
  for(std::size_t i = 0; i < border.coordinates.size(); i += 3)
    EXPECT_NEAR(border.coordinates[i] + border.coordinates[i + 1], 1, 1e-12);
  EXPECT_EQ(cells.neighbors(), (std::vector<std::array<std::size_t, 2>>{{0, 1}}));
  EXPECT_TRUE(cells.triangles().empty());

  EXPECT_TRUE(Solver_cells(solver, {Solver_point::at_vertex(0)}, {true}).borders().empty());
}

TEST(SolverCells, have_initial_distances_and_a_chord_error)
{
  const AG::Solver solver = square();
  const auto divide = [&](const double chord_error) {
    return Solver_cells(solver, opposite_corners(), {false, {0.5, 0}, chord_error});
  };
  const Solver_cells cells = divide(1e-4);
  ASSERT_EQ(cells.borders().size(), 1u);
  const std::vector<double>& points = cells.borders()[0].coordinates;
  double area = 0; // beside the polyline
  for(std::size_t i = 0; i < points.size(); i += 3)
  {
    EXPECT_NEAR(0.5 + std::hypot(points[i], points[i + 1]),
                std::hypot(1 - points[i], 1 - points[i + 1]), 1e-12);
    if(i > 0)
      area += (points[i - 3] * points[i + 1] - points[i] * points[i - 2]) / 2;
  }
  EXPECT_NEAR(cells.areas()[0], std::abs(area), 2e-4);
  EXPECT_NEAR(cells.areas()[0] + cells.areas()[1], 1, 1e-12);
  EXPECT_LT(divide(1).borders()[0].coordinates.size(), points.size());
}

TEST(SolverCells, name_bad_input)
{
  const AG::Solver solver = square();
  const auto expect = [&](const std::vector<Solver_point>& sources,
                          const AG::Solver_cell_options& options, const std::string& message) {
    SCOPED_TRACE(message);
    geodesics_test::expect_message<std::invalid_argument>(
        [&] { Solver_cells(solver, sources, options); }, message);
  };
  expect({Solver_point::at_vertex(0), Solver_point::at_vertex(9)}, {}, "source 1 is vertex 9");
  expect(opposite_corners(), {false, {0}}, "1 initial distances, and 2 sources");
  expect(opposite_corners(), {true, {0, -1}}, "initial distance of source 1 is -1");
  for(const double error : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    expect(opposite_corners(), {false, {}, error}, "the chord error is ");
}

TEST(SolverCells, can_be_interrupted)
{
  const geodesics_test::Soup_arrays arrays(geodesics_test::sphere(100, 50));
  const geodesics_test::Solver_of solver(arrays);
  AG::Solver_watch watch; // is asked after some time
  watch.go_further = [] { return false; };
  EXPECT_THROW(Solver_cells(solver, {Solver_point::at_vertex(0)}, {true}, watch),
               AG::Solver_interrupted);
}

} // namespace
