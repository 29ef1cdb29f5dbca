// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include "fixtures/Surface_searches.h"
#include "oracles/Graph_with_lines.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Geodesic_costs.h>

#include <gtest/gtest.h>

// Distances and paths between any points, on a graph that several threads share.

namespace AG = CGAL::Approximate_geodesics;

// All members compile for every graph, called or not.
template class AG::Surface_search<AG::Directional_graph<>>;
template class AG::Surface_search<AG::Discrete_geodesic_graph>;
template class AG::Surface_search<AG::Edge_graph>;
template class AG::Surface_search<AG::Lazy_discrete_geodesic_graph>;
template class AG::Surface_search<AG::Saddle_vertex_graph>;
template class AG::Surface_search<AG::Steiner_graph<>>;
template class AG::Surface_search<geodesics_test::Graph_with_lines>;

namespace {

using namespace geodesics_test;

TEST_F(Surface_searches, give_every_thread_distances_and_paths_among_points)
{
  expect_same_in_all_threads(AG::Steiner_graph<AG::Fixed_number_of_points>(
      m_triangulation, AG::Fixed_number_of_points(2)));
}

TEST_F(Surface_searches, repair_what_graphs_with_a_run_of_their_own_have_found)
{
  const Graph_with_lines graph(m_triangulation, CGAL::parameters::default_values());
  AG::Surface_search<Graph_with_lines> search(graph);
  search.repair({{m_points[0]}});
  EXPECT_EQ(search.distance(m_points[0]), 0);
}

} // namespace
