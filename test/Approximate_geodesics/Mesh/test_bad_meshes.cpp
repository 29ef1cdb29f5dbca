// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

// What the constructor of a triangulation refuses.

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

template <typename... Texts>
void expect_rejection(const Mesh& mesh, const Texts&... texts)
{
  expect_message<std::invalid_argument>([&] { Triangulation{mesh}; }, texts...);
}

TEST(Bad_mesh, face_that_is_no_triangle)
{
  Mesh mesh = quiet_mesh();
  const Vertex a = mesh.add_vertex(Point(9, 9, 0)), b = mesh.add_vertex(Point(10, 9, 0)),
               c = mesh.add_vertex(Point(10, 10, 0)), d = mesh.add_vertex(Point(9, 10, 0));
  ASSERT_NE(mesh.add_face(a, b, c, d), Mesh::null_face());
  expect_rejection(mesh, "face 24", "not a triangle", "vertex 2");
}

TEST(Bad_mesh, coordinate_that_is_no_finite_number)
{
  for(const double bad : {not_a_number, infinity, -infinity})
    for(const int axis : {0, 1, 2})
    {
      Mesh mesh = quiet_mesh();
      mesh.point(Vertex(13)) = Point(axis == 0 ? bad : 1, axis == 1 ? bad : 1, axis == 2 ? bad : 1);
      expect_rejection(mesh, "vertex 13", "infinite or not a number");
    }
}

TEST(Bad_mesh, length_that_no_double_holds)
{
  Mesh mesh = quiet_mesh();
  for(const Vertex v : mesh.vertices())
    mesh.point(v) = Point(v == Vertex(7) ? 1.5e308 : -1.5e308, 0, 0);
  expect_rejection(mesh, "vertex 7", "does not fit a double");
}

TEST(Bad_mesh, length_given_that_is_no_length)
{
  const Mesh mesh = quiet_mesh();
  for(const double bad : {-1., not_a_number, infinity, -infinity, -1e-300})
  {
    std::vector<double> lengths(mesh.num_edges(), 1);
    const Edge e(17);
    lengths[e.idx()] = bad;
    const auto map =
        boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
    expect_message<std::invalid_argument>(
        [&] { Triangulation(mesh, parameters::edge_length_map(map)); },
        "vertex " + std::to_string(mesh.vertex(e, 0).idx()),
        "vertex " + std::to_string(mesh.vertex(e, 1).idx()), "length", "not negative");
  }
}

TEST(Bad_mesh, negative_zero_is_a_length)
{
  const Mesh mesh = quiet_mesh();
  const std::vector<double> lengths(mesh.num_edges(), -0.0);
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  const Triangulation t(mesh, parameters::edge_length_map(map));
  for(const double length : t.lengths())
    EXPECT_FALSE(std::signbit(length));
}

TEST(Bad_mesh, vertex_with_two_cycles_of_halfedges)
{
  Mesh mesh = quiet_mesh();
  const Vertex a = mesh.add_vertex(Point(9, 9, 0)), b = mesh.add_vertex(Point(10, 9, 0)),
               c = mesh.add_vertex(Point(10, 10, 0));
  ASSERT_NE(mesh.add_face(a, b, c), Mesh::null_face());
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(a)))
    mesh.set_target(h, Vertex(6)); // a fan of its own
  mesh.remove_vertex(a);
  expect_rejection(mesh, "vertex 6", "do not form one cycle");
}

TEST(Bad_mesh, halfedges_that_do_not_close_around_a_vertex)
{
  Mesh mesh = to_mesh(sphere(8, 4));
  // the walk around vertex 5 gets into a cycle that does not contain where it started
  const Halfedge h = mesh.opposite(mesh.halfedge(Vertex(5)));
  const Halfedge second = mesh.opposite(mesh.prev(h));
  const Halfedge third = mesh.opposite(mesh.prev(second));
  mesh.set_next(mesh.opposite(second), third); // sets what is before `third`
  mesh.set_next(mesh.opposite(third), third);
  EXPECT_THROW(Triangulation{mesh}, std::invalid_argument);
}

TEST(Bad_mesh, links_that_lead_nowhere)
{
  Mesh mesh = quiet_mesh();
  mesh.set_halfedge(Face(7), Mesh::null_halfedge());
  expect_rejection(mesh, "face 7", "has no halfedge");

  mesh = quiet_mesh();
  mesh.set_target(mesh.halfedge(Face(7)), Mesh::null_vertex());
  expect_rejection(mesh, "no vertex");

  mesh = quiet_mesh();
  const Halfedge h = mesh.halfedge(Face(7)), g = mesh.opposite(h), next_of_g = mesh.next(g);
  mesh.set_next(g, mesh.next(h)); // now what is before that is not `h`
  mesh.set_next(g, next_of_g);
  expect_rejection(mesh, "face 7", "not linked to its halfedges in both directions");
}

TEST(Bad_mesh, halfedge_before_another_that_is_missing)
{
  Mesh mesh;
  mesh.add_vertex(Point(0, 0, 0));
  const Halfedge h = mesh.add_edge(), g = mesh.opposite(h);
  mesh.set_target(h, Vertex(0));
  mesh.set_target(g, Vertex(0));
  mesh.set_halfedge(Vertex(0), g);
  mesh.set_next(h, g); // so that there is none before `h`
  mesh.set_next(g, g);
  expect_rejection(mesh, "vertex 0", "do not form one cycle");
}

TEST(Bad_mesh, halfedge_with_a_face_that_it_does_not_go_round)
{
  Mesh mesh = to_mesh(flat_grid(2, 2));
  const Halfedge h = mesh.halfedge(Vertex(0), Vertex(1));
  mesh.set_face(mesh.is_border(h) ? h : mesh.opposite(h), Face(1));
  expect_rejection(mesh, "the halfedge from vertex 1 to vertex 0", "go round it");

  mesh = to_mesh(flat_grid(2, 2));
  mesh.set_face(mesh.halfedge(Face(1)), Face(0));
  expect_rejection(mesh, "face 1", "not a triangle");
}

TEST(Bad_mesh, faces_that_their_vertices_do_not_know)
{
  const Point origin(0, 0, 0);
  Mesh mesh = to_mesh({{origin, origin, origin}, {{0, 1, 2}}});
  for(const Vertex v : mesh.vertices())
    mesh.set_halfedge(v, Mesh::null_halfedge());
  expect_rejection(mesh, "face 0", "is not one of those around vertex 0");
}

// As many halfedges have a face as there are sides of faces, but they are others.
TEST(Bad_mesh, border_that_claims_the_face_of_a_detached_triangle)
{
  Soup soup = flat_grid(3, 2);
  soup.append({{Point(7, 7, 0), Point(8, 7, 0), Point(7, 8, 0)}, {{0, 1, 2}}});
  soup.append({{Point(7, 7, 0), Point(8, 7, 0), Point(7, 8, 0)}, {{0, 1, 2}}});
  Mesh mesh = to_mesh(soup);
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h) && mesh.target(h) < Vertex(6))
      mesh.set_face(h, Face(4));
  for(Mesh::size_type i = 6; i < 12; ++i)
    mesh.set_halfedge(Vertex(i), Mesh::null_halfedge());
  expect_rejection(mesh, "face 4", "is not one of those around vertex");
}

TEST(Bad_mesh, lengths_that_add_up_to_more_than_a_double_holds)
{
  const auto scaled = [](const double factor) {
    return to_mesh(flat_grid(30, 30).transformed(
        [&](const Point& p) { return Point(p.x() * factor, p.y() * factor, 0); }));
  };
  EXPECT_NO_THROW(Triangulation{scaled(1e300)});
  expect_rejection(scaled(5e306), "all edges", "half of what a double holds", "vertex");
}

TEST(Bad_mesh, face_that_is_too_small_beside_the_mesh)
{
  Soup soup = flat_grid(3, 3);
  soup.append({{Point(0, 0, 0), Point(1e-140, 0, 0), Point(0, 1e-140, 0)}, {{0, 1, 2}}});
  const Mesh mesh = to_mesh(soup);
  expect_message<std::invalid_argument>([&] { Triangulation(mesh).check_triangle_inequality(); },
                                        "too small", "9", "10", "11", "1e-140");
  soup.points[11] = Point(0, 1e-120, 0); // a needle
  EXPECT_NO_THROW(Triangulation(to_mesh(soup)).check_triangle_inequality());
}

TEST(Bad_mesh, faces_that_cannot_be_laid_out)
{
  const Mesh mesh = quiet_mesh();
  std::vector<double> lengths(mesh.num_edges(), 1);
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  EXPECT_NO_THROW(
      Triangulation(mesh, parameters::edge_length_map(map)).check_triangle_inequality());
  const Halfedge h = mesh.halfedge(Vertex(0), Vertex(1));
  ASSERT_TRUE(mesh.is_border(h) != mesh.is_border(mesh.opposite(h)));
  lengths[mesh.edge(h).idx()] = 2; // a face without area
  EXPECT_NO_THROW(
      Triangulation(mesh, parameters::edge_length_map(map)).check_triangle_inequality());
  lengths[mesh.edge(h).idx()] = 2.001;
  expect_message<std::invalid_argument>(
      [&] { Triangulation(mesh, parameters::edge_length_map(map)).check_triangle_inequality(); },
      "triangle inequality", "0, ", "1, ", "6", "2.001");
  lengths.assign(lengths.size(), 0);
  EXPECT_NO_THROW(
      Triangulation(mesh, parameters::edge_length_map(map)).check_triangle_inequality());
}

TEST(Good_mesh, can_be_laid_out)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
    EXPECT_NO_THROW(Triangulation(mesh).check_triangle_inequality()) << name;
}

// A mesh that says it has more halfedges than there are numbers, and is otherwise not to be
// touched: the iterators of its vertices and faces throw.
struct Huge_mesh : Mesh
{
  using Mesh::Mesh;
  std::size_t size = 0;
};
std::size_t num_halfedges(const Huge_mesh& mesh) { return mesh.size; }
std::size_t num_vertices(const Huge_mesh& mesh) { return mesh.size / 6; }
CGAL::Iterator_range<boost::graph_traits<Mesh>::face_iterator> faces(const Huge_mesh&)
{
  throw std::logic_error("faces were looked at before the size");
}

} // namespace

namespace boost {
template <>
struct graph_traits<Huge_mesh> : graph_traits<Mesh>
{
};
template <typename Tag>
struct property_map<Huge_mesh, Tag> : property_map<Mesh, Tag>
{
};
} // namespace boost
template <typename Tag>
struct CGAL::graph_has_property<Huge_mesh, Tag> : CGAL::graph_has_property<Mesh, Tag>
{
};

namespace {

TEST(Bad_mesh, more_halfedges_than_numbers)
{
  Huge_mesh mesh;
  for(const std::size_t size : {(std::size_t(1) << 32) - 1, std::size_t(1) << 32})
  {
    mesh.size = size;
    expect_message<std::length_error>([&] { Triangulation{mesh}; }, std::to_string(size), "32-bit");
  }
  mesh.size = (std::size_t(1) << 32) - 2;
  EXPECT_THROW(Triangulation{mesh}, std::logic_error); // so it got as far as the faces
}

} // namespace
