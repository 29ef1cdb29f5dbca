// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include "checks/test_random.h"
#include "grids/cells.h"
#include "meshes/surface_points.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>
#include <CGAL/approximate_geodesic_distances_on_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

// Paths where nothing has to be paid: the shortest ones are taken.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using CGAL::parameters::heights;

// ----- grids

double length_along(const std::vector<Grid_point>& path)
{
  double result = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
    result += straight_distance(path[i - 1], path[i]);
  return result;
}

template <typename... NamedParameters>
std::pair<double, double> cost_and_length(const Grid_shape& shape,
                                          const Cell_values& friction,
                                          const Grid_cell& from,
                                          const Grid_cell& to,
                                          const NamedParameters&... np)
{
  std::vector<Grid_point> path;
  const double cost = CGAL::approximate_geodesic_path_on_grid(
      shape, friction, std::back_inserter(path), from, to, np...);
  return {cost, length_along(path)};
}

TEST(Free_ways, are_straight_where_all_cells_are_free)
{
  for(const Grid_shape& shape : {Grid_shape{60, 60, 1, 1, {}}, Grid_shape{101, 70, 3, 2, {}}})
  {
    const Cell_values free = equal_cells(shape, 0), equal = equal_cells(shape);
    const Grid_cell from{shape.columns / 2, shape.rows / 2}, to{shape.columns - 1, shape.rows / 5};
    const auto [cost, length] = cost_and_length(shape, free, from, to);
    EXPECT_EQ(0, cost);
    EXPECT_NEAR(costs_of_cells(shape, equal, from)[shape.index(to)], length, 1e-9 * length);
    const auto with_bound = cost_and_length(shape, free, from, to, CGAL::parameters::epsilon(0.5));
    EXPECT_EQ(0, with_bound.first);
    EXPECT_LE(with_bound.second, 1.5 * straight_distance(shape.center(from), shape.center(to)));
    // on a surface, its lengths count
    const Cell_values h =
        values_of_cells(shape, [](const double x, const double) { return 20 * std::sin(x / 10); });
    const auto np = heights(h);
    std::vector<Grid_point> path, shortest;
    CGAL::approximate_geodesic_path_on_grid(shape, free, std::back_inserter(path), from, to, np);
    CGAL::approximate_geodesic_path_on_grid(shape, 1, std::back_inserter(shortest), from, to, np);
    ASSERT_EQ(shortest.size(), path.size());
    for(std::size_t i = 0; i < path.size(); ++i)
      EXPECT_NEAR(straight_distance(path[i], shortest[i]), 0, 1e-9);
  }
}

TEST(Free_ways, are_straight_in_a_channel)
{
  const Grid_shape shape{60, 60, 1, 1, {}};
  Cell_values friction = equal_cells(shape, 100);
  for(std::size_t row = 25; row < 36; ++row)
    for(std::size_t column = 5; column < 55; ++column)
      friction[shape.index({column, row})] = 0;
  const auto [cost, length] = cost_and_length(shape, friction, {6, 30}, {53, 28});
  EXPECT_EQ(0, cost);
  EXPECT_LE(length, 1.003 * std::hypot(47, 2));
}

// Two channels that cost the same, in exact sums, and one of which is longer.
TEST(Free_ways, are_the_shorter_ones_of_those_that_cost_the_same)
{
  const Grid_shape shape{41, 41, 1, 1, {}};
  for(const bool is_mirrored : {false, true})
  {
    Cell_values friction = equal_cells(shape, no_way);
    const auto set = [&](const std::size_t column, const std::size_t row, const double value) {
      friction[shape.index({column, is_mirrored ? 40 - row : row})] = value;
    };
    for(std::size_t column = 5; column <= 35; ++column)
      for(const std::size_t row : {std::size_t(17), std::size_t(35)})
        set(column, row, 0);
    for(std::size_t row = 17; row <= 35; ++row)
      for(const std::size_t column : {std::size_t(5), std::size_t(35)})
        set(column, row, 0);
    for(const std::size_t column : {std::size_t(4), std::size_t(36)})
      set(column, 22, 1);
    // two ways out of the ring on each side that cost as much
    const auto [cost, length] = cost_and_length(shape, friction, {4, is_mirrored ? 18u : 22u},
                                                {36, is_mirrored ? 18u : 22u});
    EXPECT_EQ(1, cost);
    EXPECT_NEAR(32 + 2 * 5 - 2 * (2 - std::sqrt(2)), length, 1e-9); // two corners are cut
  }
}

// ----- questions in the middle of a run

template <typename Search>
struct Asking_visitor : AG::Geodesic_visitor_base
{
  explicit Asking_visitor(const Search& the_search) : search(the_search) {}

  void on_settled(const typename Search::Node node, double /* distance */)
  {
    if(++number_settled < first_question)
      return;
    search.predecessor(node);
    search.source(node);
    if(throws)
      throw std::runtime_error("from the visitor");
  }

  const Search& search;
  std::size_t first_question = 10;
  bool throws = false;
  std::size_t number_settled = 0;
};

TEST(Free_ways, do_not_depend_on_questions_during_a_run)
{
  using Graph = Steiner_graph<AG::Fixed_number_of_points>;
  using Search = AG::Propagation<Graph, AG::Binary_heap_queue>;
  const Mesh mesh = to_mesh(flat_grid(6, 7));
  Weights weights(mesh.number_of_faces(), 0);
  for(std::size_t i = 0; i < weights.size(); i += 3)
    weights[i] = 1;
  const Graph graph(Triangulation(mesh, with_weights(weights)), AG::Fixed_number_of_points(2));
  const std::vector<AG::Seed> three{{0, 0, 1}, {41, 2.5, 2}, {30, 1.7, 3}}, one{{20, 0, 7}};
  const auto expect_same = [&](const Search& asked, const Search& other) {
    for(Search::Node node = 0; node < graph.number_of_nodes(); ++node)
    {
      EXPECT_EQ(other.predecessor(node), asked.predecessor(node));
      EXPECT_EQ(other.source(node), asked.source(node));
    }
  };
  for(const bool throws : {false, true})
  {
    Search asked(graph), other(graph);
    Asking_visitor<Search> visitor(asked);
    visitor.throws = throws;
    if(throws)
      EXPECT_THROW(asked.run(three, AG::Stop_rule(), visitor), std::runtime_error);
    else
    {
      asked.run(three, AG::Stop_rule(), visitor);
      other.run(three);
      expect_same(asked, other);
    }
    asked.run(one);
    other.run(one);
    expect_same(asked, other);
  }
}

// ----- an oracle: Dijkstra's algorithm with pairs of a cost and a length

using Cost_and_length = std::pair<double, double>;

struct Any_label
{
  double distance(const std::size_t other) const { return other == node ? 0 : no_way; }
  static AG::Grid_graph::Node predecessor(std::size_t /* node */)
  {
    return (std::numeric_limits<AG::Grid_graph::Node>::max)();
  }

  std::size_t node;
};

template <typename Graph, typename LengthOf>
std::vector<Cost_and_length>
cheapest_and_shortest(const Graph& graph, const std::size_t source, const LengthOf& length_of_arc)
{
  std::vector<Cost_and_length> result(graph.number_of_nodes(), {no_way, no_way});
  using Entry = std::pair<Cost_and_length, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  result[source] = {0, 0};
  queue.push({{0, 0}, source});
  while(!queue.empty())
  {
    const auto [label, node] = queue.top();
    queue.pop();
    if(label > result[node])
      continue;
    const auto relax = [&, l = label, n = node](const std::size_t target, const double cost) {
      const Cost_and_length other{l.first + cost,
                                  l.second + (cost == 0 ? length_of_arc(n, target) : 0)};
      if(other < result[target])
      {
        result[target] = other;
        queue.push({other, target});
      }
    };
    graph.for_each_arc(static_cast<typename Graph::Node>(node), Any_label{node},
                       [&](const auto target, const auto cost, const auto... number) {
                         if constexpr(sizeof...(number) == 0)
                           relax(target, cost);
                         else
                           for(std::size_t i = 0; i < (number + ...); ++i)
                             relax(target + i, cost[i]);
                       });
  }
  return result;
}

// Expects the paths of a search to all nodes to cost as little as possible, and their free parts
// to be as short as possible.
template <typename Search, typename LengthOf>
void expect_shortest(const Search& search,
                     const std::vector<Cost_and_length>& expected,
                     const LengthOf& length_of_arc)
{
  const auto& labels = search.labels(); // in the unit of the graph
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    const auto node = static_cast<typename Search::Node>(i);
    if(!search.is_reached(node))
    {
      EXPECT_EQ(no_way, expected[i].first);
      continue;
    }
    double length = 0;
    for(auto n = node, before = search.predecessor(n); before != Search::null_node;
        n = before, before = search.predecessor(n))
      if(labels.distance(before) == labels.distance(n))
        length += length_of_arc(before, n);
    EXPECT_EQ(expected[i].first, labels.distance(node));
    EXPECT_NEAR(expected[i].second, length, 1e-9 * (1 + length));
    EXPECT_NEAR(length, search.free_length(node), 1e-9 * (1 + length));
  }
}

template <typename Queue>
class Free_ways_by_queue : public testing::Test
{
};

using Queues_of_free_ways =
    testing::Types<AG::Adaptive_bucket_queue, AG::Binary_heap_queue, AG::Fibonacci_heap_queue>;
TYPED_TEST_SUITE(Free_ways_by_queue, Queues_of_free_ways, );

TYPED_TEST(Free_ways_by_queue, are_shortest_on_random_grids)
{
  Random random(test_seed());
  for(int round = 0; round < 12; ++round)
  {
    const Grid_shape shape{20, 17, 1, 1, {}};
    Cell_values friction;
    for(std::size_t i = 0; i < shape.number_of_cells(); ++i)
      friction.push_back(random.below(3) == 0   ? double(1 + random.below(2))
                         : random.below(6) == 0 ? no_way
                                                : 0);
    const std::size_t source = random.below(friction.size());
    friction[source] = 0;
    const auto check = [&](const AG::Grid_graph& graph) {
      const auto length = [&](const std::size_t a, const std::size_t b) {
        return straight_distance(graph.position(static_cast<AG::Grid_graph::Node>(a)),
                                 graph.position(static_cast<AG::Grid_graph::Node>(b)));
      };
      AG::Propagation<AG::Grid_graph, TypeParam> search(graph);
      search.run_from(static_cast<AG::Grid_graph::Node>(source));
      expect_shortest(search, cheapest_and_shortest(graph, source, length), length);
    };
    check(AG::Grid_graph(shape, friction));
    if(round < 3)
      check(AG::Grid_graph(shape, friction, CGAL::parameters::epsilon(2)));
  }
}

// ----- meshes

Vector place(const Mesh& mesh, const Triangulation& t, const AG::Intrinsic_point& p)
{
  const auto at = [&](const Node v) { return mesh.point(Vertex(t.index(v))) - CGAL::ORIGIN; };
  if(p.is_vertex())
    return at(p.vertex);
  const Node h = p.halfedge;
  const Vector a = at(t.source(h)), b = at(t.target(h));
  const Vector c = p.is_in_face() ? at(t.target(t.next(h))) : a;
  return a + p.t * (b - a) + p.s * (c - a);
}

AG::Intrinsic_point random_place(const Triangulation& t, Random& random)
{
  if(random.below(4) == 0)
    return AG::Intrinsic_point::at_vertex(static_cast<Node>(random.below(t.number_of_vertices())));
  Node h = static_cast<Node>(random.below(t.number_of_halfedges()));
  h = t.is_border(h) ? t.opposite(h) : h;
  const double x = random.between(0, 1);
  return random.below(2) == 0 ? AG::Intrinsic_point::on_edge(h, x)
                              : AG::Intrinsic_point::in_face(h, x, (1 - x) * random.between(0, 1));
}

double length_along(const Mesh& mesh, const Triangulation& t, const AG::Path& path)
{
  double result = 0;
  for(std::size_t i = 1; i < path.points.size(); ++i)
    result += std::sqrt(
        (place(mesh, t, path.points[i]) - place(mesh, t, path.points[i - 1])).squared_length());
  return result;
}

TYPED_TEST(Free_ways_by_queue, are_those_of_equal_weights_where_all_faces_are_free)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(8, 9, random));
  Barriers barriers;
  for(std::size_t e = 0; e < mesh.number_of_edges(); ++e)
    barriers.push_back(random.below(4) == 0);
  const Weights free(mesh.number_of_faces(), 0), equal(mesh.number_of_faces(), 1);
  const AG::Fixed_number_of_points points(7);
  const auto graph = [&](const Weights& weights) {
    return Steiner_graph<AG::Fixed_number_of_points>(
        Triangulation(mesh, with_weights(weights).edge_is_constrained_map(barrier_map(barriers))),
        points);
  };
  const auto free_graph = graph(free), equal_graph = graph(equal);
  AG::Surface_search<decltype(free_graph), TypeParam> search(free_graph);
  AG::Surface_search<decltype(equal_graph), TypeParam> other(equal_graph);
  using Subject = std::decay_t<decltype(free_graph)>;
  AG::Surface_search<Subject, TypeParam> to_one(free_graph);
  const Triangulation& t = free_graph.triangulation();
  for(int round = 0; round < 20; ++round)
  {
    const auto p = random_place(t, random), q = random_place(t, random);
    search.run({{p}});
    other.run({{p}});
    const AG::Path path = search.find_path(q), shortest = other.find_path(q);
    EXPECT_EQ(0, path.length);
    EXPECT_NEAR(shortest.length, length_along(mesh, t, path), 1e-9 * (1 + shortest.length));
    to_one.run_to(q, {{p}});
    EXPECT_NEAR(shortest.length, length_along(mesh, t, to_one.find_path(q)),
                1e-9 * (1 + shortest.length));
  }
}

// Weights whose sums are exact, so that many paths cost the same.
Weights some_free_faces(const Mesh& mesh, Random& random)
{
  Weights result;
  for(std::size_t i = 0; i < mesh.number_of_faces(); ++i)
    result.push_back(random.below(3) == 0 ? double(1 + random.below(2)) : 0);
  return result;
}

TYPED_TEST(Free_ways_by_queue, are_shortest_on_random_meshes_and_after_repairs)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(6, 7));
  for(int round = 0; round < 6; ++round)
  {
    Weights weights = some_free_faces(mesh, random);
    auto graph = steiner_graph(mesh, weights, AG::Fixed_number_of_points(3));
    const Triangulation& t = graph.triangulation();
    const auto length = [&](const std::size_t a, const std::size_t b) {
      return std::sqrt((place(mesh, t, graph.position(static_cast<Node>(a))) -
                        place(mesh, t, graph.position(static_cast<Node>(b))))
                           .squared_length()) /
             t.unit();
    };
    AG::Propagation<decltype(graph), TypeParam> search(graph);
    const Node source = static_cast<Node>(random.below(mesh.number_of_vertices()));
    search.run_from(source);
    for(int change = 0; change < 4; ++change)
    {
      const AG::Propagation<decltype(graph), TypeParam>& found = search;
      for(Node n = 0; n < graph.number_of_nodes(); ++n)
        found.predecessor(n);
      AG::Propagation<decltype(graph)> fresh(graph);
      fresh.run_from(source);
      for(Node n = 0; n < graph.number_of_nodes(); ++n)
      {
        EXPECT_EQ(fresh.predecessor(n), found.predecessor(n));
        EXPECT_EQ(fresh.free_length(n), found.free_length(n));
      }
      expect_shortest(found, cheapest_and_shortest(graph, source, length), length);
      std::vector<AG::Weight_change> changes;
      for(int i = 0; i < 5; ++i)
      {
        Node h = static_cast<Node>(random.below(t.number_of_halfedges()));
        h = t.is_border(h) ? t.opposite(h) : h;
        changes.push_back({h, random.below(2) == 0 ? 0. : 2.});
      }
      graph.set_weights(changes);
      search.repair({AG::Seed{source}});
    }
  }
}

TEST(Free_ways, begin_at_the_nearest_of_free_sources)
{
  const Mesh mesh = to_mesh(flat_grid(9, 9));
  const Weights free(mesh.number_of_faces(), 0);
  const auto graph = steiner_graph(mesh, free, AG::Fixed_number_of_points(3));
  AG::Surface_search<std::decay_t<decltype(graph)>> search(graph);
  const Triangulation& t = graph.triangulation();
  const auto at = [&](const std::size_t i) { return AG::Intrinsic_point::at_vertex(t.vertex(i)); };
  search.run({{at(0)}, {at(80)}});
  EXPECT_EQ(0u, search.nearest(at(10)).source);
  EXPECT_EQ(1u, search.nearest(at(70)).source);
  EXPECT_EQ(0, search.distance(at(40)));
}

// Free faces whose costs depend on the direction.
TEST(Free_ways, are_straight_where_all_directions_are_free)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(6, 6, random));
  const auto nothing = [](Face, const Vector&) { return 0.; };
  const Weights one(mesh.number_of_faces(), 1);
  const Dense_graph free = dense_graph(mesh, nothing, 5);
  const auto equal = steiner_graph(mesh, one, AG::Fixed_number_of_points(5));
  AG::Surface_search<Dense_graph> search(free);
  AG::Surface_search<std::decay_t<decltype(equal)>> other(equal);
  const Triangulation& t = free.triangulation();
  for(int round = 0; round < 10; ++round)
  {
    const auto p = random_place(t, random), q = random_place(t, random);
    search.run({{p}});
    other.run({{p}});
    const double shortest = other.find_path(q).length;
    EXPECT_NEAR(shortest, length_along(mesh, t, search.find_path(q)), 1e-9 * (1 + shortest));
  }
}

} // namespace
