// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_constructions/internal/Offsets/Distances_on_edges.h>

#include "checks/test_random.h"
#include "meshes/test_meshes.h"
#include "oracles/distances_to_curves.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Distances of points, from those of the edges around.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Index = AG::Intrinsic_triangulation::Index;
using Exact_surface_search = AG::Surface_search<AG::Saddle_vertex_graph>;

double largest_distance(const Exact_surface_search& search)
{
  double result = 0;
  for(Node v = 0; v < search.graph().triangulation().number_of_vertices(); ++v)
    result = (std::max)(result, search.distance(Intrinsic_point::at_vertex(v)));
  return result;
}

// Far larger faces than errors: paths to points beside an edge are shortest close to a kink.
TEST(Distances_over_edges, are_right_beside_long_edges)
{
  Random random(test_seed());
  const AG::Saddle_vertex_graph graph(Triangulation(to_mesh(flat_grid(12, 3))));
  const Triangulation& t = graph.triangulation();
  for(int round = 0; round < 20; ++round)
  {
    Exact_surface_search search(graph);
    AG::run_from_curves(search, {{{random_polyline(graph, 3, random)}}});
    const double allowed = 1e-5 * largest_distance(search);
    const AG::internal::Distances_on_edges<Exact_surface_search> on_edges(search,
                                                                          allowed / t.unit());
    for(Index h = 0; h < t.number_of_halfedges(); ++h)
    {
      if(t.is_border(h))
        continue;
      const double to_target = random.between(0, 0.99), to_third = random.between(0, 0.01);
      const auto point = Intrinsic_point::in_face(t.first_of_face(h), to_target, to_third);
      const double exact = search.distance(point);
      const double estimate = 1.05 * exact / t.unit();
      EXPECT_NEAR(on_edges.distance(point, estimate) * t.unit(), exact, allowed);
    }
  }
}

} // namespace
