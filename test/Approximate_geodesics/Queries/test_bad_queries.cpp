// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// What a search refuses.

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;
using Shortest_paths = CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh>;

class Bad_query : public testing::Test
{
protected:
  template <typename F, typename... Texts>
  void expect_rejection(F f, const Texts&... texts) const
  {
    expect_message<std::invalid_argument>(f, texts...);
  }

  // The free function with a source and named parameters; it must not have written anything.
  template <typename Sources, typename... NamedParameters>
  void distances(const Sources& sources, const NamedParameters&... np)
  {
    try
    {
      CGAL::approximate_geodesic_distances(m_mesh, m_distance, sources, np...);
    }
    catch(const std::exception&)
    {
      for(const Vertex v : m_mesh.vertices())
        EXPECT_EQ(m_distance[v], -5);
      throw;
    }
  }

  std::string message_about(const Vertex v) const
  {
    return (v == m_null ? "the null vertex" : "vertex " + std::to_string(v.idx())) +
           " is not in the mesh";
  }

  static Mesh make_mesh()
  {
    Mesh result = to_mesh(flat_grid(6, 6));
    result.remove_vertex(result.add_vertex(Point(7, 7, 7)));
    return result;
  }

  Mesh m_mesh = make_mesh();
  const Mesh::Property_map<Vertex, double> m_distance =
      m_mesh.add_property_map<Vertex, double>("distance", -5).first;
  const Vertex m_null = Mesh::null_vertex();
  const Vertex m_foreign = Vertex(1000);
  const Vertex m_removed = Vertex(36);
};

TEST_F(Bad_query, vertices_that_the_mesh_has_not)
{
  ASSERT_TRUE(m_mesh.is_removed(m_removed));
  std::vector<Point> points;
  for(const Vertex bad : {m_null, m_foreign, m_removed})
  {
    const std::string message = message_about(bad);
    const std::vector<Vertex> list = {Vertex(0), bad};
    expect_rejection([&] { distances(bad); }, "source: " + message);
    expect_rejection([&] { distances(list); }, "source 1 (counted from 0): " + message);
    expect_rejection([&] { distances(Vertex(0), parameters::targets(list)); },
                     "target 1 (counted from 0): " + message);
    expect_rejection(
        [&] {
          CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), bad, Vertex(0));
        },
        "source: " + message);
    expect_rejection(
        [&] {
          CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(points), Vertex(0), bad);
        },
        "target: " + message);
  }
  EXPECT_TRUE(points.empty());
}

TEST_F(Bad_query, vertices_given_to_the_class)
{
  Shortest_paths paths(m_mesh);
  paths.add_source_point(Vertex(3));
  std::vector<Point> points;
  for(const Vertex bad : {m_null, m_foreign, m_removed})
  {
    const std::string message = message_about(bad);
    const std::vector<Vertex> list = {Vertex(3), bad};
    expect_rejection([&] { paths.add_source_point(bad); }, message);
    expect_rejection([&] { Shortest_paths(m_mesh).add_source_points(list.begin(), list.end()); },
                     "source 1 (counted from 0): " + message);
    expect_rejection([&] { paths.shortest_distance_to_source_points(bad); }, message);
    expect_rejection(
        [&] { paths.shortest_path_points_to_source_points(bad, std::back_inserter(points)); },
        message);
    expect_rejection([&] { paths.build_sequence_tree(parameters::targets(list)); },
                     "target 1 (counted from 0): " + message);
    expect_rejection([&] { paths.node(bad); }, message);
  }
  EXPECT_EQ(paths.number_of_source_points(), 1u); // usable as if nothing had been tried
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(5)).first, 2);
  EXPECT_TRUE(points.empty());
}

TEST_F(Bad_query, maximum_distance_that_is_no_distance)
{
  for(const double bad : {-1., -1e-300, not_a_number, -infinity})
  {
    expect_rejection([&] { distances(Vertex(0), parameters::maximum_distance(bad)); },
                     "maximum distance");
    Shortest_paths paths(m_mesh);
    paths.add_source_point(Vertex(3));
    expect_rejection([&] { paths.build_sequence_tree(parameters::maximum_distance(bad)); },
                     "maximum distance");
    EXPECT_TRUE(paths.changed_since_last_build());
    EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(5)).first, 2);
  }
}

TEST_F(Bad_query, seeds_and_targets_given_to_a_propagation)
{
  Mesh_search search(m_mesh);
  const auto run = [&](const Search::Seed& seed, const Search::Stop_rule& stop = {}) {
    return [&search, seed, stop] { search.search().run({seed}, stop); };
  };
  const std::vector<double> expected = search.distances({Vertex(0)});
  expect_rejection(run({36}), "source node 36 does not exist", "36 nodes");
  expect_rejection(run({Search::null_node}), "source node", "does not exist");
  expect_rejection(run({0}, {infinity, {3, 36}}), "target node 36 does not exist");
  for(const double bad : {-1., not_a_number, infinity})
    expect_rejection(run({7, bad}), "source node 7", "finite number");
  for(const double bad : {-1., not_a_number})
    expect_rejection(run({0}, {bad, {}}), "maximum distance");
  EXPECT_EQ(search.field().distance, expected); // refused before the last results were forgotten
}

} // namespace
