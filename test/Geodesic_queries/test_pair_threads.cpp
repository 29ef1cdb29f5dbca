// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "threads/numbers_of_threads.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Distance_matrix_types.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>
#include <CGAL/approximate_geodesic_pair_distances.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

// Lists of pairs that several threads find, and what ends them early.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

class Pair_threads : public testing::Test
{
protected:
  template <typename NamedParameters>
  bool compute(std::vector<double>& distances, const NamedParameters& np) const
  {
    return CGAL::approximate_geodesic_pair_distances(m_mesh, m_pairs, std::back_inserter(distances),
                                                     np);
  }

  std::vector<std::pair<Surface_point, Surface_point>> pairs()
  {
    const auto points = random_surface_points(m_mesh, 200, m_random);
    std::vector<std::pair<Surface_point, Surface_point>> result;
    for(std::size_t i = 0; i < 700; ++i)
      result.emplace_back(points[m_random.below(200)], points[m_random.below(200)]);
    return result;
  }

  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(terrain(9, 8, m_random));
  const std::vector<std::pair<Surface_point, Surface_point>> m_pairs = pairs();
};

TEST_F(Pair_threads, find_the_same)
{
  const auto expect = [&](const auto& of_graph, const auto& paths) {
    std::vector<double> expected;
    EXPECT_TRUE(compute(expected, of_graph(with_concurrency(CGAL::Sequential_tag()))));
    const AG::Pair_queries queries(paths);
    const auto expected_paths = queries.paths(m_pairs);
    for_each_number_of_threads([&](const auto& tag) {
      std::vector<double> found;
      EXPECT_TRUE(compute(found, of_graph(tag)));
      EXPECT_TRUE(have_same_bits(found, expected));
      EXPECT_TRUE(have_same_bits(queries.distances(m_pairs, tag), expected));
      EXPECT_EQ(queries.paths(m_pairs, tag), expected_paths);
    });
  };
  expect([](const auto& tag) { return tag; },
         AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph>(m_mesh));
  expect([](const auto& tag) { return tag.epsilon(0.3); },
         AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>(m_mesh,
                                                                       parameters::epsilon(0.3)));
}

// Each thread has a corridor of its own.
TEST_F(Pair_threads, find_the_same_in_corridors)
{
  const AG::Surface_mesh_shortest_path<Mesh, Saddle_vertex_graph> paths(m_mesh);
  AG::Pair_queries queries(paths);
  const std::vector<double> expected = queries.distances(m_pairs);
  queries.prepare(2);
  for_each_number_of_threads([&](const auto& tag) {
    EXPECT_TRUE(have_same_bits(queries.distances(m_pairs, tag), expected));
  });
}

// A visitor that ends the computation at a question, or throws there.
struct Ending_visitor : AG::Distance_matrix_visitor_base
{
  struct Failure : std::runtime_error
  {
    Failure() : std::runtime_error("as ordered") {}
  };

  void on_progress(const AG::Distance_matrix_progress& p)
  {
    EXPECT_GE(p.number_done, number_done);
    EXPECT_LE(p.number_done, p.number_of_rows);
    number_done = p.number_done;
  }

  bool go_further()
  {
    const bool is_last = number_of_questions++ == last_question;
    if(is_last && throws)
      throw Failure();
    return !is_last;
  }

  bool throws;
  std::size_t last_question;
  std::size_t number_of_questions = 0, number_done = 0;
};

TEST_F(Pair_threads, end_if_a_visitor_wants_it)
{
  const AG::Surface_mesh_shortest_path<Mesh> paths(m_mesh);
  const AG::Pair_queries queries(paths);
  for_each_number_of_threads([&](const auto& tag) {
    for(const std::size_t last : {0u, 1u, 100u})
    {
      Ending_visitor stopping{{}, false, last}, failing{{}, true, last}, late{{}, true, 10000};
      std::vector<double> found;
      EXPECT_FALSE(compute(found, tag.visitor(std::ref(stopping))));
      EXPECT_THROW(compute(found, tag.visitor(std::ref(failing))), Ending_visitor::Failure);
      EXPECT_TRUE(found.empty());
      stopping.number_of_questions = stopping.number_done = 0;
      EXPECT_TRUE(queries.paths(m_pairs, tag.visitor(std::ref(stopping))).empty());
      EXPECT_TRUE(compute(found, tag.visitor(std::ref(late))));
      EXPECT_EQ(found.size(), m_pairs.size());
      EXPECT_EQ(late.number_done, late.number_of_questions); // one for each source
    }
  });
}

} // namespace
