// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include "checks/expect_exact_distances.h"
#include "meshes/developed_surfaces.h"
#include "oracles/boxes.h"
#include "oracles/polygonal_domain.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// Exact distances where borders and corners decide, by oracles of their own.

namespace {

using namespace geodesics_test;

// ----- borders

std::vector<Polygonal_domain> polygonal_domains()
{
  return {
      {8, 8, {{4, 4, 9, 9}}},                                                // an L
      {15, 8, {{2, -1, 3, 6}, {5, 2, 6, 9}, {8, -1, 9, 7}, {11, 1, 12, 9}}}, // a comb
      {9, 9, {{3, 3, 6, 6}}},                                                // a hole
      {12, 10, {{1, 1, 4, 3}, {6, 2, 8, 8}, {2, 5, 5, 9}, {9, 1, 11, 4}}},   // several
      {13, 13, {{2, 2, 14, 3}, {2, 2, 3, 11}, {2, 10, 11, 11}, {10, 5, 11, 11}, {5, 5, 11, 6}}},
  };
}

TEST(Saddle_vertex_graph, is_exact_around_corners_of_the_border)
{
  Random random(test_seed());
  for(const Polygonal_domain& domain : polygonal_domains())
    for(const double jitter : {0., 0.2})
    {
      SCOPED_TRACE(testing::Message() << domain.columns() << " columns, jitter " << jitter);
      Exactness(surface_of(domain, jitter, random)).expect_all(random, 6);
    }
}

// ----- boxes

TEST(Saddle_vertex_graph, is_exact_on_boxes)
{
  Random random(test_seed());
  for(const Box::Triple& size : {Box::Triple{2, 2, 2}, Box::Triple{3, 3, 3}, Box::Triple{2, 2, 4},
                                 Box::Triple{2, 3, 7}, Box::Triple{2, 9, 9}, Box::Triple{12, 2, 2}})
    for(const double jitter : {0., 0.2})
    {
      SCOPED_TRACE(testing::Message() << size[0] << ' ' << size[1] << ' ' << size[2]);
      Exactness(surface_of(Box(size), jitter, random)).expect_all(random, 5);
    }
}

} // namespace
