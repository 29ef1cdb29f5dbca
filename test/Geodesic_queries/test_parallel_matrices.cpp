// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_matrices.h"
#include "threads/same_from_all_threads.h"

#include <CGAL/approximate_geodesic_distance_matrix.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

#ifdef CGAL_LINKED_WITH_TBB

// Rows that threads compute, for a sink and for a function object.
TEST(Parallel_matrix, has_the_same_rows)
{
  const Mesh mesh = mesh_for_threads();
  const auto graph = discrete_geodesic_graph(0.5).make(Triangulation(mesh));
  std::vector<std::size_t> sources;
  for(std::size_t i = 0; i < 200; ++i)
    sources.push_back(7 * i % mesh.number_of_vertices());
  const auto find = [&](const auto& np) {
    Dense_rows<> dense;
    Radius_rows<> within_radius;
    Matrix rows;
    const auto append = [&](std::size_t, const Distance_row& row) {
      rows.emplace_back(row.begin(), row.end());
    };
    CGAL::approximate_geodesic_distance_matrix(graph, dense, sources, np);
    CGAL::approximate_geodesic_distance_matrix(graph, within_radius, sources,
                                               np.maximum_distance(5));
    CGAL::approximate_geodesic_distance_matrix(graph, append, sources, np);
    EXPECT_TRUE(are_the_same(rows, matrix_of(dense)));
    EXPECT_TRUE(are_the_same(entries_of(within_radius), within(5, rows)));
    return rows;
  };
  EXPECT_TRUE(are_the_same(find(parameters::concurrency_tag(CGAL::Parallel_tag())),
                           find(parameters::concurrency_tag(CGAL::Sequential_tag()))));
}

// While they are asked whether to go on, and another thread says no.
TEST(Parallel_matrix, may_be_ended_by_another_thread)
{
  struct Visitor : AG::Distance_matrix_visitor_base
  {
    bool go_further() { return !is_canceled; }
    std::atomic<bool> is_canceled{false};
  };
  const Mesh mesh = mesh_for_threads();
  Visitor visitor;
  std::size_t number = 0;
  const auto count = [&](const std::size_t row, const Distance_row&) {
    number = row + 1;
    if(row == 100)
      std::thread([&] { visitor.is_canceled = true; }).join();
  };
  const std::vector<Vertex> sources(10000, Vertex(3));
  EXPECT_FALSE(CGAL::approximate_geodesic_distance_matrix(
      mesh, count, sources,
      parameters::concurrency_tag(CGAL::Parallel_tag()).visitor(std::ref(visitor))));
  EXPECT_GT(number, 100u);
  EXPECT_LT(number, sources.size());
}

#endif

} // namespace
