// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include "checks/test_random.h"
#include "meshes/test_meshes.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Surfaces that are given by lengths, where edges need not be shortest paths: a shortest path may
// cross a face again and again.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Point_of_surface = AG::Intrinsic_point;
using Exact_graph = AG::Saddle_vertex_graph;
using Lazy_graph = AG::Lazy_discrete_geodesic_graph;
using Built_graph = AG::Discrete_geodesic_graph;

AG::Intrinsic_triangulation with_lengths(Mesh mesh, const std::function<double(Edge)>& length)
{
  const auto lengths = mesh.add_property_map<Edge, double>("e:length").first;
  for(const Edge e : mesh.edges())
    lengths[e] = length(e);
  return AG::Intrinsic_triangulation(mesh, parameters::edge_length_map(lengths));
}

// A cylinder without caps, between two rings of vertices. The edges from one to the other wind
// round it, as on a spring.
struct Spring
{
  static constexpr int n = 3; // vertices of a ring, and its circumference

  static Mesh mesh()
  {
    Mesh result;
    for(int i = 0; i < 2 * n; ++i)
      result.add_vertex(Point(i % n, i / n, 0));
    for(Mesh::size_type i = 0; i < n; ++i)
    {
      const Vertex a(i), b((i + 1) % n), c(i + n), d((i + 1) % n + n);
      result.add_face(a, b, c);
      result.add_face(b, d, c);
    }
    return result;
  }

  AG::Intrinsic_triangulation triangulation() const
  {
    const Mesh m = mesh();
    return with_lengths(m, [&](const Edge e) {
      const int i = int(m.vertex(e, 0).idx()), j = int(m.vertex(e, 1).idx());
      if(i / n == j / n)
        return 1.;
      const bool is_diagonal = i % n != j % n;
      return std::hypot(turns * n - (is_diagonal ? 1 : 0), height);
    });
  }

  double distance(const int i, const int j) const
  {
    const int ahead = (j - i + 2 * n) % n;
    return std::hypot((std::min)(ahead, n - ahead), i / n == j / n ? 0 : height);
  }

  int turns;
  double height;
};

template <typename Graph>
void expect_distances(const Spring& spring, const Graph& graph, const double epsilon)
{
  const auto number = [&](const int i) {
    return graph.triangulation().vertex(static_cast<std::size_t>(i));
  };
  AG::Surface_search<Graph> search(graph);
  for(int i = 0; i < 2 * Spring::n; ++i)
  {
    search.run({{Point_of_surface::at_vertex(number(i))}});
    for(int j = 0; j < 2 * Spring::n; ++j)
    {
      const Point_of_surface target = Point_of_surface::at_vertex(number(j));
      // rounded lengths of long edges are those of a slightly different surface
      const double found = search.distance(target), expected = spring.distance(i, j);
      EXPECT_GE(found, expected * (1 - 1e-6)) << i << " to " << j;
      EXPECT_LE(found, expected * (1 + epsilon) * (1 + 1e-6)) << i << " to " << j;
      EXPECT_NEAR(search.find_path(target).length, found, 1e-6 * found);
    }
  }
}

TEST(Lines_that_return, are_found_on_springs)
{
  for(const int turns : {0, 1, 2, 3, 8, 40})
    for(const double height : {0.1, 0.3, 5.})
    {
      SCOPED_TRACE(std::to_string(turns) + " turns, height " + std::to_string(height));
      const Spring spring{turns, height};
      expect_distances(spring, Exact_graph(spring.triangulation()), 1e-9);
      for(const double epsilon : {0.5, 0.1, 0.01})
      {
        const auto np = parameters::epsilon(epsilon);
        expect_distances(spring, Built_graph(spring.triangulation(), np), epsilon);
        expect_distances(spring, Lazy_graph(spring.triangulation(), np), epsilon);
      }
    }
}

// ----- against points on edges, which know nothing of straight lines

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

// ----- spikes, round which straight lines wind for long, or for ever

template <typename Graph>
void expect_all_reached(const Graph& graph)
{
  AG::Surface_search<Graph> search(graph);
  search.run({{Point_of_surface::at_vertex(0)}});
  for(AG::Intrinsic_triangulation::Index v = 0; v < graph.triangulation().number_of_vertices(); ++v)
    EXPECT_TRUE(std::isfinite(search.distance(Point_of_surface::at_vertex(v))));
}

void expect_end(const AG::Intrinsic_triangulation& t)
{
  expect_all_reached(Exact_graph(t));
  expect_all_reached(Lazy_graph(t, parameters::epsilon(0.1)));
  expect_all_reached(Built_graph(t, parameters::epsilon(0.1)));
}

TEST(Lines_that_return, end_at_spikes)
{
  Mesh mesh = to_mesh(flat_grid(6, 6));
  const std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  const auto number_of_ground_vertices = mesh.number_of_vertices();
  for(std::size_t i = 0; i < faces.size(); i += 7)
    CGAL::Euler::add_center_vertex(mesh.halfedge(faces[i]), mesh);
  for(const double height : {1e3, 1e6, 1e9, 1e15, 1e18, 1e30, 1e100})
    expect_end(with_lengths(mesh, [&](const Edge e) {
      return mesh.vertex(e, 0).idx() >= number_of_ground_vertices ||
                     mesh.vertex(e, 1).idx() >= number_of_ground_vertices
                 ? height
                 : 1.;
    }));
}

TEST(Lines_that_return, end_between_two_tips)
{
  const Mesh mesh = to_mesh(octahedron());
  for(const double width : {0., 1e-300, 1e-12, 1e-6, 1e-3})
    expect_end(with_lengths(mesh, [&](const Edge e) {
      const auto is_tip = [&](const Vertex v) { return std::abs(mesh.point(v).z()) > 0.5; };
      return is_tip(mesh.vertex(e, 0)) || is_tip(mesh.vertex(e, 1)) ? 1. : width;
    }));
}

} // namespace
