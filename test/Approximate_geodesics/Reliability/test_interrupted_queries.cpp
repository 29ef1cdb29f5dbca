// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_of_all_kinds.h"
#include "fixtures/Interrupted_query.h"

#include <gtest/gtest.h>

namespace {

using namespace geodesics_test;

TEST(Interrupted_queries, of_the_edge_graph)
{
  const Interrupted_query query(edge_graph());
  query.expect_survival_of_all();
  query.expect_survival_of_limited_runs();
  query.expect_survival_of_straightening();
}

TEST(Interrupted_queries, of_a_discrete_geodesic_graph)
{
  const Interrupted_query query(discrete_geodesic_graph(0.3));
  query.expect_survival_of_all();
  query.expect_survival_of_straightening();
}

} // namespace
