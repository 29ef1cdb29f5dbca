// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/expect_same_by_queues.h"
#include "meshes/test_weights.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace geodesics_test;

TEST(Hostile_meshes, are_searched_alike_by_all_queues_among_points)
{
  expect_same_distances_by_queues([](const Mesh& mesh) {
    return Steiner_graph<Fixed_number_of_points>(Triangulation(mesh), Fixed_number_of_points(2));
  });
}

TEST(Hostile_meshes, are_searched_alike_by_all_queues_among_points_with_weights)
{
  expect_same_distances_by_queues([](const Mesh& mesh) {
    Weights weights(mesh.num_faces());
    for(std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = i % 5 == 0 ? 0 : i % 5 == 1 ? infinity : 1e-30 * double(i);
    return Steiner_graph<Fixed_number_of_points>(Triangulation(mesh, with_weights(weights)),
                                                 Fixed_number_of_points(2));
  });
}

} // namespace
