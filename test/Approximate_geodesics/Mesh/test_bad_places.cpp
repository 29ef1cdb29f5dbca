// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// What is not a point of the surface, or not a distance to start with.

namespace {

namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Paths = CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh>;
using Coordinates = std::array<double, 3>;

class Bad_place : public testing::Test
{
protected:
  template <typename F, typename... Texts>
  static void expect_rejection(F f, const Texts&... texts)
  {
    expect_message<std::invalid_argument>(f, texts...);
  }

  // Everything that takes a point of the surface refuses this one, and is as it was before.
  template <typename... Texts>
  void expect_rejected(const Face_location& bad, const Texts&... texts)
  {
    Paths paths(m_mesh);
    paths.add_source_point(Vertex(3));
    std::vector<Point> points;
    const std::vector<Face_location> list = {bad};
    expect_rejection([&] { paths.add_source_point(bad); }, texts...);
    expect_rejection([&] { paths.add_source_point(bad.first, bad.second); }, texts...);
    expect_rejection([&] { paths.add_source_point(Surface_point(bad)); }, texts...);
    expect_rejection([&] { paths.add_source_points(list.begin(), list.end()); }, texts...);
    expect_rejection([&] { paths.shortest_distance_to_source_points(bad.first, bad.second); },
                     texts...);
    expect_rejection(
        [&] {
          paths.shortest_path_points_to_source_points(bad.first, bad.second,
                                                      std::back_inserter(points));
        },
        texts...);
    expect_rejection([&] { paths.build_sequence_tree(parameters::targets(list)); }, texts...);
    EXPECT_EQ(paths.number_of_source_points(), 1u);
    EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(5)).first, 2);

    std::vector<double> distances(m_mesh.num_vertices(), -5);
    const auto map =
        boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
    expect_rejection([&] { CGAL::approximate_geodesic_distances(m_mesh, map, bad); }, texts...);
    expect_rejection([&] { CGAL::approximate_geodesic_distances(m_mesh, map, list); }, texts...);
    expect_rejection(
        [&] {
          CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), bad, Vertex(1));
        },
        texts...);
    expect_rejection(
        [&] {
          CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), Vertex(1), bad);
        },
        texts...);
    EXPECT_EQ(distances, std::vector<double>(m_mesh.num_vertices(), -5));
    EXPECT_TRUE(points.empty());
  }

  Mesh m_mesh = to_mesh(flat_grid(6, 6));
};

TEST_F(Bad_place, in_a_face_that_the_mesh_has_not)
{
  expect_rejected({Mesh::null_face(), {0.2, 0.3, 0.5}}, "the null face is not in the mesh");
  expect_rejected({Face(50), {0.2, 0.3, 0.5}}, "face 50 is not in the mesh");
  expect_rejected({Face(1000), {0.2, 0.3, 0.5}}, "face 1000 is not in the mesh");
}

TEST_F(Bad_place, in_a_face_that_was_removed)
{
  const Face inside(24), at_border(0);
  for(const Face bad : {inside, at_border})
  {
    m_mesh = to_mesh(flat_grid(6, 6));
    CGAL::Euler::remove_face(m_mesh.halfedge(bad), m_mesh);
    ASSERT_TRUE(m_mesh.is_removed(bad));
    expect_rejected({bad, {0.2, 0.3, 0.5}},
                    "face " + std::to_string(bad.idx()) + " is not in the mesh");
  }
}

TEST_F(Bad_place, outside_of_its_face)
{
  for(const Coordinates& bad :
      {Coordinates{-0.1, 0.6, 0.5}, Coordinates{1.1, -0.1, 0}, Coordinates{0.5, 0.5, -1e-6},
       Coordinates{not_a_number, 0.5, 0.5}, Coordinates{0.5, 0.5, not_a_number},
       Coordinates{0.2, 0.2, 0.2}, Coordinates{1, 1, 1}, Coordinates{0, 0, 0},
       Coordinates{infinity, 0, 0}, Coordinates{infinity, -infinity, 1}, Coordinates{1, 1e-6, 0}})
    expect_rejected({Face(7), bad}, "barycentric coordinates", "their sum must be 1");
  Paths paths(m_mesh);
  expect_rejection(
      [&] {
        paths.add_source_point(Face(7), {0.25, 0.5, -0.125});
      },
      "0.25, 0.5, -0.125");
}

TEST_F(Bad_place, on_no_part_of_a_halfedge)
{
  Paths paths(m_mesh);
  for(const double bad : {-0.1, 1.1, not_a_number, infinity, -1e-300})
    expect_rejection([&] { paths.add_source_point(Edge_location(Halfedge(3), bad)); },
                     "parameter along a halfedge");
  expect_rejection([&] { paths.add_source_point(Edge_location(Mesh::null_halfedge(), 0.5)); },
                   "the null halfedge is not in the mesh");
  expect_rejection([&] { paths.add_source_point(Edge_location(Halfedge(10000), 0.5)); },
                   "halfedge 10000 is not in the mesh");
  for(const double end : {0., 1.})
    EXPECT_NO_THROW(paths.add_source_point(Edge_location(Halfedge(3), end)));
}

TEST_F(Bad_place, with_an_initial_distance_that_is_none)
{
  const Face_location place(Face(7), {0.2, 0.3, 0.5});
  const std::vector<Face_location> sources = {place, place};
  std::vector<double> distances(m_mesh.num_vertices(), -5);
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
  for(const double bad : {-1., -1e-300, not_a_number, infinity, -infinity})
  {
    Paths paths(m_mesh);
    expect_rejection([&] { paths.add_source_point(place, bad); }, "initial distance");
    expect_rejection([&] { paths.add_source_point(Vertex(3), bad); }, "initial distance");
    EXPECT_EQ(paths.number_of_source_points(), 0u);
    const std::vector<double> initial = {0, bad};
    expect_rejection(
        [&] {
          CGAL::approximate_geodesic_distances(m_mesh, map, sources,
                                               parameters::initial_distances(initial));
        },
        "initial distance");
  }
  EXPECT_EQ(distances, std::vector<double>(m_mesh.num_vertices(), -5));
}

TEST_F(Bad_place, with_another_number_of_initial_distances)
{
  const std::vector<Face_location> sources(2, {Face(7), {0.2, 0.3, 0.5}});
  std::vector<double> distances(m_mesh.num_vertices());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
  for(const std::size_t number : {0u, 1u, 3u})
  {
    const std::vector<double> initial(number, 1.);
    expect_rejection(
        [&] {
          CGAL::approximate_geodesic_distances(m_mesh, map, sources,
                                               parameters::initial_distances(initial));
        },
        "there are " + std::to_string(number) + " initial distances, and 2 sources");
  }
}

} // namespace
