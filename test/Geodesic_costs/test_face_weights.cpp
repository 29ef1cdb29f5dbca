// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "checks/expect_message.h"
#include "meshes/steiner_meshes.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Weights as input: exchanged ones, extreme ones, and those that are refused.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// ----- exchanged

TEST(Exchanged_weights, give_the_same_as_a_graph_built_with_them)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    const Vertex source = random_vertex(mesh, random);
    const Weights first = random_weights(mesh, random, 0.1, 10, 0.05);
    const Weights second = random_weights(mesh, random, 1e-3, 1e5, 0.05);
    auto graph = steiner_graph(mesh, first, Fixed_number_of_points(2));
    graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(second)));
    Basic_mesh_search<Steiner_graph<Fixed_number_of_points>> exchanged(mesh, std::move(graph));
    EXPECT_TRUE(have_same_bits(exchanged.distances({source}),
                               costs(mesh, second, Fixed_number_of_points(2), {source})));

    AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>> paths(
        mesh, steiner_graph(mesh, first, Fixed_number_of_points(2)));
    paths.add_source_point(source);
    const Vertex target = random_vertex(mesh, random);
    const auto expect = [&](const Weights& weights) {
      const double expected = costs(mesh, weights, Fixed_number_of_points(2), {source})[target];
      const double found = paths.shortest_distance_to_source_points(target).first;
      EXPECT_EQ(found, expected == infinity ? -1 : expected);
    };
    expect(first);
    paths.set_face_weights(weight_map(second));
    expect(second);
  });
}

TEST(Exchanged_weights, have_a_worse_bound_if_they_were_equal_before)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(8, 7));
  const Weights equal(mesh.num_faces(), 1), scaled(mesh.num_faces(), 1024);
  const Weights mild = random_weights(mesh, random, 1, 2);
  const Weights strong = random_weights(mesh, random, 1, 100);
  auto graph = steiner_graph(mesh, mild, Geometric_points(0.1));
  graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(strong)));
  EXPECT_EQ(graph.epsilon(), 0.1);
  graph = steiner_graph(mesh, equal, Geometric_points(0.1));
  EXPECT_EQ(graph.epsilon(), 0.1);
  graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(scaled)));
  EXPECT_EQ(graph.epsilon(), 0.1);
  graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(strong)));
  EXPECT_GT(graph.epsilon(), 0.1);
  EXPECT_LT(graph.epsilon(), infinity);
  const double bound = graph.epsilon();
  Basic_mesh_search<Steiner_graph<>> search(mesh, std::move(graph));
  const std::vector<double> found = search.distances({Vertex(3)});
  const std::vector<double> close = costs(mesh, strong, Geometric_points(0.01), {Vertex(3)});
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LE(found[i], close[i] * (1 + bound));
}

TEST(Exchanged_weights, are_refused_for_another_mesh)
{
  const Mesh mesh = to_mesh(flat_grid(5, 4)), other = to_mesh(flat_grid(5, 5));
  auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 1), Fixed_number_of_points(1));
  const Weights weights(other.num_faces(), 1);
  expect_message<std::invalid_argument>(
      [&] {
        graph.set_weights(AG::read_face_weights(other, graph.triangulation(), weight_map(weights)));
      },
      "mesh");
  const Mesh smaller = to_mesh(flat_grid(4, 4));
  expect_message<std::invalid_argument>(
      [&] {
        graph.set_weights(
            AG::read_face_weights(smaller, graph.triangulation(), weight_map(weights)));
      },
      "mesh");
}

// Weights that are refused for what costs would be do not take the place of those before.
TEST(Exchanged_weights, are_not_exchanged_if_costs_do_not_fit_a_double)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4).transformed(
      [](const Point& p) { return Point(p.x() * 1e200, p.y() * 1e200, 0); }));
  const Weights ones(mesh.num_faces(), 1), large(mesh.num_faces(), 1e200);
  auto graph = steiner_graph(mesh, ones, Fixed_number_of_points(1));
  const double unit = graph.unit();
  expect_message<std::invalid_argument>(
      [&] {
        graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(), weight_map(large)));
      },
      "weights", "lengths");
  EXPECT_EQ(graph.unit(), unit);

  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>> paths(mesh, graph);
  paths.add_source_point(Vertex(0));
  const double distance = paths.shortest_distance_to_source_points(Vertex(15)).first;
  expect_message<std::invalid_argument>([&] { paths.set_face_weights(weight_map(large)); },
                                        "weights");
  EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(15)).first, distance);
  EXPECT_NEAR(distance, std::sqrt(18.) * 1e200, 1e187);
}

// ... nor is anything left of them if all faces become forbidden.
TEST(Exchanged_weights, may_forbid_everything)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 1), Fixed_number_of_points(1));
  graph.set_weights(AG::read_face_weights(mesh, graph.triangulation(),
                                          weight_map(Weights(mesh.num_faces(), infinity))));
  EXPECT_EQ(graph.arc_lengths().longest, 0);
}

// No product of an infinite weight and a length of zero.
TEST(Forbidden_faces, have_no_lines_along_their_edges)
{
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(0, 0, 0), Point(1, 0, 0), Point(-1, 0, 0)};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}};
  const Mesh mesh = to_mesh(soup);
  const auto graph = steiner_graph(mesh, Weights(2, infinity), Fixed_number_of_points(1));
  const Triangulation& t = graph.triangulation();
  const auto expect_no_line = [](const std::size_t, const double cost) {
    EXPECT_EQ(infinity, cost);
  };
  for(Node h = 0; h < t.number_of_halfedges(); ++h)
  {
    const auto p = AG::Intrinsic_point::on_edge(h, 0.5);
    const AG::Points_by_face points(t, {AG::Intrinsic_point::on_edge(h, 0.25)});
    std::feclearexcept(FE_INVALID);
    graph.attach(p).for_each_node(expect_no_line);
    graph.attach(p).for_each_point(points, expect_no_line);
    AG::Lines_in_faces(t, p).for_each_point(points, expect_no_line);
    EXPECT_FALSE(std::fetestexcept(FE_INVALID)) << "undefined cost on halfedge " << h;
  }
}

// ----- of all magnitudes

TEST(Weighted_faces, may_have_weights_of_all_magnitudes)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(14, 12, random));
  const double values[] = {0, 1e-12, 1, 1e12, infinity};
  Weights weights(mesh.num_faces());
  for(double& w : weights)
    w = values[random.below(5)];
  for(const Vertex source : {Vertex(0), Vertex(40), Vertex(100)})
  {
    const std::vector<double> coarse = costs(mesh, weights, Fixed_number_of_points(1), {source});
    const std::vector<double> fine = costs(mesh, weights, Fixed_number_of_points(3), {source});
    const std::vector<double> bound = costs(mesh, weights, Geometric_points(0.1), {source});
    EXPECT_EQ(fine[source], 0);
    for(std::size_t i = 0; i < fine.size(); ++i)
    {
      EXPECT_GE(fine[i], 0);
      EXPECT_LE(fine[i], coarse[i] * (1 + rounding_of_costs));
      EXPECT_LE(bound[i], coarse[i] * 1.1);
      EXPECT_EQ(std::isinf(bound[i]), std::isinf(coarse[i]));
    }
  }
}

std::vector<double> costs_on_square(const double length, const double weight)
{
  const auto stretch = [&](const Point& p) { return Point(p.x() * length, p.y() * length, 0); };
  const Mesh mesh = to_mesh(flat_grid(4, 4).transformed(stretch));
  return costs(mesh, Weights(mesh.num_faces(), weight), Fixed_number_of_points(1), {Vertex(0)});
}

void expect_in_proportion_to(const double weight)
{
  SCOPED_TRACE(weight);
  std::vector<double> found = costs_on_square(1, weight);
  for(double& d : found)
    d /= weight;
  expect_about_the_same(found, costs_on_square(1, 1), rounding_of_costs);
}

TEST(Weighted_faces, may_cost_very_much)
{
  for(const double weight : {1e12, 1e200, 1e300})
    expect_in_proportion_to(weight);
}

TEST(Weighted_faces, may_cost_very_little)
{
  for(const double weight : {1e-12, 1e-200, 1e-300})
    expect_in_proportion_to(weight);
}

// ----- refused

TEST(Bad_weights, are_refused_by_name_of_the_face)
{
  const Mesh mesh = to_mesh(flat_grid(6, 5));
  const Face bad(17);
  std::vector<std::string> names;
  for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(bad)))
    names.push_back(std::to_string(v.idx()));
  const auto expect_refusal = [&](const auto& f) {
    expect_message<std::invalid_argument>(f, names[0], names[1], names[2], "weight");
  };
  for(const double w : {-1., -1e-300, -infinity, not_a_number})
  {
    const Weights good(mesh.num_faces(), 2);
    Weights weights = good;
    weights[bad.idx()] = w;
    std::vector<double> distances(mesh.num_vertices(), 7);
    const auto map = boost::make_iterator_property_map(distances.begin(), //
                                                       get(boost::vertex_index, mesh));
    expect_refusal(
        [&] { CGAL::approximate_geodesic_distances(mesh, map, Vertex(0), with_weights(weights)); });
    EXPECT_EQ(distances, std::vector<double>(mesh.num_vertices(), 7));
    expect_refusal([&] {
      std::vector<Point> points;
      CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), Vertex(0), Vertex(1),
                                      with_weights(weights));
    });
    using Weighted_paths = AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<>>;
    expect_refusal([&] { Weighted_paths paths(mesh, with_weights(weights)); });
    Weighted_paths paths(mesh, with_weights(good));
    paths.add_source_point(Vertex(0));
    const double before = paths.shortest_distance_to_source_points(Vertex(29)).first;
    expect_refusal([&] { paths.set_face_weights(weight_map(weights)); });
    paths.build_sequence_tree(parameters::default_values());
    EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(29)).first, before);
    EXPECT_GT(before, 0);
  }
}

TEST(Weighted_faces, are_refused_if_costs_do_not_fit_a_double)
{
  for(const double weight : {1e158, 1e300}) // with the smaller one, the unit of costs does fit
    expect_message<std::invalid_argument>([&] { costs_on_square(1e150, weight); }, "weights",
                                          "lengths");
}

// Lengths of zero do not make up for a unit of costs that does not fit.
TEST(Weighted_faces, are_refused_if_the_unit_of_costs_does_not_fit_a_double)
{
  const Mesh mesh =
      to_mesh(flat_grid(3, 3).transformed([](const Point&) { return Point(1e150, 0, 0); }));
  const Weights weights(mesh.num_faces(), 1e300);
  expect_message<std::invalid_argument>(
      [&] { costs(mesh, weights, Fixed_number_of_points(1), {Vertex(0)}); }, "weights", "lengths");
}

template <typename Graph>
void expect_refusal(const std::string& name)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Weights weights(mesh.num_faces(), 1);
  const Barriers barriers(mesh.num_edges(), true);
  expect_message<std::invalid_argument>([&] { Graph(Triangulation(mesh, with_weights(weights))); },
                                        name, "weights", "Steiner_graph");
  expect_message<std::invalid_argument>(
      [&] { Graph(Triangulation(mesh, with_barriers(barriers))); }, name, "barriers",
      "Steiner_graph");
}

TEST(Weighted_faces, are_refused_by_graphs_that_do_not_heed_them)
{
  expect_refusal<AG::Edge_graph>("Edge_graph");
  expect_refusal<AG::Discrete_geodesic_graph>("Discrete_geodesic_graph");
  expect_refusal<AG::Lazy_discrete_geodesic_graph>("Lazy_discrete_geodesic_graph");
}

TEST(Saddle_vertex_graph, refuses_weights_and_barriers)
{
  Random random(test_seed());
  const Mesh mesh = quiet_mesh();
  const Triangulation weighted(mesh, with_weights(random_weights(mesh, random, 0.5, 2)));
  expect_message<std::invalid_argument>([&] { AG::Saddle_vertex_graph{weighted}; },
                                        "Saddle_vertex_graph does not support weights",
                                        "use Steiner_graph");
  const Barriers barriers = random_barriers(mesh, 0.5, random);
  const Triangulation divided(mesh, with_barriers(barriers));
  expect_message<std::invalid_argument>([&] { AG::Saddle_vertex_graph{divided}; },
                                        "Saddle_vertex_graph does not support barriers",
                                        "use Steiner_graph");
}

} // namespace
