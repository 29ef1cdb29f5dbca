// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "meshes/steiner_meshes.h"
#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <variant>
#include <vector>

// The functions that take any points of a surface as sources and targets: they find what the class
// finds.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

template <typename Graph>
using Paths_over = AG::Surface_mesh_shortest_path<Mesh, Graph>;

using Steiner = Steiner_graph<Fixed_number_of_points>;

// What the class says of all vertices.
template <typename Graph>
std::vector<double> distances_by_class(Paths_over<Graph>& paths, const Mesh& mesh)
{
  std::vector<double> result;
  for(const Vertex v : mesh.vertices())
  {
    const double d = paths.shortest_distance_to_source_points(v).first;
    result.push_back(d < 0 ? infinity : d);
  }
  return result;
}

template <typename Sources, typename... NamedParameters>
std::vector<double>
distances_by_function(const Mesh& mesh, const Sources& sources, const NamedParameters&... np)
{
  std::vector<double> result(mesh.num_vertices(), -5);
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)),
      sources, np...);
  return result;
}

// What is found on a lazy graph depends on what is searched for.
template <typename Graph>
constexpr double tolerated = std::is_same_v<Graph, AG::Lazy_discrete_geodesic_graph> ? 0.2 : 1e-12;

template <typename Graph, typename NamedParameters>
void expect_same_distances(const Mesh& mesh, Random& random, const NamedParameters& np)
{
  Paths_over<Graph> paths(mesh, np);
  for(int i = 0; i < 6; ++i)
  {
    const Surface_point source = random_surface_point(mesh, random);
    paths.remove_all_source_points();
    paths.add_source_point(source);
    const std::vector<double> found = distances_by_function(mesh, source, np);
    expect_about_the_same(found, distances_by_class(paths, mesh), tolerated<Graph>);
    if(const Face_location* location = std::get_if<Face_location>(&source))
    {
      const std::vector<Face_location> range = {*location};
      EXPECT_TRUE(have_same_bits(distances_by_function(mesh, *location, np), found));
      EXPECT_TRUE(have_same_bits(distances_by_function(mesh, range, np), found));
    }
  }
}

TEST(Surface_functions, find_the_distances_that_the_class_finds)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    expect_same_distances<AG::Edge_graph>(mesh, random, parameters::default_values());
    expect_same_distances<AG::Lazy_discrete_geodesic_graph>(mesh, random, parameters::epsilon(0.2));
    expect_same_distances<Steiner>(mesh, random, parameters::number_of_points_per_edge(2));
  });
}

template <typename Graph, typename NamedParameters>
void expect_same_paths(const Mesh& mesh, Random& random, const NamedParameters& np)
{
  Paths_over<Graph> paths(mesh, np);
  for(int i = 0; i < 20; ++i)
  {
    const Surface_point source = random_surface_point(mesh, random);
    const Surface_point target = random_surface_point(mesh, random);
    paths.remove_all_source_points();
    paths.add_source_point(source);
    const double expected = paths.shortest_distance_to_source_points(target).first;
    std::vector<Point> points;
    const double found =
        CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, target, np);
    EXPECT_EQ(points.empty(), expected < 0);
    if(expected < 0)
    {
      EXPECT_EQ(found, infinity);
      continue;
    }
    const double tolerance = 1e-12 * size(mesh);
    EXPECT_NEAR(found, expected, tolerated<Graph> * expected + tolerance);
    EXPECT_LE(distance_in_space(points.front(), position(mesh, source)), tolerance);
    EXPECT_LE(distance_in_space(points.back(), position(mesh, target)), tolerance);
    EXPECT_NEAR(length_of(points), found, 1e-9 * found + tolerance);
  }
}

TEST(Surface_functions, find_the_paths_that_the_class_finds)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    expect_same_paths<AG::Edge_graph>(mesh, random, parameters::default_values());
    expect_same_paths<AG::Lazy_discrete_geodesic_graph>(mesh, random, parameters::epsilon(0.2));
    expect_same_paths<Steiner>(mesh, random, parameters::number_of_points_per_edge(2));
  });
}

TEST(Surface_functions, take_costs_for_distances)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    Paths_over<Steiner> paths(mesh, steiner_graph(mesh, weights, Fixed_number_of_points(2)));
    const Surface_point source = random_surface_point(mesh, random);
    paths.add_source_point(source);
    EXPECT_TRUE(have_same_bits(
        distances_by_function(mesh, source, with_weights(weights).number_of_points_per_edge(2)),
        distances_by_class(paths, mesh)));
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
