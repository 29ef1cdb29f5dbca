// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver_locator.h>

#include "checks/expect_message.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

// The nearest points of the surface. The tests of the bindings have more of them.

namespace {

using namespace geodesics_test;

namespace AG = CGAL::Approximate_geodesics;

// a square of two faces, which are on both sides of its diagonal from vertex 1 to vertex 2
const std::vector<double> corners_of_square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
const std::vector<std::int32_t> faces_of_square = {0, 1, 2, 3, 2, 1};

using Locations = std::vector<AG::Solver_locator::Location>;

Locations locate_in_square(const std::vector<double>& points,
                           const double size = 1,
                           const AG::Solver_watch& watch = {})
{
  std::vector<double> vertices = corners_of_square;
  for(double& x : vertices)
    x *= size;
  const AG::Solver solver(vertices.data(), 4, faces_of_square.data(), 2);
  Locations result;
  AG::Solver_locator(solver).locate(points.data(), points.size() / 3, std::back_inserter(result),
                                    watch);
  return result;
}

} // namespace

TEST(Solver_locator, finds_nearest_points_in_order)
{
  const Locations found = locate_in_square({0.25, 0.25, 3, 2, 2, 0, -1, 0, 0});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].face, 0);
  EXPECT_EQ(found[0].distance, 3);
  EXPECT_EQ(found[0].coordinates, (std::array<double, 3>{0.5, 0.25, 0.25}));
  EXPECT_EQ(found[1].face, 1);
  EXPECT_EQ(found[1].coordinates, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(found[2].coordinates, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(found[2].distance, 1);
}

TEST(Solver_locator, squares_of_coordinates_do_not_overflow_or_underflow)
{
  for(const double size : {1e-200, 1e200})
    EXPECT_EQ(locate_in_square({size / 4, size / 4, 3 * size}, size).at(0).distance, 3 * size);
}

TEST(Solver_locator, names_points_that_cannot_be_right)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_message<std::invalid_argument>(
      [&] {
        locate_in_square({0, 0, 0, 0, nan, 2});
      },
      "point 1 is (0, nan, 2)");
  expect_message<std::invalid_argument>(
      [&] {
        locate_in_square({1e200, 0, 0});
      },
      "point 0 is (1e+200, 0, 0)");
}

TEST(Solver_locator, needs_faces)
{
  const AG::Solver solver(corners_of_square.data(), 4, faces_of_square.data(), 0);
  expect_message<std::invalid_argument>([&] { AG::Solver_locator locator(solver); },
                                        "the mesh has no faces to locate points in");
}

TEST(Solver_locator, is_ended_by_its_watch)
{
  AG::Solver_watch watch;
  watch.go_further = [] { return false; };
  EXPECT_THROW(locate_in_square({0, 0, 0}, 1, watch), AG::Solver_interrupted);
}
