// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/Directional_graph.h>

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"
#include "paths/dijkstra.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs/cost_functions.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

// The limit of slopes on meshes: straight pieces of paths keep it, and no zigzags within faces take
// their place.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using CGAL::parameters::max_slope;

constexpr double no_limit = std::numeric_limits<double>::infinity();

double slope(const Vector& v) { return std::abs(v.z()) / std::hypot(v.x(), v.y()); }

// ----- an oracle: all straight lines between nodes at the border of a face, one by one

template <typename Cost>
std::vector<double> distances_by_pieces(const Mesh& mesh,
                                        const Dense_graph& graph,
                                        const Node source,
                                        const double limit,
                                        const Cost& cost)
{
  const Triangulation& t = graph.triangulation();
  std::vector<Vector> places;
  std::vector<std::vector<Node>> nodes_of_face(mesh.number_of_faces());
  const auto halfedge_of = [&](const Node h) {
    return mesh.halfedge(Vertex(t.index(t.source(h))), Vertex(t.index(t.target(h))));
  };
  for(Node n = 0; n < graph.number_of_nodes(); ++n)
  {
    const bool is_vertex = n < t.number_of_vertices();
    const Vertex v(t.index(is_vertex ? n : t.source(graph.position(n).halfedge)));
    const auto at = [&](const Vertex w) { return mesh.point(w) - CGAL::ORIGIN; };
    places.push_back(at(v));
    if(is_vertex)
      for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      {
        if(!mesh.is_border(h))
          nodes_of_face[mesh.face(h)].push_back(n);
      }
    else
    {
      const Halfedge h = halfedge_of(graph.position(n).halfedge);
      places.back() = at(v) + graph.position(n).t * (at(mesh.target(h)) - at(v));
      for(const Halfedge g : {h, mesh.opposite(h)})
        if(!mesh.is_border(g))
          nodes_of_face[mesh.face(g)].push_back(n);
    }
  }
  std::vector<std::vector<Face>> faces_of_node(places.size());
  for(const Face f : mesh.faces())
    for(const Node n : nodes_of_face[f])
      faces_of_node[n].push_back(f);
  return textbook_distances<double>(places.size(), source, [&](const auto n, const auto& relax) {
    for(const Face f : faces_of_node[n])
      for(const Node other : nodes_of_face[f])
        if(const Vector v = places[other] - places[n]; other != n && slope(v) <= limit * (1 + 1e-9))
          relax(other, cost(f, v));
  });
}

// Compares all nodes.
void expect_same(const Dense_graph& graph, const Node source, const std::vector<double>& expected)
{
  AG::Propagation search(graph);
  search.run_from(source);
  for(Node n = 0; n < graph.number_of_nodes(); ++n)
    if(expected[n] == no_limit)
      EXPECT_EQ(no_limit, search.distance(n));
    else
      EXPECT_NEAR(expected[n], search.distance(n), 1e-11 * expected[n]);
}

TEST(Max_slope, lets_paths_be_all_straight_pieces_within_it)
{
  Random random(test_seed());
  for(int round = 0; round < 12; ++round)
  {
    const Mesh mesh = to_mesh(terrain(4, 5, random));
    std::vector<double> slopes;
    for(const Edge e : mesh.edges())
      slopes.push_back(slope(mesh.point(mesh.vertex(e, 0)) - mesh.point(mesh.vertex(e, 1))));
    std::sort(slopes.begin(), slopes.end());
    const double limit = slopes[random.below(slopes.size())] * random.between(0.7, 1.3);
    std::vector<double> weights;
    for(std::size_t i = 0; i < mesh.number_of_faces(); ++i)
      weights.push_back(random.below(8) == 0   ? no_limit
                        : random.below(8) == 0 ? 0
                                               : random.between(0.5, 3));
    const auto weight_map =
        boost::make_function_property_map<Face>([&](const Face f) { return weights[f]; });
    const AG::Fixed_number_of_points points(12);
    const Node source = static_cast<Node>(random.below(mesh.number_of_vertices()));

    const Dense_graph by_length(Triangulation(mesh, max_slope(limit)), points);
    const auto length = [](Face, const Vector& v) { return std::sqrt(v.squared_length()); };
    expect_same(by_length, source, distances_by_pieces(mesh, by_length, source, limit, length));
    expect_same(by_length.reversed(), source,
                distances_by_pieces(mesh, by_length, source, limit, length));

    const Dense_graph by_weight(Triangulation(mesh, max_slope(limit).face_weight_map(weight_map)),
                                points);
    expect_same(
        by_weight, source,
        distances_by_pieces(mesh, by_weight, source, limit, [&](const Face f, const Vector& v) {
          return weights[f] == no_limit ? no_limit : weights[f] * std::sqrt(v.squared_length());
        }));

    const AG::Hiking_time hiking;
    const Dense_graph by_time(
        Triangulation(mesh, with_cost(hiking).max_slope((std::min)(limit, 0.25))), points);
    expect_same(by_time, source,
                distances_by_pieces(mesh, by_time, source, (std::min)(limit, 0.25),
                                    [&](const Face f, const Vector& v) {
                                      const double l = std::sqrt(v.squared_length());
                                      return l * hiking(f, v / l);
                                    }));
  }
}

// ----- closed forms

Mesh slanted_plane(const std::size_t columns, const std::size_t rows, const double steepness)
{
  return to_mesh(flat_grid(columns, rows).transformed([=](const Point& p) {
    return Point(p.x(), p.y(), steepness * p.y());
  }));
}

TEST(Max_slope, makes_paths_turn_at_sides_on_a_steep_plane)
{
  const double steepness = 1, limit = 0.4;
  const Mesh mesh = slanted_plane(7, 7, steepness);
  const Dense_graph graph(Triangulation(mesh, max_slope(limit)), AG::Fixed_number_of_points(60));
  const Vertex source(3);
  const auto found = Basic_mesh_search<Dense_graph>(mesh, graph).distances({source});
  for(const Vertex v : mesh.vertices())
  {
    const Vector way = mesh.point(v) - mesh.point(source);
    const double height = std::abs(way.z()), least = height * std::hypot(1, limit) / limit;
    const double expected = (std::max)(std::sqrt(way.squared_length()), least);
    EXPECT_GE(found[v], expected * (1 - 1e-9));
    EXPECT_LE(found[v], expected * 1.1);
  }
}

// A ramp from the ground to a platform.
TEST(Max_slope, leads_up_a_ramp)
{
  const double steepness = 0.25, height = 2, length = height / steepness;
  Soup soup;
  for(const double y : {0., 1.})
    for(const double x : {-1., 0., length, length + 1})
      soup.points.emplace_back(x, y, x > 0 ? height : 0);
  for(std::size_t i = 0; i < 3; ++i)
  {
    soup.triangles.push_back({i, i + 1, i + 4});
    soup.triangles.push_back({i + 4, i + 1, i + 5});
  }
  const Mesh mesh = to_mesh(soup);
  const auto cost = [&](const double limit) {
    std::vector<Point> path;
    return CGAL::approximate_geodesic_path(mesh, std::back_inserter(path), Vertex(0), Vertex(3),
                                           max_slope(limit).number_of_points_per_edge(100));
  };
  EXPECT_EQ(no_limit, cost(0));
  EXPECT_NEAR(2 + std::hypot(length, height), cost(0.25), 1e-9);
  const double to_and_fro = 2 + height * std::hypot(1, 0.1) / 0.1;
  EXPECT_GE(cost(0.1), to_and_fro * (1 - 1e-9));
  EXPECT_LE(cost(0.1), to_and_fro * 1.1);
}

// One wall of triangles that are steep in all directions but along it: zigzags in them are not
// offered in place of straight lines, as they are for a cost of infinity.
TEST(Max_slope, is_no_cost_that_zigzags_meet)
{
  const auto at = [](const Point& p) { return Point(p.x(), p.y(), p.y() > 2.5 ? 10 : 0); };
  const Mesh mesh = to_mesh(flat_grid(4, 6).transformed(at));
  const Vertex low(0), high(4 * 5 + 3);
  const auto distance = [&](const auto& np) {
    std::vector<Point> path;
    return CGAL::approximate_geodesic_path(mesh, std::back_inserter(path), low, high, np);
  };
  const auto forbid = [](Face, const Vector& d) { return slope(d) > 0.6 ? no_limit : 1; };
  EXPECT_LT(distance(with_cost(forbid).number_of_points_per_edge(8)), 100);
  EXPECT_EQ(no_limit, distance(max_slope(0.6).number_of_points_per_edge(8)));
  EXPECT_EQ(no_limit, distance(with_cost(forbid).max_slope(0.6).number_of_points_per_edge(8)));
  EXPECT_LT(distance(max_slope(20).number_of_points_per_edge(8)), 100);
}

// Zigzags that a function of the slope makes cheaper keep the limit, too: stairs are cheap, and too
// steep.
TEST(Max_slope, holds_for_zigzags_that_cost_less)
{
  const auto stairs = [](const double s) { return std::abs(std::abs(s) - 0.65) < 0.1 ? 0.01 : 1; };
  const Mesh mesh = slanted_plane(5, 5, 1);
  const auto distances = [&](const double limit) {
    const Dense_graph graph(Triangulation(mesh, with_cost(stairs).max_slope(limit)),
                            AG::Fixed_number_of_points(9));
    return Basic_mesh_search<Dense_graph>(mesh, graph).distances({Vertex(10)});
  };
  const double level = mesh.point(Vertex(14)).x() - mesh.point(Vertex(10)).x();
  EXPECT_NEAR(level, distances(0.5)[14], 1e-9);
  EXPECT_LT(distances(1.5)[14], 0.1 * level);
}

// The cheapest zigzags are as steep as the limit, whose direction is none of those that are sampled
// without it.
TEST(Max_slope, is_attained_by_zigzags_where_steep_directions_are_cheap)
{
  const auto cheap_if_steep = [](const double s) { return 1 - 0.8 * std::abs(s); };
  const double limit = 0.5, cost = cheap_if_steep(limit);
  const double sine = limit / std::hypot(1, limit) / std::sqrt(0.5); // on the plane
  const double expected = cost / std::sqrt(1 - sine * sine);
  const Mesh mesh = slanted_plane(5, 5, 1);
  const Dense_graph graph(Triangulation(mesh, with_cost(cheap_if_steep).max_slope(limit)),
                          AG::Fixed_number_of_points(1));
  const double level = mesh.point(Vertex(14)).x() - mesh.point(Vertex(10)).x();
  const auto distances = Basic_mesh_search<Dense_graph>(mesh, graph).distances({Vertex(10)});
  EXPECT_NEAR(expected * level, distances[14], 1e-9);
}

// ----- what else it does

TEST(Max_slope, changes_nothing_where_no_face_is_steeper)
{
  const Mesh mesh = slanted_plane(5, 6, 0.3);
  const auto np = CGAL::parameters::epsilon(0.1).max_slope(0.31);
  const AG::Directional_graph<> graph(Triangulation(mesh, np), np);
  EXPECT_EQ(0.1, graph.epsilon());
  const auto found = Basic_mesh_search<AG::Directional_graph<>>(mesh, graph).distances({Vertex(0)});
  for(const Vertex v : mesh.vertices())
  {
    const double straight = std::sqrt((mesh.point(v) - mesh.point(Vertex(0))).squared_length());
    EXPECT_GE(found[v], straight * (1 - 1e-9));
    EXPECT_LE(found[v], straight * (1.1 + 1e-9));
  }
}

TEST(Max_slope, takes_the_bound)
{
  const Mesh mesh = slanted_plane(5, 6, 0.3);
  const auto np = CGAL::parameters::epsilon(0.1).max_slope(0.29);
  const Triangulation triangulation(mesh, np);
  expect_message<std::invalid_argument>([&] { AG::Directional_graph<> graph(triangulation, np); },
                                        "steeper than max_slope", "the face with vertices",
                                        "accept_weaker_bound");
  const AG::Directional_graph<> graph(triangulation, np.accept_weaker_bound(true));
  EXPECT_EQ(no_limit, graph.epsilon());
  const auto free = CGAL::parameters::epsilon(0.1).max_slope(no_limit);
  const AG::Directional_graph<> unlimited(Triangulation(mesh, free), free);
  EXPECT_EQ(unlimited.number_of_nodes(), graph.number_of_nodes());
}

TEST(Max_slope, is_for_the_class_and_the_functions)
{
  const Mesh mesh = slanted_plane(5, 5, 1);
  AG::Surface_mesh_shortest_path<Mesh, Dense_graph> searches(
      mesh, max_slope(0.4).number_of_points_per_edge(9));
  searches.add_source_point(Vertex(0));
  std::vector<double> found(mesh.number_of_vertices());
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(found.begin(), get(boost::vertex_index, mesh)),
      Vertex(0), max_slope(0.4).number_of_points_per_edge(9));
  std::vector<Point> path;
  const double length =
      CGAL::approximate_geodesic_path(mesh, std::back_inserter(path), Vertex(0), Vertex(22),
                                      max_slope(0.4).number_of_points_per_edge(9));
  EXPECT_DOUBLE_EQ(found[22], length);
  for(std::size_t i = 1; i < path.size(); ++i)
    EXPECT_LE(slope(path[i] - path[i - 1]), 0.4 * (1 + 1e-9));
  EXPECT_GT(path.size(), 3u);
  EXPECT_EQ(found[22], searches.shortest_distance_to_source_points(Vertex(22)).first);
}

TEST(Max_slope, is_refused_by_name)
{
  const Mesh mesh = slanted_plane(2, 2, 1);
  for(const double limit : {-0.1, std::numeric_limits<double>::quiet_NaN(), -no_limit})
    expect_message<std::invalid_argument>([&] { Triangulation(mesh, max_slope(limit)); },
                                          "max_slope is", "must be a number that is not negative");
}

} // namespace
