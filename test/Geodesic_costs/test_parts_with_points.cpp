// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/parts_of_meshes.h"

#include <CGAL/Geodesic_costs.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST(Part_of_mesh, has_the_shortest_paths_through_points_on_edges)
{
  const AG::Geodesic_visitor_base visitor;
  for_each_random_pair([&](const Mesh& mesh, const auto& source, const auto& target) {
    const auto with_points = parameters::number_of_points_per_edge(2);
    expect_same_length(length_of_path(mesh, source, target, with_points),
                       length_of_path(mesh, source, target, with_points.visitor(visitor)), mesh);
  });
}

TEST_F(Bad_part, is_refused_if_it_takes_too_many_points)
{
  const auto np = parameters::maximum_number_of_points(1000).number_of_points_per_edge(500);
  const auto message = [&](const auto& all) {
    try
    {
      bare_length(m_mesh, near, near_too, all);
    }
    catch(const std::length_error& e)
    {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(message(np), "");
  EXPECT_EQ(message(np), message(np.visitor(AG::Geodesic_visitor_base())));
}

} // namespace
