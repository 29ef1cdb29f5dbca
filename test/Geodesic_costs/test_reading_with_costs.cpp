// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_same_triangulation.h"
#include "checks/test_random.h"

#include <CGAL/Geodesic_costs.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace geodesics_test;

void expect_same_triangulation_with_costs(const Mesh& mesh)
{
  const auto lengths = boost::make_function_property_map<Edge>(
      [](const Edge e) { return 1 + 1. / (1 + double(e.idx())); });
  const auto weights =
      boost::make_function_property_map<Face>([](const Face f) { return 1 + double(f.idx() % 7); });
  const auto barriers =
      boost::make_function_property_map<Edge>([](const Edge e) { return e.idx() % 5 == 0; });
  expect_same_triangulation(
      mesh,
      CGAL::parameters::edge_length_map(lengths).face_weight_map(weights).edge_is_constrained_map(
          barriers));
}

TEST(Reading, comes_to_the_same_with_costs)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    expect_same_triangulation_with_costs(mesh);
  }
  expect_same_triangulation_with_costs(to_mesh(flat_grid(200, 170)));
  for(const std::size_t degree : {254u, 255u, 256u, 257u, 1000u})
    expect_same_triangulation_with_costs(to_mesh(fan(degree)));
}

} // namespace
