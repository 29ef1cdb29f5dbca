// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/approximate_geodesic_distances.h>

#include "checks/test_recorder.h"
#include "oracles/test_oracles.h"

#include <CGAL/version.h>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <vector>

// Named parameters, those of this package and those of CGAL, in any order.

int distances_of_the_other_translation_unit();

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

class Named_parameters : public testing::Test
{
protected:
  // A limit, targets, labels, predecessors, a visitor, points and indices: all have an effect.
  template <typename NamedParameters>
  void expect_all_effective(const NamedParameters& np)
  {
    m_recorder = Recorder<Vertex>();
    for(const Vertex v : m_mesh.vertices())
    {
      m_distance[v] = m_label[v] = -7;
      m_predecessor[v] = Mesh::null_vertex();
    }
    CGAL::approximate_geodesic_distances(m_mesh, m_distance, Vertex(0), np);
    EXPECT_EQ(m_distance[Vertex(5)], 10); // of points that are doubled
    EXPECT_EQ(m_distance[Vertex(19)], infinity);
    EXPECT_EQ(m_label[Vertex(5)], 0);
    EXPECT_EQ(m_label[Vertex(19)], -1);
    EXPECT_EQ(m_predecessor[Vertex(5)], Vertex(4));
    EXPECT_EQ(m_recorder.settled.size(), 6u);
  }

  template <typename Value>
  using Map = Mesh::Property_map<Vertex, Value>;

  Mesh m_mesh = to_mesh(
      flat_grid(20, 2).transformed([](const Point& p) { return Point(p.x(), 100 * p.y(), 0); }));
  Map<double> m_distance = m_mesh.add_property_map<Vertex, double>("distance").first;
  Map<int> m_label = m_mesh.add_property_map<Vertex, int>("label").first;
  Map<Vertex> m_predecessor = m_mesh.add_property_map<Vertex, Vertex>("predecessor").first;
  Map<Point> m_doubled = doubled_points();
  Recorder<Vertex> m_recorder;
  const std::vector<Vertex> m_targets = {Vertex(19)};

private:
  Map<Point> doubled_points()
  {
    const auto result = m_mesh.add_property_map<Vertex, Point>("doubled").first;
    for(const Vertex v : m_mesh.vertices())
      result[v] = CGAL::ORIGIN + 2 * (m_mesh.point(v) - CGAL::ORIGIN);
    return result;
  }
};

TEST_F(Named_parameters, of_this_package_come_first)
{
  expect_all_effective(parameters::nearest_source_map(m_label)
                           .maximum_distance(10)
                           .predecessor_map(m_predecessor)
                           .targets(m_targets)
                           .visitor(std::ref(m_recorder))
                           .vertex_point_map(m_doubled));
}

TEST_F(Named_parameters, alternate)
{
  expect_all_effective(parameters::nearest_source_map(m_label)
                           .vertex_point_map(m_doubled)
                           .predecessor_map(m_predecessor)
                           .visitor(std::ref(m_recorder))
                           .maximum_distance(10)
                           .vertex_index_map(get(boost::vertex_index, m_mesh))
                           .targets(m_targets)
                           .geom_traits(Kernel()));
}

TEST_F(Named_parameters, are_combined)
{
  expect_all_effective(parameters::combine(
      parameters::vertex_point_map(m_doubled).visitor(std::ref(m_recorder)),
      parameters::nearest_source_map(m_label).maximum_distance(10).predecessor_map(m_predecessor)));
  expect_all_effective(parameters::combine(
      parameters::predecessor_map(m_predecessor), parameters::vertex_point_map(m_doubled),
      parameters::nearest_source_map(m_label), parameters::visitor(std::ref(m_recorder)),
      parameters::targets(m_targets).maximum_distance(10)));
  expect_all_effective(parameters::combine(
      parameters::combine(parameters::nearest_source_map(m_label),
                          parameters::predecessor_map(m_predecessor)),
      parameters::combine(parameters::maximum_distance(10.),
                          parameters::visitor(std::ref(m_recorder)).vertex_point_map(m_doubled))));
}

TEST_F(Named_parameters, may_be_none)
{
  CGAL::approximate_geodesic_distances(m_mesh, m_distance, Vertex(0), parameters::default_values());
  EXPECT_EQ(m_distance[Vertex(19)], 19);
  CGAL::approximate_geodesic_distances(m_mesh, m_distance, Vertex(0),
                                       parameters::verbose(true)); // of no concern
  EXPECT_EQ(m_distance[Vertex(19)], 19);
}

// The names that newer versions of CGAL have are theirs there, and ours elsewhere.
TEST_F(Named_parameters, may_be_of_newer_versions)
{
  CGAL::approximate_geodesic_distances(m_mesh, m_distance, Vertex(0),
                                       parameters::maximum_distance(3));
  EXPECT_EQ(m_distance[Vertex(3)], 3);
  EXPECT_EQ(m_distance[Vertex(4)], infinity);
  CGAL::approximate_geodesic_distances(
      m_mesh, m_distance, Vertex(0),
      parameters::targets(m_targets).concurrency_tag(CGAL::Sequential_tag()).maximum_distance(2.f));
  EXPECT_EQ(m_distance[Vertex(2)], 2);
  EXPECT_EQ(m_distance[Vertex(3)], infinity);
}

TEST(Translation_units, can_be_linked)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  Mesh_search search(mesh);
  EXPECT_EQ(search.distances({Vertex(0)})[2], distances_of_the_other_translation_unit());
}

} // namespace
