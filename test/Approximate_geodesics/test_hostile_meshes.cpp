// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "expect_everything.h"

#include <CGAL/Approximate_geodesics/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Lazy_discrete_geodesic_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

// Graphs of vertices on meshes that are as bad as they get: distances and paths are right all the
// same.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST(Hostile_meshes, edge_graph)
{
  expect_everything<AG::Edge_graph>(parameters::default_values(), {});
}

TEST(Hostile_meshes, discrete_geodesic_graph)
{
  for(const double epsilon : {0.1, 0.02})
    expect_everything<AG::Discrete_geodesic_graph>(
        parameters::epsilon(epsilon), {"a part of size 1e-60", "edges from 1e-60 to 1",
                                       "a part of size 1e-120", "edges from 1e-120 to 1"});
}

TEST(Hostile_meshes, lazy_discrete_geodesic_graph)
{
  for(const double epsilon : {0.1, 0.02})
    expect_everything<AG::Lazy_discrete_geodesic_graph>(parameters::epsilon(epsilon), {});
}

// What a vertex sees is followed across all faces around it, from each of its neighbours: this
// takes a time that grows with the square of their number, or with their number along edges.
TEST(Hostile_meshes, vertex_with_very_many_neighbours)
{
  for(const std::size_t valence : {std::size_t(1000), std::size_t(100000)})
  {
    const Mesh mesh = to_mesh(fan(valence));
    Shortest_paths<AG::Edge_graph> along_edges(mesh, parameters::default_values());
    along_edges.set_sources({Vertex(1)});
    const double side =
        std::sqrt(CGAL::squared_distance(mesh.point(Vertex(1)), mesh.point(Vertex(2))));
    for(const Mesh::size_type i : {1u, 2u, 17u, 500u, 999u})
    {
      const double steps = double((std::min)(std::size_t(i - 1), valence + 1 - i));
      EXPECT_NEAR(along_edges.distance(Vertex(i)), (std::min)(steps * side, 2.), 1e-11);
    }
    if(valence > 1000)
      continue;
    Shortest_paths<AG::Discrete_geodesic_graph> across_faces(mesh, parameters::epsilon(0.1));
    across_faces.set_sources({Vertex(1)});
    for(const Vertex v : mesh.vertices())
    {
      const double line = std::sqrt(CGAL::squared_distance(mesh.point(Vertex(1)), mesh.point(v)));
      EXPECT_GE(across_faces.distance(v), line * (1 - 1e-12));
      EXPECT_LE(across_faces.distance(v), line * 1.1);
    }
  }
}

} // namespace
