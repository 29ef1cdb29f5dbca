// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver_pairs.h>

#include "checks/expect_message.h"
#include "checks/solvers.h"
#include "meshes/test_meshes.h"
#include "meshes/test_soup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

// Lists of pairs that a solver finds are rows of its matrices, and paths between their ends.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

class Solver_pairs : public testing::Test
{
protected:
  using Points = std::vector<Solver_point>;

  static Soup soup()
  {
    Soup result = sphere(12, 9);
    result.append(flat_grid(3, 3)); // which no path leads to
    return result;
  }

  std::vector<double> distances(const Solver& solver) const
  {
    std::vector<double> result(m_sources.size());
    AG::Solver_pairs(solver).find_distances(m_sources, m_targets, result.data());
    return result;
  }

  const Soup_arrays m_arrays{soup()};
  const std::int64_t m_last = static_cast<std::int64_t>(m_arrays.number_of_vertices()) - 1;
  const Points m_sources{Solver_point::at_vertex(40), Solver_point::at_vertex(3),
                         Solver_point::at_vertex(40), Solver_point::in_face(7, {0.5, 0.25, 0.25}),
                         Solver_point::at_vertex(3)};
  const Points m_targets{Solver_point::at_vertex(71), Solver_point::at_vertex(m_last),
                         Solver_point::in_face(50, {0.25, 0.5, 0.25}), Solver_point::at_vertex(12),
                         Solver_point::at_vertex(3)};
};

TEST_F(Solver_pairs, are_entries_of_matrices)
{
  for(const auto epsilon : {std::optional<double>(), std::optional(0.2), std::optional(0.)})
  {
    const Solver_of solver(m_arrays, bound(epsilon));
    const std::vector<double> found = distances(solver);
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const Points target{m_targets[i]};
      AG::Solver_row_options options;
      options.targets = &target;
      double expected = 0;
      solver.compute_matrix(&expected, {m_sources[i]}, options);
      EXPECT_EQ(found[i], expected);
    }
    EXPECT_EQ(found[1], std::numeric_limits<double>::infinity());
    EXPECT_EQ(found[4], 0);
  }
}

// Not to the last bit in a graph with points.
TEST_F(Solver_pairs, may_be_prepared)
{
  for(const auto epsilon : {std::optional<double>(), std::optional(0.2), std::optional(0.)})
  {
    Solver_of solver(m_arrays, bound(epsilon));
    const std::size_t memory = solver.memory();
    const std::vector<double> expected = distances(solver);
    std::vector<double> intervals(2 * expected.size());
    solver.prepare_pairs(3);
    EXPECT_GT(solver.memory(), memory);
    const std::vector<double> found = distances(solver);
    AG::Solver_pairs(solver).find_intervals(m_sources, m_targets, intervals.data());
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_TRUE(found[i] == expected[i] || std::abs(found[i] / expected[i] - 1) < 1e-12);
      EXPECT_LE(intervals[2 * i], expected[i]);
      EXPECT_GE(intervals[2 * i + 1], found[i]);
    }
  }
}

TEST_F(Solver_pairs, have_intervals)
{
  const Solver_of exact(m_arrays, bound(0)), with_bound(m_arrays, bound(0.2)),
      along_edges(m_arrays);
  const std::vector<double> expected = distances(exact);
  for(const Solver* const solver :
      {static_cast<const Solver*>(&exact), static_cast<const Solver*>(&with_bound),
       static_cast<const Solver*>(&along_edges)})
  {
    std::vector<double> ends(2 * expected.size());
    AG::Solver_pairs(*solver).find_intervals(m_sources, m_targets, ends.data());
    for(std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_LE(ends[2 * i], expected[i]);
      EXPECT_GE(ends[2 * i + 1], expected[i]);
    }
  }
}

// Those of vertices are read from labels; others, and those after a change, are searched.
TEST_F(Solver_pairs, have_intervals_that_are_prepared)
{
  constexpr double epsilon_of_labels = 0.1;
  for(const auto epsilon : {std::optional<double>(), std::optional(0.9)})
    for(const bool has_weights : {false, true})
    {
      const std::vector<double> weights(m_arrays.number_of_faces(), 2);
      AG::Solver_options options = bound(epsilon);
      options.face_weights = has_weights ? weights.data() : nullptr;
      Solver_of solver(m_arrays, options);
      std::vector<double> searched(2 * m_sources.size()), read = searched;
      AG::Solver_pairs(solver).find_intervals(m_sources, m_targets, searched.data());
      const std::size_t memory = solver.memory();
      solver.prepare_intervals(epsilon_of_labels);
      EXPECT_GT(solver.memory(), memory);
      AG::Solver_pairs(solver).find_intervals(m_sources, m_targets, read.data());
      const double factor = (1 + epsilon_of_labels) * (1 + epsilon.value_or(0)) * 1.00001;
      for(std::size_t i = 0; i < read.size(); i += 2)
      {
        EXPECT_LE(read[i], searched[i + 1]);
        EXPECT_GE(read[i + 1], searched[i]);
        EXPECT_GE(read[i] * factor, searched[i]);
        EXPECT_LE(read[i + 1], searched[i + 1] * factor);
      }
      if(!has_weights)
        continue;
      std::vector<std::int64_t> faces(weights.size());
      std::iota(faces.begin(), faces.end(), 0);
      const std::vector<double> doubled(weights.size(), 4);
      solver.set_weights(faces.data(), doubled.data(), faces.size());
      AG::Solver_pairs(solver).find_intervals(m_sources, m_targets, read.data());
      for(std::size_t i = 1; i < read.size(); i += 2)
        EXPECT_EQ(read[i], 2 * searched[i]);
    }
  expect_message<std::invalid_argument>(
      [&] { Solver_of(m_arrays, bound(0)).prepare_intervals(0.1); }, "exact");
  expect_message<std::invalid_argument>(
      [&] { Solver_of(m_arrays, bound(0.2)).prepare_intervals(0); }, "epsilon is");
}

TEST_F(Solver_pairs, keep_intervals_that_are_prepared_if_others_fail)
{
  Solver_of solver(m_arrays, bound(0.2));
  solver.prepare_intervals(0.1);
  const std::size_t memory = solver.memory();
  EXPECT_THROW(solver.prepare_intervals(-1), std::invalid_argument);
  EXPECT_EQ(solver.memory(), memory);
}

// Those beyond the range are the same as of searches.
TEST_F(Solver_pairs, have_intervals_that_are_prepared_in_a_range)
{
  const Solver_of unprepared(m_arrays, bound(0.2));
  Solver_of solver(m_arrays, bound(0.2));
  solver.prepare_intervals(0.01);
  const double distance = distances(unprepared).front();
  std::vector<double> searched(2 * m_sources.size()), read = searched, unlimited = searched;
  AG::Solver_pairs(solver).find_intervals(m_sources, m_targets, unlimited.data());
  for(const double range : {0., distance / 2, 2 * distance})
  {
    AG::Solver_pair_options options;
    options.maximum_distance = range;
    AG::Solver_pairs(unprepared).find_intervals(m_sources, m_targets, searched.data(), options);
    AG::Solver_pairs(solver).find_intervals(m_sources, m_targets, read.data(), options);
    for(const std::size_t end : {0u, 1u})
    {
      EXPECT_EQ(read[end], range > distance ? unlimited[end] : searched[end]);
      for(const std::size_t pair : {1u, 2u, 3u}) // to another component, and not of vertices
        EXPECT_EQ(read[2 * pair + end], searched[2 * pair + end]);
    }
    EXPECT_EQ(read[9], 0);
  }
}

TEST_F(Solver_pairs, have_paths)
{
  const Solver_of solver(m_arrays, bound(0.2));
  const std::vector<double> expected = distances(solver);
  std::vector<double> lengths(m_sources.size());
  const auto paths = AG::Solver_pairs(solver).find_paths(m_sources, m_targets, lengths.data());
  ASSERT_EQ(paths.size(), lengths.size());
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    if(i == 1)
    {
      EXPECT_TRUE(paths[i].empty());
      EXPECT_EQ(lengths[i], expected[i]);
      continue;
    }
    EXPECT_NEAR(lengths[i], expected[i], 1e-6);
    std::vector<double> single;
    solver.find_path(m_sources[i], m_targets[i], false, single);
    ASSERT_GE(single.size(), 3u);
    for(std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_EQ(paths[i][k], single[k]);
      EXPECT_EQ(paths[i][paths[i].size() - 3 + k], single[single.size() - 3 + k]);
    }
  }
  AG::Solver_pair_options options;
  options.straighten = true;
  std::vector<double> straight(m_sources.size());
  AG::Solver_pairs(solver).find_paths(m_sources, m_targets, straight.data(), options);
  for(std::size_t i = 0; i < straight.size(); ++i)
    EXPECT_LE(straight[i], lengths[i]);
}

TEST_F(Solver_pairs, may_be_limited_and_end_early)
{
  const Solver_of solver(m_arrays, bound(0.2));
  const std::vector<double> all = distances(solver);
  AG::Solver_pair_options options;
  options.maximum_distance = all[0] / 2;
  std::vector<double> near(all.size());
  for(const std::size_t threads : {1u, 2u})
  {
    options.number_of_threads = threads;
    AG::Solver_pairs(solver).find_distances(m_sources, m_targets, near.data(), options);
    for(std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(near[i], all[i] <= options.maximum_distance
                             ? all[i]
                             : std::numeric_limits<double>::infinity());
  }
  std::size_t number_done = 0, number = 0;
  const AG::Solver_watch watch{{}, [&](const std::size_t done, const std::size_t of) {
                                 number_done = done;
                                 number = of;
                               }};
  AG::Solver_pairs(solver).find_distances(m_sources, m_targets, near.data(), {}, watch);
  EXPECT_EQ(number_done, 3u);
  EXPECT_EQ(number, 3u);
}

TEST_F(Solver_pairs, are_refused_by_their_number)
{
  const Solver_of solver(m_arrays);
  double distance = 0;
  const Points vertices{Solver_point::at_vertex(0), Solver_point::at_vertex(-1)};
  expect_refused("the source of pair 1 is vertex -1", [&] {
    AG::Solver_pairs(solver).find_distances(vertices, {vertices[0], vertices[0]}, &distance);
  });
  expect_refused("the target of pair 0 is vertex -1",
                 [&] { AG::Solver_pairs(solver).find_paths({vertices[0]}, {vertices[1]}); });
  expect_refused("pairs have 2 sources and 1 targets", [&] {
    AG::Solver_pairs(solver).find_intervals(vertices, {vertices[0]}, &distance);
  });
}

} // namespace
