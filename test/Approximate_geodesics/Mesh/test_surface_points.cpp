// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/surface_subjects.h"
#include "fixtures/Expected_surface_paths.h"
#include "meshes/sample_meshes.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

void expect_everything(const std::vector<Subject>& subjects)
{
  using parameters::epsilon;
  Random random(test_seed());
  for(const Subject& subject : subjects)
  {
    SCOPED_TRACE(subject.name);
    ASSERT_GT(subject.mesh.number_of_faces(), 0u);
    const Pairs_of_points pairs(subject, random);
    expect_surface_paths<AG::Edge_graph>(pairs, random, "edges", infinity,
                                         parameters::default_values());
    expect_surface_paths<AG::Discrete_geodesic_graph>(pairs, random, "discrete geodesic graph", 0.1,
                                                      epsilon(0.1));
    expect_surface_paths<AG::Lazy_discrete_geodesic_graph>(pairs, random, "lazy graph", 0.05,
                                                           epsilon(0.05));
  }
}

TEST(Surface_points, are_joined_on_generated_meshes) { expect_everything(generated_subjects()); }

TEST(Surface_points, are_joined_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  expect_everything(sample_subjects());
}

} // namespace
