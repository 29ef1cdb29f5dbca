// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/test_recorder.h"
#include "meshes/hostile_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

// Cones of several vertices that advance together, on meshes of all kinds.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Lazy_discrete_geodesic_graph;
using AG::Saddle_vertex_graph;
using CGAL::parameters::epsilon;
using Lazy_search = AG::Propagation<Lazy_discrete_geodesic_graph>;

// ----- the meshes

// A spike around which lines wind: a cone with a small angle at its tip.
Soup spiral(const std::size_t rings)
{
  return grid(7, rings, [](const double i, const double j) {
    const double turn = i * std::acos(-1.) / 3, radius = 0.02 * j; // the first and last column meet
    return Point(radius * std::cos(turn), radius * std::sin(turn), -j);
  });
}

// The same, closed.
Soup closed_spike(const std::size_t rings)
{
  Soup result = spiral(rings);
  for(auto& triangle : result.triangles)
    for(std::size_t& v : triangle)
      v = v < 7 ? 0 : v % 7 == 6 ? v - 6 : v;
  const auto is_point = [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  result.triangles.erase(std::remove_if(result.triangles.begin(), result.triangles.end(), is_point),
                         result.triangles.end());
  return result;
}

std::vector<Named_mesh> all_meshes()
{
  std::vector<Named_mesh> result = generated_meshes(test_seed());
  for(const Hostile_mesh& hostile : accepted_meshes())
    if(hostile.refusal_across_faces.empty() && hostile.mesh.number_of_vertices() < 1000)
      result.push_back({hostile.name, hostile.mesh});
  Random random(test_seed());
  result.push_back({"a spike", to_mesh(closed_spike(25))});
  result.push_back({"a slit spike", to_mesh(spiral(12))});
  result.push_back({"a terrain with vertices on edges",
                    to_mesh(with_caps(terrain(9, 8, random), [] { return 0.5; }))});
  return result;
}

std::vector<Node> some_nodes(const Triangulation& t)
{
  const std::size_t n = t.number_of_vertices();
  if(n == 0)
    return {};
  return {t.vertex(0), t.vertex(n / 2), t.vertex(n - 1)};
}

// ----- the bound

template <typename Search>
std::vector<double> distances(Search& search, const std::vector<Node>& sources)
{
  std::vector<typename Search::Seed> seeds;
  for(const Node source : sources)
    seeds.push_back({source, 0.1 * search.graph().unit() * static_cast<double>(seeds.size())});
  search.run(seeds);
  return distances_of_nodes(search);
}

// What rounding may add to distances or take off them, besides a part of them.
double rounding_of_distances(const Triangulation& t)
{
  const auto& lengths = t.lengths();
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  return 1e-13 * longest * t.unit();
}

void expect_bound_of_search(Lazy_search& search,
                            const std::vector<Node>& sources,
                            const std::vector<double>& exact)
{
  constexpr double relative = 1e-11;
  const Lazy_discrete_geodesic_graph& graph = search.graph();
  const std::vector<double> found = distances(search, sources);
  const double absolute = rounding_of_distances(graph.triangulation());
  for(Node v = 0; v < graph.number_of_nodes(); ++v)
  {
    ASSERT_EQ(found[v] < infinity, exact[v] < infinity) << "at node " << v;
    if(exact[v] == infinity)
      continue;
    EXPECT_GE(found[v], exact[v] * (1 - relative) - absolute) << "at node " << v;
    EXPECT_LE(found[v], exact[v] * (1 + graph.epsilon()) * (1 + relative) + absolute)
        << "at node " << v;
  }
}

// ----- pairs of numbers

TEST(Double_pair, computes_and_compares_as_two_numbers_do)
{
  using Pair = AG::internal::Double_pair;
  const double nan = std::nan("");
  const std::vector<double> numbers = {0,      -0.,   1,        1 + 1e-15, -2.5,
                                       1e-310, 1e300, infinity, -infinity, nan};
  const auto same = [](const double a, const double b) { return a == b || (a != a && b != b); };
  const auto expect_pair = [&](const Pair& pair, const double left, const double right) {
    EXPECT_TRUE(same(pair.left(), left)) << pair.left() << " instead of " << left;
    EXPECT_TRUE(same(pair.right(), right)) << pair.right() << " instead of " << right;
  };
  for(const double a : numbers)
    for(const double b : numbers)
    {
      const Pair x(a, b), y(b, 3), both(a);
      expect_pair(x + y, a + b, b + 3);
      expect_pair(x - y, a - b, b - 3);
      expect_pair(x * y, a * b, b * 3);
      expect_pair(both, a, a);
      expect_pair(x.swapped(), b, a);
      expect_pair(x.with_right(y), a, 3);
      const Pair::Mask less = x < y, not_above = x <= y;
      EXPECT_EQ(less.bits(), (a < b ? 1 : 0) + (b < 3 ? 2 : 0));
      EXPECT_EQ(not_above.bits(), (a <= b ? 1 : 0) + (b <= 3 ? 2 : 0));
      EXPECT_EQ((less & not_above).bits(), less.bits());
      EXPECT_EQ((less | not_above).bits(), not_above.bits());
      expect_pair(less.choose(x, y), a < b ? a : b, b < 3 ? b : 3);
      expect_pair(Pair::Mask(true).choose(x, y), a, b);
      expect_pair(Pair::Mask(false).choose(x, y), b, 3);
    }
}

TEST(Cone_front, keeps_the_bound_on_every_mesh)
{
  for(const Named_mesh& named : all_meshes())
  {
    SCOPED_TRACE(named.name);
    const Saddle_vertex_graph exact_graph{Triangulation(named.mesh)};
    AG::Propagation<Saddle_vertex_graph> exact_search(exact_graph);
    std::vector<std::vector<Node>> starts = {some_nodes(exact_graph.triangulation())}; // together
    for(const Node source : some_nodes(exact_graph.triangulation()))
      starts.push_back({source});
    for(const std::vector<Node>& sources : starts)
    {
      const std::vector<double> exact = distances(exact_search, sources);
      for(const double e : {0.01, 0.1, 0.5, 3., 100.})
      {
        SCOPED_TRACE(e);
        const Lazy_discrete_geodesic_graph graph(exact_graph.triangulation(), epsilon(e));
        Lazy_search search(graph);
        expect_bound_of_search(search, sources, exact);
      }
    }
  }
}

// ----- the arcs

struct Labels
{
  double distance(const Node node) const { return distances[node]; }

  std::vector<double> distances;
  std::vector<Node> expanded = {}; // nodes that are expanded for the second time
};

using Arc = std::tuple<Node, Node, double>; // source, target and length

struct Arc_list
{
  void make_room(const std::size_t number) { room = arcs.size() + number; }

  void append(const bool is_arc,
              const Node source,
              const double /* label */,
              const Node target,
              const double length)
  {
    if(!is_arc)
      return;
    EXPECT_LT(arcs.size(), room);
    arcs.emplace_back(source, target, length);
  }

  template <typename Loop, typename F>
  void append_in_parallel(const Loop& /* loop */, std::size_t /* number */, const F& /* append */)
  {
    ADD_FAILURE() << "these graphs have no threads";
  }

  std::size_t thread() const { return 0; }

  std::vector<Arc> sorted() const
  {
    std::vector<Arc> result = arcs;
    std::sort(result.begin(), result.end());
    return result;
  }

  std::vector<Arc> arcs = {};
  std::size_t room = 0;
};

// Finds them so many nodes at a time.
std::vector<Arc> arcs_together(const Lazy_discrete_geodesic_graph& graph,
                               const Labels& labels,
                               const std::size_t number = 32)
{
  Lazy_discrete_geodesic_graph::Run run(graph);
  Arc_list first_time, result;
  run.expand(labels.expanded.data(), labels.expanded.size(), labels, first_time);
  std::vector<Node> nodes(graph.number_of_nodes());
  std::iota(nodes.begin(), nodes.end(), Node(0));
  for(std::size_t first = 0; first < nodes.size(); first += number)
    run.expand(nodes.data() + first, (std::min)(number, nodes.size() - first), labels, result);
  return result.sorted();
}

// The edges that lead to a node and lower its label.
std::vector<Arc>
shorter_edges(const AG::Intrinsic_triangulation& t, const Labels& labels, const Node v)
{
  std::vector<Arc> result;
  for(auto h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
    if(labels.distance(t.target(h)) + t.length(h) < labels.distance(v))
      result.emplace_back(t.target(h), v, t.length(h));
  return result;
}

// Finds those of one node after the other, expanded for the first time, unless it waits.
std::vector<Arc> arcs_in_turn(const Lazy_discrete_geodesic_graph& graph, const Labels& labels)
{
  Arc_list result;
  for(Node node = 0; node < graph.number_of_nodes(); ++node)
  {
    const std::vector<Arc> shorter = shorter_edges(graph.triangulation(), labels, node);
    result.arcs.insert(result.arcs.end(), shorter.begin(), shorter.end());
    if(shorter.empty())
      graph.for_each_arc(node, labels, [&](const Node target, const double length) {
        result.arcs.emplace_back(node, target, length);
      });
  }
  return result.sorted();
}

// Whether each of these arcs is one of the others, up to rounding.
bool are_among(const std::vector<Arc>& arcs, const std::vector<Arc>& others)
{
  return std::all_of(arcs.begin(), arcs.end(), [&](const Arc& arc) {
    const auto [source, target, length] = arc;
    const auto position =
        std::lower_bound(others.begin(), others.end(), Arc(source, target, length * (1 - 1e-12)));
    return position != others.end() && *position <= Arc(source, target, length * (1 + 1e-12));
  });
}

Labels no_labels(const Lazy_discrete_geodesic_graph& graph)
{
  return {std::vector<double>(graph.number_of_nodes(), infinity)};
}

// Somewhat too large, or infinite; some nodes were expanded.
Labels random_labels(const Lazy_discrete_geodesic_graph& graph, Random& random)
{
  Labels result = no_labels(graph);
  Lazy_search search(graph);
  search.run(std::vector<AG::Seed>{{static_cast<Node>(random.below(graph.number_of_nodes()))}});
  for(Node node = 0; node < graph.number_of_nodes(); ++node)
  {
    if(random.below(3) > 0)
      result.distances[node] =
          search.distance(node) / graph.unit() * random.between(1, 1.02); // so that not all wait
    if(random.below(8) == 0)
      result.expanded.push_back(node);
  }
  return result;
}

TEST(Cone_front, finds_the_same_arcs_of_one_node_as_of_many)
{
  Random random(test_seed());
  for(const Named_mesh& named : all_meshes())
    for(const double e : {0.5, 0.1})
      if(named.mesh.number_of_vertices() > 0)
      {
        SCOPED_TRACE(named.name);
        const Lazy_discrete_geodesic_graph graph(Triangulation(named.mesh), epsilon(e));
        const Labels labels = random_labels(graph, random);
        EXPECT_EQ(arcs_together(graph, labels), arcs_together(graph, labels, 1));
      }
}

// Where no vertices lie in one line, so that rounding does not tell which of them are in sight: it
// may not be the same everywhere.
std::vector<Mesh> meshes_without_lines(Random& random)
{
  const auto noise = [&](const Point& p) {
    const double factor = random.between(0.9, 1.1);
    return Point(factor * p.x(), factor * p.y(), factor * p.z());
  };
  return {to_mesh(terrain(40, 30, random)), to_mesh(sphere(24, 15).transformed(noise))};
}

TEST(Cone_front, finds_the_same_arcs_as_for_each_arc)
{
  Random random(test_seed());
  for(const Mesh& mesh : meshes_without_lines(random))
  {
    const Lazy_discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1));
    Labels labels = random_labels(graph, random);
    labels.expanded.clear();
    const std::vector<Arc> together = arcs_together(graph, labels);
    const std::vector<Arc> in_turn = arcs_in_turn(graph, labels);
    EXPECT_EQ(in_turn.size(), together.size());
    EXPECT_TRUE(are_among(in_turn, together));
  }
}

// So that a label that was found by one of them falls with that of the node.
TEST(Cone_front, finds_no_arc_that_a_repeated_expansion_does_not_find)
{
  Random random(test_seed());
  for(const Mesh& mesh : meshes_without_lines(random))
    for(const double e : {3., 0.1})
    {
      const Lazy_discrete_geodesic_graph graph(Triangulation(mesh), epsilon(e));
      Labels labels = no_labels(graph);
      const std::vector<Arc> first = arcs_together(graph, labels);
      labels.expanded.resize(graph.number_of_nodes());
      std::iota(labels.expanded.begin(), labels.expanded.end(), Node(0));
      EXPECT_TRUE(are_among(first, arcs_together(graph, labels)));
    }
}

std::vector<Arc> edges(const Triangulation& t)
{
  std::vector<Arc> result;
  for(Node node = 0; node < t.number_of_vertices(); ++node)
    for(Node h = t.first_halfedge(node); h < t.beyond_halfedge(node); ++h)
      result.emplace_back(node, t.target(h), t.length(h));
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Cone_front, finds_edges_and_lines_that_can_be_traced)
{
  for(const Named_mesh& named : all_meshes())
  {
    SCOPED_TRACE(named.name);
    const Lazy_discrete_geodesic_graph graph(Triangulation(named.mesh), epsilon(0.5));
    const Triangulation& t = graph.triangulation();
    const std::vector<Arc> arcs = arcs_together(graph, no_labels(graph)), sides = edges(t);
    EXPECT_TRUE(std::includes(arcs.begin(), arcs.end(), sides.begin(), sides.end()));
    for(std::size_t i = 0; i < arcs.size(); i += 1 + arcs.size() / 500)
    {
      const auto [source, target, length] = arcs[i];
      const auto is_on_edge = [&](Node, const double part) {
        EXPECT_TRUE(part >= 0 && part <= 1) << part;
      };
      EXPECT_NEAR(graph.for_each_crossing(source, target, length, is_on_edge), length,
                  1e-9 * length);
    }
  }
}

// ----- runs that do not come to an end

TEST(Cone_front, survives_interruptions)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(40, 30, random));
  const Lazy_discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1));
  Lazy_search search(graph);
  const Saddle_vertex_graph exact_graph(graph.triangulation());
  AG::Propagation<Saddle_vertex_graph> exact_search(exact_graph);
  const std::vector<Node> sources = {5, 700};
  const std::vector<double> exact = distances(exact_search, sources);
  for(std::size_t number : {0u, 1u, 40u, 900u})
  {
    Recorder<Node> thrower;
    thrower.throw_at = number;
    EXPECT_THROW(search.run({AG::Seed{5}}, {}, thrower), std::runtime_error);
    EXPECT_FALSE(search.is_reached(5));
    expect_bound_of_search(search, sources, exact);

    Recorder<Node> stopper;
    stopper.stop_at = number;
    search.run({AG::Seed{5}}, {}, stopper);
    EXPECT_LT(stopper.settled.size(), graph.number_of_nodes());
    expect_bound_of_search(search, sources, exact);
  }
}

// ----- memory

// Arrays of this mesh are large enough for huge pages.
TEST(Cone_front, keeps_within_the_bound_on_a_large_mesh)
{
  const Mesh mesh = to_mesh(flat_grid(310, 300));
  const Lazy_discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1));
  Lazy_search search(graph);
  search.run_from(0);
  const Point& source = mesh.point(Vertex(graph.triangulation().index(0)));
  for(Node node = 1; node < graph.number_of_nodes(); ++node)
  {
    const Point& p = mesh.point(Vertex(graph.triangulation().index(node)));
    const double straight = std::sqrt(CGAL::squared_distance(source, p));
    ASSERT_GE(search.distance(node), straight * (1 - 1e-12));
    ASSERT_LE(search.distance(node), straight * 1.1);
  }
}

TEST(Cone_front, has_faces_that_can_be_copied)
{
  const Triangulation triangulation(to_mesh(flat_grid(310, 300)));
  const AG::internal::Unfolding faces(triangulation), copy = faces;
  EXPECT_EQ(copy.memory(), faces.memory());
  for(Node h = 0; h < triangulation.number_of_halfedges(); ++h)
  {
    ASSERT_EQ(copy[h].apex, faces[h].apex);
    ASSERT_EQ(copy[h].left, faces[h].left);
    ASSERT_EQ(copy[h].across, faces[h].across);
  }
}

// The memory of cones is used for one batch of nodes after the other, and counts.
TEST(Cone_front, needs_no_more_memory_for_the_same_run)
{
  const Lazy_discrete_geodesic_graph graph(Triangulation(to_mesh(flat_grid(40, 30))));
  Lazy_discrete_geodesic_graph::Run run(graph);
  std::vector<Node> nodes(graph.number_of_nodes());
  std::iota(nodes.begin(), nodes.end(), Node(0));
  const auto expand_all = [&] {
    Arc_list arcs;
    run.forget_all();
    run.expand(nodes.data(), nodes.size(), no_labels(graph), arcs);
    return arcs.sorted();
  };
  const std::vector<Arc> arcs = expand_all();
  const std::size_t memory = run.memory();
  EXPECT_GT(memory, 32 * 128u); // a cone of 128 bytes per node of a batch, at least
  EXPECT_EQ(expand_all(), arcs);
  EXPECT_EQ(run.memory(), memory);
}

} // namespace
