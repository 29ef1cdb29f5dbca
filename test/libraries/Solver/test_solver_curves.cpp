// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver_curves.h>

#include "checks/expect_message.h"
#include "checks/solvers.h"
#include "meshes/test_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

// Curves and regions of plain arrays.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

using AG::Solver_curves;
using AG::Solver_point;

// A flat grid of 9 x 9 vertices.
class Curves_of_arrays : public testing::Test
{
protected:
  static std::vector<double> coordinates()
  {
    std::vector<double> result;
    for(int y = 0; y < 9; ++y)
      for(int x = 0; x < 9; ++x)
        result.insert(result.end(), {double(x), double(y), 0});
    return result;
  }

  static std::vector<std::int64_t> faces()
  {
    std::vector<std::int64_t> result;
    for(std::int64_t y = 0; y < 8; ++y)
      for(std::int64_t x = 0; x < 8; ++x)
      {
        const std::int64_t v = x + 9 * y;
        result.insert(result.end(), {v, v + 1, v + 10, v, v + 10, v + 9});
      }
    return result;
  }

  const std::vector<double> m_coordinates = coordinates();
  const std::vector<std::int64_t> m_faces = faces();
  const AG::Solver m_solver = {m_coordinates.data(), 81, m_faces.data(), 128};
  const Solver_curves m_curves{m_solver};
};

TEST_F(Curves_of_arrays, have_exact_distances)
{
  std::vector<double> distances(81);
  m_curves.find_distances(
      m_curves.curve({Solver_point::at_vertex(18), Solver_point::at_vertex(26)}, false),
      distances.data()); // the row y = 2
  for(std::size_t v = 0; v < 81; ++v)
    EXPECT_NEAR(distances[v], std::abs(double(v / 9) - 2), 1e-12);
  m_curves.find_distances(m_curves.region({0}), distances.data());
  EXPECT_EQ(distances[10], 0);
  EXPECT_NEAR(distances[12], 2, 1e-12);
}

TEST_F(Curves_of_arrays, have_distances_with_a_sign_if_wanted)
{
  std::vector<double> distances(81);
  m_curves.find_distances(
      m_curves.curve({Solver_point::at_vertex(18), Solver_point::at_vertex(26)}, false),
      distances.data(), true); // the row y = 2, from border to border
  for(std::size_t v = 0; v < 81; ++v)
    EXPECT_NEAR(distances[v], 2 - double(v / 9), 1e-12);
  expect_message<std::invalid_argument>(
      [&] {
        m_curves.find_distances(
            m_curves.curve({Solver_point::at_vertex(30), Solver_point::at_vertex(32)}, false),
            distances.data(), true);
      },
      "source 0 has no two sides");
}

TEST_F(Curves_of_arrays, have_offsets)
{
  const auto row =
      m_curves.curve({Solver_point::at_vertex(18), Solver_point::at_vertex(26)}, false);
  const std::vector<Solver_curves::Offset> offsets = m_curves.offsets(row, {1.5, 3});
  ASSERT_EQ(offsets.size(), 3u); // two, and one
  for(const auto& offset : offsets)
  {
    ASSERT_EQ(offset.coordinates.size() % 3, 0u);
    for(std::size_t i = 0; i < offset.coordinates.size(); i += 3)
      EXPECT_NEAR(std::abs(offset.coordinates[i + 1] - 2), offset.distance, 0.01);
  }
  const auto middle = m_curves.curve({Solver_point::at_vertex(40)}, false);
  const auto ring = m_curves.offsets(middle, {2}).at(0).coordinates;
  EXPECT_EQ(ring.front(), ring[ring.size() - 3]);
}

TEST(Curves_of_large_arrays, can_be_interrupted_and_tell_their_progress)
{
  const Soup_arrays arrays(sphere(120, 80));
  const AG::Solver solver(arrays.coordinates.data(), arrays.number_of_vertices(),
                          arrays.corners.data(), arrays.number_of_faces());
  const Solver_curves curves(solver);
  const auto pole = curves.curve({Solver_point::at_vertex(0)}, false);
  AG::Solver_watch watch;
  std::size_t number_done = 0, number = 0;
  watch.on_progress = [&](const std::size_t done, const std::size_t all) {
    number_done = done;
    number = all;
  };
  std::vector<double> distances(solver.number_of_vertices());
  curves.find_distances(pole, distances.data(), false, watch);
  EXPECT_EQ(number_done, number);
  EXPECT_GT(number, 0u);
  watch.go_further = [] { return false; };
  EXPECT_THROW(curves.find_distances(pole, distances.data(), false, watch), AG::Solver_interrupted);
  EXPECT_THROW(curves.offsets(pole, {1, 2}, watch), AG::Solver_interrupted);
}

TEST_F(Curves_of_arrays, are_refused_with_elements_that_do_not_exist)
{
  expect_message<std::invalid_argument>(
      [&] {
        m_curves.curve({Solver_point::at_vertex(0), Solver_point::at_vertex(81)}, true);
      },
      "point 1 is vertex 81");
  expect_message<std::invalid_argument>([&] { m_curves.region({128}); },
                                        "face 128 of the region does not exist");
}

} // namespace
