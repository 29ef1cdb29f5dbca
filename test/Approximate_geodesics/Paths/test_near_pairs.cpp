// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include "fixtures/Near_pairs.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include <gtest/gtest.h>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

using Graphs_of_pairs = testing::Types<AG::Edge_graph,
                                       AG::Discrete_geodesic_graph,
                                       AG::Lazy_discrete_geodesic_graph,
                                       AG::Saddle_vertex_graph>;
TYPED_TEST_SUITE(Near_pairs, Graphs_of_pairs, );

TYPED_TEST(Near_pairs, have_the_distance_of_the_field)
{
  Random random(test_seed());
  this->compare(to_mesh(terrain(6, 5, random)), CGAL::parameters::default_values());
}

} // namespace
