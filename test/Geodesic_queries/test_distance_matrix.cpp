// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

// Distance matrices are, row by row, what single searches find.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

std::vector<Mesh> small_meshes()
{
  std::vector<Mesh> result{Mesh(), to_mesh(Soup{std::vector<Point>(3, Point(1, 1, 1)), {}})};
  const std::uint64_t first = test_seed();
  for(std::uint64_t i = 0; i < number_of_kinds_of_soups; ++i)
    result.push_back(to_mesh(random_small_soup(first + i)));
  return result;
}

// ----- graphs

// Straight lines between points that are not nodes are found from the other end.
template <typename Kind, typename GeodesicGraph>
void expect_rows_of_searches(const Kind& kind,
                             const GeodesicGraph& graph,
                             const Mesh& mesh,
                             const std::vector<Surface_point>& points)
{
  const auto sources = intrinsic_points(mesh, graph.triangulation(), points);
  const auto vertices = intrinsic_points(mesh, graph.triangulation(), all_vertices(mesh));
  auto both = vertices;
  both.insert(both.begin() + static_cast<std::ptrdiff_t>(both.size() / 2), sources.begin(),
              sources.end());
  EXPECT_TRUE(are_the_same(dense_matrix(graph, sources), //
                           matrix_by_searches(graph, sources, vertices)));
  EXPECT_TRUE(are_the_same(dense_matrix(graph, vertices, parameters::targets(both)),
                           matrix_by_searches(graph, vertices, both)));
  EXPECT_TRUE(are_about_the_same(dense_matrix(graph, sources, parameters::targets(both)),
                                 matrix_by_searches(graph, sources, both), kind.asymmetry,
                                 size(mesh)));
}

TEST(Distance_matrix, has_the_rows_that_searches_find_in_every_graph)
{
  Random random(test_seed());
  for(const Mesh& mesh : small_meshes())
  {
    std::vector<Surface_point> points = some_vertices(mesh);
    if(mesh.number_of_faces() > 0)
      for(const Surface_point& p : random_surface_points(mesh, 5, random))
        points.push_back(p);
    for_each_small_graph(0.5, [&](const auto& kind) {
      expect_rows_of_searches(kind, kind.make(Triangulation(mesh)), mesh, points);
    });
  }
}

TEST(Distance_matrix, heeds_weights_and_barriers_of_a_graph)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(6, 5));
  const Weights weights = random_weights(mesh, random, 0.5, 2, 0.05);
  const Barriers barriers = random_barriers(mesh, 0.2, random);
  const Triangulation triangulation(
      mesh, with_weights(weights).edge_is_constrained_map(barrier_map(barriers)));
  const std::vector<Surface_point> points = random_surface_points(mesh, 12, random);
  const auto expect = [&](const auto& kind) {
    expect_rows_of_searches(kind, kind.make(triangulation), mesh, points);
  };
  expect(graph_with_spaced_points(2));
  expect(graph_with_points("geometric points", Geometric_points(1.), 1));
}

TEST(Distance_matrix, takes_indices_of_vertices_for_points_of_a_graph)
{
  const Mesh mesh = with_removed_elements(); // so that indices have gaps
  const Graph graph{Triangulation(mesh)};
  const std::vector<int> indices{29, 2, 2, 17};
  std::vector<unsigned char> small_indices(indices.begin(), indices.end());
  std::vector<Vertex> sources(indices.begin(), indices.end());
  EXPECT_TRUE(are_the_same(dense_matrix(graph, indices), dense_matrix(mesh, sources)));
  EXPECT_TRUE(are_the_same(dense_matrix(graph, small_indices, parameters::targets(indices)),
                           dense_matrix(mesh, sources, parameters::targets(sources))));
}

// ----- meshes

class Matrix_of_a_mesh : public testing::Test
{
protected:
  // A row by the class with the same named parameters, but for `targets`. Straight lines between
  // points that are not nodes are found from the other end.
  template <typename GeodesicGraph, typename Class_parameters, typename Named_parameters>
  void expect_rows_of_class(const Class_parameters& of_class,
                            const Named_parameters& np,
                            const double deviation_of_lines = 1e-12)
  {
    const Matrix expected =
        rows_of(AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph>(m_mesh, of_class));
    Matrix found = dense_matrix(m_mesh, m_points, np);
    EXPECT_TRUE(are_about_the_same(found, expected, deviation_of_lines, size(m_mesh)));
    for(std::size_t i = 0; i < m_points.size(); ++i)
      for(std::size_t j = 0; j < m_points.size(); ++j)
        if(m_points[i].index() > 0 && m_points[j].index() > 0) // neither of them is a vertex
          found[i][j] = expected[i][j];
    EXPECT_TRUE(are_the_same(found, expected));
  }

  template <typename Paths>
  Matrix rows_of(Paths paths) const
  {
    Matrix result;
    for(const Surface_point& source : m_points)
    {
      paths.remove_all_source_points();
      paths.add_source_point(source);
      result.emplace_back();
      for(const Surface_point& target : m_points)
      {
        const double d = paths.shortest_distance_to_source_points(target).first;
        result.back().push_back(d < 0 ? infinity : d);
      }
    }
    return result;
  }

  std::vector<Surface_point> points()
  {
    std::vector<Surface_point> result = all_vertices(m_mesh);
    for(const Surface_point& p : random_surface_points(m_mesh, 20, m_random))
      result.push_back(p);
    m_random.shuffle(result);
    return result;
  }

  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(with_holes(terrain(9, 8, m_random), 0.2, m_random));
  const std::vector<Surface_point> m_points = points();
};

TEST_F(Matrix_of_a_mesh, is_that_of_the_class)
{
  const auto np = parameters::targets(m_points);
  expect_rows_of_class<AG::Edge_graph>(parameters::default_values(), np);
  expect_rows_of_class<Discrete_geodesic_graph>(parameters::epsilon(0.1), np.epsilon(0.1), 0.1);
  expect_rows_of_class<Saddle_vertex_graph>(parameters::epsilon(0), np.epsilon(0));
  expect_rows_of_class<Steiner_graph<Fixed_number_of_points>>(
      parameters::number_of_points_per_edge(2), np.number_of_points_per_edge(2));
}

TEST_F(Matrix_of_a_mesh, is_that_of_the_class_with_maps)
{
  const auto np = parameters::targets(m_points);
  const Weights weights = random_weights(m_mesh, m_random, 0.2, 5);
  const Barriers barriers = random_barriers(m_mesh, 0.3, m_random);
  std::vector<double> lengths(m_mesh.number_of_edges());
  for(double& length : lengths)
    length = m_random.between(1, 2);
  const auto length_map =
      boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, m_mesh));
  expect_rows_of_class<Steiner_graph<>>(with_weights(weights).epsilon(0.5),
                                        np.face_weight_map(weight_map(weights)).epsilon(0.5));
  expect_rows_of_class<Steiner_graph<Fixed_number_of_points>>(
      with_barriers(barriers).number_of_points_per_edge(1),
      np.edge_is_constrained_map(barrier_map(barriers)).number_of_points_per_edge(1));
  expect_rows_of_class<AG::Edge_graph>(parameters::edge_length_map(length_map),
                                       np.edge_length_map(length_map));
}

// Between points of all kinds.
TEST_F(Matrix_of_a_mesh, holds_the_bound)
{
  const auto np = parameters::targets(m_points);
  const Matrix exact = dense_matrix(m_mesh, m_points, np.epsilon(0)),
               found = dense_matrix(m_mesh, m_points, np.epsilon(0.3));
  const double rounding = 1e-12 * size(m_mesh);
  for(std::size_t i = 0; i < m_points.size(); ++i)
    for(std::size_t j = 0; j < m_points.size(); ++j)
    {
      EXPECT_GE(found[i][j], exact[i][j] * (1 - single_precision) - rounding);
      EXPECT_LE(found[i][j], exact[i][j] * 1.3 + rounding);
    }
}

// Points are those of the mesh, whatever its indices are.
TEST_F(Matrix_of_a_mesh, does_not_depend_on_indices)
{
  const Matrix expected = dense_matrix(m_mesh, m_points);
  const int vertices = static_cast<int>(m_mesh.num_vertices());
  const int halfedges = static_cast<int>(m_mesh.num_halfedges());
  const auto backward = boost::make_function_property_map<Vertex>(
      [=](const Vertex v) { return vertices - 1 - static_cast<int>(v.idx()); });
  const auto halfedges_backward = boost::make_function_property_map<Halfedge>(
      [=](const Halfedge h) { return halfedges - 1 - static_cast<int>(h.idx()); });
  EXPECT_EQ(
      dense_matrix(m_mesh, m_points,
                   parameters::vertex_index_map(backward).halfedge_index_map(halfedges_backward)),
      expected);
}

TEST_F(Matrix_of_a_mesh, may_have_one_source_that_is_no_range)
{
  const auto expected = [&](const Surface_point& p) {
    return dense_matrix(m_mesh, std::vector<Surface_point>{p});
  };
  const Face_location location = random_face_location(m_mesh, m_random);
  EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, Vertex(7)), expected(Vertex(7))));
  EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, location), expected(location)));
  EXPECT_TRUE(are_the_same(dense_matrix(m_mesh, m_points[3]), expected(m_points[3])));
}

TEST_F(Matrix_of_a_mesh, may_have_numbers_in_single_precision)
{
  Dense_rows<float> rows;
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, m_points));
  Matrix expected = dense_matrix(m_mesh, m_points);
  for(auto& row : expected)
    for(double& distance : row)
      distance = double(static_cast<float>(distance));
  EXPECT_TRUE(are_the_same(matrix_of(rows), expected));
}

TEST_F(Matrix_of_a_mesh, has_nothing_without_rows_or_columns)
{
  const std::vector<Vertex> none;
  Dense_rows<> rows;
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, none));
  EXPECT_EQ(rows.number_of_rows(), 0u);
  EXPECT_EQ(rows.number_of_columns(), m_mesh.number_of_vertices());
  ASSERT_TRUE(CGAL::approximate_geodesic_distance_matrix(m_mesh, rows, m_points,
                                                         parameters::targets(none)));
  EXPECT_EQ(rows.number_of_rows(), m_points.size());
  EXPECT_EQ(rows.number_of_columns(), 0u);
}

// ----- other mesh types

TEST_F(Matrix_of_a_mesh, is_the_same_for_a_polyhedron)
{
  const Mesh mesh = to_mesh(terrain(7, 6, m_random));
  CGAL::Polyhedron_3<Kernel> copy; // without indices
  std::map<Vertex, boost::graph_traits<CGAL::Polyhedron_3<Kernel>>::vertex_descriptor> vertices;
  CGAL::copy_face_graph(mesh, copy,
                        parameters::vertex_to_vertex_map(boost::make_assoc_property_map(vertices)));
  std::vector<boost::graph_traits<CGAL::Polyhedron_3<Kernel>>::vertex_descriptor> copies;
  for(const Vertex v : mesh.vertices())
    copies.push_back(vertices.at(v));
  EXPECT_TRUE(are_the_same(dense_matrix(copy, copies, parameters::targets(copies)),
                           dense_matrix(mesh, vertices_of(mesh))));
}

TEST_F(Matrix_of_a_mesh, is_the_same_for_a_part_of_a_mesh)
{
  std::vector<Face> faces;
  for(const Face f : m_mesh.faces())
    if(f.idx() % 5 > 0 && f.idx() > 10)
      faces.push_back(f);
  CGAL::Face_filtered_graph<Mesh> part(m_mesh, faces);
  Mesh copy;
  std::map<Vertex, Vertex> copies;
  CGAL::copy_face_graph(part, copy,
                        parameters::vertex_to_vertex_map(boost::make_assoc_property_map(copies)));
  ASSERT_LT(copies.size(), m_mesh.number_of_vertices());
  std::vector<Vertex> sources, sources_of_copy;
  for(const Vertex v : vertices(part))
  {
    sources.push_back(v);
    sources_of_copy.push_back(copies.at(v));
  }
  EXPECT_TRUE(
      are_the_same(dense_matrix(part, sources),
                   dense_matrix(copy, sources_of_copy, parameters::targets(sources_of_copy))));
}

// ----- closed forms

// All diagonals go the same way, so that paths along edges are as long as in a lattice of
// triangles.
TEST(Known_matrix, along_the_edges_of_a_grid)
{
  const Mesh mesh = to_mesh(flat_grid(7, 6));
  const Matrix found = dense_matrix(mesh, vertices_of(mesh));
  for(const Vertex v : mesh.vertices())
    for(const Vertex w : mesh.vertices())
    {
      const Kernel::Vector_3 step(mesh.point(v), mesh.point(w));
      const double x = std::abs(step.x()), y = std::abs(step.y());
      const double diagonal = step.x() * step.y() > 0 ? (std::min)(x, y) : 0;
      EXPECT_NEAR(found[v][w], x + y - (2 - std::sqrt(2.)) * diagonal, 1e-12) << v << ' ' << w;
    }
}

TEST(Known_matrix, in_the_plane)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(6, 5));
  std::vector<Surface_point> points = all_vertices(mesh);
  for(const Surface_point& p : random_surface_points(mesh, 20, random))
    points.push_back(p);
  const auto np = parameters::targets(points);
  const Matrix exact = dense_matrix(mesh, points, np.epsilon(0)),
               bounded = dense_matrix(mesh, points, np.epsilon(0.05));
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = 0; j < points.size(); ++j)
    {
      const double straight =
          std::sqrt(CGAL::squared_distance(position(mesh, points[i]), position(mesh, points[j])));
      EXPECT_NEAR(exact[i][j], straight,
                  1e-12 * (1 + straight)); // some points are next to vertices
      EXPECT_GE(bounded[i][j], straight * (1 - single_precision) - 1e-12);
      EXPECT_LE(bounded[i][j], straight * 1.05 + 1e-12);
    }
}

// From a corner to the center of the face opposite of it.
TEST(Known_matrix, of_a_regular_tetrahedron)
{
  const Mesh mesh = to_mesh({{Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)},
                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}});
  const double side = std::sqrt(8.), height = std::sqrt(6.);
  std::vector<Face_location> centers;
  for(const Face f : mesh.faces())
    centers.push_back({f, {1. / 3, 1. / 3, 1. / 3}});
  const Matrix to_corners = dense_matrix(mesh, vertices_of(mesh), parameters::epsilon(0));
  const Matrix to_centers =
      dense_matrix(mesh, vertices_of(mesh), parameters::epsilon(0).targets(centers));
  for(std::size_t i = 0; i < 4; ++i)
    for(std::size_t j = 0; j < 4; ++j)
      EXPECT_NEAR(to_corners[i][j], i == j ? 0 : side, 1e-12);
  for(const Vertex v : mesh.vertices())
    for(std::size_t j = 0; j < 4; ++j)
      EXPECT_NEAR(to_centers[v][j],
                  height * (faces_of(mesh, v).count(centers[j].first) > 0 ? 2. / 3 : 4. / 3),
                  1e-12);
}

} // namespace
