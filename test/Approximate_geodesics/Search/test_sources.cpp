// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles/test_oracles.h"

#include <CGAL/approximate_geodesic_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// Several sources.

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

std::vector<Vertex> random_vertices(const Mesh& mesh, const std::size_t n, Random& random)
{
  std::vector<Vertex> result;
  for(std::size_t i = 0; i < n; ++i)
    result.push_back(random_vertex(mesh, random));
  return result;
}

TEST(Sources, give_the_minimum_over_single_sources)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    Mesh_search search(mesh);
    const std::vector<Vertex> sources = random_vertices(mesh, 6, random);
    std::vector<double> expected(mesh.num_vertices(), infinity);
    for(const Vertex s : sources)
      expected = minimum(expected, search.distances({s}));
    const Field field = search.run(sources);
    EXPECT_TRUE(have_same_bits(field.distance, expected));
    EXPECT_TRUE(is_optimal(mesh, edge_lengths(mesh), field, sources));
  }
}

TEST(Sources, may_be_repeated_and_in_any_order)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    Mesh_search search(mesh);
    std::vector<Vertex> sources = random_vertices(mesh, 5, random);
    const std::vector<double> expected = search.distances(sources);
    for(std::size_t i = 0; i < 5; ++i)
    {
      sources.push_back(sources[random.below(5)]);
      random.shuffle(sources);
      EXPECT_TRUE(have_same_bits(search.distances(sources), expected));
    }
  }
}

// The source that a vertex is said to be nearest to, alone, has the same distance; and a vertex has
// the label of the one before it.
TEST(Sources, are_labeled_consistently)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    Mesh_search search(mesh), single(mesh);
    std::vector<Vertex> sources = random_vertices(mesh, 4, random);
    sources.push_back(sources.front());
    std::vector<std::vector<double>> distances;
    for(const Vertex s : sources)
      distances.push_back(single.distances({s}));
    const Field field = search.run(sources);
    for(const Vertex v : mesh.vertices())
    {
      const std::size_t source = search.search().source(search.node(v));
      EXPECT_EQ(source == Search::null_source, field.distance[v.idx()] == infinity);
      if(source == Search::null_source)
        continue;
      ASSERT_LT(source, sources.size() - 1); // of equal ones, the first
      EXPECT_EQ(distances[source][v.idx()], field.distance[v.idx()]);
      const Node predecessor = search.search().predecessor(search.node(v));
      if(predecessor != Search::null_node)
      {
        EXPECT_EQ(search.search().source(predecessor), source);
      }
      else
      {
        EXPECT_EQ(sources[source], v);
      }
    }
  }
}

// A workspace is asked for labels in some runs and not in others.
TEST(Sources, are_labeled_again_in_every_run)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  Mesh_search used(mesh);
  for(std::size_t run = 0; run < 40; ++run)
  {
    const std::vector<Vertex> sources = random_vertices(mesh, 3, random);
    Search::Stop_rule stop;
    if(run % 3 == 0)
      stop.maximum_distance = random.between(0, 10);
    if(run % 3 == 1)
      stop.targets = {used.node(random_vertex(mesh, random))};
    Mesh_search fresh(mesh);
    used.run(sources, stop);
    fresh.run(sources, stop);
    for(Node n = 0; n < mesh.number_of_vertices() && run % 4 != 0; ++n)
      EXPECT_EQ(used.search().source(n) == Search::null_source, !fresh.search().is_reached(n));
    for(Node n = 0; n < mesh.number_of_vertices() && run % 4 == 1; ++n)
      EXPECT_EQ(used.search().source(n), fresh.search().source(n));
  }
}

TEST(Seeds, may_start_with_a_distance)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    const std::vector<double> lengths = edge_lengths(mesh);
    const double scale = *std::max_element(lengths.begin(), lengths.end());
    Mesh_search search(mesh);
    std::vector<Search::Seed> seeds = search.seeds(random_vertices(mesh, 4, random));
    for(Search::Seed& seed : seeds)
      seed.distance = random.between(0, 3 * scale);
    seeds.push_back({seeds[0].node, seeds[0].distance / 2, 77}); // the better of two at one node
    search.search().run(seeds);

    // Seeds are vertices, so a distance is reached from a seed by Dijkstra's sums from there.
    for(const Edge e : mesh.edges())
      for(const Halfedge h : {mesh.halfedge(e), mesh.opposite(mesh.halfedge(e))})
        EXPECT_LE(search.search().distance(search.node(mesh.target(h))),
                  search.search().distance(search.node(mesh.source(h))) + lengths[e.idx()]);
    for(Node n = 0; n < mesh.number_of_vertices(); ++n)
    {
      const double distance = search.search().distance(n);
      for(const Search::Seed& seed : seeds)
        EXPECT_LE(seed.node == n ? distance : 0, seed.distance);
      const Node p = search.search().predecessor(n);
      bool is_tight = distance == infinity;
      for(const Search::Seed& seed : seeds)
        is_tight |= p == Search::null_node && seed.node == n && seed.distance == distance &&
                    search.search().source(n) == seed.source;
      if(p != Search::null_node)
        for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(search.vertex(n))))
          is_tight |= search.node(mesh.source(h)) == p &&
                      search.search().distance(p) + lengths[mesh.edge(h).idx()] == distance;
      EXPECT_TRUE(is_tight) << "node " << n;
    }
  }
}

// A mesh whose unit is tiny: a seed's distance there can be larger than any number of units.
TEST(Seeds, must_not_start_beyond_all_units)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4).transformed(
      [](const Point& p) { return Point(p.x() * 1e-300, p.y() * 1e-300, 0); }));
  Mesh_search search(mesh);
  search.search().run_from(Node(3));
  EXPECT_EQ(search.search().source(0), 0u);
  EXPECT_THROW(search.search().run({{0, 0, 5}, {3, 1e300, 6}}), std::invalid_argument);
  search.search().run({{0, 0, 5}});
  EXPECT_EQ(search.search().source(3), 5u);
}

// Asking for sources in the middle of a run is too early, but does no harm to what is asked later.
TEST(Seeds, are_right_though_a_visitor_asked_too_early)
{
  struct Asker : CGAL::Approximate_geodesics::Geodesic_visitor_base
  {
    explicit Asker(const Mesh_search& a_search) : search(a_search) {}
    void on_settled(const Node node, double) { search.search().source(node); }
    bool go_further() { return --rounds > 0; }
    const Mesh_search& search;
    int rounds = 1 << 30;
  };

  const Mesh mesh = to_mesh(flat_grid(30, 30));
  Mesh_search search(mesh), fresh(mesh);
  const std::vector<Search::Seed> seeds{
      {0, 0, 10}, {60, 1000, 11}, {500, 0, 12}}; // node 60 is overtaken
  fresh.search().run(seeds);
  for(const int rounds : {3, 1 << 30})
  {
    Asker asker(search);
    asker.rounds = rounds;
    search.search().run(seeds, {}, asker);
    for(Node n = 0; n < mesh.number_of_vertices(); ++n)
    {
      if(!search.search().is_reached(n))
        continue;
      EXPECT_EQ(search.search().source(n), fresh.search().source(n)) << "node " << n;
    }
  }
  search.search().run({{700, 0, 77}});
  EXPECT_EQ(search.search().source(500), 77u);
}

TEST(Free_function, writes_distances_labels_and_predecessors)
{
  Random random(test_seed());
  for(const auto& [name, const_mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    Mesh mesh = const_mesh;
    const auto distance = mesh.add_property_map<Vertex, double>("distance", -1).first;
    const auto label = mesh.add_property_map<Vertex, int>("label", -5).first;
    const auto predecessor = mesh.add_property_map<Vertex, Vertex>("predecessor").first;
    const std::vector<Vertex> sources = random_vertices(mesh, 3, random);
    CGAL::approximate_geodesic_distances(
        mesh, distance, sources,
        parameters::nearest_source_map(label).predecessor_map(predecessor));

    Mesh_search search(mesh);
    const Field expected = search.run(sources);
    for(const Vertex v : mesh.vertices())
    {
      EXPECT_EQ(distance[v], expected.distance[v.idx()]);
      const bool is_reached = distance[v] < infinity;
      EXPECT_EQ(label[v], is_reached ? int(search.search().source(search.node(v))) : -1);
      const bool is_source =
          distance[v] == 0 && expected.predecessor[v.idx()] == Mesh::null_vertex();
      EXPECT_EQ(predecessor[v], is_source ? v : expected.predecessor[v.idx()]);
    }
  }
}

TEST(Free_function, takes_no_source_and_no_mesh)
{
  Mesh empty;
  const auto nothing = empty.add_property_map<Vertex, double>("distance").first;
  EXPECT_NO_THROW(CGAL::approximate_geodesic_distances(empty, nothing, std::vector<Vertex>()));

  Mesh mesh = to_mesh(flat_grid(3, 3));
  const Vertex alone = mesh.add_vertex(Point(0, 0, 0));
  const auto distance = mesh.add_property_map<Vertex, double>("distance", -1).first;
  CGAL::approximate_geodesic_distances(mesh, distance, std::vector<Vertex>());
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(distance[v], infinity);
  CGAL::approximate_geodesic_distances(mesh, distance, alone);
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(distance[v], v == alone ? 0 : infinity);

  Mesh single;
  const Vertex only = single.add_vertex(Point(1, 2, 3));
  const auto zero = single.add_property_map<Vertex, double>("distance", -1).first;
  CGAL::approximate_geodesic_distances(single, zero, only);
  EXPECT_EQ(zero[only], 0);
}

} // namespace
