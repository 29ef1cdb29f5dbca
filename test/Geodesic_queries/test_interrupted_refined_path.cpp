// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Interrupted_function.h"

#include <CGAL/Geodesic_queries/refined_path.h>

#include <gtest/gtest.h>

#include <iterator>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

TEST_F(Interrupted_function, refined_path)
{
  expect_survival_of([&](Results_of_functions& r) {
    AG::refined_path(m_mesh, std::back_inserter(r.points), Vertex(3), Vertex(60));
  });
}

} // namespace
