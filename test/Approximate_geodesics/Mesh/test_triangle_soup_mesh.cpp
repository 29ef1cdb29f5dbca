// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Mesh/Triangle_soup_mesh.h>

#include "checks/expect_message.h"
#include "meshes/random_soups.h"
#include "meshes/sample_meshes.h"
#include "meshes/soup_meshes.h"
#include "meshes/test_mesh_type.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/iterator/transform_iterator.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace geodesics_test;
using CGAL::Approximate_geodesics::Triangle_soup_mesh;
using CGAL::Approximate_geodesics::internal::Paired_sides;

// All kinds of graphs find the same distances, to the last bit, as on a mesh with links.
void expect_same_bits_as_mesh(const Soup& soup, const bool is_short = false)
{
  const Mesh mesh = to_mesh(soup);
  const Soup_mesh arrays = on_arrays(soup);
  const std::size_t source = soup.triangles.empty() ? 0 : soup.triangles.front()[1];
  const auto compare = [&](const auto& np) {
    EXPECT_TRUE(have_same_bits(distances_from_vertex(arrays, source, np),
                               distances_from_vertex(mesh, source, np)));
  };
  compare(CGAL::parameters::default_values());
  compare(CGAL::parameters::epsilon(0.1));
  if(!is_short)
    compare(CGAL::parameters::epsilon(0));
}

TEST(Triangle_soup_mesh, has_the_same_bits_as_a_mesh_with_links)
{
  for(const std::uint64_t seed : seeds_of_small_soups())
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_same_bits_as_mesh(random_small_soup(seed));
  }
}

TEST(Triangle_soup_mesh, has_the_same_bits_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name : {"elephant.off", "eight.off", "mannequin-devil.off"})
  {
    SCOPED_TRACE(name);
    expect_same_bits_as_mesh(soup_of(sample_mesh(name)), name != "eight.off");
  }
}

TEST(Triangle_soup_mesh, is_taken_by_everything_that_takes_a_mesh)
{
  for(const Mesh& original : simple_meshes())
  {
    const Soup soup = soup_of(original);
    const Soup_mesh mesh = on_arrays(soup);
    EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
    const auto all = vertices(mesh);
    expect_same_results(original, mesh,
                        std::vector<Soup_mesh::Vertex_index>(all.begin(), all.end()));
  }
}

// Walks along all links, in both directions.
TEST(Triangle_soup_mesh, has_consistent_links)
{
  for(const std::uint64_t seed : seeds_of_small_soups())
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = random_small_soup(seed);
    const Soup_mesh mesh = on_arrays(soup);
    for(const auto h : halfedges(mesh))
    {
      ASSERT_EQ(opposite(opposite(h, mesh), mesh), h);
      ASSERT_NE(opposite(h, mesh), h);
      ASSERT_EQ(prev(next(h, mesh), mesh), h);
      ASSERT_EQ(next(prev(h, mesh), mesh), h);
      ASSERT_EQ(source(h, mesh), target(opposite(h, mesh), mesh));
      ASSERT_EQ(source(next(h, mesh), mesh), target(h, mesh));
      ASSERT_EQ(edge(h, mesh), edge(opposite(h, mesh), mesh));
      ASSERT_EQ(face(next(h, mesh), mesh), face(h, mesh));
      ASSERT_EQ(halfedge(source(h, mesh), target(h, mesh), mesh), std::make_pair(h, true));
    }
    std::size_t sum_of_degrees = 0;
    for(const auto v : vertices(mesh))
    {
      sum_of_degrees += degree(v, mesh);
      const auto h = halfedge(v, mesh);
      ASSERT_TRUE(h == Soup_mesh::Halfedge_index() || target(h, mesh) == v);
    }
    ASSERT_EQ(sum_of_degrees, num_halfedges(mesh));
    for(std::size_t f = 0; f < num_faces(mesh); ++f)
      for(std::size_t i = 0; i < 3; ++i)
        ASSERT_EQ(source(Soup_mesh::Halfedge_index(3 * f + i), mesh), soup.triangles[f][i]);
  }
}

// Single precision, plain pointers, signed indices, and faces with sizes.
TEST(Triangle_soup_mesh, takes_arrays_of_many_types)
{
  Random random(test_seed());
  const Soup soup = terrain(9, 8, random).transformed([](const Point& p) {
    const auto single = [](const double x) { return static_cast<double>(static_cast<float>(x)); };
    return Point(single(p.x()), single(p.y()), single(p.z()));
  });
  std::vector<std::array<float, 3>> points;
  for(const Point& p : soup.points)
    points.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  std::vector<std::vector<std::int64_t>> triangles;
  for(const auto& t : soup.triangles)
    triangles.push_back({t.begin(), t.end()});
  const auto epsilon = CGAL::parameters::epsilon(0.1);
  const auto expected = distances_from_vertex(to_mesh(soup), 3, epsilon);

  EXPECT_TRUE(have_same_bits(
      distances_from_vertex(Triangle_soup_mesh(points, triangles), 3, epsilon), expected));
  const auto pointers = CGAL::make_range(points.data(), points.data() + points.size());
  const auto faces =
      CGAL::make_range(soup.triangles.data(), soup.triangles.data() + soup.triangles.size());
  EXPECT_TRUE(have_same_bits(distances_from_vertex(Triangle_soup_mesh(pointers, faces), 3, epsilon),
                             expected));
}

// Iterators that make points and triangles from other arrays.
TEST(Triangle_soup_mesh, takes_iterators_that_return_values)
{
  const Soup soup = sphere(7, 6);
  std::vector<double> coordinates;
  std::vector<std::size_t> corners;
  for(const Point& p : soup.points)
    coordinates.insert(coordinates.end(), p.cartesian_begin(), p.cartesian_end());
  for(const auto& t : soup.triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  const auto range = [](const std::size_t size, const auto f) {
    using Counter = boost::counting_iterator<std::size_t>;
    return CGAL::make_range(boost::make_transform_iterator(Counter(0), f),
                            boost::make_transform_iterator(Counter(size), f));
  };
  const double* const c = coordinates.data();
  const std::size_t* const t = corners.data();
  const Triangle_soup_mesh mesh(
      range(soup.points.size(),
            [c](const std::size_t i) { return Point(c[3 * i], c[3 * i + 1], c[3 * i + 2]); }),
      range(soup.triangles.size(), [t](const std::size_t i) {
        return std::array<std::size_t, 3>{t[3 * i], t[3 * i + 1], t[3 * i + 2]};
      }));
  static_assert(std::is_same_v<decltype(mesh.point(mesh.vertex(0))), Point>);
  static_assert(std::is_same_v<decltype(on_arrays(soup).point(mesh.vertex(0))), const Point&>);
  const auto epsilon = CGAL::parameters::epsilon(0.1);
  EXPECT_TRUE(have_same_bits(distances_from_vertex(mesh, 3, epsilon),
                             distances_from_vertex(to_mesh(soup), 3, epsilon)));
}

TEST(Triangle_soup_mesh, does_not_take_vectors_that_end_before_it)
{
  using Points = std::vector<Point>;
  using Triples = std::vector<std::array<std::size_t, 3>>;
  static_assert(std::is_constructible_v<Soup_mesh, const Points&, Triples&>);
  static_assert(!std::is_constructible_v<Soup_mesh, Points, Triples&>);
  static_assert(!std::is_constructible_v<Soup_mesh, Points&, Triples>);
  static_assert(!std::is_constructible_v<Soup_mesh, Points, Triples>);
}

TEST(Triangle_soup_mesh, is_read_by_functions_of_cgal)
{
  for(const std::uint64_t seed : seeds_of_small_soups())
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = random_small_soup(seed);
    const Soup_mesh mesh = on_arrays(soup);
    const Mesh expected = to_mesh(soup);
    EXPECT_EQ(CGAL::is_closed(mesh), CGAL::is_closed(expected));
    EXPECT_EQ(num_edges(mesh), num_edges(expected));
    EXPECT_EQ(edges(mesh).size(), num_edges(mesh));
    for(const auto e : edges(mesh))
      EXPECT_EQ(edge(opposite(halfedge(e, mesh), mesh), mesh), e);
    Mesh copy;
    CGAL::copy_face_graph(mesh, copy);
    EXPECT_TRUE(copy.is_valid());
    EXPECT_EQ(num_edges(copy), num_edges(expected));
    EXPECT_EQ(num_faces(copy), num_faces(expected));
    namespace PMP = CGAL::Polygon_mesh_processing;
    EXPECT_NEAR(PMP::area(mesh), PMP::area(expected), 1e-12 * PMP::area(expected));
    EXPECT_NEAR(PMP::area(copy), PMP::area(expected), 1e-12 * PMP::area(expected));
    std::vector<std::size_t> components(num_faces(mesh));
    const auto number_of_components = [&](const auto& m) {
      return PMP::connected_components(
          m, boost::make_iterator_property_map(components.begin(), get(boost::face_index, m)));
    };
    EXPECT_EQ(number_of_components(mesh), number_of_components(expected));
  }
}

TEST(Triangle_soup_mesh, gives_vertices_by_their_numbers)
{
  const Soup soup = flat_grid(6, 5);
  const Soup_mesh mesh = on_arrays(soup);
  std::vector<double> distances(soup.points.size());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  CGAL::approximate_geodesic_distances(mesh, map, mesh.vertex(7), CGAL::parameters::epsilon(0));
  EXPECT_NEAR(distances[27], std::sqrt(13), 1e-12);
  expect_message<std::invalid_argument>(
      [&] { CGAL::approximate_geodesic_distances(mesh, map, mesh.vertex(30)); }, "vertex 30");
  expect_message<std::invalid_argument>(
      [&] { CGAL::approximate_geodesic_distances(mesh, map, mesh.vertex(std::size_t(-1))); },
      "null vertex");
}

// Graphs for many queries are built from arrays.
TEST(Triangle_soup_mesh, has_graphs)
{
  const Soup soup = sphere(12, 9);
  using CGAL::Approximate_geodesics::Discrete_geodesic_graph;
  const Discrete_geodesic_graph built{Triangulation(on_arrays(soup))},
      expected{Triangulation(to_mesh(soup))};
  EXPECT_EQ(built.number_of_arcs(), expected.number_of_arcs());
  EXPECT_TRUE(built.is_valid());
}

TEST(Triangle_soup_mesh, may_be_empty_or_have_isolated_vertices)
{
  EXPECT_EQ(num_halfedges(on_arrays({})), 0u);
  const Soup points{std::vector<Point>(3, Point(1, 2, 3)), {}};
  EXPECT_EQ(distances_from_vertex(on_arrays(points), 1),
            std::vector<double>({infinity, 0, infinity}));
}

TEST(Triangle_soup_mesh, names_what_is_wrong)
{
  const Soup right = flat_grid(3, 3);
  const auto expect_refused = [](const Soup& soup, const std::vector<std::string>& texts) {
    expect_texts<std::invalid_argument>([&] { on_arrays(soup); }, texts);
  };
  Soup soup = right;
  soup.triangles[2][1] = 9;
  expect_refused(soup, {"face 2 has vertex 9;", "there are 9"});
  soup.triangles[2][1] = std::size_t(-1);
  expect_refused(soup, {"face 2 has vertex"});
  soup = right;
  soup.triangles[4][0] = soup.triangles[4][2];
  expect_refused(soup, {"face 4 has vertex", "twice"});
  soup = right;
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  expect_refused(soup, {"face", "in the same direction"});
  soup = right;
  soup.triangles.push_back(soup.triangles[5]);
  expect_refused(soup, {"face 5 and face 8 have the same vertices"});
  for(std::size_t f = 0; f < right.triangles.size(); ++f) // with neighbors before or after it
  {
    soup = right;
    soup.triangles.push_back(soup.triangles[f]);
    expect_refused(soup, {"face " + std::to_string(f) + " and face 8 have the same vertices"});
  }
  soup = right;
  soup.triangles.push_back({0, 4, 8});
  expect_refused(soup, {"vertices 0 and 4 is not manifold: face 0, face 1 and face 8"});
}

// Whichever end of an edge has the smaller number, and from whichever faces come first.
TEST(Triangle_soup_mesh, names_edges_that_are_not_manifold)
{
  const std::vector<Point> points(6, Point(0, 0, 0));
  const std::vector<std::array<std::size_t, 3>> up{{0, 1, 2}, {0, 1, 3}},
      down{{1, 0, 2}, {1, 0, 3}};
  for(const auto& triangles : {up, down})
    expect_message<std::invalid_argument>(
        [&] { Triangle_soup_mesh(points, triangles); },
        "face 0 and face 1 traverse the edge between vertices 0 and 1 in the same direction");
  for(std::array<std::size_t, 3> third : {std::array<std::size_t, 3>{0, 1, 5}, {1, 0, 5}})
    for(auto triangles : {up, down})
    {
      triangles.push_back(third);
      expect_message<std::invalid_argument>(
          [&] { Triangle_soup_mesh(points, triangles); },
          "the edge between vertices 0 and 1 is not manifold: face 0, face 1 and face 2 share it");
    }
}

TEST(Triangle_soup_mesh, names_vertices_that_are_not_manifold)
{
  using Triples = std::vector<std::array<std::size_t, 3>>;
  const std::vector<Point> points(9, Point(0, 0, 0));
  const Triples two_corners{{4, 1, 2}, {3, 4, 5}};
  const Triples closed{{4, 0, 1}, {4, 1, 2}, {4, 2, 0}, {4, 5, 6}, {4, 6, 7}, {4, 7, 5}};
  const Triples closed_and_open{{4, 5, 6}, {4, 0, 1}, {4, 1, 2}, {4, 2, 0}};
  for(const Triples& triangles : {two_corners, closed, closed_and_open})
    expect_message<std::invalid_argument>([&] { Triangle_soup_mesh(points, triangles); },
                                          "vertex 4 is not manifold");
}

TEST(Triangle_soup_mesh, names_faces_that_are_not_triangles)
{
  const std::vector<Point> points(4, Point(0, 0, 0));
  const std::vector<std::vector<int>> faces{{0, 1, 2}, {2, 1, 0, 3}};
  expect_message<std::invalid_argument>([&] { Triangle_soup_mesh(points, faces); },
                                        "face 1 has 4 vertices");
}

TEST(Triangle_soup_mesh, refuses_coordinates_that_are_not_finite)
{
  Soup soup = flat_grid(3, 3);
  soup.points[4] = Point(0, infinity, 0);
  expect_message<std::invalid_argument>([&] { distances_from_vertex(on_arrays(soup), 0); },
                                        "vertex 4", "infinite or not a number");
}

// Halfedges of 10^8 vertices need all 32 bits. Sizes are checked before anything is read.
TEST(Triangle_soup_mesh, has_numbers_of_32_bits)
{
  const auto corners = [](std::size_t) { return std::array<int, 3>{0, 1, 2}; };
  for(const std::size_t number_of_faces : {std::size_t(800'000'000), std::size_t(1) << 40})
    EXPECT_THROW(Paired_sides(3, number_of_faces, corners), std::length_error);
  EXPECT_THROW(Paired_sides(0xffffffff, 1, corners), std::length_error);
  EXPECT_EQ(Paired_sides::side_after(4294967292), 4294967293);
  EXPECT_EQ(Paired_sides::side_after(4294967294), 4294967292);
  EXPECT_EQ(Paired_sides::side_before(4294967292), 4294967294);
  EXPECT_EQ(Soup_mesh::Halfedge_index(std::size_t(4294967294)), 4294967294u);
  EXPECT_EQ(Soup_mesh::Vertex_index(std::size_t(1) << 32), Soup_mesh::Vertex_index());
}

} // namespace
