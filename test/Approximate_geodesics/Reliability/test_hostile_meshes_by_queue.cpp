// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/expect_same_by_queues.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>

#include <gtest/gtest.h>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST(Hostile_meshes, are_searched_alike_by_all_queues_along_edges)
{
  expect_same_distances_by_queues([](const Mesh& mesh) { return Graph(Triangulation(mesh)); });
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_in_discrete_geodesic_graphs)
{
  expect_same_distances_by_queues([](const Mesh& mesh) {
    return AG::Discrete_geodesic_graph(Triangulation(mesh), parameters::epsilon(0.1));
  });
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_in_lazy_graphs)
{
  expect_same_distances_by_queues([](const Mesh& mesh) {
    return AG::Lazy_discrete_geodesic_graph(Triangulation(mesh), parameters::epsilon(0.1));
  });
}

} // namespace
