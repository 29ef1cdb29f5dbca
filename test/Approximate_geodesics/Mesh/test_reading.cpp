// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_same_triangulation.h"
#include "meshes/hostile_meshes.h"
#include "oracles/test_oracles.h"

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

void expect_same_triangulations(const Mesh& mesh)
{
  expect_same_triangulation(mesh, parameters::default_values());
  const auto lengths = boost::make_function_property_map<Edge>(
      [](const Edge e) { return 1 + 1. / (1 + double(e.idx())); });
  expect_same_triangulation(mesh, parameters::edge_length_map(lengths));
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
