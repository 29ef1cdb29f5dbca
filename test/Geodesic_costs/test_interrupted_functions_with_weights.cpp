// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Interrupted_function.h"
#include "meshes/test_weights.h"

#include <CGAL/Geodesic_costs.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <gtest/gtest.h>

namespace {

using namespace geodesics_test;

TEST_F(Interrupted_function, approximate_geodesic_distances_with_weights)
{
  const Weights weights(m_mesh.num_faces(), 2);
  expect_survival_of([&](Results_of_functions& r) {
    CGAL::approximate_geodesic_distances(
        m_mesh, map(r.distance), m_sources,
        CGAL::parameters::epsilon(1.).face_weight_map(weight_map(weights)));
  });
}

} // namespace
