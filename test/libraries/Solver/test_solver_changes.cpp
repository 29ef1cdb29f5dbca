// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include "checks/solvers.h"
#include "meshes/test_meshes.h"
#include "meshes/test_soup.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <vector>

// Weights and barriers of a solver that change.

namespace {

using namespace geodesics_test;

// A square with a wall from (4, 0) to (4, 8), in which each edge is a door.
class Solver_changes : public testing::Test
{
protected:
  static constexpr std::size_t SIDE = 9;
  static constexpr std::int64_t NUMBER_OF_DOORS = 8;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Solver_changes()
  {
    for(std::int64_t y = 0; y < NUMBER_OF_DOORS; ++y)
    {
      m_wall.push_back(4 + std::int64_t(SIDE) * y);
      m_wall.push_back(4 + std::int64_t(SIDE) * (y + 1));
    }
  }

  Solver_options options(const std::vector<double>& weights) const
  {
    Solver_options result = bound(0.1);
    result.may_change = true;
    result.face_weights = weights.data();
    result.barriers = m_wall.data();
    result.number_of_barriers = NUMBER_OF_DOORS;
    return result;
  }

  const Soup_arrays m_arrays{flat_grid(SIDE, SIDE)};
  std::vector<std::int64_t> m_wall;
  std::vector<double> m_weights = std::vector<double>(m_arrays.number_of_faces(), 1);
};

TEST_F(Solver_changes, of_weights_give_the_same_as_another_solver)
{
  Solver_of solver(m_arrays, options(m_weights));
  for(std::int64_t i = 0; i < 20; ++i)
  {
    const std::int64_t face = (37 * i) % std::int64_t(m_weights.size());
    m_weights[std::size_t(face)] = i % 6 == 5 ? infinity : double(1 + i % 4);
    solver.set_weights(&face, &m_weights[std::size_t(face)], 1);
    EXPECT_EQ(solver.error_bound(), 0.1);
    EXPECT_EQ(solver_distances(solver), solver_distances(Solver_of(m_arrays, options(m_weights))));
  }
}

TEST_F(Solver_changes, of_barriers_open_doors_and_close_them)
{
  Solver_of solver(m_arrays, options(m_weights));
  const std::vector<double> closed = solver_distances(solver);
  EXPECT_EQ(closed.back(), infinity);
  const std::array<bool, 2> open{false, false};
  solver.set_barriers(m_wall.data(), open.data(), 2);
  const std::vector<double> found = solver_distances(solver);
  EXPECT_GE(found.back(), std::sqrt(5 * 5 + 8 * 8));
  EXPECT_LT(found.back(), infinity);
  EXPECT_EQ(solver.error_bound(), 0.1);

  std::stringstream file;
  solver.save(file);
  const Solver read(file);
  EXPECT_NEAR(solver_distances(read).back(), found.back(), 0.1 * found.back());

  const std::array<bool, 2> shut{true, true};
  solver.set_barriers(m_wall.data(), shut.data(), 2);
  EXPECT_EQ(solver_distances(solver), closed);
}

// A graph for barriers is not saved, so that another one has to be built.
TEST_F(Solver_changes, of_the_last_barriers_can_be_saved)
{
  Solver_options options = bound(0.1);
  options.barriers = m_wall.data();
  options.number_of_barriers = 2;
  Solver_of solver(m_arrays, options);
  const std::array<bool, 2> open{false, false};
  solver.set_barriers(m_wall.data(), open.data(), 2);
  const double distance = solver_distances(solver).back();
  std::stringstream file, second_file;
  solver.save(file);
  const Solver read(file);
  EXPECT_FALSE(read.has_barriers());
  EXPECT_NEAR(solver_distances(read).back(), distance, 0.1 * distance);
  read.save(second_file);
  EXPECT_EQ(solver_distances(Solver(second_file)), solver_distances(read));
}

TEST_F(Solver_changes, are_refused_if_they_are_wrong)
{
  Solver_of solver(m_arrays, options(m_weights));
  const std::vector<double> before = solver_distances(solver);
  const double two = 2, nothing = std::numeric_limits<double>::quiet_NaN();
  const std::int64_t face = 3, no_face = 128;
  const bool open = false;
  expect_refused("face 128", [&] { solver.set_weights(&no_face, &two, 1); });
  expect_refused("weight", [&] { solver.set_weights(&face, &nothing, 1); });
  const std::array<std::int64_t, 2> edge{0, 1}, none{0, 80};
  expect_refused("barrier", [&] { solver.set_barriers(edge.data(), &open, 1); });
  expect_refused("edge", [&] { solver.set_barriers(none.data(), &open, 1); });
  EXPECT_EQ(solver_distances(solver), before);
  Solver_of other(m_arrays, bound(0.1));
  expect_refused("without face weights", [&] { other.set_weights(&face, &two, 1); });
}

} // namespace
