// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/sample_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace geodesics_test;

// Bits of Boost's distances, and the certificate, from a few random sources.
void expect_dijkstra_distances(const Mesh& mesh, const std::size_t sources, Random& random)
{
  const std::vector<double> lengths = edge_lengths(mesh);
  Mesh_search search(mesh);
  for(std::size_t i = 0; i < sources; ++i)
  {
    const Vertex source = random_vertex(mesh, random);
    SCOPED_TRACE(testing::Message() << "source " << source);
    const Field field = search.run({source});
    EXPECT_TRUE(have_same_bits(field.distance, boost_distances(mesh, lengths, source)));
    EXPECT_TRUE(is_optimal(mesh, lengths, field, {source}));
  }
}

TEST(Distances, are_those_of_boost_on_generated_meshes)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    ASSERT_TRUE(CGAL::is_triangle_mesh(mesh));
    expect_dijkstra_distances(mesh, 5, random);
  }
}

TEST(Distances, are_those_of_boost_on_a_hub)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(fan(100000, 1));
  ASSERT_EQ(mesh.degree(Vertex(0)), 100000u);
  expect_dijkstra_distances(mesh, 1, random);
}

TEST(Distances, are_those_of_boost_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  std::size_t number_of_meshes = 0;
  for(const std::string& name : names_of_sample_files())
  {
    const Mesh mesh = sample_mesh(name);
    if(mesh.number_of_faces() == 0 || !CGAL::is_triangle_mesh(mesh))
      continue; // a polygon mesh, or one that is not manifold
    SCOPED_TRACE(name);
    ++number_of_meshes;
    expect_dijkstra_distances(mesh, mesh.number_of_vertices() > 5000 ? 2 : 4, random);
  }
  EXPECT_GE(number_of_meshes, 100u); // the collection has more
}

// Sums of the same roots, in other coordinates.
TEST(Distances, do_not_change_when_an_integer_grid_moves_by_integers)
{
  const auto bend = [](const Point& p) { return Point(p.x(), 2 * p.y(), int(p.x()) % 3); };
  const auto move = [](const Point& p) { return Point(p.x() + 12345, p.y() - 777, p.z() + 31); };
  const Soup soup = flat_grid(20, 20).transformed(bend);
  EXPECT_TRUE(have_same_bits(Mesh_search(to_mesh(soup.transformed(move))).distances({Vertex(3)}),
                             Mesh_search(to_mesh(soup)).distances({Vertex(3)})));
}

// Along axes and the diagonals that the grid has; anywhere else, a staircase of both.
TEST(Distances, on_a_grid_have_a_closed_form)
{
  const std::size_t n = 40;
  const Mesh mesh = to_mesh(flat_grid(n, n));
  const std::vector<double> found = Mesh_search(mesh).distances({Vertex(0)});
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double straight = static_cast<double>((std::max)(i, j) - (std::min)(i, j));
      const double expected = straight + static_cast<double>((std::min)(i, j)) * std::sqrt(2.);
      const double rounding = expected * static_cast<double>(2 * n) * 0x1p-53;
      EXPECT_NEAR(found[i + j * n], expected, rounding);
    }
  EXPECT_EQ(found[n - 1], static_cast<double>(n - 1));
}

} // namespace
