// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_everything.h"
#include "fixtures/expect_distances_on_fan.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include <gtest/gtest.h>

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

// What a vertex sees is followed across all faces around it, from each of its neighbors: this
// takes a time that grows with the square of their number, or with their number along edges.
TEST(Hostile_meshes, vertex_with_very_many_neighbors)
{
  for(const std::size_t valence : {std::size_t(1000), std::size_t(100000)})
    expect_distances_on_fan<AG::Edge_graph>(valence, parameters::default_values());
  expect_distances_on_fan<AG::Discrete_geodesic_graph>(1000, parameters::epsilon(0.1));
  expect_distances_on_fan<AG::Lazy_discrete_geodesic_graph>(1000, parameters::epsilon(0.1));
}

} // namespace
