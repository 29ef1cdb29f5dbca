// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_recorder.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;
using Shortest_paths = CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh, Graph>;

struct Vertex_sequence
{
  void operator()(const Vertex v) { vertices.push_back(v); }
  void operator()(const Halfedge, const double) { ADD_FAILURE() << "an edge was crossed"; }
  template <typename Coordinates>
  void operator()(const Face, const Coordinates&)
  {
    ADD_FAILURE() << "a face was crossed";
  }
  std::vector<Vertex> vertices = {};
};

// The length of the shortest edge between two vertices, or infinity.
double
edge_length(const Mesh& mesh, const std::vector<double>& lengths, const Vertex a, const Vertex b)
{
  double result = infinity;
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(a)))
    if(mesh.source(h) == b)
      result = (std::min)(result, lengths[mesh.edge(h).idx()]);
  return result;
}

// The sum along the path, from the source on.
double length(const Mesh& mesh, const std::vector<double>& lengths, const std::vector<Vertex>& path)
{
  double result = 0;
  for(std::size_t i = path.size(); i-- > 1;)
    result += edge_length(mesh, lengths, path[i], path[i - 1]);
  return result;
}

// The path to `v` as vertices, which has to fit the distance and the points.
void expect_valid_path(Shortest_paths& paths,
                       const Mesh& mesh,
                       const std::vector<double>& lengths,
                       const Vertex v,
                       const std::vector<Vertex>& sources)
{
  Vertex_sequence sequence;
  const auto [distance, it] = paths.shortest_path_sequence_to_source_points(v, sequence);
  std::vector<Point> points;
  EXPECT_EQ(paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first,
            distance);
  ASSERT_EQ(points.size(), sequence.vertices.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i], mesh.point(sequence.vertices[i]));
  if(distance < 0)
  {
    EXPECT_TRUE(points.empty());
    EXPECT_TRUE(it == paths.source_points_end());
    return;
  }
  ASSERT_FALSE(points.empty());
  const auto position = std::distance(paths.source_points_begin(), it);
  EXPECT_EQ(sequence.vertices.front(), v);
  EXPECT_EQ(sequence.vertices.back(), sources[static_cast<std::size_t>(position)]);
  EXPECT_EQ(length(mesh, lengths, sequence.vertices), distance);
  std::vector<Vertex> sorted = sequence.vertices;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end()) << "visited twice";
}

TEST(Class, finds_paths_of_the_length_it_says)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const std::vector<double> lengths = edge_lengths(named.mesh);
    Shortest_paths paths(named.mesh);
    const std::vector<Vertex> sources = {random_vertex(named.mesh, random),
                                         random_vertex(named.mesh, random)};
    paths.add_source_points(sources.begin(), sources.end());
    for(const Vertex v : named.mesh.vertices())
      expect_valid_path(paths, named.mesh, lengths, v, sources);
  }
}

TEST(Function, finds_paths_of_the_length_it_says)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const Mesh& mesh = named.mesh;
    const std::vector<double> lengths = edge_lengths(mesh);
    // where a path goes is read from a map of points that says which vertex each is
    const auto labels = [](const Vertex v) { return Point(double(v.idx()), 0, 0); };
    std::vector<Point> points_of_vertices;
    for(const Vertex v : mesh.vertices())
      points_of_vertices.push_back(labels(v));
    const auto label_map = boost::make_iterator_property_map(points_of_vertices.begin(),
                                                             get(boost::vertex_index, mesh));
    const auto length_map =
        boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
    for(std::size_t i = 0; i < 10; ++i)
    {
      const Vertex source = random_vertex(mesh, random), target = random_vertex(mesh, random);
      std::vector<Point> points;
      const double distance = CGAL::approximate_geodesic_path(
          mesh, std::back_inserter(points), source, target,
          parameters::edge_length_map(length_map).vertex_point_map(label_map));
      EXPECT_EQ(distance, boost_distances(mesh, lengths, source)[target.idx()]);
      EXPECT_EQ(points.empty(), distance == infinity);
      if(points.empty())
        continue;
      std::vector<Vertex> path;
      for(const Point& p : points)
        path.insert(path.begin(), Vertex(static_cast<Mesh::size_type>(p.x())));
      EXPECT_EQ(path.back(), source);
      EXPECT_EQ(path.front(), target);
      EXPECT_EQ(length(mesh, lengths, path), distance);
    }
  }
}

TEST(Function, gives_one_point_or_none)
{
  Mesh mesh = to_mesh(flat_grid(4, 4));
  const Vertex alone = mesh.add_vertex(Point(9, 9, 9));
  std::vector<Point> points;
  const auto path = [&](const Vertex source, const Vertex target, const auto& np) {
    points.clear();
    return CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, target, np);
  };
  EXPECT_EQ(path(Vertex(5), Vertex(5), parameters::default_values()), 0);
  EXPECT_EQ(points, std::vector<Point>{mesh.point(Vertex(5))});
  EXPECT_EQ(path(alone, alone, parameters::default_values()), 0);
  EXPECT_EQ(points, std::vector<Point>{mesh.point(alone)});
  EXPECT_EQ(path(Vertex(5), alone, parameters::default_values()), infinity);
  EXPECT_TRUE(points.empty());
  EXPECT_EQ(path(Vertex(0), Vertex(3), parameters::maximum_distance(2.5)), infinity);
  EXPECT_TRUE(points.empty());
  EXPECT_EQ(path(Vertex(0), Vertex(3), parameters::maximum_distance(3)), 3);
  EXPECT_EQ(points.size(), 4u);
  Recorder<Vertex> recorder;
  recorder.stop_at = 0;
  EXPECT_EQ(
      path(Vertex(0), Vertex(15), parameters::combine(parameters::visitor(std::ref(recorder)))),
      infinity);
  EXPECT_TRUE(points.empty());
}

TEST(Class, keeps_iterators_to_sources)
{
  const Mesh mesh = to_mesh(flat_grid(10, 10));
  Shortest_paths paths(mesh);
  EXPECT_TRUE(paths.changed_since_last_build());
  std::vector<Shortest_paths::Source_point_iterator> iterators;
  for(Mesh::size_type i = 0; i < 50; ++i)
    iterators.push_back(paths.add_source_point(Vertex(i)));
  paths.build_sequence_tree();
  for(std::size_t i = 0; i < 50; i += 2)
    paths.remove_source_point(iterators[i]);
  EXPECT_EQ(paths.number_of_source_points(), 25u);
  EXPECT_TRUE(paths.changed_since_last_build());
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(4)).first, 1);
  for(std::size_t i = 1; i < 50; i += 2)
  {
    const auto [distance, it] =
        paths.shortest_distance_to_source_points(Vertex(static_cast<Mesh::size_type>(i)));
    EXPECT_EQ(distance, 0);
    EXPECT_TRUE(it == iterators[i]);
  }
  EXPECT_TRUE(paths.source_points_begin() == iterators[1]);
  const std::vector<Vertex> none;
  EXPECT_TRUE(paths.add_source_points(none.begin(), none.end()) == paths.source_points_end());
  EXPECT_FALSE(paths.changed_since_last_build());
}

TEST(Class, takes_isolated_vertices_as_sources)
{
  Mesh mesh = to_mesh(flat_grid(3, 3));
  const Vertex alone = mesh.add_vertex(Point(9, 9, 9));
  Shortest_paths paths(mesh);
  const auto it = paths.add_source_point(alone);
  EXPECT_EQ(it->first, Mesh::null_face());
  EXPECT_EQ(paths.shortest_distance_to_source_points(alone).first, 0);
  EXPECT_LT(paths.shortest_distance_to_source_points(Vertex(0)).first, 0);
  std::vector<Point> points;
  paths.shortest_path_points_to_source_points(alone, std::back_inserter(points));
  EXPECT_EQ(points, std::vector<Point>{mesh.point(alone)});
}

TEST(Class, runs_under_conditions_until_sources_change)
{
  const Mesh mesh = to_mesh(flat_grid(50, 50));
  const Vertex near(3), far(49);
  Shortest_paths paths(mesh);
  paths.collect_statistics(true);
  paths.add_source_point(Vertex(0));
  const auto distance = [&](const Vertex v) {
    return paths.shortest_distance_to_source_points(v).first;
  };

  paths.build_sequence_tree(parameters::maximum_distance(5));
  EXPECT_FALSE(paths.changed_since_last_build());
  EXPECT_EQ(distance(near), 3);
  EXPECT_LT(distance(far), 0);
  paths.build_sequence_tree(); // nothing has changed
  EXPECT_LT(distance(far), 0);

  paths.build_sequence_tree(parameters::targets(std::vector<Vertex>{near}));
  EXPECT_EQ(distance(near), 3);
  EXPECT_LT(distance(far), 0);
  EXPECT_LT(paths.search().statistics().settled_nodes, 100u);

  paths.build_sequence_tree(parameters::default_values());
  EXPECT_EQ(distance(far), 49);

  Recorder<Vertex> recorder;
  recorder.stop_at = 10;
  paths.build_sequence_tree(parameters::visitor(std::ref(recorder)));
  EXPECT_GE(recorder.settled.size(), 10u);
  EXPECT_LT(distance(far), 0);
  for(const auto& [v, d] : recorder.settled)
    EXPECT_EQ(distance(v), d);

  paths.add_source_point(near);
  EXPECT_EQ(distance(far), 46);
}

TEST(Class, is_usable_after_an_exception)
{
  const Mesh mesh = to_mesh(flat_grid(20, 20));
  Shortest_paths paths(mesh);
  paths.add_source_point(Vertex(0));
  Recorder<Vertex> recorder;
  recorder.throw_at = 100;
  EXPECT_THROW(paths.build_sequence_tree(parameters::visitor(std::ref(recorder))),
               std::runtime_error);
  EXPECT_EQ(recorder.settled.size(), 100u);
  EXPECT_TRUE(paths.changed_since_last_build());
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(19)).first, 19);
}

// Counts in memory that copies of it share.
struct Shared_counter : CGAL::Approximate_geodesics::Geodesic_visitor_base
{
  explicit Shared_counter(std::size_t& shared) : shared_count(&shared) {}
  void on_settled(Vertex, double) { ++own_count, ++*shared_count; }

  std::size_t* shared_count;
  std::size_t own_count = 0;
};

TEST(Visitor, is_copied_unless_given_by_reference)
{
  Mesh mesh = to_mesh(flat_grid(7, 7));
  const auto map = mesh.add_property_map<Vertex, double>("distance").first;
  std::size_t count = 0;
  Shared_counter counter(count);
  CGAL::approximate_geodesic_distances(mesh, map, Vertex(0), parameters::visitor(counter));
  EXPECT_EQ(count, 49u);
  EXPECT_EQ(counter.own_count, 0u);
  CGAL::approximate_geodesic_distances(mesh, map, Vertex(0),
                                       parameters::visitor(std::ref(counter)));
  EXPECT_EQ(count, 98u);
  EXPECT_EQ(counter.own_count, 49u);
}

TEST(Class, gives_nodes_and_a_graph_to_search_oneself)
{
  const Mesh mesh = to_mesh(flat_grid(7, 7));
  const Shortest_paths paths(mesh);
  Search search(paths.graph());
  search.run_from(paths.node(Vertex(0)));
  EXPECT_EQ(search.distance(paths.node(Vertex(6))), 6);
}

} // namespace
