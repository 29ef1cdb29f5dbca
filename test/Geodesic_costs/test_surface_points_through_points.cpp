// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/surface_subjects.h"
#include "fixtures/Expected_surface_paths.h"
#include "meshes/sample_meshes.h"
#include "meshes/test_weights.h"

#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_costs/equal_parts.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

void expect_everything_through_points(const std::vector<Subject>& subjects)
{
  Random random(test_seed());
  for(const Subject& subject : subjects)
  {
    SCOPED_TRACE(subject.name);
    ASSERT_GT(subject.mesh.number_of_faces(), 0u);
    const Pairs_of_points pairs(subject, random);
    expect_surface_paths<AG::Steiner_graph<AG::Fixed_number_of_points>>(
        pairs, random, "equal parts", infinity, parameters::number_of_points_per_edge(3));
    expect_surface_paths<AG::Steiner_graph<AG::Geometric_points>>(pairs, random, "progressions",
                                                                  0.5, lenient_parameters(0.5));
  }
}

TEST(Surface_points, are_joined_on_generated_meshes)
{
  expect_everything_through_points(generated_subjects());
}

TEST(Surface_points, are_joined_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  expect_everything_through_points(sample_subjects());
}

} // namespace
