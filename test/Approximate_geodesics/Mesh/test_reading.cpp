// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/hostile_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Geodesic_costs.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

// A mesh that is right in every respect is read from its links, in the order of its memory. Where
// elements were removed it is read step by step. Both have to come to the same.

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;
using Index = Triangulation::Index;

// The same mesh, with a vertex that was removed; no other one has another index.
Mesh with_removed_vertex(const Mesh& mesh)
{
  Mesh result = mesh;
  result.remove_vertex(result.add_vertex(Point(0, 0, 0)));
  return result;
}

void expect_same_triangulation(const Triangulation& a, const Triangulation& b)
{
  EXPECT_TRUE(a.is_valid());
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.targets(), b.targets());
  EXPECT_EQ(a.lengths(), b.lengths());
  EXPECT_EQ(a.unit(), b.unit());
  EXPECT_EQ(a.number_of_faces(), b.number_of_faces());
  EXPECT_EQ(a.thin_faces().number_of_faces(), b.thin_faces().number_of_faces());
  for(Index v = 0; v < a.number_of_vertices(); ++v)
  {
    ASSERT_EQ(a.first_halfedge(v), b.first_halfedge(v));
    ASSERT_EQ(a.index(v), b.index(v));
  }
  for(Index h = 0; h < a.number_of_halfedges(); ++h)
  {
    ASSERT_EQ(a.opposite(h), b.opposite(h));
    ASSERT_EQ(a.is_border(h), b.is_border(h));
    ASSERT_EQ(a.weight(h), b.weight(h));
    ASSERT_EQ(a.is_barrier(h), b.is_barrier(h));
  }
}

template <typename NamedParameters>
void expect_same_triangulation(const Mesh& mesh, const NamedParameters& np)
{
  expect_same_triangulation(Triangulation(mesh, np), Triangulation(with_removed_vertex(mesh), np));
}

void expect_same_triangulations(const Mesh& mesh)
{
  expect_same_triangulation(mesh, parameters::default_values());
  const auto lengths = boost::make_function_property_map<Edge>(
      [](const Edge e) { return 1 + 1. / (1 + double(e.idx())); });
  const auto weights =
      boost::make_function_property_map<Face>([](const Face f) { return 1 + double(f.idx() % 7); });
  const auto barriers =
      boost::make_function_property_map<Edge>([](const Edge e) { return e.idx() % 5 == 0; });
  expect_same_triangulation(
      mesh, parameters::edge_length_map(lengths).face_weight_map(weights).edge_is_constrained_map(
                barriers));
  const auto backward = boost::make_function_property_map<Vertex>(
      [n = mesh.num_vertices()](const Vertex v) { return n - 1 - v.idx() % n; });
  expect_same_triangulation(
      Triangulation(mesh, parameters::vertex_index_map(backward)),
      Triangulation(with_removed_vertex(mesh), parameters::vertex_index_map(backward)));
}

TEST(Reading, comes_to_the_same_step_by_step)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    expect_same_triangulations(mesh);
  }
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    expect_same_triangulation(row.mesh, parameters::default_values());
  }
}

// They are numbered one patch after the other.
TEST(Reading, comes_to_the_same_on_large_meshes)
{
  expect_same_triangulations(to_mesh(flat_grid(200, 170)));
}

TEST(Reading, knows_opposites_around_vertices_of_high_degree)
{
  for(const std::size_t degree : {254u, 255u, 256u, 257u, 1000u})
    expect_same_triangulations(to_mesh(fan(degree)));
}

std::string reason(const Mesh& mesh)
{
  try
  {
    Triangulation{mesh};
  }
  catch(const std::invalid_argument& e)
  {
    return e.what();
  }
  return "";
}

TEST(Reading, refuses_the_same_step_by_step)
{
  for(const Hostile_mesh& row : refused_meshes())
    EXPECT_EQ(reason(row.mesh), reason(with_removed_vertex(row.mesh))) << row.name;
}

} // namespace
