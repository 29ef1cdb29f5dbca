// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/sample_meshes.h"
#include "meshes/surface_points.h"
#include "oracles/exact_distances.h"
#include "oracles/test_oracles.h"
#include "paths/Kinds_on_path.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Beside CGAL's exact class: the same program does the same with either class, and no distance is
// below the exact one.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using Our_exact_paths = AG::Surface_mesh_shortest_path<Mesh>; // only header and type differ
using Our_paths_across_faces = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;

constexpr double TOLERANCE = 1e-6; // lengths of arcs may be rounded up to a `float`

template <typename Shortest_paths>
class Both : public testing::Test
{
protected:
  Both() : m_mesh(make_mesh()), m_paths(m_mesh) {}

  static Mesh make_mesh()
  {
    Soup soup = flat_grid(6, 5);
    soup.append(flat_grid(3, 3)); // which no path leads to
    return to_mesh(soup);
  }

  Face_location at(const double x, const double y) const
  {
    return location_at(m_mesh, Point(x, y, 0));
  }

  double distance(const Face_location& p)
  {
    return m_paths.shortest_distance_to_source_points(p.first, p.second).first;
  }
  double distance(const Vertex v) { return m_paths.shortest_distance_to_source_points(v).first; }

  std::string kinds_on_path(const Face_location& p)
  {
    Kinds_on_path result;
    m_paths.shortest_path_sequence_to_source_points(p.first, p.second, result);
    return result.kinds;
  }

  const Mesh m_mesh;
  Shortest_paths m_paths;
};
struct Names_of_classes
{
  template <typename Shortest_paths>
  static std::string GetName(int)
  {
    return std::is_same_v<Shortest_paths, Exact_shortest_paths> ? "exact"
           : std::is_same_v<Shortest_paths, Our_exact_paths>    ? "ours"
                                                                : "ours_across_faces";
  }
};
using Classes = testing::Types<Our_exact_paths, Our_paths_across_faces, Exact_shortest_paths>;
TYPED_TEST_SUITE(Both, Classes, Names_of_classes);

TYPED_TEST(Both, keep_iterators_valid)
{
  std::vector<Face_location> places;
  std::vector<typename TypeParam::Source_point_iterator> iterators;
  Random random(test_seed());
  for(int i = 0; i < 20; ++i)
  {
    places.push_back(random_face_location(this->m_mesh, random));
    iterators.push_back(this->m_paths.add_source_point(places.back()));
    this->m_paths.build_sequence_tree();
  }
  for(std::size_t i = 0; i < places.size(); i += 2)
    this->m_paths.remove_source_point(iterators[i]);
  EXPECT_EQ(this->m_paths.number_of_source_points(), 10u);
  auto it = this->m_paths.source_points_begin();
  for(std::size_t i = 1; i < places.size(); i += 2, ++it)
  {
    EXPECT_TRUE(it == iterators[i]);
    EXPECT_EQ(iterators[i]->first, places[i].first);
    EXPECT_EQ(iterators[i]->second, places[i].second);
    EXPECT_NEAR(this->distance(places[i]), 0, 1e-7);
  }
  EXPECT_TRUE(it == this->m_paths.source_points_end());
}

TYPED_TEST(Both, say_when_sources_have_changed)
{
  const auto first = this->m_paths.add_source_point(this->at(0.3, 0.2));
  EXPECT_TRUE(this->m_paths.changed_since_last_build());
  this->m_paths.build_sequence_tree();
  EXPECT_FALSE(this->m_paths.changed_since_last_build());
  this->distance(this->at(3.3, 1.2));
  EXPECT_FALSE(this->m_paths.changed_since_last_build());
  this->m_paths.add_source_point(this->at(2.3, 0.2));
  EXPECT_TRUE(this->m_paths.changed_since_last_build());
  this->distance(this->at(3.3, 1.2)); // builds
  EXPECT_FALSE(this->m_paths.changed_since_last_build());
  this->m_paths.remove_source_point(first);
  EXPECT_TRUE(this->m_paths.changed_since_last_build());
  this->m_paths.clear();
  EXPECT_FALSE(this->m_paths.changed_since_last_build());
  EXPECT_EQ(this->m_paths.number_of_source_points(), 0u);
}

TYPED_TEST(Both, take_ranges_of_places)
{
  const std::vector<Face_location> places = {this->at(0.3, 0.2), this->at(4.7, 3.4)};
  const auto first = this->m_paths.add_source_points(places.begin(), places.end());
  EXPECT_TRUE(first == this->m_paths.source_points_begin());
  const Face_location near_first = this->at(0.5, 0.3), near_second = this->at(4.5, 3.2);
  const auto [distance, source] =
      this->m_paths.shortest_distance_to_source_points(near_first.first, near_first.second);
  EXPECT_NEAR(distance, std::hypot(0.2, 0.1), TOLERANCE);
  EXPECT_TRUE(source == first);
  const auto [other_distance, other_source] =
      this->m_paths.shortest_distance_to_source_points(near_second.first, near_second.second);
  EXPECT_NEAR(other_distance, std::hypot(0.2, 0.2), TOLERANCE);
  EXPECT_FALSE(other_source == first);
}

TYPED_TEST(Both, add_and_remove_vertices)
{
  const std::vector<Vertex> vertices = {Vertex(0), Vertex(5), Vertex(24)};
  const auto first = this->m_paths.add_source_points(vertices.begin(), vertices.end());
  EXPECT_EQ(this->m_paths.number_of_source_points(), 3u);
  EXPECT_TRUE(first == this->m_paths.source_points_begin());
  auto second = first; // the exact class's iterator does not tell its difference type
  ++second;
  auto last = second;
  ++last;
  EXPECT_TRUE(++last == this->m_paths.source_points_end());
  EXPECT_EQ(this->distance(Vertex(0)), 0);
  const auto [distance, source] = this->m_paths.shortest_distance_to_source_points(Vertex(4));
  EXPECT_NEAR(distance, 1, TOLERANCE);
  EXPECT_TRUE(source == second);

  this->m_paths.remove_source_point(second);
  EXPECT_EQ(this->m_paths.number_of_source_points(), 2u);
  const auto [other_distance, other_source] =
      this->m_paths.shortest_distance_to_source_points(Vertex(4));
  EXPECT_NEAR(other_distance, 4, TOLERANCE);
  EXPECT_TRUE(other_source == first);

  this->m_paths.remove_all_source_points();
  EXPECT_EQ(this->m_paths.number_of_source_points(), 0u);
  EXPECT_LT(this->distance(Vertex(4)), 0);
  this->m_paths.clear();
  this->m_paths.add_source_point(Vertex(3));
  EXPECT_NEAR(this->distance(Vertex(4)), 1, TOLERANCE);
}

TYPED_TEST(Both, show_sources_as_places_in_faces)
{
  for(const Vertex v : this->m_mesh.vertices())
  {
    const auto it = this->m_paths.add_source_point(v);
    const auto& [face, weights] = *it;
    ASSERT_NE(face, Mesh::null_face());
    Halfedge h = this->m_mesh.halfedge(face);
    for(const double weight : weights)
    {
      EXPECT_EQ(weight, this->m_mesh.source(h) == v ? 1 : 0);
      h = this->m_mesh.next(h);
    }
  }
}

TYPED_TEST(Both, say_when_there_is_no_path)
{
  this->m_paths.add_source_point(Vertex(0));
  std::vector<Point> points;
  Kinds_on_path visited;
  const Vertex elsewhere(32);
  const auto [length, source] =
      this->m_paths.shortest_path_points_to_source_points(elsewhere, std::back_inserter(points));
  EXPECT_LT(length, 0);
  EXPECT_TRUE(source == this->m_paths.source_points_end());
  EXPECT_TRUE(points.empty());
  this->m_paths.shortest_path_sequence_to_source_points(elsewhere, visited);
  EXPECT_EQ(visited.kinds, "");
  EXPECT_LT(this->distance(elsewhere), 0);
}

TYPED_TEST(Both, give_paths_between_vertices)
{
  const auto source = this->m_paths.add_source_point(Vertex(1));
  std::vector<Point> points;
  const auto [length, it] =
      this->m_paths.shortest_path_points_to_source_points(Vertex(4), std::back_inserter(points));
  EXPECT_NEAR(length, 3, TOLERANCE);
  EXPECT_TRUE(it == source);
  ASSERT_GE(points.size(), 2u);
  EXPECT_EQ(points.front(), Point(4, 0, 0));
  EXPECT_EQ(points.back(), Point(1, 0, 0));

  Kinds_on_path visited;
  EXPECT_NEAR(this->m_paths.shortest_path_sequence_to_source_points(Vertex(4), visited).first, 3,
              TOLERANCE);
  ASSERT_GE(visited.vertices.size(), 2u);
  EXPECT_EQ(visited.vertices.front(), Vertex(4));
  EXPECT_EQ(visited.vertices.back(), Vertex(1));
}

TYPED_TEST(Both, give_paths_from_query_to_source)
{
  const auto source = this->m_paths.add_source_point(this->at(1.7, 1.2));
  const Face_location query = this->at(1.2, 1.7);
  std::vector<Point> points;
  const auto [length, it] = this->m_paths.shortest_path_points_to_source_points(
      query.first, query.second, std::back_inserter(points));
  EXPECT_NEAR(length, std::sqrt(0.5), TOLERANCE);
  EXPECT_TRUE(it == source);
  ASSERT_EQ(points.size(), 3u);
  for(const auto& [found, expected] :
      {std::pair(points[0], Point(1.2, 1.7, 0)), std::pair(points[1], Point(1.45, 1.45, 0)),
       std::pair(points[2], Point(1.7, 1.2, 0))})
    EXPECT_LE(distance_in_space(found, expected), 1e-9);
}

TYPED_TEST(Both, tell_visitors_kinds_in_order)
{
  this->m_paths.add_source_point(this->at(1.7, 1.2));
  EXPECT_EQ(this->kinds_on_path(this->at(1.2, 1.7)), "fef");
  EXPECT_EQ(this->kinds_on_path(this->at(1.6, 1.3)), "ff");
  Kinds_on_path from_vertex;
  this->m_paths.shortest_path_sequence_to_source_points(Vertex(7), from_vertex); // (1, 1)
  EXPECT_EQ(from_vertex.kinds, "vf");
}

TYPED_TEST(Both, compute_points_and_places)
{
  const TypeParam& paths = this->m_paths;
  const Mesh& mesh = this->m_mesh;
  const auto expect_at = [](const Point& found, const Point& expected) {
    EXPECT_LE(distance_in_space(found, expected), 1e-15);
  };
  const std::array<double, 3> weights = {0.5, 0.2, 0.3};
  for(const Face f : mesh.faces())
  {
    const Point expected = position(mesh, Face_location(f, weights));
    expect_at(paths.point(f, weights), expected);
    expect_at(TypeParam::point(f, weights, mesh), expected);
    expect_at(TypeParam::point(f, weights, mesh, mesh.points()), expected);
  }
  for(const Halfedge h : mesh.halfedges())
  {
    const Point expected = position(mesh, Edge_location(h, 0.2));
    expect_at(paths.point(h, 0.2), expected);
    expect_at(TypeParam::point(h, 0.2, mesh), expected);
    expect_at(TypeParam::point(h, 0.2, mesh, mesh.points()), expected);
    if(mesh.is_border(h))
      continue;
    expect_at(position(mesh, paths.face_location(h, 0.2)), expected);
    EXPECT_EQ(TypeParam::face_location(h, 0.2, mesh), paths.face_location(h, 0.2));
    EXPECT_EQ(paths.face_location(h, 0.2).first, mesh.face(h));
  }
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_EQ(paths.point(v), mesh.point(v));
    EXPECT_EQ(TypeParam::point(v, mesh), mesh.point(v));
    EXPECT_EQ(position(mesh, paths.face_location(v)), mesh.point(v));
    EXPECT_EQ(TypeParam::face_location(v, mesh), paths.face_location(v));
  }
}

// ----- lengths

TEST(Our_class, is_exact_if_no_graph_is_named)
{
  Random random(test_seed());
  for(const Soup& soup : {flat_grid(9, 7), terrain(14, 11, random), sphere(16, 11), fan(30, 2)})
  {
    const Mesh mesh = to_mesh(soup);
    const Vertex source(static_cast<Mesh::size_type>(random.below(mesh.number_of_vertices())));
    const std::vector<double> exact = exact_distances(mesh, source);
    Our_exact_paths paths(mesh);
    paths.add_source_point(source);
    for(const Vertex v : mesh.vertices())
    {
      std::vector<Point> points;
      EXPECT_NEAR(paths.shortest_distance_to_source_points(v).first, exact[v.idx()],
                  1e-9 * exact[v.idx()]);
      EXPECT_NEAR(paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first,
                  exact[v.idx()], 1e-9 * exact[v.idx()]);
    }
  }
}

// Never below the distances along the surface, of which the exact class has a rounding error.
void expect_not_below_exact(const Mesh& mesh, const Vertex source)
{
  Mesh_search search(mesh);
  const std::vector<double> found = search.distances({source});
  const std::vector<double> exact = exact_distances(mesh, source);
  for(const Vertex v : mesh.vertices())
  {
    if(mesh.is_isolated(v))
      continue;
    EXPECT_EQ(found[v.idx()] == infinity, exact[v.idx()] == infinity) << v;
    EXPECT_GE(found[v.idx()], exact[v.idx()] * (1 - 1e-12)) << v;
  }
}

TEST(Distances, are_not_below_the_exact_ones_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name :
      {"tetrahedron.off", "icosahedron.off", "cube-meshed.off", "eight.off", "elephant.off",
       "head.off", "sphere.off", "mesh_with_border.off", "mushroom.off", "cactus.off", "plane.off",
       "pinion.off", "rotor.off", "hand.off", "elk.off", "holes.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_GT(mesh.number_of_faces(), 0u);
    ASSERT_LT(mesh.number_of_vertices(), 5000u);
    expect_not_below_exact(mesh, *mesh.vertices_begin());
  }
}

TEST(Distances, are_not_below_the_exact_ones_on_generated_meshes)
{
  Random random(test_seed());
  expect_not_below_exact(to_mesh(terrain(20, 15, random)), Vertex(7));
  expect_not_below_exact(to_mesh(sphere(16, 11)), Vertex(0));
  expect_not_below_exact(to_mesh(fan(30, 2)), Vertex(3));
}

} // namespace
