// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Solver/Solver.h>

#include "checks/solvers.h"
#include "meshes/test_meshes.h"
#include "meshes/test_soup.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

// What a solver finds besides distances and paths is what the functions find on the same mesh.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

constexpr double infinite = std::numeric_limits<double>::infinity();

class Solver_results : public testing::Test
{
protected:
  using Numbers = std::vector<std::int64_t>;

  const Soup m_soup = sphere(12, 9);
  const Mesh m_mesh = to_mesh(m_soup);
  const Soup_arrays m_arrays{m_soup};
  const Solver_of m_solver{m_arrays, bound(0.2)};
  const Solver_of m_along_edges{
      m_arrays}; // as functions and solvers choose other graphs with a bound
  const std::vector<Vertex> m_vertices{Vertex(3), Vertex(40), Vertex(71)};
  const std::vector<Solver_point> m_sources{Solver_point::at_vertex(3), Solver_point::at_vertex(40),
                                            Solver_point::at_vertex(71)};
};

TEST_F(Solver_results, tell_of_the_graph)
{
  EXPECT_EQ(m_solver.error_bound(), 0.2);
  EXPECT_EQ(m_along_edges.error_bound(), infinite);
  EXPECT_EQ(Solver_of(m_arrays, bound(0)).error_bound(), 0);
  const std::size_t before = m_solver.memory();
  EXPECT_GT(before, m_arrays.number_of_vertices() * sizeof(double));
  solver_distances(m_solver);
  EXPECT_GT(m_solver.memory(), before); // of the search, which the next one takes up
}

TEST_F(Solver_results, tell_the_nearest_sources)
{
  std::vector<double> all = solver_distances(m_solver, m_sources), each, near(all.size());
  Numbers nearest(all.size()), nearest_of_near(all.size());
  m_solver.find_distances(m_sources, all.data(), nearest.data());
  AG::Solver_search_options options;
  options.maximum_distance = 0.5;
  m_solver.find_distances(m_sources, near.data(), nearest_of_near.data(), nullptr, options);
  std::size_t number_of_near = 0;
  for(std::size_t i = 0; i < m_sources.size(); ++i)
  {
    each = solver_distances(m_solver, {m_sources[i]});
    for(std::size_t v = 0; v < all.size(); ++v)
      if(nearest[v] == static_cast<std::int64_t>(i))
      {
        EXPECT_EQ(each[v], all[v]);
        const bool is_near = all[v] <= 0.5;
        EXPECT_EQ(near[v], is_near ? all[v] : infinite);
        EXPECT_EQ(nearest_of_near[v], is_near ? nearest[v] : -1);
        number_of_near += is_near ? 1 : 0;
      }
  }
  EXPECT_GT(number_of_near, m_sources.size());
  EXPECT_LT(number_of_near, all.size());
}

TEST_F(Solver_results, are_rows_to_targets)
{
  const std::size_t columns = m_sources.size();
  AG::Solver_row_options options;
  options.targets = &m_sources;
  for(const std::size_t threads : {1u, 2u})
  {
    options.number_of_threads = threads;
    std::vector<double> rows(columns * columns);
    m_solver.compute_matrix(rows.data(), m_sources, options);
    for(std::size_t i = 0; i < columns; ++i)
    {
      const std::vector<double> row = solver_distances(m_solver, {m_sources[i]});
      for(std::size_t j = 0; j < columns; ++j)
        EXPECT_EQ(rows[i * columns + j], row[m_vertices[j].idx()]);
    }
  }
}

TEST_F(Solver_results, are_a_voronoi_partition)
{
  Numbers found(m_arrays.number_of_faces()), expected(found.size());
  m_along_edges.find_voronoi_partition(m_sources, found.data());
  AG::voronoi_partition(m_mesh, CGAL::make_property_map(expected), m_vertices);
  EXPECT_EQ(found, expected);
}

TEST_F(Solver_results, are_the_farthest_vertices)
{
  Numbers found;
  const double distance = m_along_edges.find_farthest_vertices(5, m_sources, found);
  std::vector<Vertex> expected;
  EXPECT_EQ(distance,
            AG::farthest_point_sampling(m_mesh, std::back_inserter(expected), 5, m_vertices));
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i], static_cast<std::int64_t>(expected[i].idx()));
}

TEST_F(Solver_results, are_gradients_and_isolines)
{
  const std::vector<double> values = solver_distances(m_solver);
  const auto map = CGAL::make_property_map(values);
  std::vector<double> found(3 * m_arrays.number_of_faces());
  m_solver.find_gradient(values.data(), found.data());
  std::vector<Kernel::Vector_3> expected(m_arrays.number_of_faces());
  AG::gradient(m_mesh, map, CGAL::make_property_map(expected));
  for(std::size_t f = 0; f < expected.size(); ++f)
    for(int i = 0; i < 3; ++i)
      EXPECT_EQ(found[3 * f + static_cast<std::size_t>(i)], expected[f][i]);

  std::vector<std::vector<Point>> polylines;
  AG::isolines(m_mesh, map, 1., std::back_inserter(polylines));
  const auto found_polylines = m_solver.find_isolines(values.data(), 1);
  ASSERT_EQ(found_polylines.size(), polylines.size());
  ASSERT_FALSE(polylines.empty());
  for(std::size_t i = 0; i < polylines.size(); ++i)
  {
    ASSERT_EQ(found_polylines[i].size(), 3 * polylines[i].size());
    for(std::size_t j = 0; j < found_polylines[i].size(); ++j)
      EXPECT_EQ(found_polylines[i][j], polylines[i][j / 3][static_cast<int>(j % 3)]);
  }
}

TEST_F(Solver_results, are_refused_with_what_is_wrong)
{
  std::vector<double> weights(m_arrays.number_of_faces(), 1);
  weights[7] = -2;
  Solver_options options = bound(0.2);
  options.face_weights = weights.data();
  expect_refused("face 7 has weight -2", [&] { Solver_of(m_arrays, options); });
  const std::vector<std::int64_t> barriers{3, 4, 5, 100000};
  options = bound(0.2);
  options.barriers = barriers.data();
  options.number_of_barriers = 2;
  expect_refused("barrier 1 has vertex 100000", [&] { Solver_of(m_arrays, options); });

  Numbers vertices;
  expect_refused("source 0 is not a vertex", [&] {
    m_solver.find_farthest_vertices(1, {Solver_point::in_face(0, {0.2, 0.3, 0.5})}, vertices);
  });
  AG::Solver_row_options rows;
  rows.number_of_threads = 100000;
#ifdef CGAL_LINKED_WITH_TBB
  std::vector<double> distances(m_arrays.number_of_vertices());
  expect_refused("number of threads is 100000",
                 [&] { m_solver.compute_matrix(distances.data(), {m_sources[0]}, rows); });
#endif
}

} // namespace
