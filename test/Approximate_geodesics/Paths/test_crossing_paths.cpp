// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles/exact_distances.h"
#include "oracles/straight_lines.h"
#include "oracles/test_oracles.h"
#include "paths/Path_recorder.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <vector>

// `epsilon` in the functions and the class, and paths that run across faces.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using AG::Lazy_discrete_geodesic_graph;
using CGAL::parameters::epsilon;

template <typename GeodesicGraph>
void expect_paths_of_the_length_they_say(const Mesh& mesh, const double tolerance)
{
  AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph> paths(mesh, epsilon(0.1));
  Random random(test_seed());
  const Vertex source = random_vertex(mesh, random);
  paths.add_source_point(source);
  for(const Vertex v : mesh.vertices())
  {
    Path_recorder recorder{mesh};
    std::vector<Point> points;
    const double distance = paths.shortest_path_sequence_to_source_points(v, recorder).first;
    paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
    EXPECT_EQ(points.empty(), distance < 0);
    EXPECT_EQ(points, recorder.points);
    if(points.empty())
      continue;
    EXPECT_EQ(points.front(), mesh.point(v));
    EXPECT_EQ(points.back(), mesh.point(source));
    EXPECT_TRUE(recorder.stays_on_surface()) << "to vertex " << v;
    EXPECT_NEAR(length_of(points), distance, distance * tolerance) << "to vertex " << v;
  }
}

TEST(Paths_across_faces, have_the_length_they_say)
{
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    expect_paths_of_the_length_they_say<Discrete_geodesic_graph>(named.mesh, 2e-7);
    expect_paths_of_the_length_they_say<Lazy_discrete_geodesic_graph>(named.mesh, 1e-9);
  }
}

TEST(Paths_across_faces, have_it_where_faces_have_no_area)
{
  Random random(test_seed());
  for(std::size_t i = 0; i < 20; ++i)
  {
    // vertices may come to lie at the same place
    const auto part = [&] { return 0.25 * static_cast<double>(1 + random.below(3)); };
    const Soup soup = with_caps(with_caps(flat_grid(6, 5), part), part);
    expect_paths_of_the_length_they_say<Discrete_geodesic_graph>(to_mesh(soup), 2e-7);
    expect_paths_of_the_length_they_say<Lazy_discrete_geodesic_graph>(to_mesh(soup), 1e-7);
  }
}

// An arc that was found with one rounding is seen with another one: in doubt, vertices on the ray
// through another one are not hidden by that.
TEST(Paths_across_faces, are_found_again_in_doubt)
{
  Random random(test_seed());
  for(const Mesh& mesh : {to_mesh(flat_grid(15, 12)), to_mesh(terrain(25, 20, random))})
  {
    const Discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1));
    for(Node source = 0; source < graph.number_of_nodes(); source += 11)
      graph.for_each_arc(source, nullptr, [&](const Node target, const double length) {
        const AG::internal::Cone_rules rules(graph.epsilon());
        AG::internal::Arc_search search(graph.triangulation(), rules, source, target, length);
        search.find_in_doubt();
        EXPECT_TRUE(search.is_found());
        EXPECT_EQ(search.found.target, target);
      });
  }
}

// When a node is expanded again, those behind it have to be told.
TEST(Lazy_discrete_geodesic_graph, finds_distances_that_are_sums_of_arcs)
{
  Random random(test_seed());
  const auto pull = [](const Point& p) { return Point(p.x(), 20 * p.y(), p.z()); };
  const Mesh mesh = to_mesh(terrain(120, 120, random).transformed(pull));
  const Lazy_discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1));
  AG::Propagation<Lazy_discrete_geodesic_graph> search(graph);
  search.collect_statistics(true);
  std::size_t repeated = 0;
  for(Node source = 0; source < graph.number_of_nodes(); source += 3000)
  {
    search.run_from(source);
    repeated += search.statistics().repeated_pops();
    const double unit = graph.triangulation().unit();
    for(Node node = 0; node < graph.number_of_nodes(); node += 3)
    {
      const Node previous = search.predecessor(node);
      if(previous == search.null_node)
        continue;
      const double difference = (search.distance(node) - search.distance(previous)) / unit;
      const auto ignore = [](Node, double) {};
      EXPECT_NEAR(graph.for_each_crossing(previous, node, difference, ignore), difference,
                  1e-12 * search.distance(node) / unit);
    }
  }
  EXPECT_GT(repeated, 0u);
}

TEST(Paths_across_faces, are_straight_in_the_plane)
{
  const Mesh mesh = to_mesh(flat_grid(12, 12));
  std::vector<Point> points;
  const double distance = CGAL::approximate_geodesic_path(
      mesh, std::back_inserter(points), Vertex(0), Vertex(5 * 12 + 3), epsilon(1e-6));
  EXPECT_NEAR(distance, std::sqrt(34.), 1e-9);
  EXPECT_GT(points.size(), 5u); // an edge at least for every unit
  for(const Point& p : points)
    EXPECT_NEAR(5 * p.x(), 3 * p.y(), 1e-9);
}

TEST(Functions_with_epsilon, agree_and_keep_their_bound)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(25, 20, random));
  const Vertex source(101);
  const std::vector<double> exact = exact_distances(mesh, source);
  for(const double e : {0.3, 0.03})
  {
    std::vector<double> found(mesh.num_vertices());
    std::vector<Vertex> predecessor(mesh.num_vertices());
    const auto index = get(boost::vertex_index, mesh);
    CGAL::approximate_geodesic_distances(
        mesh, boost::make_iterator_property_map(found.begin(), index), source,
        epsilon(e).predecessor_map(boost::make_iterator_property_map(predecessor.begin(), index)));
    EXPECT_EQ(predecessor[source.idx()], source);
    for(const Vertex v : mesh.vertices())
    {
      EXPECT_GE(found[v.idx()], exact[v.idx()] * (1 - 1e-10));
      EXPECT_LE(found[v.idx()], exact[v.idx()] * (1 + e));
      EXPECT_LE(found[predecessor[v.idx()].idx()], found[v.idx()]);
      if(v.idx() % 20 != 0)
        continue;
      std::vector<Point> points;
      const double to_v =
          CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, v, epsilon(e));
      EXPECT_NEAR(to_v, found[v.idx()], found[v.idx()] * e);
      EXPECT_NEAR(length_of(points), to_v, to_v * 1e-10);
      EXPECT_EQ(points.front(), mesh.point(source));
      EXPECT_EQ(points.back(), mesh.point(v));
    }
  }
}

TEST(Functions_with_epsilon, can_stop_at_a_distance)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(25, 20, random));
  const std::vector<double> exact = exact_distances(mesh, Vertex(101));
  std::map<Vertex, double> found;
  const double limit = 6, e = 0.1;
  CGAL::approximate_geodesic_distances(mesh, boost::make_assoc_property_map(found), Vertex(101),
                                       epsilon(e).maximum_distance(limit));
  for(const auto& [v, distance] : found)
  {
    EXPECT_TRUE(distance <= limit || distance == infinity);
    if(exact[v.idx()] * (1 + e) <= limit)
    {
      EXPECT_LE(distance, limit);
    }
  }
}

TEST(Functions_with_epsilon, take_lengths_in_place_of_coordinates)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(15, 15, random));
  const std::vector<double> lengths = edge_lengths(mesh);
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  std::map<Vertex, double> from_lengths, from_points;
  CGAL::approximate_geodesic_distances(mesh, boost::make_assoc_property_map(from_lengths),
                                       Vertex(7), epsilon(0.1).edge_length_map(map));
  CGAL::approximate_geodesic_distances(mesh, boost::make_assoc_property_map(from_points), Vertex(7),
                                       epsilon(0.1));
  for(const auto& [v, distance] : from_points)
    EXPECT_NEAR(from_lengths[v], distance, distance * 1e-12);
}

// One graph, its arcs found by whichever thread comes first.
TEST(Lazy_discrete_geodesic_graph, may_be_searched_by_several_threads)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(40, 40, random));
  for(const auto arcs :
      {Lazy_discrete_geodesic_graph::Arcs::FORGOTTEN, Lazy_discrete_geodesic_graph::Arcs::KEPT})
  {
    const Lazy_discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1), arcs);
    using Search = AG::Propagation<Lazy_discrete_geodesic_graph>;
    Search expected(graph);
    expected.run_from(17);

    std::vector<std::optional<Search>> searches(4);
    const Lazy_discrete_geodesic_graph fresh(Triangulation(mesh), epsilon(0.1), arcs);
    std::vector<std::thread> threads;
    for(auto& search : searches)
      threads.emplace_back([&] {
        search.emplace(fresh);
        search->run_from(17);
      });
    for(std::thread& thread : threads)
      thread.join();
    for(const auto& search : searches)
      for(Node node = 0; node < graph.number_of_nodes(); ++node)
        EXPECT_EQ(search->distance(node), expected.distance(node));
  }
}

} // namespace
