// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "checks/test_random.h"
#include "fixtures/Surface_searches.h"
#include "meshes/surface_points.h"
#include "oracles/Graph_with_lines.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Paths/Path_straightener.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <vector>

// Distances and paths between any points, on a graph that several threads share.

namespace AG = CGAL::Approximate_geodesics;

namespace {

using namespace geodesics_test;

TEST_F(Surface_searches, give_every_thread_distances_and_paths)
{
  expect_same_in_all_threads(AG::Edge_graph(m_triangulation));
  expect_same_in_all_threads(Discrete_geodesic_graph(m_triangulation));
  expect_same_in_all_threads(Lazy_discrete_geodesic_graph(
      m_triangulation, CGAL::parameters::epsilon(0.1), Lazy_discrete_geodesic_graph::Arcs::KEPT));
}

// The length of a path is that of its points, wherever they are; along edges, it is the distance to
// the last bit.
TEST_F(Surface_searches, tell_the_length_of_the_points)
{
  const auto expect = [this](const auto& graph, const double rounding) {
    AG::Surface_search search(graph);
    search.run({{m_points[0], 2}, {m_points[1], 3.5}, {m_points[2]}});
    for(const AG::Intrinsic_point& p : m_points)
    {
      const AG::Path path = search.find_path(p);
      const auto answer = search.nearest(p);
      const double offset = search.sources()[answer.source].distance;
      const double sum = AG::internal::length_of_segments(m_triangulation, path.points);
      EXPECT_NEAR(path.length, sum * m_triangulation.unit(), 1e-12 * (1 + path.length));
      EXPECT_NEAR(path.length + offset, answer.distance, (1e-14 + rounding) * answer.distance);
      if(rounding == 0 && offset == 0)
      {
        EXPECT_EQ(path.length, answer.distance);
      }
    }
  };
  expect(AG::Edge_graph(m_triangulation), 0);
  expect(Discrete_geodesic_graph(m_triangulation), 1e-6);
}

TEST_F(Surface_searches, take_graphs_that_have_what_concepts_ask_for)
{
  const Graph_with_lines graph(m_triangulation, CGAL::parameters::default_values());
  EXPECT_EQ(results(graph, 0), results(AG::Edge_graph(m_triangulation), 0));

  AG::Surface_mesh_shortest_path<Mesh, Graph_with_lines> paths(m_mesh);
  AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph> expected(m_mesh);
  paths.add_source_point(Vertex(5));
  expected.add_source_point(Vertex(5));
  for(const Vertex v : m_mesh.vertices())
    EXPECT_EQ(paths.shortest_distance_to_source_points(v).first,
              expected.shortest_distance_to_source_points(v).first);
}

// Edges are far shorter than the mesh: positions that are rounded again do not fit them.
TEST(Vertex_positions, fit_the_edges_of_any_mesh_of_points)
{
  Random random(test_seed());
  const Soup soup = terrain(400, 3, random);
  for(const double offset : {0., 0.3, 1e3, -1e7})
    for(const double scale : {1., 1e-3, 1e5})
    {
      const Mesh mesh = to_mesh(soup.transformed([&](const Point& p) {
        return Point(p.x() * scale + offset / 7, p.y() * scale - offset,
                     p.z() * scale + offset / 3);
      }));
      const Triangulation triangulation(mesh);
      AG::Mesh_translation translation(mesh, get(boost::vertex_index, mesh), triangulation);
      translation.list_vertices();
      EXPECT_TRUE(AG::Vertex_positions(triangulation, translation.position_of_vertex(mesh.points()))
                      .are_known())
          << "offset " << offset << ", scale " << scale;
    }
}

TEST_F(Surface_searches, are_led_by_positions_to_the_same_distance)
{
  const Discrete_geodesic_graph graph(m_triangulation);
  const auto coordinates = m_mesh.points();
  const AG::Vertex_positions positions(m_triangulation,
                                       m_translation.position_of_vertex(coordinates));
  ASSERT_TRUE(positions.are_known());
  AG::Surface_search complete(graph), led(graph), ending(graph);
  complete.run({{m_points[0]}});
  for(const AG::Intrinsic_point& p : m_points)
  {
    led.run_to(p, {{m_points[0]}}, positions);
    ending.run_to(p, {{m_points[0]}});
    EXPECT_NEAR(led.distance(p), complete.distance(p), 1e-12 * complete.distance(p));
    EXPECT_EQ(ending.distance(p), complete.distance(p));
  }
}

TEST_F(Surface_searches, keep_their_results_when_input_is_refused)
{
  const AG::Edge_graph graph(m_triangulation);
  AG::Surface_search search(graph);
  search.run({{m_points[0]}});
  const double before = search.distance(m_points[3]);
  for(const double wrong : {-1., infinity, std::nan("")})
    expect_message<std::invalid_argument>(
        [&] {
          search.run({{m_points[1]}, {m_points[2], wrong}});
        },
        "source 1");
  expect_message<std::invalid_argument>(
      [&] {
        search.run({{m_points[1]}}, {-1, {}});
      },
      "maximum distance");
  EXPECT_EQ(search.distance(m_points[3]), before);
  EXPECT_FALSE(search.find_path(m_points[3]).points.empty());
}

// Nor are they lost if no node was reached, but points in the face of the source.
TEST_F(Surface_searches, keep_results_without_nodes_when_input_is_refused)
{
  const AG::Edge_graph graph(m_triangulation);
  AG::Surface_search search(graph);
  Node h = 0;
  while(m_triangulation.is_border(h))
    ++h;
  const auto source = AG::Intrinsic_point::in_face(h, 0.3, 0.3),
             target = AG::Intrinsic_point::in_face(h, 0.3, 0.301);
  search.run({{source}}, {0.01, {}});
  ASSERT_TRUE(search.search().reached_nodes().empty());
  const double before = search.distance(target);
  EXPECT_LT(before, 0.01);
  expect_message<std::invalid_argument>(
      [&] {
        search.run({{m_points[1]}}, {std::nan(""), {}});
      },
      "maximum distance");
  EXPECT_EQ(search.distance(target), before);
}

// What was found before must not be mixed with what changes.
TEST_F(Surface_searches, forget_everything_when_they_start_anew)
{
  struct Bomb : AG::Geodesic_visitor_base
  {
    bool go_further() const { throw std::runtime_error("bang"); }
  };
  const AG::Edge_graph graph(m_triangulation);
  AG::Surface_search search(graph);
  const AG::Intrinsic_point p = AG::Intrinsic_point::in_face(0, 0.25, 0.25),
                            q = AG::Intrinsic_point::in_face(0, 0.5, 0.125);
  search.run({{p}});
  EXPECT_LT(search.distance(q), infinity);
  search.restart();
  EXPECT_EQ(search.distance(q), infinity);
  search.run({{p}});
  EXPECT_THROW(search.run({{m_points[1]}}, {}, Bomb()), std::runtime_error);
  EXPECT_EQ(search.distance(q), infinity);
  EXPECT_TRUE(search.find_path(q).points.empty());
}

TEST_F(Surface_searches, refuse_what_is_not_a_point)
{
  using AG::Intrinsic_point;
  const AG::Edge_graph graph(m_triangulation);
  AG::Surface_search search(graph);
  search.run({{m_points[0]}});
  const auto n = m_triangulation.number_of_vertices(), m = m_triangulation.number_of_halfedges();
  for(const Intrinsic_point& wrong :
      {Intrinsic_point::at_vertex(n), Intrinsic_point::on_edge(m, 0.5),
       Intrinsic_point::on_edge(0, -0.5), Intrinsic_point::on_edge(0, std::nan("")),
       Intrinsic_point::in_face(0, 0.75, 0.5), Intrinsic_point::in_face(0, 5, -3)})
  {
    const auto refused = [](const auto& f) {
      expect_message<std::invalid_argument>(f, "not one of the triangulated surface");
    };
    refused([&] { search.run({{m_points[1]}, {wrong}}); });
    refused([&] { search.run({{m_points[1]}}, {1e9, {wrong}}); });
    refused([&] { search.run_to(wrong, {{m_points[1]}}); });
    refused([&] { search.distance(wrong); });
    refused([&] { search.find_path(wrong); });
  }
}

TEST_F(Surface_searches, end_at_a_distance_and_at_targets)
{
  const AG::Edge_graph graph(m_triangulation);
  AG::Surface_search all(graph), near(graph), ending(graph);
  all.run({{m_points[0]}});
  const double limit = all.distance(m_points[5]);
  near.run({{m_points[0]}}, {limit, {}});
  ending.run({{m_points[0]}}, {limit * 1e6, {m_points[5], m_points[6]}});
  for(const AG::Intrinsic_point& p : m_points)
  {
    const double distance = all.distance(p);
    EXPECT_EQ(near.distance(p), distance <= limit ? distance : infinity);
    EXPECT_EQ(near.find_path(p).points.empty(), distance > limit);
  }
  EXPECT_EQ(ending.distance(m_points[5]), all.distance(m_points[5]));
  EXPECT_EQ(ending.distance(m_points[6]), all.distance(m_points[6]));
}

// One call gives what one question for each vertex does.
TEST(Shortest_distances, are_written_to_a_map_at_once)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(9, 7, random));
  AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph> paths(mesh);
  paths.add_source_point(random_surface_point(mesh, random));
  paths.add_source_point(Vertex(5), 0.25);
  std::vector<double> distances(mesh.number_of_vertices());
  std::vector<std::size_t> sources(mesh.number_of_vertices());
  const auto index = get(boost::vertex_index, mesh);
  paths.shortest_distances_to_source_points(
      boost::make_iterator_property_map(distances.begin(), index),
      CGAL::parameters::nearest_source_map(
          boost::make_iterator_property_map(sources.begin(), index)));
  for(const Vertex v : mesh.vertices())
  {
    const auto [distance, source] = paths.shortest_distance_to_source_points(v);
    EXPECT_EQ(distances[v], distance);
    EXPECT_EQ(std::ptrdiff_t(sources[v]), std::distance(paths.source_points_begin(), source));
  }
}

// A visitor of a single pair is heard, and may end the run.
TEST(Single_pairs_with_a_visitor, notify_it)
{
  struct Visitor : AG::Geodesic_visitor_base
  {
    void on_settled(Vertex, double) { ++settled; }
    bool go_further() const { return settled < limit; }
    std::size_t settled = 0, limit;
  };
  const Mesh mesh = to_mesh(flat_grid(20, 20));
  AG::Surface_mesh_shortest_path<Mesh> paths(mesh);
  Visitor patient{{}, 0, 1000000}, hasty{{}, 0, 20};
  const Vertex first(0), last(mesh.number_of_vertices() - 1);
  EXPECT_GT(paths.shortest_distance(first, last, CGAL::parameters::visitor(std::ref(patient))), 0);
  EXPECT_GT(patient.settled, 100u);
  EXPECT_EQ(paths.shortest_distance(first, last, CGAL::parameters::visitor(std::ref(hasty))), -1);
  EXPECT_LT(hasty.settled, 100u);
}

} // namespace
