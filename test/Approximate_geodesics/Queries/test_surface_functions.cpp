// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/functions_and_class.h"
#include "meshes/for_generated_meshes.h"
#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST(Surface_functions, find_the_distances_that_the_class_finds)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    expect_same_distances_as_class<AG::Edge_graph>(mesh, random, parameters::default_values());
    expect_same_distances_as_class<AG::Lazy_discrete_geodesic_graph>(mesh, random,
                                                                     parameters::epsilon(0.2));
  });
}

TEST(Surface_functions, find_the_paths_that_the_class_finds)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    expect_same_paths_as_class<AG::Edge_graph>(mesh, random, parameters::default_values());
    expect_same_paths_as_class<AG::Lazy_discrete_geodesic_graph>(mesh, random,
                                                                 parameters::epsilon(0.2));
  });
}

TEST(Surface_functions, start_at_initial_distances)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(15, 12, random));
  const std::vector<Surface_point> sources = random_surface_points(mesh, 6, random);
  std::vector<double> initial;
  std::vector<double> expected(mesh.num_vertices(), infinity);
  for(const Surface_point& source : sources)
  {
    initial.push_back(random.between(0, 4));
    std::vector<double> single = distances_by_function(mesh, source);
    for(double& d : single)
      d += initial.back();
    expected = minimum(expected, single);
  }
  const std::vector<double> found =
      distances_by_function(mesh, sources, parameters::initial_distances(initial));
  for(const Vertex v : mesh.vertices())
    EXPECT_NEAR(found[v.idx()], expected[v.idx()], 1e-12);

  std::vector<std::size_t> nearest(mesh.num_vertices(), 99);
  std::vector<double> again(mesh.num_vertices());
  const auto index = get(boost::vertex_index, mesh);
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(again.begin(), index), sources,
      parameters::initial_distances(initial).nearest_source_map(
          boost::make_iterator_property_map(nearest.begin(), index)));
  EXPECT_TRUE(have_same_bits(again, found));
  for(const Vertex v : mesh.vertices())
  {
    const std::size_t i = nearest[v.idx()];
    ASSERT_LT(i, sources.size());
    EXPECT_NEAR(initial[i] + distances_by_function(mesh, sources[i])[v.idx()], found[v.idx()],
                1e-12);
  }
}

TEST(Surface_functions, end_at_targets_in_faces)
{
  const Mesh mesh = to_mesh(flat_grid(40, 40));
  const Surface_point source = location_at(mesh, Point(10.3, 10.4, 0));
  const std::vector<double> expected =
      distances_by_function(mesh, source, parameters::epsilon(0.1));
  const std::vector<Face_location> targets = {location_at(mesh, Point(13.3, 12.6, 0))};
  const std::vector<double> found =
      distances_by_function(mesh, source, parameters::epsilon(0.1).targets(targets));
  EXPECT_EQ(found[12 + 12 * 40], expected[12 + 12 * 40]);
  EXPECT_EQ(found.back(), infinity);
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_TRUE(found[i] == expected[i] || found[i] == infinity);
}

// From the nearest of some sources; the last point is the target.
TEST(Surface_functions, find_a_path_from_several_places)
{
  const Mesh mesh = to_mesh(flat_grid(9, 9));
  const std::vector<Surface_point> sources = {location_at(mesh, Point(1.3, 1.2, 0)),
                                              location_at(mesh, Point(6.5, 5.25, 0)), Vertex(80)};
  std::vector<Point> points;
  const double found = CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), sources,
                                                       location_at(mesh, Point(5, 4.5, 0)),
                                                       parameters::epsilon(0.01));
  const double straight = std::hypot(1.5, 0.75);
  EXPECT_GE(found, straight * (1 - 1e-12));
  EXPECT_LE(found, straight * 1.01);
  ASSERT_FALSE(points.empty());
  EXPECT_LE(distance_in_space(points.front(), Point(6.5, 5.25, 0)), 1e-12);
  EXPECT_LE(distance_in_space(points.back(), Point(5, 4.5, 0)), 1e-12);
}

// A place in a face can be given from any of the three halfedges.
TEST(Mesh_translation, gives_the_same_point_as_a_face_location)
{
  const Mesh mesh = to_mesh(sphere(6, 5));
  const Triangulation triangulation(mesh);
  AG::Mesh_translation places(mesh, get(boost::vertex_index, mesh), triangulation);
  places.list_vertices();
  for(Triangulation::Index h = 0; h < triangulation.number_of_halfedges(); ++h)
  {
    const AG::Intrinsic_point place = AG::Intrinsic_point::in_face(h, 0.5, 0.125);
    const Point expected = places.point(place, mesh.points(), Kernel());
    EXPECT_LE(distance_in_space(position(mesh, places.face_location(place)), expected), 1e-12);
  }
}

} // namespace
