// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_everything.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Geodesic_costs.h>

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

// Beside much longer edges, short ones vanish when faces are unfolded, and so do widths of faces.
TEST(Hostile_meshes, saddle_vertex_graph)
{
  expect_everything<AG::Saddle_vertex_graph>(
      parameters::default_values(),
      {"caps of 1e9", "caps of 1e200", "edges from 1e-30 to 1", "edges from 1e-60 to 1",
       "edges from 1e-120 to 1", "needles of 1e9", "needles of 1e12"});
}

// ----- a vertex with very many neighbors, in every graph

// From a vertex of the frontier of a disk whose hub is vertex 0: the shortest way along edges is
// the frontier's, or by way of the hub.
template <typename Graph, typename NamedParameters>
void expect_distances_on_fan(const std::size_t valence, const NamedParameters& np)
{
  const Mesh mesh = to_mesh(fan(valence));
  const auto line = [&](const Vertex v) {
    return std::sqrt(CGAL::squared_distance(mesh.point(Vertex(1)), mesh.point(v)));
  };
  Shortest_paths<Graph> paths(mesh, np);
  const Bound bound = bound_of(paths.graph());
  constexpr double rounding = 1e-11; // of sums along the frontier
  paths.set_sources({Vertex(1)});
  for(const Vertex v : mesh.vertices())
  {
    const std::size_t i = v.idx();
    const std::size_t steps = (std::min)(i - 1, valence + 1 - i);
    const double along_edges =
        i == 0 ? 1 : (std::min)(static_cast<double>(steps) * line(Vertex(2)), 2.);
    const double found = paths.distance(v);
    EXPECT_GE(found, (bound.is_along_edges ? along_edges : line(v)) - rounding);
    EXPECT_LE(found, along_edges * (1 + bound.of_edges) + rounding);
    if(bound.epsilon < infinity)
    {
      EXPECT_LE(found, line(v) * (1 + bound.epsilon));
    }
  }
}

// What a vertex sees is followed across all faces around it, from each of its neighbors: this
// takes a time that grows with the square of their number, or with their number along edges.
TEST(Hostile_meshes, vertex_with_very_many_neighbors)
{
  for(const std::size_t valence : {std::size_t(1000), std::size_t(100000)})
    expect_distances_on_fan<AG::Edge_graph>(valence, parameters::default_values());
  expect_distances_on_fan<AG::Discrete_geodesic_graph>(1000, parameters::epsilon(0.1));
  expect_distances_on_fan<AG::Lazy_discrete_geodesic_graph>(1000, parameters::epsilon(0.1));
  expect_distances_on_fan<AG::Steiner_graph<AG::Fixed_number_of_points>>(
      1000, parameters::number_of_points_per_edge(1));
}

} // namespace
