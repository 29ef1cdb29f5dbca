// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_costs/Directional_graph.h>

#include "checks/expect_message.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"
#include "paths/dijkstra.h"

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Geodesic_costs/cost_functions.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Costs that depend on the direction, next to what they have to be.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

template <typename Value>
using Constant_map = boost::static_property_map<Value, Face>;

// Costs of real paths: not below the cheapest ones, and not above the bound.
void expect_within(const double cost, const double cheapest, const double epsilon)
{
  constexpr double rounding = 1e-9;
  EXPECT_GE(cost, (1 - rounding) * cheapest);
  EXPECT_LE(cost, (1 + rounding) * (1 + epsilon) * cheapest);
}

template <typename G>
std::vector<double> distances(const Mesh& mesh, const G& graph, const Vertex source)
{
  return Basic_mesh_search<G>(mesh, graph).distances({source});
}

// Distances from a vertex and to it on a plane where all faces have the same gauge: these of the
// straight lines.
template <typename Cost>
void expect_straight_lines(const Mesh& mesh, const Cost& cost, const double epsilon)
{
  const auto graph = bounded_graph(mesh, cost_everywhere(cost), epsilon);
  EXPECT_EQ(epsilon, graph.epsilon());
  const Vertex source(mesh.number_of_vertices() / 2);
  const auto from = distances(mesh, graph, source);
  const auto to = distances(mesh, graph.reversed(), source);
  for(const Vertex v : mesh.vertices())
  {
    const Vector way = mesh.point(v) - mesh.point(source);
    expect_within(from[v], cost.cost(way), epsilon);
    expect_within(to[v], cost.cost(-way), epsilon);
  }
}

// The same arcs as those of a graph, all of them, one after the other.
std::vector<double> distances_by_all_arcs(const Dense_graph& graph, const Node source)
{
  const Triangulation& t = graph.triangulation();
  std::vector<double> result = textbook_distances<double>(
      graph.number_of_nodes(), source, [&](const std::size_t number, const auto& relax) {
        const auto node = static_cast<Node>(number);
        if(node >= t.number_of_vertices())
          graph.attach(graph.position(node)).for_each_node(relax);
        else // as a point of its edges
          for(Node h = t.first_halfedge(node); h < t.beyond_halfedge(node); ++h)
            graph.attach(AG::Intrinsic_point::on_edge(h, 0)).for_each_node(relax);
      });
  for(double& distance : result)
    distance *= graph.unit();
  return result;
}

double smallest_value(const std::function<double(double)>& f, double low, double high)
{
  constexpr double golden = 0.6180339887498949;
  for(int i = 0; i < 200; ++i)
  {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return f(low);
}

// ----- closed forms

TEST(Directional_costs, are_those_of_a_moving_river)
{
  const Mesh mesh = to_mesh(flat_grid(6, 7));
  for(const double epsilon : {0.5, 0.1})
    for(const double drift : {0., 0.3, 0.9})
      expect_straight_lines(mesh, Wind{Vector(0.8 * drift, -0.6 * drift, 0), 1}, epsilon);
}

TEST(Directional_costs, are_those_of_a_slanted_plane)
{
  const Mesh mesh = to_mesh(flat_grid(6, 7).transformed(
      [](const Point& p) { return Point(p.x(), p.y(), p.x() - p.y()); }));
  expect_straight_lines(mesh, Slant{3, Vector(0.5, 0.2, -0.3)}, 0.1);
}

// Costs with flat pieces, which make corners between any two directions.
TEST(Directional_costs, are_those_of_polyhedral_norms)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(4, 5));
  for(const int sides : {3, 4, 6, 7})
    for(const double turn : {0., 0.3, 0.7})
    {
      SCOPED_TRACE(std::to_string(sides) + " sides, turned by " + std::to_string(turn));
      expect_straight_lines(mesh, Half_planes::regular(sides, turn), 0.1);
      expect_straight_lines(mesh, Half_planes::random(random, sides), 0.3);
    }
}

// Two winds, one on each side of a straight line: where a way crosses it is a problem of one
// number.
TEST(Directional_costs, refract_paths_at_a_line)
{
  const std::size_t columns = 9, rows = 4;
  const Mesh mesh = to_mesh(flat_grid(columns, rows));
  const double border = mesh.point(Vertex(2 * columns)).y();
  const std::vector<std::pair<Wind, Wind>> pairs = {
      {{Vector(0, 0, 0), 1}, {Vector(0, 0, 0), 2. / 3}},
      {{Vector(0, 0, 0), 1}, {Vector(0, 0, 0), 1. / 3}},
      {{Vector(0, 0, 0), 1}, {Vector(0, 0, 0), 0.1}},
      {{Vector(0, 0, 0), 1}, {Vector(0, 0, 0), 0.01}},
      {{Vector(0.5, 0, 0), 1}, {Vector(-0.5, 0.3, 0), 1}},
      {{Vector(0, 0, 0), 1}, {Vector(1.2, 0, 0), 1.5}}};
  for(const auto& [below, above] : pairs)
  {
    const auto cost = [&, b = below, a = above](const Face f, const Vector& d) {
      double height = 0;
      for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        height += mesh.point(v).y() / 3;
      return height < border ? b.cost(d) : a.cost(d);
    };
    const double epsilon = 0.05;
    const auto graph = bounded_graph(mesh, cost, epsilon);
    const Vertex source(0);
    const auto found = distances(mesh, graph, source);
    for(const Vertex v : mesh.vertices())
      if(mesh.point(v).y() > border)
      {
        const auto crossing_at = [&, b = below, a = above](const double x) {
          const Point p(x, border, 0);
          return b.cost(p - mesh.point(source)) + a.cost(mesh.point(v) - p);
        };
        // along the border, whichever side is cheaper; ways do not leave the mesh there
        const double cheapest = smallest_value(crossing_at, 0, mesh.point(Vertex(columns - 1)).x());
        EXPECT_LE(found[v], (1 + 1e-9) * (1 + epsilon) * cheapest);
      }
  }
}

// A tensor per face that measures lengths on another surface.
TEST(Directional_costs, measure_a_cone_and_a_terrain_by_tensors)
{
  Random random(test_seed());
  const std::vector<std::pair<Soup, Soup>> pairs = {
      {fan(12, 0), fan(12, 1)}, {fan(9, 0.5), fan(9, 3)}, {flat_grid(6, 5), terrain(6, 5, random)}};
  for(const auto& [measured, real] : pairs)
  {
    const Mesh mesh = to_mesh(measured), other = to_mesh(real);
    std::vector<std::array<double, 6>> tensors;
    for(const Face f : mesh.faces())
    {
      std::vector<Vertex> v;
      for(const Vertex w : mesh.vertices_around_face(mesh.halfedge(f)))
        v.push_back(w);
      const Vector a = mesh.point(v[1]) - mesh.point(v[0]), b = mesh.point(v[2]) - mesh.point(v[0]);
      const Vector c = other.point(v[1]) - other.point(v[0]),
                   d = other.point(v[2]) - other.point(v[0]);
      const Vector n = CGAL::cross_product(a, b); // the dual base of `a` and `b` follows from it
      const Vector p = CGAL::cross_product(b, n) / n.squared_length(),
                   q = CGAL::cross_product(n, a) / n.squared_length();
      const auto entry = [&](const int i, const int j) {
        return (c * c) * p[i] * p[j] + (c * d) * (p[i] * q[j] + p[j] * q[i]) +
               (d * d) * q[i] * q[j];
      };
      tensors.push_back(
          {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)});
    }
    const AG::Tensor_cost cost(Values_by_index<Face, std::vector<std::array<double, 6>>>{&tensors});
    const double epsilon = 0.1;
    const auto found = distances(mesh, bounded_graph(mesh, cost, epsilon), Vertex(1));
    const auto exact = Basic_mesh_search<AG::Saddle_vertex_graph>(other).distances({Vertex(1)});
    for(const Vertex v : mesh.vertices())
      expect_within(found[v], exact[v], epsilon);
  }
}

// Straight up a steep slope, one goes in zigzags: so fast as one gains height at best.
template <typename Cost>
void expect_zigzags(const Cost& cost, const double slope, const double sign)
{
  const Mesh mesh = to_mesh(flat_grid(5, 9).transformed(
      [slope](const Point& p) { return Point(p.x(), p.y(), slope * p.y()); }));
  const double largest = std::atan(slope);
  const double per_height = smallest_value(
      [&](const double angle) {
        return cost(Face(0), Vector(std::cos(angle), 0, sign * std::sin(angle))) / std::sin(angle);
      },
      1e-3, largest);
  const double epsilon = 0.4;
  const auto graph = bounded_graph(mesh, cost, epsilon);
  const Vertex low(2), high(2 + 5 * 8);
  const double height = mesh.point(high).z() - mesh.point(low).z();
  const auto found = sign > 0 ? distances(mesh, graph, low) : distances(mesh, graph, high);
  expect_within(found[sign > 0 ? high : low], per_height * height, epsilon);
}

TEST(Directional_costs, make_paths_zigzag_on_a_slope)
{
  for(const double sign : {1., -1.})
  {
    expect_zigzags(AG::Hiking_time(), 1, sign);
    expect_zigzags(AG::Hiking_time(0.6), 0.5, sign);
    expect_zigzags(AG::Hiking_time(), 0.2, sign); // straight
    expect_zigzags(AG::Walking_energy(), 0.4, sign);
  }
}

// Costs that are not convex are looked at closely where zigzags begin to pay.
template <typename Cost>
void expect_close_to_zigzags(const Cost& cost, const double slope, const double sign)
{
  const double x = 1 / std::hypot(1, slope), z = sign * slope / std::hypot(1, slope);
  const Mesh mesh = to_mesh(flat_grid(2, 2).transformed(
      [&](const Point& p) { return Point(p.x(), x * p.y(), z * p.y()); }));
  const auto per_height = [&](const double angle) {
    const double up = std::sin(angle);
    return cost(Face(0), Vector(std::cos(angle), x * up, z * up)) / up;
  };
  double best = 1e-3;
  for(double angle = best; angle < 1.57; angle += 1e-4) // there are several minima
    best = per_height(angle) < per_height(best) ? angle : best;
  const double expected = smallest_value(per_height, best - 1e-4, best + 1e-4);
  const double epsilon = 0.05;
  const Triangulation triangulation(mesh, with_cost(cost).epsilon(epsilon));
  const Directional_graph<AG::Fixed_number_of_points> along_edges(triangulation,
                                                                  AG::Fixed_number_of_points(0));
  expect_within(distances(mesh, along_edges, Vertex(0))[Vertex(2)], expected, epsilon / 10);
}

TEST(Directional_costs, make_paths_zigzag_on_a_wall)
{
  for(const double slope : {1., 3., 1e9})
    for(const double sign : {1., -1.})
    {
      SCOPED_TRACE(sign * slope);
      expect_close_to_zigzags(AG::Hiking_time(), slope, sign);
      expect_close_to_zigzags(AG::Walking_energy(), slope, sign);
    }
}

// Walkers on a slope that is not steep go straight, also if they are not sampled.
TEST(Directional_costs, are_those_of_a_slope)
{
  const double slope = 0.2;
  const Mesh mesh = to_mesh(flat_grid(6, 7).transformed(
      [=](const Point& p) { return Point(p.x(), p.y(), slope * (0.6 * p.x() + 0.8 * p.y())); }));
  for(const double epsilon : {0.5, 0.1, 0.02})
  {
    const auto np = with_cost(AG::Hiking_time()).epsilon(epsilon);
    const Directional_graph<> graph(Triangulation(mesh, np), np);
    EXPECT_EQ(0, graph.sampling_error());
    EXPECT_EQ(epsilon, graph.epsilon());
    const Vertex source(20);
    const auto from = distances(mesh, graph, source),
               to = distances(mesh, graph.reversed(), source);
    for(const Vertex v : mesh.vertices())
    {
      const Vector way = mesh.point(v) - mesh.point(source);
      const double length = std::sqrt(way.squared_length());
      if(v == source)
        continue;
      expect_within(from[v], length * AG::Hiking_time()(Face(0), way / length), epsilon);
      expect_within(to[v], length * AG::Hiking_time()(Face(0), -way / length), epsilon);
    }
  }
}

TEST(Directional_costs, have_their_published_values)
{
  const AG::Hiking_time time;
  EXPECT_NEAR(3600 / 6000., time(0, Vector(1, 0, -0.05)), 1e-12);
  EXPECT_NEAR(3600 / (6000 * std::exp(-3.5 * 0.05)), time(0, Vector(0, 1, 0)), 1e-12);
  const AG::Walking_energy energy;
  EXPECT_NEAR(2.5, energy(0, Vector(1, 0, 0)), 1e-12);
  EXPECT_NEAR(17.3, energy(0, Vector(1, 0, 0.45)), 0.5); // as measured
  EXPECT_EQ(infinity, energy(0, Vector(1, 0, 0.5)));
  for(const double up : {1., -1.})
  {
    EXPECT_EQ(infinity, time(0, Vector(0, 0, up)));
    EXPECT_EQ(infinity, energy(0, Vector(0, 0, up)));
  }
  const AG::Drift_time drift(Constant_map<Vector>(Vector(3, 0, 0)), 5);
  EXPECT_NEAR(1 / 8., drift(Face(0), Vector(1, 0, 0)), 1e-15);
  EXPECT_NEAR(1 / 2., drift(Face(0), Vector(-1, 0, 0)), 1e-15);
  EXPECT_NEAR(1 / 4., drift(Face(0), Vector(0, 1, 0)), 1e-15);
}

// ----- arcs

TEST(Directional_costs, do_not_need_the_arcs_that_are_left_out)
{
  Random random(test_seed());
  for(const Soup& soup : {terrain(5, 4, random), flat_grid(4, 4), fan(7, 1), sphere(5, 3)})
  {
    const Mesh mesh = to_mesh(soup);
    const auto slants = random_slants(mesh, random, 0.9);
    for(const std::size_t number : {0u, 3u, 20u})
    {
      const Dense_graph graph = dense_graph(mesh, cost_of_faces(slants), number);
      AG::Propagation<Dense_graph> search(graph);
      search.run_from(0);
      const auto expected = distances_by_all_arcs(graph, 0);
      for(Node n = 0; n < graph.number_of_nodes(); ++n)
        EXPECT_NEAR(expected[n], search.distance(n), 1e-9 * expected[n]);
    }
  }
}

TEST(Directional_costs, are_weights_if_directions_do_not_matter)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(6, 6, random));
  const auto weights = random_weights(mesh, random, 0.1, 10, 0);
  const auto cost = [&](const Face f, const Vector&) { return weights[f.idx()]; };
  const auto found = distances(mesh, dense_graph(mesh, cost, 5), Vertex(0));
  const Steiner_graph<Fixed_number_of_points> other(Triangulation(mesh, with_weights(weights)),
                                                    Fixed_number_of_points(5));
  const auto expected = distances(mesh, other, Vertex(0));
  for(const Vertex v : mesh.vertices())
    expect_within(found[v], expected[v], 0.01);
}

// ----- there and back

TEST(Directional_costs, make_the_way_back_the_way_there_reversed)
{
  Random random(test_seed());
  for(const Soup& soup : {terrain(7, 6, random), fan(8, 1), sphere(6, 5)})
  {
    const Mesh mesh = to_mesh(soup);
    const auto slants = random_slants(mesh, random, 0.8);
    const auto cost = cost_of_faces(slants);
    const auto compare = [&](const auto& graph, const auto& graph_of_reversed) {
      EXPECT_TRUE(have_same_bits(distances(mesh, graph.reversed(), Vertex(2)),
                                 distances(mesh, graph_of_reversed, Vertex(2))));
      EXPECT_FALSE(have_same_bits(distances(mesh, graph, Vertex(2)),
                                  distances(mesh, graph_of_reversed, Vertex(2))));
    };
    compare(bounded_graph(mesh, cost, 0.2), bounded_graph(mesh, reversed_cost(cost), 0.2));
    compare(dense_graph(mesh, cost, 10), dense_graph(mesh, reversed_cost(cost), 10));
  }
}

TEST(Directional_costs, make_the_way_back_zigzag)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(7, 6, random));
  const auto compare = [&](const auto& cost) {
    EXPECT_TRUE(
        have_same_bits(distances(mesh, dense_graph(mesh, cost, 4).reversed(), Vertex(2)),
                       distances(mesh, dense_graph(mesh, reversed_cost(cost), 4), Vertex(2))));
  };
  compare(AG::Hiking_time());
  compare(AG::Walking_energy());
  compare([](const Face f, const Vector& d) { // neither smooth nor convex
    return 1 + std::abs(std::sin(17 * d.x() + 3 * d.y() + double(f.idx() % 5)));
  });
}

TEST(Directional_costs, are_there_what_they_are_back_from_the_other_end)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(6, 6, random));
  const auto slants = random_slants(mesh, random, 0.8);
  const auto graph = bounded_graph(mesh, cost_of_faces(slants), 0.1);
  const auto to_last = distances(mesh, graph.reversed(), Vertex(35));
  const auto to_first = distances(mesh, graph.reversed(), Vertex(0));
  EXPECT_NEAR(distances(mesh, graph, Vertex(0))[35], to_last[0], 1e-9 * to_last[0]);
  EXPECT_GT(std::abs(to_last[0] - to_first[35]), 1e-6 * to_last[0]);
}

// ----- directions that are forbidden or free

TEST(Directional_costs, make_faces_one_way)
{
  const Mesh mesh = to_mesh(flat_grid(5, 5));
  const auto graph = dense_graph(mesh, AG::One_way(Constant_map<Vector>(Vector(1, 0, 0)), 2.), 6);
  const Vertex source(12);
  const auto from = distances(mesh, graph, source);
  const auto to = distances(mesh, graph.reversed(), source);
  for(const Vertex v : mesh.vertices())
  {
    const Vector way = mesh.point(v) - mesh.point(source);
    const double length = 2 * std::sqrt(way.squared_length());
    EXPECT_EQ(way.x() < 0, from[v] == infinity);
    EXPECT_EQ(way.x() > 0, to[v] == infinity);
    if(way.x() >= 0)
      expect_within(from[v], length, 0.05);
    if(way.x() <= 0)
      expect_within(to[v], length, 0.05);
  }
  EXPECT_EQ(infinity, graph.epsilon());
}

// Where a way allows one half of the directions, or nearly all, its length does not matter.
TEST(Directional_costs, make_faces_of_any_size_one_way)
{
  const Face face(0);
  for(const double length : {1e-200, 1e-3, 1., 1e200})
    for(const double cosine : {-0.9, 0., 0.9})
    {
      const AG::One_way cost(Constant_map<Vector>(Vector(0.6 * length, 0.8 * length, 0)), 2.,
                             cosine);
      EXPECT_EQ(2, cost(face, Vector(0.6, 0.8, 0)));
      EXPECT_EQ(cosine <= 0 ? 2 : infinity, cost(face, Vector(-0.8, 0.6, 0)));
      EXPECT_EQ(infinity, cost(face, Vector(-0.6, -0.8, 0)));
    }
  const AG::One_way everywhere(Constant_map<Vector>(Vector(0, 0, 0)), 2.);
  EXPECT_EQ(2, everywhere(face, Vector(-1, 0, 0)));
}

TEST(Directional_costs, refuse_values_that_are_not_finite)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  const auto expect_refused = [&](const auto& cost) {
    expect_message<std::invalid_argument>([&] { Triangulation t(mesh, with_cost(cost)); }, "face",
                                          "nan in the direction ");
  };
  for(const double value : {not_a_number, infinity, -infinity})
  {
    for(const Vector& v : {Vector(value, 0, 0), Vector(1, value, 0), Vector(0, 0, value)})
    {
      expect_refused(AG::One_way(Constant_map<Vector>(v)));
      expect_refused(AG::Drift_time(Constant_map<Vector>(v), 2));
    }
    for(std::size_t i = 0; i < 6; ++i)
    {
      std::array<double, 6> tensor = {1, 0, 0, 1, 0, 1};
      tensor[i] = value;
      expect_refused(AG::Tensor_cost(Constant_map<std::array<double, 6>>(tensor)));
    }
  }
}

TEST(Directional_costs, refuse_parameters_out_of_range)
{
  const Constant_map<Vector> map(Vector(1, 0, 0));
  for(const double value : {not_a_number, infinity, -1.})
  {
    expect_message<std::invalid_argument>([&] { AG::Hiking_time cost(value); }, "factor");
    expect_message<std::invalid_argument>([&] { AG::Drift_time cost(map, value); }, "speed");
    expect_message<std::invalid_argument>([&] { AG::One_way cost(map, value); }, "the cost of");
  }
  for(const double value : {not_a_number, infinity, -1.1, 1.1})
    expect_message<std::invalid_argument>([&] { AG::One_way cost(map, 1, value); }, "cosine");
}

TEST(Directional_costs, may_be_of_a_current_that_is_too_strong)
{
  const Mesh mesh = to_mesh(flat_grid(7, 7));
  const AG::Drift_time cost(Constant_map<Vector>(Vector(2, 0, 0)), 1);
  const Vertex source(21);
  const auto from = distances(mesh, dense_graph(mesh, cost, 20), source);
  std::size_t number = 0;
  for(const Vertex v : mesh.vertices())
  {
    const Vector way = mesh.point(v) - mesh.point(source);
    const double sine = 1. / 2; // of the widest angle
    const double length = std::sqrt(way.squared_length());
    if(way.x() < 0 || std::abs(way.y()) > sine * length + 1e-9)
      EXPECT_EQ(infinity, from[v]);
    else if(length > 0 && std::abs(way.y()) < 0.9 * sine * length)
    {
      expect_within(from[v], length * cost(Face(0), way / length), 0.05);
      ++number;
    }
  }
  EXPECT_GT(number, 5u);
}

TEST(Directional_costs, may_be_free_or_infinite_in_faces)
{
  const Mesh mesh = to_mesh(flat_grid(6, 6));
  const Wind wind{Vector(0.4, 0, 0), 1};
  const auto cost = [&](const Face f, const Vector& d) {
    return f.idx() % 5 == 0 ? 0. : f.idx() % 7 == 0 ? infinity : wind.cost(d);
  };
  const auto found = distances(mesh, bounded_graph(mesh, cost, 0.2), Vertex(0));
  const auto reference = distances(mesh, dense_graph(mesh, cost, 40), Vertex(0));
  for(const Vertex v : mesh.vertices())
    EXPECT_LE(found[v], (1 + 1e-9) * 1.2 * reference[v]);
}

TEST(Directional_costs, may_be_free_in_some_directions)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const auto cost = [](const Face, const Vector& d) { return (std::max)(d.x(), 0.); };
  const auto found = distances(mesh, dense_graph(mesh, cost, 3), Vertex(5));
  for(const Vertex v : mesh.vertices())
    EXPECT_NEAR((std::max)(mesh.point(v).x() - mesh.point(Vertex(5)).x(), 0.), found[v], 1e-9);
}

} // namespace
