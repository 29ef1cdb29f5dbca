// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

// Small meshes that programs for shortest paths have got wrong. They are searched along edges, and
// across faces.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

template <typename Graph>
class Known_traps : public testing::Test
{
protected:
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Graph>;

  // The edge graph knows no paths across faces, so that distances can be larger there.
  static constexpr bool crosses_faces = std::is_same_v<Graph, AG::Discrete_geodesic_graph>;

  // Lengths of arcs may be rounded up to a `float`.
  static constexpr double TOLERANCE = 1e-6;

  static void expect_near(const double found, const double expected)
  {
    EXPECT_NEAR(found, expected, TOLERANCE * expected);
  }

  static double distance(Paths& paths, const Surface_point& p)
  {
    return paths.shortest_distance_to_source_points(p).first;
  }

  static std::vector<Surface_point> path(Paths& paths, const Surface_point& p)
  {
    std::vector<Surface_point> result;
    paths.shortest_path_surface_points_to_source_points(p, std::back_inserter(result));
    return result;
  }

  // Every step leads on, and stays on the surface.
  static void expect_sound(const Mesh& mesh, const std::vector<Surface_point>& points)
  {
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      EXPECT_TRUE(share_a_face(mesh, points[i - 1], points[i]));
      EXPECT_NE(position(mesh, points[i - 1]), position(mesh, points[i]));
    }
  }
};

struct Names_of_graphs
{
  template <typename Graph>
  static std::string GetName(int)
  {
    return std::is_same_v<Graph, AG::Edge_graph> ? "along_edges" : "across_faces";
  }
};
using Graphs = testing::Types<AG::Edge_graph, AG::Discrete_geodesic_graph>;
TYPED_TEST_SUITE(Known_traps, Graphs, Names_of_graphs);

// Of two triangles, as they are found in a square.
Mesh square()
{
  return to_mesh(
      {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}});
}

// Source and query lie inside the same edge: the way is along that, and not by way of its ends.
TYPED_TEST(Known_traps, source_and_query_on_the_same_edge)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  typename TestFixture::Paths paths(mesh);
  for(const Halfedge h : mesh.halfedges())
  {
    paths.remove_all_source_points();
    paths.add_source_point(Edge_location(h, 0.2));
    const double length = distance_in_space(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    this->expect_near(this->distance(paths, Edge_location(h, 0.9)), 0.7 * length);
    this->expect_near(this->distance(paths, Edge_location(mesh.opposite(h), 0.7)), 0.1 * length);
    EXPECT_NEAR(this->distance(paths, Edge_location(mesh.opposite(h), 0.8)), 0, 1e-15);
    EXPECT_EQ(this->path(paths, Edge_location(h, 0.9)).size(), 2u);
  }
}

// The target is on an edge at the border, from either side of which it can be named.
TYPED_TEST(Known_traps, target_on_a_border_edge)
{
  const Mesh mesh = square();
  typename TestFixture::Paths paths(mesh);
  paths.add_source_point(Vertex(3));
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h) || mesh.is_border(mesh.opposite(h)))
    {
      const Surface_point target = Edge_location(h, 0.25);
      const double straight = distance_in_space(position(mesh, target), mesh.point(Vertex(3)));
      const double found = this->distance(paths, target);
      EXPECT_GE(found, straight * (1 - 1e-12));
      EXPECT_LE(found, straight * (this->crosses_faces ? 1.1 : 2));
      const std::vector<Surface_point> points = this->path(paths, target);
      ASSERT_GE(points.size(), 2u);
      this->expect_sound(mesh, points);
    }
}

// Around a notch in an open mesh: the path has to go on along a vertex of the border.
TYPED_TEST(Known_traps, path_along_a_border_vertex)
{
  Soup soup = flat_grid(5, 5);
  const auto is_in_notch = [&](const std::array<std::size_t, 3>& t) { // above (2, 2)
    double x = 0, y = 0;
    for(const std::size_t i : t)
    {
      x += soup.points[i].x() / 3;
      y += soup.points[i].y() / 3;
    }
    return x > 1 && x < 3 && y > 2;
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_in_notch),
                       soup.triangles.end());
  const Mesh mesh = to_mesh(soup);
  typename TestFixture::Paths paths(mesh);
  paths.add_source_point(location_at(mesh, Point(0.9, 3.9, 0)));
  const Face_location target = location_at(mesh, Point(3.1, 3.9, 0));
  const double taut = 2 * std::hypot(0.1, 1.9) + 2; // over (1, 2) and (3, 2)
  const double found = this->distance(paths, target);
  EXPECT_GE(found, taut * (1 - 1e-12));
  EXPECT_LE(found, taut * 1.1);
  const std::vector<Surface_point> points = this->path(paths, target);
  this->expect_sound(mesh, points);
  for(const Point& corner : {Point(1, 2, 0), Point(3, 2, 0)})
    EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                            [&](const Surface_point& p) { return position(mesh, p) == corner; }));
}

// Isolated vertices, first and last: no halfedge leads to them.
TYPED_TEST(Known_traps, isolated_vertices)
{
  Soup soup{{Point(9, 9, 9)}, {}};
  soup.append(flat_grid(3, 3));
  soup.points.push_back(Point(8, 8, 8));
  const Mesh mesh = to_mesh(soup);
  typename TestFixture::Paths paths(mesh);
  paths.add_source_point(Vertex(1));
  for(const Vertex isolated : {Vertex(0), Vertex(10)})
  {
    EXPECT_EQ(paths.shortest_distance_to_source_points(isolated).first, -1);
    EXPECT_TRUE(this->path(paths, isolated).empty());
  }
  this->expect_near(this->distance(paths, Vertex(3)), 2);
  const auto isolated = paths.add_source_point(Vertex(0));
  EXPECT_EQ(isolated->first, Mesh::null_face());
  EXPECT_EQ(this->distance(paths, Vertex(0)), 0);
  this->expect_near(this->distance(paths, Vertex(3)), 2);
}

// Property maps that are temporary objects, and gone when the search is run.
TYPED_TEST(Known_traps, temporary_property_maps)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const auto make_index_map = [&] {
    return boost::make_function_property_map<Vertex>(
        [indices = std::vector<std::size_t>(16, 3)](const Vertex v) {
          return indices[v.idx()] + v.idx() - 3;
        });
  };
  const auto make_point_map = [&] {
    return boost::make_function_property_map<Vertex>(
        [points = std::vector<Point>(mesh.points().begin(), mesh.points().end())](const Vertex v) {
          return points[v.idx()];
        });
  };
  typename TestFixture::Paths paths(
      mesh, parameters::vertex_index_map(make_index_map()).vertex_point_map(make_point_map()));
  paths.add_source_point(Vertex(0));
  std::vector<Point> points;
  const double length =
      paths.shortest_path_points_to_source_points(Vertex(12), std::back_inserter(points)).first;
  this->expect_near(length, 3);
  EXPECT_EQ(points.front(), Point(0, 3, 0));
  EXPECT_EQ(points.back(), Point(0, 0, 0));
}

// Two triangles, and a source inside a border edge: to both ends of that, it is half of it.
TYPED_TEST(Known_traps, source_in_a_border_edge)
{
  const Mesh mesh = square();
  typename TestFixture::Paths paths(mesh);
  for(const Halfedge h : mesh.halfedges())
  {
    paths.remove_all_source_points();
    paths.add_source_point(Edge_location(h, 0.5));
    const double half =
        0.5 * distance_in_space(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    this->expect_near(this->distance(paths, mesh.source(h)), half);
    this->expect_near(this->distance(paths, mesh.target(h)), half);
    paths.remove_all_source_points();
    paths.add_source_point(Edge_location(h, 0.25));
    this->expect_near(this->distance(paths, mesh.source(h)), half / 2);
    this->expect_near(this->distance(paths, mesh.target(h)), half * 3 / 2);
  }
}

// Three sources next to each other: each of them has distance zero, to itself, and hides nothing.
TYPED_TEST(Known_traps, neighbors_as_sources)
{
  const Mesh mesh = to_mesh(flat_grid(6, 6));
  typename TestFixture::Paths paths(mesh);
  for(const Face f : mesh.faces())
  {
    paths.remove_all_source_points();
    std::vector<Vertex> sources;
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      sources.push_back(v);
    paths.add_source_points(sources.begin(), sources.end());
    auto it = paths.source_points_begin();
    for(const Vertex v : sources)
    {
      EXPECT_EQ(paths.shortest_distance_to_source_points(v).first, 0);
      EXPECT_TRUE(paths.shortest_distance_to_source_points(v).second == it++);
      EXPECT_EQ(this->path(paths, v).size(), 1u);
    }
    for(const Vertex v : mesh.vertices())
    {
      double straight = infinity;
      for(const Vertex s : sources)
        straight = (std::min)(straight, distance_in_space(mesh.point(v), mesh.point(s)));
      EXPECT_GE(this->distance(paths, v), straight * (1 - 1e-12));
      EXPECT_LE(this->distance(paths, v), straight * (this->crosses_faces ? 1.1 : 1.5));
    }
  }
}

// A bathtub with flat walls, a frontier and a plug that does not touch it: from the plug there is
// no path to the tub, and no path has the same point twice, or one off the surface.
TYPED_TEST(Known_traps, bathtub_with_a_plug)
{
  Soup soup = grid(13, 13, [](const double i, const double j) {
    const double depth =
        (std::min)((std::min)(i, j), (std::min)(12 - i, 12 - j)); // from the frontier
    return Point(i, j, depth < 2 ? 4 : (std::max)(0., 4 - 2 * (depth - 1)));
  });
  soup.append(
      flat_grid(3, 3).transformed([](const Point& p) { return Point(5 + p.x(), 5 + p.y(), 0); }));
  const Mesh mesh = to_mesh(soup);
  const Vertex in_plug(13 * 13 + 4);
  typename TestFixture::Paths paths(mesh);
  Random random(test_seed());
  for(int i = 0; i < 10; ++i)
  {
    paths.remove_all_source_points();
    paths.add_source_point(Vertex(static_cast<Mesh::size_type>(random.below(13 * 13))));
    EXPECT_EQ(paths.shortest_distance_to_source_points(in_plug).first, -1);
    EXPECT_TRUE(this->path(paths, in_plug).empty());
    for(Mesh::size_type v = 0; v < 13 * 13; ++v)
    {
      const std::vector<Surface_point> points = this->path(paths, Vertex(v));
      EXPECT_FALSE(points.empty());
      this->expect_sound(mesh, points);
    }
  }
}

// A point that was found at a vertex has weights like 1 and -5.6e-17. It is the vertex.
TYPED_TEST(Known_traps, negative_weights_by_rounding)
{
  const Mesh mesh = to_mesh(sphere(8, 5));
  typename TestFixture::Paths paths(mesh);
  for(const Face f : mesh.faces())
    for(const std::array<double, 3>& weights : {std::array<double, 3>{1, -5.6e-17, 0},
                                                {1 - 1e-16, 1e-16, -5.6e-17},
                                                {1 + 1e-15, -1e-15, 0}})
    {
      const Vertex v = mesh.source(mesh.halfedge(f));
      paths.remove_all_source_points();
      paths.add_source_point(f, weights);
      EXPECT_EQ(paths.shortest_distance_to_source_points(v).first, 0);
      paths.remove_all_source_points();
      paths.add_source_point(v);
      EXPECT_EQ(paths.shortest_distance_to_source_points(f, weights).first, 0);
      EXPECT_EQ(this->path(paths, Face_location(f, weights)).size(), 1u);
    }
}

// A point in a face without area lies on the longest side of that, and looks out of it straight.
TYPED_TEST(Known_traps, face_without_area)
{
  const Mesh mesh = to_mesh(
      {{Point(0, 0, 0), Point(2, 0, 0), Point(1, 0, 0), Point(1, -1, 0)}, {{0, 1, 2}, {1, 0, 3}}});
  typename TestFixture::Paths paths(mesh);
  const Point p(0.8, 0, 0);
  const auto h = mesh.halfedge(Face(0));
  std::array<double, 3> weights{};
  const std::array<double, 3> weight_of_vertex{0.45, 0.25, 0.3};
  weights[0] = weight_of_vertex[mesh.source(h).idx()];
  weights[1] = weight_of_vertex[mesh.target(h).idx()];
  weights[2] = weight_of_vertex[mesh.target(mesh.next(h)).idx()];
  paths.add_source_point(Face(0), weights);
  const double exact = distance_in_space(p, mesh.point(Vertex(3)));
  EXPECT_GE(this->distance(paths, Vertex(3)), exact * (1 - 1e-12));
  EXPECT_LE(this->distance(paths, Vertex(3)), exact * (TestFixture::crosses_faces ? 1.1 : 2.5));
}

// A straight line next to an edge, which it crosses close to its end. Where exactly it does so is
// hard to say, but the path must not go beyond its end and come back.
TYPED_TEST(Known_traps, line_beside_an_edge)
{
  const Mesh mesh = necklace(1);
  typename TestFixture::Paths paths(mesh);
  paths.add_source_point(Edge_location(Halfedge(5), 0.51385994793987544));
  const Face_location query(Face(1), {1e-12, 0.4867521621088059, 0.51324783789019413});
  const std::vector<Surface_point> points = this->path(paths, query);
  EXPECT_NEAR(length_of(mesh, points), this->distance(paths, query), 1e-12);
}

} // namespace
