// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_of_all_kinds.h"
#include "meshes/random_soups.h"
#include "meshes/surface_points.h"
#include "peers/Pairing_heap_queue.h"
#include "peers/Published_bucket_queue.h"

#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

// What holds for paths on any mesh, and for all ways to ask for them.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

// Arcs of discrete geodesic graphs are numbers of single precision.
constexpr double rounding_of_arcs = 1e-6;

template <typename GeodesicGraph>
class Checked_paths
{
public:
  Checked_paths(const Mesh& mesh, const Kind_of_graph<GeodesicGraph>& kind)
    : m_mesh(mesh),
      m_rounding((has_flat_faces(mesh) ? 1e-7 : 1e-13) * size(mesh)),
      m_deviation(kind.deviation + rounding_of_arcs),
      m_paths(mesh, kind.make(Triangulation(mesh)))
  {
  }

  void check(const Surface_point& source, const Surface_point& target)
  {
    m_paths.remove_all_source_points();
    m_paths.add_source_point(source);
    const double distance = m_paths.shortest_distance_to_source_points(target).first;
    check_pair(source, target, distance);
    if(distance < 0)
      return;
    const double length = check_path(source, target, CGAL::parameters::default_values());
    EXPECT_NEAR(length, distance, rounding_of_arcs * distance + m_rounding);
    const double straight = check_path(source, target, CGAL::parameters::straighten(true));
    EXPECT_LE(straight, length * (1 + 1e-12) + m_rounding);
    EXPECT_GE(straight,
              distance_in_space(position(m_mesh, source), position(m_mesh, target)) - m_rounding);
  }

private:
  // Returns the length, after it was compared with what the path measures.
  template <typename NamedParameters>
  double
  check_path(const Surface_point& source, const Surface_point& target, const NamedParameters& np)
  {
    std::vector<Surface_point> points;
    const double length =
        m_paths
            .shortest_path_surface_points_to_source_points(target, std::back_inserter(points), np)
            .first;
    EXPECT_NEAR(length_of(m_mesh, points), length, 1e-9 * length + m_rounding);
    EXPECT_LE(distance_in_space(position(m_mesh, points.front()), position(m_mesh, target)),
              m_rounding);
    EXPECT_LE(distance_in_space(position(m_mesh, points.back()), position(m_mesh, source)),
              m_rounding);
    for(std::size_t i = 1; i < points.size(); ++i)
      EXPECT_TRUE(share_a_face(m_mesh, points[i - 1], points[i])) << "step " << i;
    return length;
  }

  // Both ways to ask for a pair agree with what the sources say.
  void check_pair(const Surface_point& source, const Surface_point& target, const double distance)
  {
    std::vector<Point> points;
    const double found = m_paths.shortest_distance(source, target);
    const double length = m_paths.shortest_path_points(source, target, std::back_inserter(points));
    EXPECT_EQ(found < 0, distance < 0);
    EXPECT_EQ(points.empty(), distance < 0);
    if(distance < 0)
      return;
    EXPECT_NEAR(found, distance, m_deviation * distance + m_rounding);
    EXPECT_NEAR(length, distance, m_deviation * distance + m_rounding);
  }

  const Mesh& m_mesh;
  double m_rounding; // of coordinates, and of heights
  double m_deviation;
  AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph> m_paths;
};

class Path_properties : public testing::TestWithParam<std::uint64_t>
{
protected:
  Path_properties() : m_random(GetParam()), m_mesh(to_mesh(random_small_soup(GetParam()))) {}

  template <typename GeodesicGraph>
  void expect_good_paths(const Kind_of_graph<GeodesicGraph>& kind)
  {
    Checked_paths<GeodesicGraph> paths(m_mesh, kind);
    for(int i = 0; i < 6; ++i)
    {
      SCOPED_TRACE(testing::Message() << "pair " << i);
      const Surface_point source = random_surface_point(m_mesh, m_random);
      paths.check(source, random_surface_point(m_mesh, m_random));
    }
  }

  template <typename Queue, typename GeodesicGraph>
  std::vector<double> distances(const GeodesicGraph& graph, const std::size_t source)
  {
    AG::Propagation<GeodesicGraph, Queue> search(graph);
    search.run_from(static_cast<std::uint32_t>(source));
    return distances_of_nodes(search);
  }

  Random m_random;
  const Mesh m_mesh;
};

TEST_P(Path_properties, along_edges) { expect_good_paths(edge_graph()); }

TEST_P(Path_properties, in_a_discrete_geodesic_graph)
{
  expect_good_paths(discrete_geodesic_graph(0.1));
}

TEST_P(Path_properties, over_points) { expect_good_paths(graph_with_spaced_points(2)); }

// The edge graph and Steiner graphs are searched with all queues in other tests.
TEST_P(Path_properties, queues_do_not_change_distances)
{
  const auto graph = discrete_geodesic_graph(0.2).make(Triangulation(m_mesh));
  const std::size_t source = m_random.below(m_mesh.number_of_vertices());
  const auto expected = distances<AG::Adaptive_bucket_queue>(graph, source);
  EXPECT_TRUE(have_same_bits(distances<AG::Pairing_heap_queue>(graph, source), expected));
  EXPECT_TRUE(have_same_bits(distances<AG::Published_bucket_queue>(graph, source), expected));
  EXPECT_TRUE(have_same_bits(distances<AG::Radix_heap_queue>(graph, source), expected));
}

INSTANTIATE_TEST_SUITE_P(On_random_meshes,
                         Path_properties,
                         testing::ValuesIn(seeds_of_small_soups()));

} // namespace
