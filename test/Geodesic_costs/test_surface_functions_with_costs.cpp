// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/functions_and_class.h"
#include "meshes/steiner_meshes.h"
#include "meshes/surface_points.h"

#include <gtest/gtest.h>

namespace {

namespace parameters = CGAL::parameters;
using namespace geodesics_test;

using Steiner = Steiner_graph<Fixed_number_of_points>;

TEST(Surface_functions, find_distances_and_paths_through_points_that_the_class_finds)
{
  const auto with_points = parameters::number_of_points_per_edge(2);
  for_generated_meshes([&](const Mesh& mesh, Random& random) {
    expect_same_distances_as_class<Steiner>(mesh, random, with_points);
    expect_same_paths_as_class<Steiner>(mesh, random, with_points);
  });
}

TEST(Surface_functions, take_costs_for_distances)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    Paths_over<Steiner> paths(mesh, steiner_graph(mesh, weights, Fixed_number_of_points(2)));
    const Surface_point source = random_surface_point(mesh, random);
    paths.add_source_point(source);
    EXPECT_TRUE(have_same_bits(
        distances_by_function(mesh, source, with_weights(weights).number_of_points_per_edge(2)),
        distances_by_class(paths, mesh)));
  });
}

} // namespace
