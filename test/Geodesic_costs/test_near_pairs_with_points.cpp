// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include "fixtures/Near_pairs.h"

#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/equal_parts.h>

#include <gtest/gtest.h>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

using Graphs_of_pairs = testing::Types<AG::Steiner_graph<AG::Fixed_number_of_points>,
                                       AG::Steiner_graph<AG::Geometric_points>>;
TYPED_TEST_SUITE(Near_pairs, Graphs_of_pairs, );

TYPED_TEST(Near_pairs, have_the_distance_of_the_field)
{
  Random random(test_seed());
  this->compare(to_mesh(terrain(6, 5, random)), CGAL::parameters::default_values());
}

} // namespace
