// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Queries/internal/Offsets/Offset_tracer.h>

#include "meshes/hostile_meshes.h"
#include "oracles/distances_to_curves.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// How offset curves are traced, in any unit.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Search_from_curve = AG::Surface_search<AG::Saddle_vertex_graph>;

std::size_t number_of_points(const Soup& soup, const double unit)
{
  const Mesh mesh = to_mesh(scaled(soup, unit));
  const AG::Saddle_vertex_graph graph{Triangulation(mesh)};
  Search_from_curve search(graph);
  search.run({{Intrinsic_point::at_vertex(graph.triangulation().vertex(0))}});
  AG::internal::Offset_tracer tracer(search, {0.1 * unit, 2.5 * unit}, 1e-4 * unit);
  std::size_t result = 0;
  for(const auto& line : tracer.trace())
    result += line.points.size();
  return result;
}

// Squares of lengths are infinite or zero where the length of an edge is one of these.
TEST(Offset_tracer, divides_faces_alike_in_any_unit)
{
  const Soup soup = flat_grid(4, 3);
  const std::size_t expected = number_of_points(soup, 1);
  EXPECT_GT(expected, 100u);
  for(const int exponent : {-1000, 1000})
    EXPECT_EQ(number_of_points(soup, std::ldexp(1., exponent)), expected) << exponent;
}

} // namespace
