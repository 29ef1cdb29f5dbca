// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_fields.h"
#include "checks/expect_message.h"
#include "meshes/test_mesh_type.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

// Gradients and partitions, and all functions of distances on other meshes.

namespace {

using namespace geodesics_test;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_mesh = CGAL::Surface_mesh<Exact_kernel::Point_3>;

// ----- gradients

TEST(Gradient, of_a_linear_function_is_exact_on_a_grid)
{
  const Mesh mesh = to_mesh(flat_grid(9, 6));
  for(const Vector& expected : {Vector(1, 0, 0), Vector(-3, 0.25, 0), Vector(0, 0, 0)})
  {
    const auto map =
        at_points(mesh, [&](const Point& p) { return expected * (p - CGAL::ORIGIN) + 7; });
    for(const Vector& found : gradients(mesh, map))
      EXPECT_EQ(found, expected);
  }
}

// The part of the slope that is parallel to the face, whatever the unit of the coordinates.
TEST(Gradient, of_a_linear_function_is_its_projection_to_the_faces)
{
  Random random(test_seed());
  const Soup soup = terrain(12, 9, random);
  const Vector slope(2, -1, 3);
  for(const double unit : {1e-250, 1e-90, 1., 1e90, 1e250})
  {
    const Mesh mesh = to_mesh(
        soup.transformed([&](const Point& p) { return CGAL::ORIGIN + unit * (p - CGAL::ORIGIN); }));
    const std::vector<Vector> found = gradients(
        mesh, at_points(mesh, [&](const Point& p) { return slope * (p - CGAL::ORIGIN); }));
    const Mesh original = to_mesh(soup);
    for(const Face f : mesh.faces())
    {
      const auto [a, b, c] = corners(original, f);
      const Vector n = CGAL::normal(original.point(a), original.point(b), original.point(c));
      const Vector expected = slope - (slope * n) / n.squared_length() * n;
      EXPECT_LT((found[f.idx()] - expected).squared_length(), 1e-22);
    }
  }
}

TEST(Gradient, is_zero_where_there_is_none)
{
  Random random(test_seed());
  const Mesh mesh =
      to_mesh(with_caps(flat_grid(6, 4), [] { return 0.5; }).transformed([](const Point& p) {
        return p.y() == 0 ? Point(1, 1, 1) : p; // edges of length zero, too
      }));
  const auto x = [&](const Point& p) { return p.x() > 4 ? infinity : p.x(); };
  const std::vector<Vector> found = gradients(mesh, at_points(mesh, x));
  for(const Face f : mesh.faces())
  {
    const auto [a, b, c] = corners(mesh, f);
    const bool is_reached = (std::max)({x(mesh.point(a)), x(mesh.point(b)), x(mesh.point(c))}) < 5;
    const bool has_area = !CGAL::collinear(mesh.point(a), mesh.point(b), mesh.point(c));
    EXPECT_EQ(found[f.idx()] == CGAL::NULL_VECTOR, !is_reached || !has_area);
  }
  for(const Vector& v : gradients(mesh, at_vertices([](Vertex) { return std::nan(""); })))
    EXPECT_EQ(v, CGAL::NULL_VECTOR);
}

TEST(Gradient, is_zero_where_it_does_not_fit_a_double)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3).transformed(
      [](const Point& p) { return Point(p.x() * 1e-10, p.y() * 1e-10, 0); }));
  for(const double slope : {1e308, 1.7e308})
    for(const Vector& v : gradients(
            mesh, at_points(mesh, [&](const Point& p) { return p.x() > 0 ? slope : -slope; })))
      EXPECT_EQ(v, CGAL::NULL_VECTOR);
}

// With values whose difference is not a `double`, but over faces that are so large.
template <typename MeshKernel>
class Steep_gradient : public testing::Test
{
};
using Kernels = testing::Types<Kernel, Exact_kernel>;
TYPED_TEST_SUITE(Steep_gradient, Kernels, );

TYPED_TEST(Steep_gradient, is_right_if_it_fits_a_double)
{
  using MeshPoint = typename TypeParam::Point_3;
  using Vector_3 = typename TypeParam::Vector_3;
  CGAL::Surface_mesh<MeshPoint> mesh;
  CGAL::make_triangle(MeshPoint(0, 0, 0), MeshPoint(4e10, 0, 0), MeshPoint(0, 4e10, 0), mesh);
  std::vector<double> values = {-1.5e308, 1.5e308, -1.5e308};
  std::vector<Vector_3> result(1);
  AG::gradient(mesh,
               boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh)),
               boost::make_iterator_property_map(result.begin(), get(boost::face_index, mesh)));
  EXPECT_NEAR(CGAL::to_double(result[0].x()) / 7.5e297, 1, 1e-12);
  EXPECT_EQ(result[0].y(), 0);
}

// ----- Voronoi partitions

TEST(Voronoi_partition, divides_a_strip_in_the_middle)
{
  const Mesh mesh = to_mesh(flat_grid(10, 2));
  const std::vector<int> cells = partition(mesh, {Vertex(9), Vertex(0)});
  for(std::size_t i = 0; i < 9; ++i)
  {
    EXPECT_EQ(cells[2 * i], i < 4 ? 1 : 0); // two corners at x = i + 1
    EXPECT_EQ(cells[2 * i + 1], i < 5 ? 1 : 0);
  }
}

// A triangle, and one beside each of its edges, with the source near one of its corners.
TEST(Voronoi_partition, gives_a_face_with_three_sources_to_the_nearest)
{
  const Mesh mesh = to_mesh({{Point(0, 0, 0), Point(10, 0, 0), Point(5, 9, 0), //
                              Point(0, -3, 0), Point(11, 0, 0), Point(5, 11, 0)},
                             {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}}});
  EXPECT_EQ(partition(mesh, {Vertex(3), Vertex(4), Vertex(5)}), std::vector<int>({1, 0, 1, 2}));
}

// The rule, applied to what the function for distances says of the vertices.
TEST(Voronoi_partition, follows_from_the_sources_of_the_corners)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    std::vector<Vertex> sources;
    for(int i = 0; i < 5; ++i)
      sources.push_back(random_vertex(mesh, random));
    const auto np = parameters::epsilon(0.3).maximum_distance(random.between(5, 20));
    std::map<Vertex, double> distance;
    std::map<Vertex, int> expected, source;
    CGAL::approximate_geodesic_distances(
        mesh, boost::make_assoc_property_map(distance), sources,
        np.nearest_source_map(boost::make_assoc_property_map(expected)));
    const std::vector<int> cells =
        partition(mesh, sources, np.nearest_source_map(boost::make_assoc_property_map(source)));
    EXPECT_EQ(source, expected);
    for(const Face f : mesh.faces())
    {
      std::map<int, int> votes;
      for(const Vertex v : corners(mesh, f))
        ++votes[source[v]];
      const int cell = cells[f.idx()];
      ASSERT_EQ(votes.count(cell), 1u);
      EXPECT_TRUE(votes.size() == 3 || votes[cell] > 1);
      for(const Vertex v : corners(mesh, f))
        for(const Vertex w : corners(mesh, f))
          EXPECT_TRUE(votes.size() < 3 || source[v] != cell || distance[v] <= distance[w]);
    }
  }
}

TEST(Voronoi_partition, leaves_out_what_is_not_reached)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  const std::vector<int> cells = partition(mesh, {Vertex(0), Vertex(2)});
  for(const Face f : mesh.faces())
    EXPECT_EQ(cells[f.idx()], corners(mesh, f)[0].idx() < 2 + 12 * 9 ? 1 : -1);
  EXPECT_EQ(partition(mesh, {}), std::vector<int>(mesh.num_faces(), -1));
}

// ----- meshes

// All functions, on a mesh of any type: the results as numbers.
template <typename AnyMesh>
std::vector<double> everything(const AnyMesh& mesh)
{
  using Graph_traits = boost::graph_traits<AnyMesh>;
  std::vector<typename Graph_traits::vertex_descriptor> points;
  const double radius = AG::farthest_point_sampling(mesh, std::back_inserter(points), 6);
  std::map<typename Graph_traits::vertex_descriptor, double> distance;
  std::map<typename Graph_traits::face_descriptor, int> cell;
  std::map<typename Graph_traits::face_descriptor, Vector> gradient;
  const auto distances = boost::make_assoc_property_map(distance);
  CGAL::approximate_geodesic_distances(mesh, distances, points);
  AG::voronoi_partition(mesh, boost::make_assoc_property_map(cell), points);
  AG::gradient(mesh, distances, boost::make_assoc_property_map(gradient));
  std::vector<Polyline> lines;
  AG::isolines(mesh, distances, std::array<float, 2>{0.25, 0.5}, std::back_inserter(lines));

  std::vector<double> result = {radius, double(lines.size()), length(lines)};
  for(const auto v : points)
    result.push_back(get(CGAL::vertex_point, mesh, v).x());
  for(const auto f : faces(mesh))
  {
    result.push_back(cell[f]);
    result.push_back(gradient[f].x());
  }
  return result;
}

TEST(Distance_fields, are_the_same_on_a_polyhedron)
{
  for(const Mesh& mesh : simple_meshes())
  {
    const std::vector<double> expected = everything(mesh);
    const std::vector<double> found = everything(Copied_mesh<Polyhedron>(mesh).mesh);
    ASSERT_EQ(found.size(), expected.size());
    for(std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-12); // corners may come in another order
  }
}

TEST(Distance_fields, need_neither_faces_nor_vertices)
{
  EXPECT_EQ(everything(Mesh()), std::vector<double>(3, 0.));
  EXPECT_EQ(everything(Polyhedron()), std::vector<double>(3, 0.));
  Mesh points;
  for(int i = 0; i < 4; ++i)
    points.add_vertex(Point(i, 0, 0));
  EXPECT_EQ(everything(points), std::vector<double>({0, 0, 0, 0, 1, 2, 3}));
}

TEST(Distance_fields, do_not_mind_removed_elements)
{
  Mesh mesh = to_mesh({{Point(9, 9, 9)}, {}}), original = to_mesh(flat_grid(5, 4));
  mesh += original;
  mesh.remove_vertex(Vertex(0));
  EXPECT_TRUE(have_same_bits(everything(mesh), everything(original)));
}

TEST(Distance_fields, are_exact_with_an_exact_kernel)
{
  using Exact_point = Exact_kernel::Point_3;
  using Exact_vector = Exact_kernel::Vector_3;
  Exact_mesh mesh;
  mesh.add_face(mesh.add_vertex(Exact_point(0, 0, 0)), mesh.add_vertex(Exact_point(3, 0, 0)),
                mesh.add_vertex(Exact_point(0, 7, 1)));
  const auto x = at_vertices([&](const Vertex v) { return CGAL::to_double(mesh.point(v).x()); });
  std::map<Face, Exact_vector> gradient;
  AG::gradient(mesh, x, boost::make_assoc_property_map(gradient));
  EXPECT_EQ(gradient.at(Face(0)), Exact_vector(1, 0, 0));
  std::vector<std::vector<Exact_point>> lines;
  AG::isolines(mesh, x, std::vector<double>{1.5}, std::back_inserter(lines));
  const std::vector<Exact_point> expected = {Exact_point(1.5, 0, 0), Exact_point(1.5, 3.5, 0.5)};
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], expected);
}

TEST(Distance_fields, take_points_from_a_map)
{
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  const auto doubled = boost::make_function_property_map<Vertex>(
      [&](const Vertex v) { return CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN); });
  std::map<Face, Vector> gradient;
  AG::gradient(mesh, x, boost::make_assoc_property_map(gradient),
               parameters::vertex_point_map(doubled).geom_traits(Kernel()));
  EXPECT_EQ(gradient.at(Face(0)), Vector(0.5, 0, 0));
  std::vector<Polyline> lines;
  AG::isolines(mesh, x, std::vector<int>{1}, std::back_inserter(lines),
               parameters::vertex_point_map(doubled).geom_traits(Kernel()));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], Polyline({Point(2, 0, 0), Point(2, 2, 0)}));
}

TEST(Distance_fields, refuse_other_faces_than_triangles)
{
  Mesh mesh;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), mesh);
  const auto x = at_points(mesh, [](const Point& p) { return p.x(); });
  expect_message<std::invalid_argument>([&] { isolines(mesh, x, {0.5}); }, "face 0",
                                        "not a triangle");
  expect_message<std::invalid_argument>([&] { gradients(mesh, x); }, "face 0", "not a triangle");
  expect_message<std::invalid_argument>([&] { partition(mesh, {}); }, "not a triangle");
  expect_message<std::invalid_argument>([&] { sample(mesh, {}, 3); }, "not a triangle");
}

TEST(Distance_fields, refuse_sources_that_are_not_vertices)
{
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  const std::vector<Vertex> wrong = {Vertex(0), Vertex(6)};
  const char* message = "vertex 6 is not in the mesh";
  expect_message<std::invalid_argument>([&] { partition(mesh, wrong); }, message);
  expect_message<std::invalid_argument>([&] { sample(mesh, wrong, 3); }, message);
  expect_message<std::invalid_argument>([&] { sample(mesh, {Mesh::null_vertex()}, 3); },
                                        "the null vertex is not in the mesh");
}

} // namespace
