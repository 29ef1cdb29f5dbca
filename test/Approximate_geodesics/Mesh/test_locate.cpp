// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/surface_points.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Where points and rays meet a mesh.

namespace {

using namespace geodesics_test;
using Paths = CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh>;
using Tree_traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
using Tree = CGAL::AABB_tree<Tree_traits>;
using Ray = Kernel::Ray_3;

std::size_t number_of_zeros(const Face_location& location)
{
  std::size_t result = 0;
  for(const double weight : location.second)
    result += weight == 0 ? 1 : 0;
  return result;
}

bool is_valid(const Face_location& location)
{
  const auto& [a, b, c] = location.second;
  return a >= 0 && b >= 0 && c >= 0 && std::abs(a + b + c - 1) <= 1e-15;
}

class Locate : public testing::Test
{
protected:
  Locate() : m_paths(m_mesh) { m_paths.build_aabb_tree(m_tree); }

  Face_location nearest(const double x, const double y, const double z) const
  {
    return m_paths.locate(Point(x, y, z), m_tree);
  }

  static Ray down(const double x, const double y)
  {
    return Ray(Point(x, y, 5), Kernel::Direction_3(0, 0, -1));
  }

  void expect_at(const Face_location& found, const Point& p) const
  {
    ASSERT_NE(found.first, Mesh::null_face());
    EXPECT_TRUE(is_valid(found));
    EXPECT_LE(distance_in_space(position(m_mesh, found), p), 1e-9);
  }

  const Mesh m_mesh = to_mesh(flat_grid(5, 5));
  Paths m_paths;
  Tree m_tree;
};

TEST_F(Locate, finds_the_nearest_point)
{
  expect_at(nearest(1.3, 2.4, 0), Point(1.3, 2.4, 0));
  expect_at(nearest(1.3, 2.4, 7), Point(1.3, 2.4, 0));
  expect_at(nearest(-3, 2.25, 1), Point(0, 2.25, 0)); // on a border edge
  expect_at(nearest(9, 9, 9), Point(4, 4, 0));        // at a corner of the mesh
}

TEST_F(Locate, finds_where_a_ray_comes_first)
{
  Mesh two_floors = m_mesh;
  two_floors.join(
      to_mesh(flat_grid(5, 5).transformed([](const Point& p) { return Point(p.x(), p.y(), 2); })));
  const Paths paths(two_floors);
  const Face_location found = paths.locate<Tree_traits>(down(1.3, 2.4));
  ASSERT_NE(found.first, Mesh::null_face());
  EXPECT_LE(distance_in_space(position(two_floors, found), Point(1.3, 2.4, 2)), 1e-12);
  const Ray up(Point(1.3, 2.4, 1), Kernel::Direction_3(0, 0, 1));
  EXPECT_LE(
      distance_in_space(position(two_floors, paths.locate<Tree_traits>(up)), Point(1.3, 2.4, 2)),
      1e-12);
}

TEST_F(Locate, finds_nothing_where_a_ray_misses)
{
  for(const Ray& ray : {down(-1, 2), Ray(Point(1, 1, 5), Kernel::Direction_3(0, 0, 1)),
                        Ray(Point(1, 1, 5), Kernel::Direction_3(1, 0, 0))})
  {
    EXPECT_EQ(m_paths.locate(ray, m_tree).first, Mesh::null_face());
    EXPECT_EQ(m_paths.locate<Tree_traits>(ray).first, Mesh::null_face());
  }
}

// Then it is where it enters the first of them, or starts.
TEST_F(Locate, follows_rays_that_lie_in_the_plane_of_faces)
{
  const Kernel::Direction_3 ahead(1, 0.1, 0);
  expect_at(m_paths.locate(Ray(Point(-1, 0.4, 0), ahead), m_tree), Point(0, 0.5, 0));
  expect_at(m_paths.locate(Ray(Point(1.3, 1.4, 0), ahead), m_tree), Point(1.3, 1.4, 0));
  const Kernel::Direction_3 along_edges(1, 0, 0);
  expect_at(m_paths.locate(Ray(Point(-1, 2, 0), along_edges), m_tree), Point(0, 2, 0));
}

TEST_F(Locate, knows_vertices_and_edges)
{
  for(const Vertex v : m_mesh.vertices())
  {
    const Point& p = m_mesh.point(v);
    EXPECT_EQ(number_of_zeros(nearest(p.x(), p.y(), p.z())), 2u);
    EXPECT_EQ(number_of_zeros(m_paths.locate(down(p.x(), p.y()), m_tree)), 2u);
    EXPECT_EQ(number_of_zeros(nearest(p.x() + 1e-12, p.y() - 1e-12, 1)), 2u);
  }
  EXPECT_EQ(number_of_zeros(nearest(1.4, 2, 0)), 1u);
  EXPECT_EQ(number_of_zeros(nearest(1.4, 1.4, 0)), 1u);
  EXPECT_EQ(number_of_zeros(m_paths.locate(down(2, 0.7), m_tree)), 1u);
  EXPECT_EQ(number_of_zeros(nearest(1.4, 2.2, 0)), 0u);
}

TEST_F(Locate, moves_by_as_much_as_it_is_told)
{
  const Point p(1.3, 2.001, 0);
  EXPECT_EQ(number_of_zeros(m_paths.locate(p, m_tree)), 0u);
  EXPECT_EQ(number_of_zeros(m_paths.locate(p, m_tree, 0.01)), 1u);
  EXPECT_EQ(number_of_zeros(m_paths.locate<Tree_traits>(p, 0.01)), 1u);
  EXPECT_EQ(number_of_zeros(m_paths.locate(p, m_tree, 0.5)), 2u);
  EXPECT_EQ(number_of_zeros(m_paths.locate(down(1.3, 2.001), m_tree, 0.01)), 1u);
  EXPECT_EQ(number_of_zeros(m_paths.locate(Point(1.3, 2 + 1e-12, 0), m_tree, 0)), 0u);
  for(const double all : {1., 10.}) // never all three
    EXPECT_TRUE(is_valid(m_paths.locate(p, m_tree, all)));
}

TEST_F(Locate, needs_no_object)
{
  const auto points = get(CGAL::vertex_point, m_mesh);
  const Point p(1.3, 2.4, 1);
  Tree tree;
  Paths::build_aabb_tree(m_mesh, tree, points);
  for(const Face_location& found :
      {Paths::locate<Tree_traits>(p, m_mesh, points), Paths::locate(p, tree, m_mesh, points),
       Paths::locate<Tree_traits>(down(1.3, 2.4), m_mesh, points),
       Paths::locate(down(1.3, 2.4), tree, m_mesh, points), m_paths.locate<Tree_traits>(p)})
    expect_at(found, Point(1.3, 2.4, 0));
}

TEST(Locate_in_nothing, gives_no_face)
{
  const Mesh empty;
  const Paths paths(empty);
  EXPECT_EQ(paths.locate<Tree_traits>(Point(1, 2, 3)).first, Mesh::null_face());
  const Ray ray(Point(1, 2, 3), Kernel::Direction_3(0, 0, 1));
  EXPECT_EQ(paths.locate<Tree_traits>(ray).first, Mesh::null_face());
}

// A located point is where a path from there starts, and nothing is between a vertex that was
// located and the vertex itself. Distances along the edges of a grid are known.
TEST_F(Locate, gives_what_sources_and_queries_can_be)
{
  for(const Vertex v : m_mesh.vertices())
  {
    m_paths.remove_all_source_points();
    const Point& p = m_mesh.point(v);
    const Face_location location = nearest(p.x(), p.y(), 0.1);
    m_paths.add_source_point(location);
    EXPECT_EQ(m_paths.shortest_distance_to_source_points(v).first, 0);
    EXPECT_EQ(m_paths.shortest_distance_to_source_points(location.first, location.second).first, 0);
    EXPECT_EQ(m_paths.point(location.first, location.second), p);
  }
}

// Vertices of meshes whose coordinates are not round numbers, and points inside faces without area.
TEST(Locate_precisely, on_all_kinds_of_meshes)
{
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const Mesh& mesh = named.mesh;
    Paths paths(mesh);
    Tree tree;
    paths.build_aabb_tree(tree);
    const double tolerance = 1e-9 * size(mesh);
    Random random(7);
    for(int i = 0; i < 40; ++i)
    {
      const Point p = position(mesh, random_face_location(mesh, random));
      const Face_location found = paths.locate(p, tree);
      EXPECT_TRUE(is_valid(found));
      EXPECT_LE(distance_in_space(position(mesh, found), p), tolerance);
      paths.remove_all_source_points();
      paths.add_source_point(found);
      EXPECT_EQ(paths.shortest_distance_to_source_points(found).first, 0);
    }
    for(const Vertex v : mesh.vertices())
      if(!mesh.is_isolated(v))
      {
        EXPECT_LE(
            distance_in_space(position(mesh, paths.locate(mesh.point(v), tree)), mesh.point(v)),
            tolerance);
      }
  }
}

// The height of such a triangle is nothing but noise.
TEST(Locate_precisely, in_flat_triangles)
{
  const Point a(0.1, 0.2, 0.3), b(3.1, 1.7, 0.9);
  const auto between = [&](const double t) { return a + t * (b - a); };
  for(const double part : {0.01, 0.37, 0.5, 0.93})
    for(const double wanted : {0., 0.005, 0.37, 0.81, 1.})
    {
      const Mesh mesh = to_mesh({{a, b, between(part)}, {{0, 1, 2}}});
      const Point p = between(wanted);
      const Face_location found =
          CGAL::Approximate_geodesics::internal::face_location(Face(0), p, mesh, mesh.points(), 0);
      EXPECT_TRUE(is_valid(found));
      EXPECT_LE(distance_in_space(position(mesh, found), p), 1e-14);
    }
}

TEST(Locate_precisely, with_other_points)
{
  using Point_map = Mesh::Property_map<Vertex, Point>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh, Point_map>;
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
  Mesh mesh = to_mesh(flat_grid(3, 3));
  const Point_map shifted = mesh.add_property_map<Vertex, Point>("v:shifted").first;
  for(const Vertex v : mesh.vertices())
    put(shifted, v, mesh.point(v) + Kernel::Vector_3(100, 0, 0));
  const Face_location found = Paths::locate<Traits>(Point(100.5, 0.25, 0), mesh, shifted);
  EXPECT_LE(distance_in_space(position(mesh, found), Point(0.5, 0.25, 0)), 1e-12);
  CGAL::AABB_tree<Traits> tree;
  Paths(mesh).build_aabb_tree(tree, shifted);
  EXPECT_EQ(Paths::locate(Point(100.5, 0.25, 0), tree, mesh, shifted), found);
}

TEST(Locate_precisely, in_faces_without_area)
{
  const Mesh mesh = to_mesh(
      {{Point(0, 0, 0), Point(2, 0, 0), Point(1, 0, 0), Point(1, 3, 0)}, {{0, 2, 1}, {0, 1, 3}}});
  Paths paths(mesh);
  const Face degenerate(0);
  for(const Point& p : {Point(0.5, 0, 0), Point(1, 0, 0), Point(0, 0, 0), Point(1.7, 0, 0)})
  {
    const Face_location nearest = paths.locate<Tree_traits>(p);
    EXPECT_TRUE(is_valid(nearest));
    EXPECT_LE(distance_in_space(position(mesh, nearest), p), 1e-15);
    const Face_location in_face =
        CGAL::Approximate_geodesics::internal::face_location(degenerate, p, mesh, mesh.points(), 0);
    EXPECT_TRUE(is_valid(in_face));
    EXPECT_LE(distance_in_space(position(mesh, in_face), p), 1e-15);
  }
}

} // namespace
