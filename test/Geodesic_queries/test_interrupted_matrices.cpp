// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "checks/failing_allocation.h"

#include <CGAL/Geodesic_queries/Rows_in_memory.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// Distance matrices that end for want of memory. Sinks are empty then, and can be used again.

namespace {

namespace parameters = CGAL::parameters;
using namespace geodesics_test;

Values values_in(const Dense_rows<>& rows)
{
  Values result;
  for(const auto& row : matrix_of(rows))
    result.insert(result.end(), row.begin(), row.end());
  return result;
}

Values values_in(const Sparse_rows<double>& rows)
{
  Values result;
  for(const auto& row : entries_of(rows))
    for(const auto& [distance, column] : row)
      result.insert(result.end(), {distance, double(column)});
  return result;
}

class Interrupted_matrix : public testing::Test
{
protected:
  // In the sink that `make` makes.
  template <typename Make, typename Sources, typename NamedParameters>
  void expect_survival_in(Make make, const Sources& sources, const NamedParameters& np) const
  {
    using Rows = decltype(make());
    expect_survival<Rows>(
        {make,
         [&](Rows& rows) {
           EXPECT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, sources, np));
         },
         [](Rows& rows) { return values_in(rows); },
         [](Rows& rows) { EXPECT_EQ(rows.number_of_rows(), 0u); }});
  }

  template <typename Sources, typename NamedParameters>
  void expect_survival_in_all(const Sources& sources, const NamedParameters& np) const
  {
    expect_survival_in([] { return Dense_rows<>(); }, sources, np);
    expect_survival_in([] { return Radius_rows<>(); }, sources, np);
    expect_survival_in([] { return Nearest_rows<>(5); }, sources, np);
    expect_survival([&] {
      Values result;
      CGAL::approximate_geodesic_distance_matrix(
          m_mesh,
          [&](const std::size_t row, const Distance_row& distances) {
            result.push_back(double(row));
            result.insert(result.end(), distances.begin(), distances.end());
          },
          sources, np);
      return result;
    });
  }

  const Mesh m_mesh = small_terrain();
  const std::vector<Vertex> m_vertices = {Vertex(3), Vertex(40), Vertex(3), Vertex(62)};
};

TEST_F(Interrupted_matrix, of_vertices)
{
  expect_survival_in_all(m_vertices, parameters::targets(m_vertices));
  expect_survival_in_all(m_vertices, parameters::maximum_distance(4));
}

TEST_F(Interrupted_matrix, of_points_across_faces)
{
  Random random(test_seed());
  const std::vector<Surface_point> points = random_surface_points(m_mesh, 6, random);
  expect_survival_in_all(points, parameters::targets(points).epsilon(1.));
}

TEST_F(Interrupted_matrix, that_is_symmetric)
{
  const auto np = parameters::targets(m_vertices).symmetric(true);
  expect_survival_in([] { return Dense_rows<>(); }, m_vertices, np);
  expect_survival_in([] { return Radius_rows<>(); }, m_vertices, np);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_F(Interrupted_matrix, of_several_threads)
{
  const std::vector<Vertex> sources(20, Vertex(7));
  expect_survival_in_all(sources, parameters::concurrency_tag(CGAL::Parallel_tag()));
}
#endif

} // namespace
