// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_random.h"
#include "surfaces/springs.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// Lines that return to faces, against points on edges, which know nothing of straight lines.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Point_of_surface = AG::Intrinsic_point;
using Exact_graph = AG::Saddle_vertex_graph;
using Lazy_graph = AG::Lazy_discrete_geodesic_graph;
using Built_graph = AG::Discrete_geodesic_graph;

Point_of_surface random_point(const AG::Intrinsic_triangulation& t, Random& random)
{
  for(;;)
  {
    const auto h =
        static_cast<AG::Intrinsic_triangulation::Index>(random.below(t.number_of_halfedges()));
    if(t.is_border(h))
      continue;
    const double s = random.between(0.01, 0.98);
    return Point_of_surface::in_face(h, random.between(0.005, 0.99 - s), s);
  }
}

template <typename Graph>
void expect_close(const std::vector<Point_of_surface>& points,
                  const std::vector<std::vector<double>>& upper_bounds,
                  const Graph& graph,
                  const double epsilon)
{
  constexpr double error_of_bounds = 0.02, rounding = 1e-6;
  AG::Surface_search<Graph> search(graph);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    search.run({{points[i]}});
    for(std::size_t j = 0; j < points.size(); ++j)
    {
      const double found = search.distance(points[j]), bound = upper_bounds[i][j];
      EXPECT_LE(found, bound * (1 + epsilon) * (1 + rounding)) << i << " to " << j;
      EXPECT_GE(found, bound / (1 + error_of_bounds) * (1 - rounding)) << i << " to " << j;
    }
  }
}

// Any lengths between 1 and 2 make triangles.
TEST(Lines_that_return, are_found_where_lengths_are_random)
{
  Random random(test_seed());
  for(const Soup& soup : {octahedron(), flat_grid(4, 4), terrain(5, 5, random)})
    for(int repetition = 0; repetition < 3; ++repetition)
    {
      const auto t =
          with_lengths(to_mesh(soup), [&](Edge) { return random.between(1.001, 1.999); });
      std::vector<Point_of_surface> points;
      for(AG::Intrinsic_triangulation::Index v = 0; v < t.number_of_vertices(); v += 3)
        points.push_back(Point_of_surface::at_vertex(v));

      const AG::Steiner_graph<> reference(t, parameters::epsilon(0.02));
      AG::Surface_search<AG::Steiner_graph<>> search(reference);
      std::vector<std::vector<double>> upper_bounds;
      for(const Point_of_surface& p : points)
      {
        search.run({{p}});
        upper_bounds.emplace_back();
        for(const Point_of_surface& q : points)
          upper_bounds.back().push_back(search.distance(q));
      }
      expect_close(points, upper_bounds, Exact_graph(t), 0);
      expect_close(points, upper_bounds, Built_graph(t, parameters::epsilon(0.1)), 0.1);
      expect_close(points, upper_bounds, Lazy_graph(t, parameters::epsilon(0.1)), 0.1);
    }
}

// From and to points in faces: no more than by way of Steiner points, which are no nearer than
// real.
TEST(Lines_that_return, lead_from_and_to_points_in_faces)
{
  Random random(test_seed());
  for(const int turns : {1, 3})
  {
    const Spring spring{turns, 0.3};
    const auto t = spring.triangulation();
    const AG::Steiner_graph<> reference(t, parameters::epsilon(0.2));
    AG::Surface_search<AG::Steiner_graph<>> upper(reference);
    const Exact_graph exact_graph(t);
    AG::Surface_search<Exact_graph> exact(exact_graph);
    const Built_graph built_graph(t, parameters::epsilon(0.1));
    AG::Surface_search<Built_graph> built(built_graph);
    const Lazy_graph lazy_graph(t, parameters::epsilon(0.1));
    AG::Surface_search<Lazy_graph> lazy(lazy_graph);
    for(int i = 0; i < 20; ++i)
    {
      const Point_of_surface p = random_point(t, random);
      upper.run({{p}});
      exact.run({{p}});
      built.run({{p}});
      lazy.run({{p}});
      for(int j = 0; j < 20; ++j)
      {
        const Point_of_surface q = random_point(t, random);
        const double distance = exact.distance(q);
        EXPECT_LE(distance, upper.distance(q) * (1 + 1e-9)) << turns << " turns";
        EXPECT_LE(built.distance(q), 1.1 * (1 + 1e-6) * distance) << turns << " turns";
        EXPECT_LE(lazy.distance(q), 1.1 * (1 + 1e-6) * distance) << turns << " turns";
        EXPECT_GE(built.distance(q), distance * (1 - 1e-9)) << turns << " turns";
        EXPECT_GE(lazy.distance(q), distance * (1 - 1e-9)) << turns << " turns";
      }
    }
  }
}

} // namespace
