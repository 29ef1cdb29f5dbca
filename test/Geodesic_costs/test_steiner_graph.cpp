// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "checks/expect_message.h"
#include "meshes/Random_points.h"
#include "meshes/sample_meshes.h"
#include "meshes/steiner_meshes.h"
#include "oracles/Full_graph.h"
#include "oracles/exact_distances.h"

#include <CGAL/Approximate_geodesics/Queues/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Queues/Ordered_queues.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// Relations that hold on all meshes, whatever the weights; next to brute force and the exact class.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// ----- special cases

TEST(Steiner_graph, is_the_edge_graph_if_there_are_no_points)
{
  for_generated_meshes([](const Mesh& mesh, Random& random) {
    const Vertex source = random_vertex(mesh, random);
    Basic_mesh_search<Steiner_graph<Fixed_number_of_points>> search(
        mesh, parameters::number_of_points_per_edge(0));
    EXPECT_EQ(search.graph().number_of_nodes(), mesh.number_of_vertices());
    EXPECT_TRUE(have_same_bits(search.distances({source}), Mesh_search(mesh).distances({source})));
  });
}

template <typename Placement>
void expect_unweighted(const Mesh& mesh, const Placement& placement, const Vertex source)
{
  Basic_mesh_search<Steiner_graph<Placement>> unweighted(
      mesh, Steiner_graph<Placement>(Triangulation(mesh), placement));
  EXPECT_TRUE(have_same_bits(costs(mesh, Weights(mesh.num_faces(), 1), placement, {source}),
                             unweighted.distances({source})));
}

TEST(Steiner_graph, does_not_change_if_all_weights_are_one)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights&, Random& random) {
    const Vertex source = random_vertex(mesh, random);
    expect_unweighted(mesh, Fixed_number_of_points(0), source);
    expect_unweighted(mesh, Fixed_number_of_points(3), source);
    expect_unweighted(mesh, lenient_points(0.3), source);
  });
}

TEST(Steiner_graph, has_costs_in_exact_proportion_to_powers_of_two)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    const Vertex source = random_vertex(mesh, random);
    for(const int k : {-70, -1, 3, 100})
    {
      Weights scaled = weights;
      for(double& w : scaled)
        w = std::ldexp(w, k);
      std::vector<double> expected = costs(mesh, weights, Fixed_number_of_points(2), {source});
      for(double& d : expected)
        d = std::ldexp(d, k);
      EXPECT_TRUE(
          have_same_bits(costs(mesh, scaled, Fixed_number_of_points(2), {source}), expected));
    }
  });
}

TEST(Steiner_graph, may_be_empty)
{
  const Steiner_graph<> graph;
  EXPECT_EQ(graph.number_of_nodes(), 0u);
  const Mesh mesh;
  const Weights weights;
  EXPECT_EQ(steiner_graph(mesh, weights, Fixed_number_of_points(4)).number_of_nodes(), 0u);
}

TEST(Bad_meshes, are_refused_only_if_paths_run_across_faces)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  std::vector<double> lengths(mesh.num_edges(), 1);
  lengths[0] = 3;
  const auto np = parameters::edge_length_map(
      boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh)));
  const Triangulation triangulation(mesh, np);
  using Fixed_graph = Steiner_graph<Fixed_number_of_points>;
  EXPECT_NO_THROW(Fixed_graph(triangulation, Fixed_number_of_points(0)));
  expect_message<std::invalid_argument>(
      [&] { Fixed_graph g(triangulation, Fixed_number_of_points(1)); }, "triangle inequality");
}

// Up to rounding, these are lengths of a triangle, whose sides at one corner are 0 and 1.
TEST(Geometric_points, take_lengths_that_only_just_make_triangles)
{
  const Mesh mesh = to_mesh(flat_grid(2, 2));
  std::vector<double> lengths(mesh.num_edges(), 1 - 1e-15);
  lengths[mesh.edge(mesh.halfedge(Vertex(0), Vertex(1))).idx()] = 0;
  lengths[mesh.edge(mesh.halfedge(Vertex(0), Vertex(3))).idx()] = 1;
  const auto np = parameters::edge_length_map(
      boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh)));
  const Steiner_graph<> graph(Triangulation(mesh, np), lenient_points(0.1));
  AG::Propagation<Steiner_graph<>> search(graph);
  search.run_from(graph.triangulation().vertex(0));
  for(Node n = 0; n < graph.number_of_nodes(); ++n)
    EXPECT_TRUE(search.distance(n) >= 0 && search.distance(n) <= 1 + 1e-12);
}

// ----- arcs

// All arcs are looked at by the reference, and only few by the graph.
template <typename Placement>
void expect_all_arcs(const Mesh& mesh,
                     const Weights& weights,
                     const Placement& placement,
                     Random& random)
{
  const auto graph = steiner_graph(mesh, weights, placement);
  const Full_graph reference(mesh, graph);
  AG::Propagation<Steiner_graph<Placement>> search(graph);
  const std::size_t number_of_vertices = mesh.number_of_vertices();
  for(const std::size_t choice : {number_of_vertices, graph.number_of_nodes()}) // points as well
  {
    const Node source = static_cast<Node>(random.below(choice));
    search.run_from(source);
    expect_about_the_same(distances_of_nodes(search), reference.distances(source),
                          rounding_of_costs);
  }
}

TEST(Steiner_graph, finds_the_cheapest_of_all_paths)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    for(const std::size_t m : {0u, 1u, 2u, 5u})
      expect_all_arcs(mesh, weights, Fixed_number_of_points(m), random);
    expect_all_arcs(mesh, Weights(mesh.num_faces(), 1), Fixed_number_of_points(3), random);
    expect_all_arcs(mesh, weights, Random_points(6), random);
  });
}

// A row of points is not looked at from end to end if it is long.
TEST(Steiner_graph, finds_the_cheapest_of_all_paths_among_many_points)
{
  Random random(test_seed());
  for(const Soup& soup : small_soups(random))
  {
    const Mesh mesh = to_mesh(soup);
    for(const double range : {1., 1.5, 20., 1e4})
      for(const double extreme : {0., 0.1})
      {
        SCOPED_TRACE(range);
        const Weights weights = random_weights(mesh, random, 1, range, extreme);
        for(const std::size_t m : {19u, 20u, 37u, 60u})
          expect_all_arcs(mesh, weights, Fixed_number_of_points(m), random);
        expect_all_arcs(mesh, weights, Random_points(60, random.below(1000)), random);
        if(range < 100) // else there are thousands of points
          expect_all_arcs(mesh, weights, Geometric_points(0.1), random);
      }
  }
}

// What a graph asks a search, as if nothing was known yet: so all arcs are worth looking at.
struct No_labels
{
  Node predecessor(Node /* node */) const { return Triangulation::null_index; }
  double distance(Node /* node */) const { return infinity; }
};

TEST(Steiner_graph, has_no_more_arcs_than_its_maximum_degree)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    for(const double share : {0., 0.3})
      for(const std::size_t m : {0u, 1u, 30u})
      {
        const Barriers barriers = random_barriers(mesh, share, random);
        const Triangulation triangulation(
            mesh, with_weights(weights).edge_is_constrained_map(barrier_map(barriers)));
        const Steiner_graph<Fixed_number_of_points> graph(triangulation, Fixed_number_of_points(m));
        std::size_t largest = 0;
        for(Node n = 0; n < graph.number_of_nodes(); ++n)
        {
          std::size_t degree = 0;
          graph.for_each_arc(n, No_labels(), [&](const Node target, const double cost) {
            EXPECT_LT(target, graph.number_of_nodes());
            EXPECT_GE(cost, 0);
            ++degree;
          });
          largest = (std::max)(largest, degree);
        }
        EXPECT_LE(largest, graph.maximum_degree());
      }
  });
}

// ----- relations between distances

template <typename Queue>
std::vector<double> distances_by(const Steiner_graph<Fixed_number_of_points>& graph,
                                 const Node source)
{
  AG::Propagation<Steiner_graph<Fixed_number_of_points>, Queue> search(graph);
  search.run_from(source);
  return distances_of_nodes(search);
}

TEST(Steiner_graph, gives_the_same_with_every_queue)
{
  std::size_t number = 0, number_of_equals = 0;
  for_weighted_meshes([&](const Mesh& mesh, const Weights& weights, Random& random) {
    for(const std::size_t m : {2u, 22u})
    {
      const auto graph = steiner_graph(mesh, weights, Fixed_number_of_points(m));
      const Node source = static_cast<Node>(random.below(graph.number_of_nodes()));
      const std::vector<double> first = distances_by<AG::Adaptive_bucket_queue>(graph, source);
      for(const std::vector<double>& other : {distances_by<AG::Binary_heap_queue>(graph, source),
                                              distances_by<AG::Radix_heap_queue>(graph, source)})
      {
        expect_about_the_same(first, other, 1e-13);
        for(std::size_t i = 0; i < first.size(); ++i, ++number)
          number_of_equals += first[i] == other[i];
      }
    }
  });
  RecordProperty("distances", std::to_string(number));
  RecordProperty("bitwise_equal", std::to_string(number_of_equals));
}

TEST(Steiner_graph, does_not_get_worse_with_more_points)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    const Vertex source = random_vertex(mesh, random);
    std::vector<double> last(mesh.num_vertices(), infinity);
    for(const std::size_t m : {0u, 1u, 3u, 7u})
    {
      const std::vector<double> found = costs(mesh, weights, Fixed_number_of_points(m), {source});
      for(std::size_t i = 0; i < found.size(); ++i)
        EXPECT_LE(found[i], last[i] * (1 + rounding_of_costs));
      last = found;
    }
  });
}

TEST(Steiner_graph, is_symmetric)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    Basic_mesh_search<Steiner_graph<Fixed_number_of_points>> search(
        mesh, steiner_graph(mesh, weights, Fixed_number_of_points(3)));
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> there = search.distances({source});
    for(std::size_t i = 0; i < 5; ++i)
    {
      const Vertex v = random_vertex(mesh, random);
      expect_about_the_same({search.distances({v})[source]}, {there[v]}, rounding_of_costs);
    }
  });
}

TEST(Steiner_graph, finds_the_nearest_of_several_sources)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    Basic_mesh_search<Steiner_graph<Fixed_number_of_points>> search(
        mesh, steiner_graph(mesh, weights, Fixed_number_of_points(3)));
    std::vector<Vertex> sources;
    std::vector<double> expected(mesh.num_vertices(), infinity);
    for(std::size_t i = 0; i < 4; ++i)
    {
      sources.push_back(random_vertex(mesh, random));
      expected = minimum(expected, search.distances({sources.back()}));
    }
    expect_about_the_same(search.distances(sources), expected, 1e-13);
  });
}

TEST(Steiner_graph, does_not_depend_on_where_the_mesh_is)
{
  Random random(test_seed());
  const double c = std::cos(1.), s = std::sin(1.);
  const auto move = [&](const Point& p) {
    const double x = c * p.x() - s * p.y(), y = s * p.x() + c * p.y();
    return Point(x + 3, c * y - s * p.z() - 5, s * y + c * p.z() + 7);
  };
  for(const Soup& soup : small_soups(random))
  {
    const Mesh mesh = to_mesh(soup), moved = to_mesh(soup.transformed(move));
    const Weights weights = random_weights(mesh, random, 1, 10, 0.1);
    const Vertex source = random_vertex(mesh, random);
    expect_about_the_same(costs(moved, weights, Fixed_number_of_points(5), {source}),
                          costs(mesh, weights, Fixed_number_of_points(5), {source}), 1e-9);
  }
}

// ----- next to exact distances

void expect_bound_on(const Mesh& mesh, const Vertex source)
{
  const std::vector<double> exact = exact_distances(mesh, source);
  for(const double e : {0.5, 0.1, 0.01})
  {
    Basic_mesh_search<Steiner_graph<>> search(mesh, parameters::epsilon(e));
    const double bound = search.graph().epsilon();
    EXPECT_EQ(bound, e);
    expect_within_bound(search.distances({source}), exact, bound);
  }
}

TEST(Faces_of_equal_weight, have_the_bound_on_generated_meshes)
{
  Random random(test_seed());
  for(const Soup& soup : {flat_grid(12, 9), terrain(16, 12, random), sphere(20, 9), fan(40, 3),
                          fan(9), growing_strip(30, 1e-3, 1e3)})
  {
    const Mesh mesh = to_mesh(soup);
    expect_bound_on(mesh, random_vertex(mesh, random));
  }
}

TEST(Faces_of_equal_weight, have_the_bound_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name : {"cube.off", "mesh_with_border.off", "eight.off", "oblong.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_GT(mesh.num_vertices(), 0u);
    expect_bound_on(mesh, Vertex(mesh.number_of_vertices() / 3));
  }
}

} // namespace
