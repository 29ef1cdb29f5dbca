// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include "fixtures/Single_pairs.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Geodesic_costs/equal_parts.h>

#include <gtest/gtest.h>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

using With_points =
    Graph_and_queue<AG::Steiner_graph<AG::Fixed_number_of_points>, AG::Radix_heap_queue>;
INSTANTIATE_TYPED_TEST_SUITE_P(On_points, Single_pairs, With_points, );

} // namespace
