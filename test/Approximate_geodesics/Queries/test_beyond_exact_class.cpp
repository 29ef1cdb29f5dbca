// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/surface_points.h"
#include "paths/Kinds_on_path.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

// What the class can do with points in faces, and the exact one cannot.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Our_shortest_paths = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;

TEST(Our_class, tells_points_of_edges_and_corners_as_such)
{
  const Mesh mesh = to_mesh(flat_grid(6, 5));
  Our_shortest_paths paths(mesh);
  paths.add_source_point(location_at(mesh, Point(1.5, 1.5, 0))); // on a diagonal
  const auto kinds = [&](const Point& p) {
    Kinds_on_path result;
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
