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

// What the constructor of a triangulation refuses because of a map or a limit. Meshes that
// everything refuses are in meshes/hostile_meshes.h.

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

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

TEST(Bad_mesh, border_that_is_linked_in_one_direction)
{
  Mesh mesh = quiet_mesh();
  const Halfedge h = mesh.opposite(mesh.halfedge(Vertex(0), Vertex(1)));
  ASSERT_TRUE(mesh.is_border(h));
  mesh.set_next_only(mesh.prev(h), mesh.next(h));
  expect_message<std::invalid_argument>([&] { Triangulation{mesh}; },
                                        "the halfedge from vertex 1 to vertex 0 is on the border");
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
