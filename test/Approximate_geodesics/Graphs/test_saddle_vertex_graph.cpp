// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include "checks/expect_exact_distances.h"
#include "meshes/developed_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Distances and paths on surfaces where they have a closed form.

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;

// ----- the plane

// Regular ones, where lines through a vertex meet many others, and one that is not.
std::vector<Soup> flat_grids(const std::size_t columns, const std::size_t rows, Random& random)
{
  const double root = std::sqrt(3.) / 2;
  return {flat_grid(columns, rows),
          grid(columns, rows, [=](double i, double j) { return Point(i - j / 2, root * j, 0); }),
          grid(columns, rows, [=](double i, double j) { return Point(i / 3, j / 7 + i / 30, 0); }),
          grid(columns, rows, [=](double i, double j) { return Point(i + 3 * j, j, 0); }),
          grid(columns, rows, [&](const double i, const double j) {
            const double x = i > 0 && i < double(columns - 1) ? random.between(-0.2, 0.2) : 0,
                         y = j > 0 && j < double(rows - 1) ? random.between(-0.2, 0.2) : 0;
            return Point(i + x, j + y, 0);
          })};
}

TEST(Saddle_vertex_graph, is_exact_in_the_plane)
{
  Random random(test_seed());
  for(const std::size_t size : {2u, 3u, 6u, 11u, 24u})
    for(const Soup& soup : flat_grids(size, size + 1, random))
    {
      SCOPED_TRACE(size);
      Exactness(flat_surface(soup)).expect_all(random, 4);
      Exactness(without_coordinates(flat_surface(soup))).expect_all(random, 2);
    }
}

TEST(Saddle_vertex_graph, is_exact_in_a_large_plane)
{
  Random random(test_seed());
  for(const Soup& soup : flat_grids(100, 100, random))
    Exactness(flat_surface(soup)).expect_all(random, 1);
}

TEST(Saddle_vertex_graph, is_exact_in_units_of_all_sizes)
{
  Random random(test_seed());
  for(const double unit : {1e-150, 1e-30, 1 / 3., 1e10, 1e150})
    for(const Soup& soup : flat_grids(8, 7, random))
    {
      SCOPED_TRACE(unit);
      const auto scaled = [&](const Point& p) { return Point(unit * p.x(), unit * p.y(), 0); };
      Exactness(flat_surface(soup.transformed(scaled))).expect_all(random, 2);
    }
}

double distance_in_plane(const Mesh& mesh, const Vertex a, const Point& b)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(a), b));
}

// The line from the lower source crosses an edge of the face that the other one lies in, whose line
// to the corner ahead has crossed no edge.
TEST(Saddle_vertex_graph, a_source_in_a_face_hides_nothing_behind_it)
{
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(-1, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0));
  const Vertex c = mesh.add_vertex(Point(0, 1, 0)), lower = mesh.add_vertex(Point(0, -0.1, 0));
  const Vertex p = mesh.add_vertex(Point(-0.9, 0.3, 0));
  mesh.add_face(a, lower, b);
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, p);
  const Triangulation t(mesh);
  const AG::Saddle_vertex_graph graph(t);
  AG::Surface_search<AG::Saddle_vertex_graph> search(graph);
  Triangulation::Index h = t.first_halfedge(t.vertex(a));
  while(t.target(h) != t.vertex(b) || t.target(t.next(h)) != t.vertex(c))
    ++h;
  const Point inner(-0.01, 0.9, 0);
  search.run({{AG::Intrinsic_point::at_vertex(t.vertex(lower))},
              {AG::Intrinsic_point::in_face(h, 0.045, 0.9)}});
  const double expected =
      (std::min)(distance_in_plane(mesh, lower, mesh.point(p)), distance_in_plane(mesh, p, inner));
  EXPECT_NEAR(search.distance(AG::Intrinsic_point::at_vertex(t.vertex(p))), expected, 1e-14);
}

// Near to a corner, and at it but for rounding.
TEST(Saddle_vertex_graph, is_exact_from_points_next_to_a_vertex)
{
  const Mesh mesh = to_mesh(flat_grid(12, 11));
  const Triangulation t(mesh);
  const AG::Saddle_vertex_graph graph(t);
  AG::Surface_search<AG::Saddle_vertex_graph> search(graph);
  const Vertex center(5 * 12 + 6);
  const auto v = t.vertex(center);
  for(Triangulation::Index h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
    for(const double part : {1e-4, 1e-7, 1e-10, 1e-13, 1e-16, 1e-17, 1e-200, 0.})
      for(const auto& source :
          {AG::Intrinsic_point::in_face(h, part, part), AG::Intrinsic_point::on_edge(h, part),
           AG::Intrinsic_point::on_edge(t.opposite(h), 1 - part)})
      {
        SCOPED_TRACE(part);
        search.run({{source}});
        for(const Vertex w : mesh.vertices())
          EXPECT_NEAR(search.distance(AG::Intrinsic_point::at_vertex(t.vertex(w))),
                      distance_in_plane(mesh, w, mesh.point(center)), 3 * part + 1e-13);
      }
}

// ----- cones

TEST(Saddle_vertex_graph, is_exact_on_cones)
{
  Random random(test_seed());
  for(const Long angle : {Long(0.3), Long(1), Long(3), long_pi(), Long(5), Long(6.28),
                          2 * long_pi(), Long(6.2832), Long(7), 3 * long_pi(), Long(12), Long(40)})
    for(const std::size_t rings : {1u, 2u, 7u})
      for(const double jitter : {0., 0.2})
      {
        SCOPED_TRACE(testing::Message() << angle << ' ' << rings << ' ' << jitter);
        Exactness(cone(rings, angle, jitter, random)).expect_all(random, 3);
      }
}

TEST(Saddle_vertex_graph, is_exact_on_cones_of_many_rings)
{
  Random random(test_seed());
  for(const Long angle : {Long(2), Long(8)})
    Exactness(cone(60, angle, 0.2, random)).expect_all(random, 2);
}

// ----- what is rolled up

TEST(Saddle_vertex_graph, is_exact_on_cylinders)
{
  Random random(test_seed());
  for(const double height : {0.1, 1., 2.7})
    for(const std::size_t columns : {3u, 5u, 16u})
      Exactness(cylinder(columns, 9, 1, height, random)).expect_all(random, 4);
}

TEST(Saddle_vertex_graph, is_exact_on_flat_tori)
{
  Random random(test_seed());
  for(const Place& v : {Place{0, 1}, Place{0.5L, std::sqrt(Long(3)) / 2}, Place{0.3L, 2.2L}})
    for(const std::size_t rows : {3u, 8u, 15u})
      Exactness(flat_torus(12, rows, {1, 0}, v, random)).expect_all(random, 4);
}

TEST(Saddle_vertex_graph, is_exact_on_envelopes)
{
  Random random(test_seed());
  for(const std::size_t columns : {2u, 4u, 9u})
    Exactness(envelope(columns, 7, random)).expect_all(random, 5);
}

} // namespace
