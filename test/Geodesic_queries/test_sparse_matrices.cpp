// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/test_weights.h"

#include <CGAL/approximate_geodesic_distance_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Rows that keep some distances only, and matrices that are the same in both directions: all is
// compared to the dense matrix, to the last bit.

namespace {

namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// Radii between which entries come and go, and those of some entries.
std::vector<double> radii(const Matrix& matrix)
{
  std::vector<double> distances;
  for(const auto& row : matrix)
    for(const double distance : row)
      if(distance < infinity)
        distances.push_back(distance);
  std::sort(distances.begin(), distances.end());
  if(distances.empty())
    return {1};
  const double middle = distances[distances.size() / 2];
  return {0,
          distances[distances.size() / 10],
          middle,
          std::nextafter(middle, 0.),
          distances.back(),
          infinity};
}

// Where arcs depend on labels, how far a search goes decides which paths it finds, by as much as
// the bound.
testing::AssertionResult are_about_the_same(const Entries& entries,
                                            const Matrix& dense,
                                            const double radius,
                                            const double epsilon)
{
  const double factor = (1 + epsilon) * (1 + 1e-12);
  for(std::size_t row = 0; row < dense.size(); ++row)
  {
    std::vector<bool> has_entry(dense[row].size());
    for(const auto& [distance, column] : entries[row])
    {
      const double other = dense[row][column];
      has_entry[column] = true;
      if(!(distance <= radius && distance <= factor * other && other <= factor * distance))
        return testing::AssertionFailure()
               << "row " << row << ", column " << column << ": " << distance << " and " << other;
    }
    for(std::size_t column = 0; column < has_entry.size(); ++column)
      if(factor * dense[row][column] < radius && !has_entry[column])
        return testing::AssertionFailure() << "row " << row << " lacks column " << column;
  }
  return testing::AssertionSuccess();
}

// ----- graphs

class Sparse_matrix_of_graph
{
public:
  template <typename GeodesicGraph>
  static void expect_entries_of_dense_matrix(const GeodesicGraph& graph,
                                             const std::vector<Intrinsic_point>& sources,
                                             const std::vector<Intrinsic_point>& targets)
  {
    const auto np = parameters::targets(targets);
    const Matrix dense = dense_matrix(graph, sources, np);
    for(const double radius : radii(dense))
    {
      SCOPED_TRACE(testing::Message() << "radius " << radius);
      const Entries expected = within(radius, dense);
      EXPECT_TRUE(
          are_the_same(radius_entries(graph, sources, np.maximum_distance(radius)), expected));
      EXPECT_TRUE(are_the_same(nearest_entries(5, graph, sources, np.maximum_distance(radius)),
                               nearest_of(5, expected)));
    }
    for(const std::size_t number : {std::size_t(1), targets.size() / 2 + 1, targets.size() + 9})
    {
      SCOPED_TRACE(testing::Message() << number << " nearest");
      EXPECT_TRUE(are_the_same(nearest_entries(number, graph, sources, np),
                               nearest_of(number, within(infinity, dense))));
    }
  }

  template <typename GeodesicGraph>
  static void expect_entries_within_bound(const GeodesicGraph& graph,
                                          const std::vector<Intrinsic_point>& points,
                                          const double epsilon)
  {
    const auto np = parameters::targets(points);
    const Matrix dense = dense_matrix(graph, points, np);
    for(const double radius : radii(dense))
      EXPECT_TRUE(are_about_the_same(radius_entries(graph, points, np.maximum_distance(radius)),
                                     dense, radius, epsilon));
  }

  // to all vertices, to some of them twice, to points, and to both
  template <typename GeodesicGraph>
  static void expect_all(const GeodesicGraph& graph,
                         const Mesh& mesh,
                         const std::vector<Surface_point>& points,
                         Random& random)
  {
    const auto sources = intrinsic_points(mesh, graph.triangulation(), points);
    auto vertices = intrinsic_points(mesh, graph.triangulation(), all_vertices(mesh));
    expect_entries_of_dense_matrix(graph, sources, vertices);
    auto both = vertices;
    both.insert(both.end(), sources.begin(), sources.end());
    random.shuffle(both);
    expect_entries_of_dense_matrix(graph, sources, both);
    random.shuffle(vertices);
    vertices.resize((vertices.size() + 2) / 3);
    vertices.insert(vertices.end(), vertices.begin(), vertices.begin() + vertices.size() / 2);
    expect_entries_of_dense_matrix(graph, sources, vertices);
    expect_entries_of_dense_matrix(graph, sources, sources);
  }
};

// Exact distances that differ by less than their rounding may be found in another order.
void expect_in_every_graph(const Mesh& mesh, Random& random, const bool has_close_distances)
{
  std::vector<Surface_point> points = some_vertices(mesh);
  if(mesh.number_of_faces() > 0)
    for(const Surface_point& p : random_surface_points(mesh, 3, random))
      points.push_back(p);
  for_each_small_graph(0.5, [&](const auto& kind) {
    using GeodesicGraph = typename std::decay_t<decltype(kind)>::Graph;
    if(kind.deviation == kind.epsilon) // as much as there may be
    {
      const GeodesicGraph graph = kind.make(Triangulation(mesh));
      Sparse_matrix_of_graph::expect_entries_within_bound(
          graph, intrinsic_points(mesh, graph.triangulation(), points), kind.epsilon);
    }
    else if(!has_close_distances || !std::is_same_v<GeodesicGraph, Saddle_vertex_graph>)
      Sparse_matrix_of_graph::expect_all(kind.make(Triangulation(mesh)), mesh, points, random);
  });
}

TEST(Sparse_matrix, has_entries_of_the_dense_one_on_generated_meshes)
{
  const std::uint64_t first = test_seed();
  for(std::uint64_t i = 0; i < number_of_kinds_of_soups; ++i)
  {
    SCOPED_TRACE(testing::Message() << "seed " << first + i);
    Random random(first + i);
    expect_in_every_graph(to_mesh(random_small_soup(first + i)), random, false);
  }
}

TEST(Sparse_matrix, has_entries_of_the_dense_one_on_hostile_meshes)
{
  Random random(test_seed());
  for(const Hostile_mesh& row : accepted_meshes())
    if(row.refusal_across_faces.empty() && row.mesh.number_of_vertices() < 100 &&
       !(size(row.mesh) < 1e-300)) // radii are rounded there as all numbers are
    {
      SCOPED_TRACE(row.name);
      expect_in_every_graph(row.mesh, random, true);
    }
}

// ----- meshes

class Sparse_matrix_of_mesh : public testing::Test
{
protected:
  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(scattered_parts(m_random));
  const std::vector<Vertex> m_vertices = vertices_of(m_mesh);
};

TEST_F(Sparse_matrix_of_mesh, has_parts_that_reach_each_other_only)
{
  const Matrix dense = dense_matrix(m_mesh, m_vertices, parameters::epsilon(0.1));
  const Entries all = radius_entries(m_mesh, m_vertices, parameters::epsilon(0.1));
  EXPECT_EQ(all, within(infinity, dense));
  EXPECT_EQ(all.front(), std::vector<Entry>({{0, 0}})); // an isolated vertex
  EXPECT_EQ(all.back(), std::vector<Entry>({{0, m_vertices.size() - 1}}));
  EXPECT_TRUE(are_the_same(nearest_entries(20, m_mesh, m_vertices, parameters::epsilon(0.1)),
                           nearest_of(20, all)));
}

TEST_F(Sparse_matrix_of_mesh, may_have_numbers_in_single_precision)
{
  Radius_rows<float> within_radius;
  Nearest_rows<float> nearest(4);
  const auto np = parameters::maximum_distance(2.5);
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, within_radius, m_vertices, np));
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, nearest, m_vertices, np));
  Entries expected = radius_entries(m_mesh, m_vertices, np);
  Entries expected_nearest = nearest_of(4, expected); // before they are rounded
  for(Entries* const entries : {&expected, &expected_nearest})
    for(auto& row : *entries)
      for(Entry& entry : row)
        entry.first = double(static_cast<float>(entry.first));
  EXPECT_TRUE(are_the_same(entries_of(within_radius), expected));
  EXPECT_TRUE(are_the_same(entries_of(nearest), expected_nearest));
}

// Of equally far columns, the first ones are kept, wherever the search finds them first.
TEST_F(Sparse_matrix_of_mesh, keeps_the_first_of_equally_far_columns)
{
  const Mesh grid = to_mesh(flat_grid(9, 9));
  std::vector<Vertex> targets = vertices_of(grid);
  for(int i = 0; i < 5; ++i)
  {
    const auto np = parameters::targets(targets);
    const Entries all = within(infinity, dense_matrix(grid, vertices_of(grid), np));
    for(const std::size_t number : {2u, 4u, 8u, 30u})
      EXPECT_TRUE(are_the_same(nearest_entries(number, grid, vertices_of(grid), np),
                               nearest_of(number, all)));
    m_random.shuffle(targets);
  }
  const Vertex center(40);
  const std::vector<Entry> expected{{0, 40}, {1, 31}, {1, 39}, {1, 41}};
  EXPECT_EQ(nearest_entries(4, grid, center).front(), expected);
}

TEST_F(Sparse_matrix_of_mesh, can_be_computed_into_the_same_sink_again)
{
  Radius_rows<> rows;
  for(const double radius : {3., 0.5, 2.})
  {
    ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, m_vertices,
                                                           parameters::maximum_distance(radius)));
    EXPECT_TRUE(are_the_same(entries_of(rows), within(radius, dense_matrix(m_mesh, m_vertices))));
  }
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, std::vector<Vertex>()));
  EXPECT_EQ(rows.number_of_rows(), 0u);
  EXPECT_EQ(rows.number_of_entries(), 0u);
  EXPECT_EQ(rows.number_of_columns(), m_vertices.size());
}

// A single column in a face does not hide those at vertices, which are many.
TEST_F(Sparse_matrix_of_mesh, has_columns_at_vertices_beside_one_in_a_face)
{
  std::vector<Surface_point> targets = all_vertices(m_mesh);
  targets.insert(targets.begin() + 50, Face_location(Face(3), {0.2, 0.3, 0.5}));
  const auto np = parameters::targets(targets);
  const Entries expected = within(infinity, dense_matrix(m_mesh, m_vertices, np));
  EXPECT_TRUE(are_the_same(radius_entries(m_mesh, m_vertices, np), expected));
  EXPECT_TRUE(are_the_same(nearest_entries(9, m_mesh, m_vertices, np), nearest_of(9, expected)));
}

// ----- both directions

class Symmetric_matrix : public testing::Test
{
protected:
  Symmetric_matrix()
  {
    m_points = all_vertices(m_mesh);
    for(const Surface_point& p : random_surface_points(m_mesh, 30, m_random))
      m_points.push_back(p);
    m_random.shuffle(m_points); // more than a block of the square
  }

  auto np() const { return parameters::targets(m_points).epsilon(1.); }

  // Where a distance is shorter in one direction than in the other one.
  static std::pair<std::size_t, std::size_t> shorter_direction(const Matrix& matrix)
  {
    for(std::size_t i = 0; i < matrix.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(matrix[i][j] < matrix[j][i])
          return {i, j};
    return {0, 0};
  }

  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(with_holes(terrain(14, 10, m_random), 0.3, m_random));
  std::vector<Surface_point> m_points;
};

TEST_F(Symmetric_matrix, has_the_shorter_one_of_both_distances)
{
  const Matrix dense = dense_matrix(m_mesh, m_points, np());
  const Matrix expected = smaller_of_both_directions(dense);
  ASSERT_NE(dense, expected);
  EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, m_points, np().symmetric(true)), expected));
  EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, m_points, np().symmetric(false)), dense));
  EXPECT_TRUE(are_the_same(radius_entries(m_mesh, m_points, np().symmetric(true)),
                           within(infinity, expected)));
  EXPECT_TRUE(are_the_same(radius_entries(m_mesh, m_points, np().symmetric(false)),
                           within(infinity, dense)));
}

// A distance that is too long in one direction, and not in the other one.
TEST_F(Symmetric_matrix, has_entries_that_one_direction_has)
{
  const Matrix dense = dense_matrix(m_mesh, m_points, np());
  const auto [i, j] = shorter_direction(dense);
  ASSERT_NE(i, j);
  const double radius = dense[i][j];
  const auto within_radius = np().maximum_distance(radius);
  const Matrix expected = smaller_of_both_directions(dense);
  EXPECT_NE(within(radius, dense), within(radius, expected));
  EXPECT_TRUE(are_the_same(radius_entries(m_mesh, m_points, within_radius), within(radius, dense)));
  EXPECT_TRUE(are_the_same(radius_entries(m_mesh, m_points, within_radius.symmetric(true)),
                           within(radius, expected)));
  Matrix limited = expected;
  for(auto& row : limited)
    for(double& distance : row)
      distance = distance <= radius ? distance : infinity;
  EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, m_points, within_radius.symmetric(true)), limited));
}

TEST_F(Symmetric_matrix, may_have_all_vertices_for_columns)
{
  const auto bounded = parameters::epsilon(1.);
  EXPECT_TRUE(
      are_the_same(dense_matrix(m_mesh, vertices_of(m_mesh), bounded.symmetric(true)),
                   smaller_of_both_directions(dense_matrix(m_mesh, vertices_of(m_mesh), bounded))));
  const Graph graph{Triangulation(m_mesh)};
  std::vector<std::size_t> indices;
  for(const Vertex v : m_mesh.vertices())
    indices.push_back(v.idx());
  EXPECT_TRUE(are_the_same(dense_matrix(graph, indices, parameters::symmetric(true)),
                           smaller_of_both_directions(dense_matrix(graph, indices))));
}

TEST_F(Symmetric_matrix, may_have_numbers_in_single_precision)
{
  Dense_rows<float> dense;
  Radius_rows<float> sparse;
  const auto np = this->np().symmetric(true).maximum_distance(4);
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, dense, m_points, np));
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, sparse, m_points, np));
  EXPECT_TRUE(are_the_same(entries_of(sparse), within(4, matrix_of(dense))));
  EXPECT_TRUE(are_the_same(matrix_of(dense), smaller_of_both_directions(matrix_of(dense))));
}

} // namespace
