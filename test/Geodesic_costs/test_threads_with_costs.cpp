// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_with_points.h"
#include "meshes/test_weights.h"
#include "threads/same_from_all_threads.h"

#include <CGAL/Geodesic_costs.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace geodesics_test;

TEST(Threads, may_share_a_graph_with_points)
{
  expect_graph_to_be_shared(graph_with_spaced_points(1));
}

TEST_F(Threads_with_a_mesh, may_find_costs)
{
  const Weights weights(m_mesh.number_of_faces(), 2);
  expect_same_from_all_threads([&](const std::size_t i) {
    Values result;
    if(i == 0)
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i));
    else
      CGAL::approximate_geodesic_distances(m_mesh, map(result), vertex(i),
                                           CGAL::parameters::face_weight_map(weight_map(weights)));
    return result;
  });
}

} // namespace
