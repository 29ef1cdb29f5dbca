// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_with_points.h"
#include "fixtures/Path_properties.h"

#include <gtest/gtest.h>

namespace {

using namespace geodesics_test;

TEST_P(Path_properties, over_points) { expect_good_paths(graph_with_spaced_points(2)); }

INSTANTIATE_TEST_SUITE_P(On_random_meshes,
                         Path_properties,
                         testing::ValuesIn(seeds_of_small_soups()));

} // namespace
