// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/sample_meshes.h"
#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

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

} // namespace
