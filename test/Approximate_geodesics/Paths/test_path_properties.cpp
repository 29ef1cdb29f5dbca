// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_of_all_kinds.h"
#include "fixtures/Path_properties.h"
#include "oracles/test_oracles.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

TEST_P(Path_properties, along_edges) { expect_good_paths(edge_graph()); }

TEST_P(Path_properties, in_a_discrete_geodesic_graph)
{
  expect_good_paths(discrete_geodesic_graph(0.1));
}

// The edge graph and Steiner graphs are searched with all queues in other tests.
TEST_P(Path_properties, queues_do_not_change_distances)
{
  const auto graph = discrete_geodesic_graph(0.2).make(Triangulation(m_mesh));
  const std::size_t source = m_random.below(m_mesh.number_of_vertices());
  const auto expected = distances<AG::Adaptive_bucket_queue>(graph, source);
  EXPECT_TRUE(have_same_bits(distances<AG::Pairing_heap_queue>(graph, source), expected));
  EXPECT_TRUE(have_same_bits(distances<AG::Published_bucket_queue>(graph, source), expected));
  EXPECT_TRUE(have_same_bits(distances<AG::Radix_heap_queue>(graph, source), expected));
}

INSTANTIATE_TEST_SUITE_P(On_random_meshes,
                         Path_properties,
                         testing::ValuesIn(seeds_of_small_soups()));

} // namespace
