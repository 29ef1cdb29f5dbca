// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

// Regular meshes, where rows of vertices lie in one line: cones must not run along them, and the
// bound has to hold where they end instead.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using AG::Lazy_discrete_geodesic_graph;
using AG::internal::Cone_rules;
using AG::internal::Cone_side;
using AG::internal::Plane_vector;
using AG::internal::Straight_arc;
using AG::internal::Unfolding;
using CGAL::parameters::epsilon;
using Expansion = AG::internal::Cone_expansion<Unfolding>;

constexpr double epsilons_of_lattices[] = {0.5, 0.1, 0.01};

// ----- the meshes: (2 half + 1)^2 vertices, of which the one in the middle is where it always is

struct Lattice
{
  std::string name;
  Soup (*make)(std::size_t half);
};

template <typename F>
Soup lattice(const std::size_t half, F point)
{
  const double middle = static_cast<double>(half);
  return grid(2 * half + 1, 2 * half + 1,
              [&](const double i, const double j) { return point(i - middle, j - middle); });
}

const Lattice all_lattices[] = {
    {"flat",
     [](const std::size_t half) {
       return lattice(half, [](const double x, const double y) { return Point(x, y, 0); });
     }},
    {"hexagonal",
     [](const std::size_t half) {
       return lattice(half, [](const double x, const double y) {
         return Point(x - y / 2, std::sqrt(0.75) * y, 0);
       });
     }},
    {"wavy",
     [](const std::size_t half) {
       return lattice(half, [](const double x, const double y) {
         return Point(x, y, 3 * std::sin(x / 7) * std::cos(y / 9));
       });
     }},
    {"heights in whole meters",
     [](const std::size_t half) {
       return lattice(half, [](const double x, const double y) {
         return Point(10 * x, 10 * y, std::round(40 * std::sin(x / 31) * std::cos(y / 17)));
       });
     }},
    {"part of a cylinder",
     [](const std::size_t half) {
       return lattice(half, [](const double x, const double y) {
         return Point(60 * std::cos(x / 60), 60 * std::sin(x / 60), y);
       });
     }},
    {"part of a sphere", [](const std::size_t half) {
       return lattice(half, [](const double x, const double y) {
         const double length = std::sqrt(x * x + y * y + 400 * 400);
         return Point(400 * x / length, 400 * y / length, 400 * 400 / length);
       });
     }}};

Node middle_node(const Triangulation& t, const std::size_t half)
{
  return t.vertex(half * (2 * half + 1) + half);
}

// ----- what they cost

constexpr std::size_t small_half = 45, large_half = 135;
constexpr double most_growth = 1.2;

struct Counting_windows : AG::internal::Leave_out_detours
{
  bool prune(const AG::internal::Window&) const
  {
    ++windows;
    return false;
  }
  std::size_t& windows;
};

// What vertices in the middle look through, when the graph is built.
std::size_t windows_in_the_middle(const Triangulation& t, const std::size_t half, const double e)
{
  const Unfolding unfolding(t);
  const Expansion expansion(t, unfolding, Cone_rules(e));
  const Node middle = middle_node(t, half);
  std::size_t result = 0;
  for(Node v = middle - 5; v < middle + 5; ++v)
    expansion.expand(
        v, [](const Straight_arc&) {}, Counting_windows{{}, result});
  return result;
}

TEST(Regular_meshes, cost_a_vertex_the_same_whatever_their_size)
{
  for(const Lattice& lattice : all_lattices)
  {
    SCOPED_TRACE(lattice.name);
    const auto windows = [&](const std::size_t half) {
      return static_cast<double>(
          windows_in_the_middle(Triangulation(to_mesh(lattice.make(half))), half, 0.1));
    };
    EXPECT_LE(windows(large_half), most_growth * windows(small_half));
  }
}

// Also where points are attached, which leave out no arc.
TEST(Regular_meshes, cost_a_point_the_same_whatever_their_size)
{
  for(const Lattice& lattice : all_lattices)
  {
    SCOPED_TRACE(lattice.name);
    const auto number_of_arcs = [&](const std::size_t half) {
      const Lazy_discrete_geodesic_graph graph(Triangulation(to_mesh(lattice.make(half))),
                                               epsilon(0.1));
      const Triangulation& t = graph.triangulation();
      std::size_t result = 0;
      const Node h = t.first_halfedge(middle_node(t, half));
      graph.attach(AG::Intrinsic_point::in_face(h, 0.3, 0.2)).for_each_node([&](Node, double) {
        ++result;
      });
      return static_cast<double>(result);
    };
    EXPECT_LE(number_of_arcs(large_half), most_growth * number_of_arcs(small_half));
  }
}

TEST(Regular_meshes, cost_a_vertex_the_same_in_a_lazy_search)
{
  for(const Lattice& lattice : all_lattices)
  {
    SCOPED_TRACE(lattice.name);
    const auto arcs_per_vertex = [&](const std::size_t half) {
      const Lazy_discrete_geodesic_graph graph(Triangulation(to_mesh(lattice.make(half))),
                                               epsilon(0.1));
      AG::Propagation<Lazy_discrete_geodesic_graph> search(graph);
      search.collect_statistics(true);
      search.run_from(middle_node(graph.triangulation(), half));
      return static_cast<double>(search.statistics().relaxations) /
             static_cast<double>(graph.number_of_nodes());
    };
    EXPECT_GT(arcs_per_vertex(small_half), 5); // edges at least, of which a border has fewer
    EXPECT_LE(arcs_per_vertex(large_half), most_growth * arcs_per_vertex(small_half));
  }
}

// ----- the bound

// Exact distances by source.
using Distances_by_source = std::map<Node, std::vector<double>>;

template <typename Graph>
void expect_bound_of_graph(const Triangulation& t, const Distances_by_source& exact, const double e)
{
  const Graph graph(t, epsilon(e));
  AG::Propagation<Graph> search(graph);
  for(const auto& [source, distances] : exact)
  {
    search.run_from(source);
    for(Node v = 0; v < t.number_of_vertices(); ++v)
    {
      EXPECT_GE(search.distance(v), distances[v] * (1 - 1e-12)) << "at vertex " << v;
      EXPECT_LE(search.distance(v), distances[v] * (1 + e)) << "at vertex " << v;
    }
  }
}

TEST(Regular_meshes, have_the_bound)
{
  constexpr std::size_t half = 25;
  for(const Lattice& lattice : all_lattices)
  {
    SCOPED_TRACE(lattice.name);
    const Triangulation t(to_mesh(lattice.make(half)));
    const AG::Saddle_vertex_graph exact_graph(t);
    AG::Propagation<AG::Saddle_vertex_graph> search(exact_graph);
    Distances_by_source exact;
    for(const Node source : {middle_node(t, half), t.vertex(0), t.vertex(7)})
    {
      search.run_from(source);
      for(Node v = 0; v < t.number_of_vertices(); ++v)
        exact[source].push_back(search.distance(v));
    }
    for(const double e : epsilons_of_lattices)
    {
      expect_bound_of_graph<Discrete_geodesic_graph>(t, exact, e);
      expect_bound_of_graph<Lazy_discrete_geodesic_graph>(t, exact, e);
    }
  }
}

// ----- the proof of it

// The shortest way from the first of some points on turning rays to `x` that passes all of them
// between them and the tip: it bends where they are farthest to the right.
double length_of_way(std::vector<Plane_vector> points, const Plane_vector x)
{
  double result = 0;
  points.push_back(x);
  for(auto here = points.begin(); std::next(here) != points.end();)
  {
    auto next = std::next(here);
    for(auto other = next; other != points.end(); ++other)
      if(cross(*next - *here, *other - *here) <= 0)
        next = other;
    result += length(*next - *here);
    here = next;
  }
  return result;
}

Cone_side side_through(const Plane_vector position, const Cone_rules& rules)
{
  const double distance = length(position);
  return {
      1 / distance * position,          distance, position, distance, rules.part_saved * distance,
      rules.large_part_saved * distance};
}

// A vertex that has an arc, others to the right of it that are served, one after the other, and a
// point x beyond the last: where the side says that x is served, the way over the vertex is good
// enough.
TEST(Side_of_a_cone, serves_only_where_the_way_is_short_enough)
{
  Random random(test_seed());
  std::size_t number_of_stays = 0, number_of_moves = 0, number_of_points = 0;
  for(std::size_t round = 0; round < 20000; ++round)
  {
    const Cone_rules rules(std::exp(random.between(-5, 0)));
    std::vector<Plane_vector> points = {{1, 0}};
    Cone_side side = side_through(points.front(), rules);
    const double largest_turn = std::exp(random.between(-9, -1));
    const auto beyond = [&](const double farthest) { // on a ray that is turned on
      const double distance = side.distance * random.between(0.7, farthest);
      const double turn = random.between(0, largest_turn);
      return distance * turned_right(side.direction, {std::cos(turn), std::sin(turn)});
    };
    for(std::size_t step = 0; step < 20; ++step)
    {
      const Plane_vector c = beyond(1.6), server = side.server;
      if(!side.serves(c, length(c), side.large_saving))
        continue;
      side.move_to(c, length(c));
      points.push_back(c);
      ++(side.server.x == server.x ? number_of_stays : number_of_moves);
    }
    const Plane_vector ray = beyond(2); // where it is served from on
    const double start = side.start_of_service(ray, length(ray));
    if(start > 1e6)
      continue;
    const Plane_vector x = (std::max)(start, 1.) * ray;
    ++number_of_points;
    EXPECT_LE(1 + rules.longest_detour * length_of_way(points, x),
              rules.longest_detour * length(x) * (1 + 1e-12));
  }
  EXPECT_GT(number_of_stays, 1000u);
  EXPECT_GT(number_of_moves, 1000u);
  EXPECT_GT(number_of_points, 1000u);
}

} // namespace
