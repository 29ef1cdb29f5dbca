// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/surface_points.h"
#include "oracles/exact_distances.h"

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
#include <variant>
#include <vector>

// The interface of CGAL's exact class, where it is about any points of the surface: the same
// program does the same with either class.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Our_shortest_paths = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;

constexpr double TOLERANCE = 1e-6; // lengths of arcs may be rounded up to a `float`

// Remembers what a path goes through, a letter for each.
struct Kinds
{
  void operator()(const Vertex) { kinds += 'v'; }
  void operator()(const Halfedge, const double t)
  {
    EXPECT_GE(t, 0);
    EXPECT_LE(t, 1);
    kinds += 'e';
  }
  void operator()(const Face, const std::array<double, 3>&) { kinds += 'f'; }

  std::string kinds = {};
};

template <typename Shortest_paths>
class Both : public testing::Test
{
protected:
  Both() : m_paths(m_mesh) {}

  Face_location at(const double x, const double y) const
  {
    return location_at(m_mesh, Point(x, y, 0));
  }

  double distance(const Face_location& p)
  {
    return m_paths.shortest_distance_to_source_points(p.first, p.second).first;
  }

  std::string kinds_on_path(const Face_location& p)
  {
    Kinds result;
    m_paths.shortest_path_sequence_to_source_points(p.first, p.second, result);
    return result.kinds;
  }

  const Mesh m_mesh = to_mesh(flat_grid(6, 5));
  Shortest_paths m_paths;
};
struct Names_of_classes
{
  template <typename Shortest_paths>
  static std::string GetName(int)
  {
    return std::is_same_v<Shortest_paths, Exact_shortest_paths> ? "exact" : "ours";
  }
};
using Classes = testing::Types<Our_shortest_paths, Exact_shortest_paths>;
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
  Kinds from_vertex;
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

// ----- what the exact class has not

TEST(Our_class, tells_points_of_edges_and_corners_as_such)
{
  const Mesh mesh = to_mesh(flat_grid(6, 5));
  Our_shortest_paths paths(mesh);
  paths.add_source_point(location_at(mesh, Point(1.5, 1.5, 0))); // on a diagonal
  const auto kinds = [&](const Point& p) {
    Kinds result;
    const auto [f, weights] = location_at(mesh, p);
    paths.shortest_path_sequence_to_source_points(f, weights, result);
    return result.kinds;
  };
  EXPECT_EQ(kinds(Point(1.5, 1.5, 0)), "e");
  EXPECT_EQ(kinds(Point(1.75, 1.75, 0)), "ee");
  EXPECT_EQ(kinds(Point(1, 1.5, 0)), "ee");
  EXPECT_EQ(kinds(Point(2, 2, 0)), "ve");
  EXPECT_EQ(kinds(Point(1.6, 1.2, 0)), "fe");
}

// A border halfedge has no face to its left.
TEST(Our_class, finds_places_on_border_halfedges)
{
  const Mesh mesh = to_mesh(flat_grid(4, 3));
  const Our_shortest_paths paths(mesh);
  for(const Halfedge h : mesh.halfedges())
  {
    const Face_location found = paths.face_location(h, 0.25);
    ASSERT_NE(found.first, Mesh::null_face());
    EXPECT_LE(distance_in_space(position(mesh, found), position(mesh, Edge_location(h, 0.25))),
              1e-15);
  }
}

// A run with targets ends as soon as their distances are certain, and these are those of a full
// run.
TEST(Our_class, ends_a_run_at_targets_in_faces)
{
  const Mesh mesh = to_mesh(flat_grid(60, 60));
  Our_shortest_paths paths(mesh);
  paths.add_source_point(location_at(mesh, Point(20.4, 20.3, 0)));
  const std::vector<Surface_point> targets = {location_at(mesh, Point(24.3, 21.7, 0)),
                                              location_at(mesh, Point(17.5, 22, 0)), Vertex(1221)};
  const Surface_point far_away = location_at(mesh, Point(57.2, 55.1, 0));
  const auto distance = [&](const Surface_point& p) {
    return paths.shortest_distance_to_source_points(p).first;
  };
  std::vector<double> expected;
  for(const Surface_point& p : targets)
    expected.push_back(distance(p));
  const double expected_far_away = distance(far_away);
  EXPECT_GE(paths.search().reached_nodes().size(), mesh.number_of_vertices());

  paths.build_sequence_tree(parameters::targets(targets));
  EXPECT_FALSE(paths.changed_since_last_build());
  EXPECT_LT(paths.search().reached_nodes().size(), mesh.number_of_vertices() / 10);
  for(std::size_t i = 0; i < targets.size(); ++i)
    EXPECT_EQ(distance(targets[i]), expected[i]);
  EXPECT_EQ(distance(far_away), -1);

  const std::vector<Face_location> places = {std::get<Face_location>(far_away)};
  paths.build_sequence_tree(parameters::targets(places));
  EXPECT_EQ(distance(far_away), expected_far_away);
}

// A target that cannot be reached does not keep the run from its end.
TEST(Our_class, ends_a_run_without_a_way_to_a_target)
{
  Soup soup = flat_grid(4, 4);
  soup.append(flat_grid(3, 3));
  const Mesh mesh = to_mesh(soup);
  Our_shortest_paths paths(mesh);
  paths.add_source_point(Vertex(0));
  const Face on_island(18);
  const std::vector<Face_location> targets = {{on_island, {0.3, 0.3, 0.4}}};
  paths.build_sequence_tree(parameters::targets(targets));
  EXPECT_EQ(paths.shortest_distance_to_source_points(targets[0]).first, -1);
  EXPECT_EQ(paths.search().reached_nodes().size(), 16u);
}

// No place beyond the maximum distance is reached, on whichever way.
TEST(Our_class, ends_a_run_at_a_distance)
{
  const Mesh mesh = to_mesh(flat_grid(20, 20));
  Our_shortest_paths paths(mesh);
  const Face_location source = location_at(mesh, Point(7.4, 7.2, 0));
  paths.add_source_point(source);
  Random random(test_seed());
  for(const double limit : {0., 0.3, 3.})
  {
    for(const Surface_point& p : random_surface_points(mesh, 200, random))
    {
      paths.build_sequence_tree(parameters::default_values());
      const double expected = paths.shortest_distance_to_source_points(p).first;
      paths.build_sequence_tree(parameters::maximum_distance(limit));
      EXPECT_EQ(paths.shortest_distance_to_source_points(p).first,
                expected <= limit ? expected : -1);
    }
    EXPECT_EQ(paths.shortest_distance_to_source_points(source).first, 0);
  }
}

} // namespace
