// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Impatient_maps.h"
#include "meshes/surface_points.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Values = std::vector<double>;

TEST_F(Impatient_maps, end_the_construction_of_a_triangulation)
{
  expect_uses(m_mesh.number_of_vertices(), parameters::vertex_point_map(point_map()));
  expect_uses(m_mesh.number_of_edges(), parameters::edge_length_map(map<Edge>(m_lengths)));
}

TEST_F(Impatient_maps, leave_distances_alone_if_they_are_read)
{
  expect_untouched_distances(parameters::vertex_point_map(point_map()));
  expect_untouched_distances(parameters::epsilon(0.5).vertex_point_map(point_map()));
  expect_untouched_distances(parameters::edge_length_map(map<Edge>(m_lengths)));
}

// First all distances, then all sources, and then all predecessors, each in the order of the
// vertices.
TEST_F(Impatient_maps, have_what_was_written_before)
{
  const std::size_t n = m_points.size();
  const Values expected = Mesh_search(m_mesh).distances({Vertex(3)});
  Values distances;
  std::vector<std::size_t> sources;
  std::vector<Vertex> predecessors;
  const auto forget = [&] {
    distances.assign(n, -1);
    sources.assign(n, 99);
    predecessors.assign(n, Vertex(99));
  };
  const auto check = [&](const std::size_t number_written) {
    for(std::size_t i = 0; i < n; ++i)
    {
      EXPECT_EQ(distances[i], i < number_written ? expected[i] : -1);
      EXPECT_EQ(sources[i], n + i < number_written ? 0u : 99u);
      EXPECT_EQ(predecessors[i] != Vertex(99), 2 * n + i < number_written);
    }
  };
  const std::size_t uses = interrupt(
      [&] {
        forget();
        CGAL::approximate_geodesic_distances(m_mesh, map<Vertex>(distances), Vertex(3),
                                             parameters::nearest_source_map(map<Vertex>(sources))
                                                 .predecessor_map(map<Vertex>(predecessors)));
      },
      check);
  EXPECT_EQ(uses, 3 * n);
  check(uses);
}

TEST_F(Impatient_maps, interrupt_queries_of_the_class)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;
  m_patience.set(1000000);
  Paths paths(m_mesh, parameters::vertex_point_map(point_map()));
  const Face_location source = random_face_location(m_mesh, m_random);
  paths.add_source_point(source);
  const double expected = paths.shortest_distance_to_source_points(Vertex(60)).first;

  std::vector<Point> points, all_points;
  paths.shortest_path_points_to_source_points(Vertex(60), std::back_inserter(all_points));
  interrupt(
      [&] {
        points.clear();
        EXPECT_EQ(
            paths.shortest_path_points_to_source_points(Vertex(60), std::back_inserter(points))
                .first,
            paths.shortest_path_points(Vertex(60), source, std::back_inserter(points)));
      },
      [&](std::size_t) {
        EXPECT_TRUE(std::equal(points.begin(),
                               points.begin() +
                                   std::ptrdiff_t((std::min)(points.size(), all_points.size())),
                               all_points.begin()));
        EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(60)).first, expected);
      });
}

// The points of a path that were written when the next one's could not be read.
TEST_F(Impatient_maps, interrupt_paths_that_are_written)
{
  const auto expect_first_points = [&](const auto& np) {
    std::vector<Point> points, all_points;
    CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(all_points), Vertex(3), Vertex(60),
                                    np);
    interrupt(
        [&] {
          points.clear();
          CGAL::approximate_geodesic_path(
              m_mesh, std::back_inserter(points), Vertex(3), Vertex(60),
              parameters::combine(np, parameters::vertex_point_map(point_map())));
        },
        [&](std::size_t) {
          ASSERT_LE(points.size(), all_points.size());
          EXPECT_TRUE(std::equal(points.begin(), points.end(), all_points.begin()));
        });
    EXPECT_EQ(points, all_points);
  };
  expect_first_points(parameters::maximum_distance(1e9));
  expect_first_points(parameters::epsilon(0.1));
}

} // namespace
