// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics.h>

#include "oracles/test_oracles.h"

#include <gtest/gtest.h>

int distance_of_the_other_translation_unit();

namespace {

using namespace geodesics_test;

TEST(Translation_units, of_all_packages_can_be_linked)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  Mesh_search search(mesh);
  EXPECT_EQ(search.distances({Vertex(0)})[2], distance_of_the_other_translation_unit());
}

} // namespace
