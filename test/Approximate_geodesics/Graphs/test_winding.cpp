// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include "meshes/test_meshes.h"
#include "surfaces/springs.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Point_of_surface = AG::Intrinsic_point;
using Exact_graph = AG::Saddle_vertex_graph;
using Lazy_graph = AG::Lazy_discrete_geodesic_graph;
using Built_graph = AG::Discrete_geodesic_graph;

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
