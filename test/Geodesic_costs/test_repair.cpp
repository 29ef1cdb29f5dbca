// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "meshes/steiner_meshes.h"
#include "oracles/straight_lines.h"

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs/Directional_graph.h>
#include <CGAL/Geodesic_costs/cost_functions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Searches that are repaired after changes of weights, barriers and sources, beside fresh ones.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

// A graph that changes at random, with a search that is repaired and one that is not.
template <typename Placement>
class Changing_graph
{
  using Graph = Steiner_graph<Placement>;
  using Index = AG::Intrinsic_triangulation::Index;

public:
  Changing_graph(const Mesh& mesh, const Barriers& barriers, const Placement& placement, Random& r)
    : m_random(r),
      m_weights(random_weights(mesh, m_random, 0.1, 10, 0.05)),
      m_graph(Triangulation(mesh,
                            with_weights(m_weights).edge_is_constrained_map(barrier_map(barriers))),
              placement),
      m_repaired(m_graph),
      m_fresh(m_graph)
  {
    for(Index h = 0; h < surface().number_of_halfedges(); ++h)
    {
      if(!surface().is_border(h))
        m_halfedges.push_back(h);
      if(surface().is_barrier(h))
        m_barriers.push_back(h);
    }
    add_source();
  }

  void change()
  {
    const std::size_t kind = m_random.below(8);
    if(kind == 0)
      add_source();
    else if(kind == 1 && m_sources.size() > 1)
      m_sources.erase(m_sources.begin() + std::ptrdiff_t(m_random.below(m_sources.size())));
    else if(kind < 4 && !m_barriers.empty())
      m_graph.set_barriers(random_barrier_changes(1 + m_random.below(3)));
    else
      m_graph.set_weights(random_changes(1 + m_random.below(3)));
  }

  void expect_equal_bits()
  {
    m_repaired.repair(m_sources);
    m_fresh.run(m_sources);
    const auto &repaired = m_repaired.search(), &fresh = m_fresh.search();
    std::size_t number_reached = 0;
    for(std::uint32_t n = 0; n < m_graph.number_of_nodes(); ++n)
    {
      ASSERT_EQ(repaired.distance(n), fresh.distance(n)) << "node " << n;
      ASSERT_EQ(repaired.source(n) == repaired.null_source, !fresh.is_reached(n));
      const auto before = repaired.predecessor(n);
      if(before != repaired.null_node)
      {
        ASSERT_LE(repaired.distance(before), repaired.distance(n));
      }
      number_reached += fresh.is_reached(n) ? 1 : 0;
    }
    expect_order(number_reached);
  }

  // ... also of other points, and paths are as long as they are said to be.
  void expect_paths()
  {
    for(int i = 0; i < 5; ++i)
    {
      const AG::Intrinsic_point p = random_point();
      const double distance = m_repaired.distance(p);
      ASSERT_EQ(distance, m_fresh.distance(p));
      if(distance == infinity)
        continue;
      const auto answer = m_repaired.nearest(p);
      const double initial = m_sources[answer.source].distance;
      ASSERT_NEAR(m_repaired.find_path(p).length, distance - initial, 1e-10 * distance);
    }
  }

private:
  const AG::Intrinsic_triangulation& surface() const { return m_graph.triangulation(); }

  Index random_halfedge() { return m_halfedges[m_random.below(m_halfedges.size())]; }

  AG::Intrinsic_point random_point()
  {
    const Index h = random_halfedge();
    const double t = m_random.between(0.1, 0.45), s = m_random.between(0.1, 0.45);
    switch(m_random.below(3))
    {
    case 0:
      return AG::Intrinsic_point::at_vertex(surface().target(h));
    case 1:
      return AG::Intrinsic_point::on_edge(h, t);
    default:
      return AG::Intrinsic_point::in_face(h, t, s);
    }
  }

  void add_source()
  {
    m_sources.push_back({random_point(), m_random.below(2) == 0 ? 0 : m_random.between(0, 3)});
  }

  std::vector<AG::Weight_change> random_changes(const std::size_t number)
  {
    std::vector<AG::Weight_change> result;
    for(std::size_t i = 0; i < number; ++i)
    {
      const std::size_t kind = m_random.below(10);
      const double weight = kind == 0   ? 0
                            : kind == 1 ? infinity
                            : kind == 2 ? 1
                                        : m_random.between(0.1, 10);
      result.push_back({random_halfedge(), weight});
    }
    return result;
  }

  std::vector<AG::Barrier_change> random_barrier_changes(const std::size_t number)
  {
    std::vector<AG::Barrier_change> result;
    for(std::size_t i = 0; i < number; ++i)
      result.push_back({m_barriers[m_random.below(m_barriers.size())], m_random.below(2) == 0});
    return result;
  }

  // Each node that was reached is in the order, and no other.
  void expect_order(const std::size_t number_reached) const
  {
    std::vector<bool> is_known(m_graph.number_of_nodes());
    std::size_t number = 0;
    for(const auto node : m_repaired.search().reached_nodes())
    {
      ASSERT_TRUE(m_fresh.search().is_reached(node));
      number += is_known[node] ? 0 : 1;
      is_known[node] = true;
    }
    ASSERT_EQ(number, number_reached);
    ASSERT_LE(m_repaired.search().reached_nodes().size(), 4 * m_graph.number_of_nodes());
  }

  Random& m_random;
  Weights m_weights;
  Graph m_graph;
  AG::Surface_search<Graph> m_repaired, m_fresh;
  std::vector<Index> m_halfedges; // not at the border
  std::vector<Index> m_barriers;
  std::vector<AG::Source_point> m_sources;
};

template <typename Placement>
void repair_after_changes(const Mesh& mesh,
                          const double share_of_barriers,
                          const Placement& placement,
                          const std::size_t number_of_changes,
                          Random& random)
{
  const Barriers barriers = random_barriers(mesh, share_of_barriers, random);
  Changing_graph<Placement> graph(mesh, barriers, placement, random);
  for(std::size_t i = 0; i < number_of_changes; ++i)
  {
    SCOPED_TRACE("change " + std::to_string(i));
    graph.change();
    graph.expect_equal_bits();
    graph.expect_paths();
    if(testing::Test::HasFatalFailure())
      return;
  }
}

// Where faces have no area, sums are the same only up to rounding, from different queues, too.
bool have_faces_area(const Mesh& mesh)
{
  return Steiner_graph<>(Triangulation(mesh), lenient_points(0.5)).epsilon() < infinity;
}

void repair_generated_meshes(const std::size_t largest_mesh, const std::size_t number_of_changes)
{
  for_generated_meshes([=](const Mesh& mesh, Random& random) {
    if(mesh.num_faces() > largest_mesh)
      return;
    for(const double share : {0., 0.1})
    {
      for(const std::size_t number : {0u, 3u})
        repair_after_changes(mesh, share, Fixed_number_of_points(number), number_of_changes,
                             random);
      if(have_faces_area(mesh))
        repair_after_changes(mesh, share, lenient_points(0.5), number_of_changes / 4, random);
    }
  });
}

TEST(Repaired_search, has_the_bits_of_a_fresh_one) { repair_generated_meshes(1000, 20); }

TEST(Repaired_search, has_the_bits_of_a_fresh_one_after_very_many_changes)
{
  repair_generated_meshes(10000, 170); // more than 10^4 in all
}

// ... where all lengths are rounded sums of the same few numbers, so that many are equal.
TEST(Repaired_search, has_the_bits_of_a_fresh_one_where_many_paths_are_equal)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(12, 9));
  using Placement = Fixed_number_of_points;
  Steiner_graph<Placement> graph(Triangulation(mesh), Placement(3));
  AG::Propagation<Steiner_graph<Placement>> repaired(graph), fresh(graph);
  const std::vector<AG::Seed> seeds = {{0}, {50}};
  for(int i = 0; i < 200; ++i)
  {
    const auto h =
        static_cast<std::uint32_t>(random.below(graph.triangulation().number_of_halfedges()));
    if(graph.triangulation().is_border(h))
      continue;
    graph.set_weights({{h, double(1 + random.below(2))}});
    repaired.repair(seeds);
    fresh.run(seeds);
    for(std::uint32_t n = 0; n < graph.number_of_nodes(); ++n)
      ASSERT_EQ(repaired.distance(n), fresh.distance(n)) << i;
  }
}

// Seeds come and go. Returns how many arcs are read, relative to those of fresh searches.
template <typename Graph>
double repair_after_moves(const Graph& graph, Random& random)
{
  AG::Propagation<Graph> repaired(graph), fresh(graph);
  repaired.collect_statistics(true);
  fresh.collect_statistics(true);
  std::vector<AG::Seed> seeds;
  double repaired_arcs = 0, fresh_arcs = 0;
  for(int i = 0; i < 40; ++i)
  {
    if(seeds.size() > 5)
      seeds.erase(seeds.begin());
    seeds.push_back(
        {static_cast<std::uint32_t>(random.below(graph.triangulation().number_of_vertices()))});
    repaired.repair(seeds);
    fresh.run(seeds);
    for(std::uint32_t n = 0; n < graph.number_of_nodes(); ++n)
      EXPECT_EQ(repaired.distance(n), fresh.distance(n)) << i;
    repaired_arcs += static_cast<double>(repaired.statistics().relaxations);
    fresh_arcs += static_cast<double>(fresh.statistics().relaxations);
  }
  return repaired_arcs / fresh_arcs;
}

TEST(Repaired_search, has_the_bits_of_a_fresh_one_where_costs_depend_on_the_direction)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(12, 9, random));
  using Graph = AG::Directional_graph<Fixed_number_of_points>;
  const Graph graph(Triangulation(mesh, CGAL::parameters::face_weight_map(
                                            AG::directional_cost(AG::Hiking_time()))),
                    Fixed_number_of_points(3));
  EXPECT_LT(repair_after_moves(graph, random), 0.5);
}

TEST(Repaired_search, has_the_bits_of_a_fresh_one_along_edges)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    const AG::Edge_graph graph{Triangulation(mesh)};
    repair_after_moves(graph, random);
  });
  Random random(test_seed());
  const AG::Edge_graph without_hubs{Triangulation(to_mesh(terrain(30, 20, random)))};
  EXPECT_LT(repair_after_moves(without_hubs, random), 0.5);
}

// Few nodes are expanded, and all count as settled.
TEST(Repaired_search, counts_no_repetitions_that_there_are_not)
{
  const AG::Edge_graph graph{Triangulation(to_mesh(flat_grid(40, 40)))};
  AG::Propagation<AG::Edge_graph> search(graph);
  search.collect_statistics(true);
  search.run_from(0);
  for(const std::uint32_t node : {5u, 9u})
  {
    search.run_further({{node}});
    EXPECT_LE(search.statistics().repeated_pops(), search.statistics().pops);
  }
  search.repair({{0}, {5}});
  EXPECT_LE(search.statistics().repeated_pops(), search.statistics().pops);
}

TEST(Repaired_search, reads_few_arcs)
{
  const Mesh mesh = to_mesh(flat_grid(40, 40));
  using Placement = Fixed_number_of_points;
  Steiner_graph<Placement> graph(Triangulation(mesh), Placement(3));
  AG::Propagation<Steiner_graph<Placement>> search(graph);
  search.collect_statistics(true);
  const auto node = [&](const std::size_t i) { return graph.triangulation().vertex(i); };
  const std::vector<AG::Seed> seeds = {{node(0)}};
  search.run(seeds);
  const std::size_t number_of_arcs = search.statistics().relaxations;
  search.repair(seeds);
  EXPECT_EQ(search.statistics().relaxations, 0u);
  const auto last = graph.triangulation().first_halfedge(node(mesh.num_vertices() - 1));
  const auto h = graph.triangulation().is_border(last) ? last + 1 : last;
  graph.set_weights({{h, 2}});
  search.repair(seeds);
  EXPECT_GT(search.statistics().relaxations, 0u);
  EXPECT_LT(search.statistics().relaxations, number_of_arcs / 100);
}

// ... although a run from more seeds comes between them and the repair.
TEST(Repaired_search, knows_changes_before_further_seeds)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(9, 8, random));
  using Placement = Fixed_number_of_points;
  Steiner_graph<Placement> graph(Triangulation(mesh), Placement(2));
  AG::Propagation<Steiner_graph<Placement>> repaired(graph), fresh(graph);
  for(int i = 0; i < 20; ++i)
  {
    const std::vector<AG::Seed> seeds = {{0}, {static_cast<std::uint32_t>(10 + i)}};
    repaired.run({seeds[0]});
    auto h = graph.triangulation().first_halfedge(
        static_cast<std::uint32_t>(random.below(mesh.num_vertices())));
    h += graph.triangulation().is_border(h) ? 1 : 0;
    graph.set_weights({{h, random.between(0.2, 5)}});
    repaired.run_further({seeds[1]});
    repaired.repair(seeds);
    fresh.run(seeds);
    for(std::uint32_t n = 0; n < graph.number_of_nodes(); ++n)
      ASSERT_EQ(repaired.distance(n), fresh.distance(n)) << i;
  }
}

// A run that ended early leaves nothing to repair.
TEST(Repaired_search, begins_anew_after_other_runs)
{
  const Mesh mesh = to_mesh(flat_grid(12, 9));
  using Placement = Fixed_number_of_points;
  Steiner_graph<Placement> graph(Triangulation(mesh), Placement(1));
  AG::Surface_search<Steiner_graph<Placement>> search(graph), fresh(graph);
  const auto point = [&](const std::size_t i) {
    return AG::Intrinsic_point::at_vertex(graph.triangulation().vertex(i));
  };
  const auto expect = [&] {
    search.repair({{point(3)}});
    fresh.run({{point(3)}});
    for(std::size_t i = 0; i < mesh.num_vertices(); ++i)
      ASSERT_EQ(search.distance(point(i)), fresh.distance(point(i)));
  };
  expect();
  search.run({{point(3)}}, {2});
  expect();
  search.run({{point(3)}}, {infinity, {point(17)}});
  expect();
  search.run_to(point(17), {{point(3)}});
  expect();
  const Weights weights(mesh.num_faces(), 3);
  graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(weights)));
  expect();
  search.repair({});
  EXPECT_EQ(search.distance(point(3)), infinity);
  expect();
}

TEST(Changes_of_arcs, are_listed_in_linear_time_one_by_one)
{
  AG::Arc_changes changes;
  std::size_t number_of_allocations = 0, memory = 0;
  for(std::size_t i = 0; i < 10000; ++i)
  {
    changes.reserve(1);
    changes.add({i, true, false}, 20000);
    number_of_allocations += changes.memory() != memory ? 1 : 0;
    memory = changes.memory();
  }
  EXPECT_EQ(changes.number(), 10000u);
  EXPECT_LT(number_of_allocations, 30u);
}

TEST(Repaired_search, is_what_the_class_makes_after_changes)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(9, 8, random));
  using Placement = Fixed_number_of_points;
  Weights weights = random_weights(mesh, random, 0.5, 2);
  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Placement>> paths(
      mesh, steiner_graph(mesh, weights, Placement(2)));
  std::vector<Vertex> sources = {Vertex(3), Vertex(40)};
  paths.add_source_points(sources.begin(), sources.end());
  for(int i = 0; i < 30; ++i)
  {
    if(i % 5 == 4)
    {
      sources.push_back(random_vertex(mesh, random));
      paths.add_source_point(sources.back());
    }
    else
    {
      const Face f(static_cast<Mesh::size_type>(random.below(mesh.num_faces())));
      weights[f] = i % 7 == 6 ? infinity : random.between(0.5, 4);
      paths.set_weights(std::vector<std::pair<Face, double>>{{f, weights[f]}});
    }
    const std::vector<double> expected = costs(mesh, weights, Placement(2), sources);
    for(const Vertex v : mesh.vertices())
    {
      const double distance = paths.shortest_distance_to_source_points(v).first;
      ASSERT_EQ(distance < 0 ? infinity : distance, expected[v]) << i;
    }
  }
}

// ... up to rounding, as the points on the two sides of a barrier are counted from different ends.
TEST(Lifted_barriers, give_the_same_as_a_graph_built_without_them)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    if(mesh.num_faces() > 1000)
      return;
    using Placement = Fixed_number_of_points;
    const Weights weights = random_weights(mesh, random, 0.1, 10, 0.05);
    Barriers barriers = random_barriers(mesh, 0.3, random);
    std::vector<Edge> edges;
    for(const Edge e : mesh.edges())
      if(barriers[e.idx()] && !mesh.is_border(e))
        edges.push_back(e);
    for(const std::size_t number : {0u, 1u, 4u, 20u})
    {
      const auto graph = [&] {
        return Steiner_graph<Placement>(
            Triangulation(mesh,
                          with_weights(weights).edge_is_constrained_map(barrier_map(barriers))),
            Placement(number));
      };
      AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Placement>> paths(mesh, graph());
      const Vertex source = random_vertex(mesh, random);
      paths.add_source_point(source);
      const Barriers all = barriers;
      for(int i = 0; i < 5; ++i)
      {
        std::vector<std::pair<Edge, bool>> changes;
        for(const Edge e : edges)
          if(random.below(2) == 0)
          {
            barriers[e.idx()] = !barriers[e.idx()];
            changes.emplace_back(e, barriers[e.idx()]);
          }
        paths.set_barriers(changes);
        AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Placement>> others(mesh, graph());
        others.add_source_point(source);
        for(const Vertex v : mesh.vertices())
        {
          const double expected = others.shortest_distance_to_source_points(v).first;
          ASSERT_NEAR(paths.shortest_distance_to_source_points(v).first, expected,
                      1e-13 * std::abs(expected))
              << number << " points, change " << i;
        }
      }
      barriers = all;
    }
  });
}

// Where points are for a bound, they are on barriers only on request.
TEST(Lifted_barriers, keep_the_bound_if_it_is_wanted)
{
  const Mesh mesh = to_mesh(flat_grid(9, 7));
  Barriers barriers(mesh.num_edges());
  const auto is_on_wall = [&](const Vertex v) { return mesh.point(v).x() == 4; };
  std::vector<std::pair<Edge, bool>> changes;
  for(const Edge e : mesh.edges())
    if(is_on_wall(mesh.vertex(e, 0)) && is_on_wall(mesh.vertex(e, 1)))
    {
      barriers[e.idx()] = true;
      changes.emplace_back(e, false);
    }
  for(const bool may_change : {false, true})
  {
    AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<>> paths(
        mesh, Steiner_graph<>(Triangulation(mesh, with_barriers(barriers)),
                              Geometric_points(0.1, may_change)));
    paths.add_source_point(Vertex(1));
    EXPECT_EQ(paths.graph().epsilon(), 0.1);
    EXPECT_LT(paths.shortest_distance_to_source_points(Vertex(8)).first, 0);
    paths.set_barriers(changes);
    EXPECT_EQ(paths.graph().epsilon(), may_change ? 0.1 : infinity);
    for(const Vertex v : mesh.vertices())
    {
      const double exact = distance_in_space(mesh.point(Vertex(1)), mesh.point(v));
      const double found = paths.shortest_distance_to_source_points(v).first;
      EXPECT_GE(found, exact * (1 - 1e-12));
      if(may_change)
      {
        EXPECT_LE(found, exact * 1.1);
      }
    }
    for(auto& change : changes)
      change.second = true;
    paths.set_barriers(changes);
    EXPECT_LT(paths.shortest_distance_to_source_points(Vertex(8)).first, 0);
    for(auto& change : changes)
      change.second = false;
  }
}

TEST(Lifted_barriers, are_refused_if_they_were_none)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  Barriers barriers(mesh.num_edges());
  std::vector<std::pair<Edge, bool>> changes;
  for(const Edge e : mesh.edges())
    if(!mesh.is_border(e))
    {
      barriers[e.idx()] = changes.empty();
      changes.emplace_back(e, false);
    }
  using Placement = Fixed_number_of_points;
  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Placement>> paths(
      mesh, Steiner_graph<Placement>(Triangulation(mesh, with_barriers(barriers)), Placement(1)));
  expect_message<std::invalid_argument>([&] { paths.set_barriers(changes); }, "barrier", "vert");
  EXPECT_FALSE(paths.graph().triangulation().has_lifted_barriers());
  Steiner_graph<Placement> graph = paths.graph();
  expect_message<std::invalid_argument>(
      [&] {
        graph.set_barriers({AG::Barrier_change{1u << 20, false}});
      },
      "halfedge");
}

TEST(Changes_of_weights, are_refused_if_they_are_wrong)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  using Placement = Fixed_number_of_points;
  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Placement>> paths(
      mesh, Steiner_graph<Placement>(Triangulation(mesh), Placement(1)));
  using Changes = std::vector<std::pair<Face, double>>;
  const Face f(2);
  for(const double weight : {-1., std::nan(""), 1e307})
    expect_message<std::invalid_argument>(
        [&] {
          paths.set_weights(Changes{{Face(1), 5}, {f, weight}});
        },
        "weight", "the face with");
  expect_message<std::invalid_argument>(
      [&] {
        paths.set_weights(Changes{{Face(1234), 1}});
      },
      "face");
  EXPECT_FALSE(paths.graph().triangulation().has_weights());
  Steiner_graph<Placement> graph = paths.graph();
  expect_message<std::invalid_argument>([&] { graph.set_weights({{1u << 20, 2}}); }, "halfedge");
  paths.set_weights(Changes{{f, 0}, {Face(1), 1e-300}, {Face(3), infinity}});
  paths.add_source_point(Vertex(0));
  EXPECT_GT(paths.shortest_distance_to_source_points(Vertex(15)).first, 0);
}

} // namespace
