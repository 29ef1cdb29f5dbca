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
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using AG::Solver_cells;
using AG::Solver_point;

// A square of two triangles, divided between two opposite corners by its other diagonal.
TEST(SolverCells, divide_a_square)
{
  const std::vector<double> coordinates{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::vector<std::int64_t> corners{0, 1, 2, 0, 2, 3};
  const AG::Solver solver(coordinates.data(), 4, corners.data(), 2);
  const Solver_cells cells(solver, {Solver_point::at_vertex(0), Solver_point::at_vertex(2)});
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

  EXPECT_TRUE(Solver_cells(solver, {Solver_point::at_vertex(0)}, true).borders().empty());
  geodesics_test::expect_message<std::invalid_argument>(
      [&] {
        Solver_cells(solver, {Solver_point::at_vertex(0), Solver_point::at_vertex(9)});
      },
      "source 1 is vertex 9");
}

TEST(SolverCells, can_be_interrupted)
{
  using namespace geodesics_test;
  const Solver_of solver(Soup_arrays(sphere(150, 100)));
  const auto divide = [&](const AG::Solver_watch& watch) {
    Solver_cells(solver, {Solver_point::at_vertex(7)}, true, watch);
  };
  EXPECT_THROW(divide(impatient_watch()), AG::Solver_interrupted);
}

} // namespace
