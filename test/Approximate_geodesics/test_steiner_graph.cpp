// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "expect_message.h"
#include "test_weights.h"

#include <CGAL/Approximate_geodesics/Adaptive_bucket_queue.h>
#include <CGAL/Approximate_geodesics/Binary_heap_queue.h>
#include <CGAL/Approximate_geodesics/Equally_dense_points.h>
#include <CGAL/Approximate_geodesics/Radix_heap_queue.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Relations that hold on all meshes, whatever the weights, and what is refused.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using AG::Equally_dense_points;

constexpr double rounding = 1e-12;

// Calls `f(mesh, weights, random)` for all kinds of meshes, with weights that are much different,
// some of them zero and some infinite.
template <typename F>
void for_weighted_meshes(F f)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    f(named.mesh, random_weights(named.mesh, random, 0.05, 20, 0.05), random);
  }
}

bool has_edge_of_length_zero(const Mesh& mesh)
{
  const std::vector<double> lengths = edge_lengths(mesh);
  return std::find(lengths.begin(), lengths.end(), 0.) != lengths.end();
}

// ----- special cases

TEST(Steiner_graph, is_the_edge_graph_if_there_are_no_points)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const Mesh& mesh = named.mesh;
    const Vertex source = random_vertex(mesh, random);
    Basic_mesh_search<Steiner_graph<Equally_spaced_points>> search(
        mesh, parameters::number_of_points_per_edge(0));
    EXPECT_EQ(search.graph().number_of_nodes(), mesh.number_of_vertices());
    EXPECT_TRUE(have_same_bits(search.distances({source}), Mesh_search(mesh).distances({source})));
  }
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
    expect_unweighted(mesh, Equally_spaced_points(0), source);
    expect_unweighted(mesh, Equally_spaced_points(3), source);
    expect_unweighted(mesh, Geometric_points(0.3), source);
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
      std::vector<double> expected = costs(mesh, weights, Equally_spaced_points(2), {source});
      for(double& d : expected)
        d = std::ldexp(d, k);
      EXPECT_TRUE(
          have_same_bits(costs(mesh, scaled, Equally_spaced_points(2), {source}), expected));
    }
  });
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
    search.run(source);
    std::vector<double> found;
    for(Node n = 0; n < graph.number_of_nodes(); ++n)
      found.push_back(search.distance(n));
    expect_about_the_same(found, reference.distances(source), rounding);
  }
}

TEST(Steiner_graph, finds_the_cheapest_of_all_paths)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    for(const std::size_t m : {0u, 1u, 2u, 5u})
      expect_all_arcs(mesh, weights, Equally_spaced_points(m), random);
    expect_all_arcs(mesh, Weights(mesh.num_faces(), 1), Equally_spaced_points(3), random);
    expect_all_arcs(mesh, weights, Random_points(6), random);
  });
}

std::vector<Soup> small_soups(Random& random)
{
  const auto pull = [](const Point& p) { return Point(p.x(), 8 * p.y(), p.z()); };
  return {terrain(6, 5, random),
          terrain(5, 4, random).transformed(pull),
          sphere(6, 4),
          fan(9, 1),
          flat_grid(5, 5),
          growing_strip(12, 1e-2, 1e2),
          random_soup(15, 30, random)};
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
          expect_all_arcs(mesh, weights, Equally_spaced_points(m), random);
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
        Barriers barriers(mesh.num_edges());
        for(std::size_t i = 0; i < barriers.size(); ++i)
          barriers[i] = random.between(0, 1) < share;
        const Triangulation triangulation(
            mesh, with_weights(weights).edge_is_constrained_map(barrier_map(barriers)));
        const Steiner_graph<Equally_spaced_points> graph(triangulation, Equally_spaced_points(m));
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
std::vector<double> distances_by(const Steiner_graph<Equally_spaced_points>& graph,
                                 const Node source)
{
  AG::Propagation<Steiner_graph<Equally_spaced_points>, Queue> search(graph);
  search.run(source);
  std::vector<double> result;
  for(Node n = 0; n < graph.number_of_nodes(); ++n)
    result.push_back(search.distance(n));
  return result;
}

TEST(Steiner_graph, gives_the_same_with_every_queue)
{
  std::size_t number = 0, number_of_equals = 0;
  for_weighted_meshes([&](const Mesh& mesh, const Weights& weights, Random& random) {
    for(const std::size_t m : {2u, 22u})
    {
      const auto graph = steiner_graph(mesh, weights, Equally_spaced_points(m));
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
      const std::vector<double> found = costs(mesh, weights, Equally_spaced_points(m), {source});
      for(std::size_t i = 0; i < found.size(); ++i)
        EXPECT_LE(found[i], last[i] * (1 + rounding));
      last = found;
    }
  });
}

TEST(Steiner_graph, is_symmetric)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    Basic_mesh_search<Steiner_graph<Equally_spaced_points>> search(
        mesh, steiner_graph(mesh, weights, Equally_spaced_points(3)));
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> there = search.distances({source});
    for(std::size_t i = 0; i < 5; ++i)
    {
      const Vertex v = random_vertex(mesh, random);
      expect_about_the_same({search.distances({v})[source]}, {there[v]}, rounding);
    }
  });
}

TEST(Steiner_graph, finds_the_nearest_of_several_sources)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    Basic_mesh_search<Steiner_graph<Equally_spaced_points>> search(
        mesh, steiner_graph(mesh, weights, Equally_spaced_points(3)));
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
    expect_about_the_same(costs(moved, weights, Equally_spaced_points(5), {source}),
                          costs(mesh, weights, Equally_spaced_points(5), {source}), 1e-9);
  }
}

// ----- paths

// Remembers, for each point of a path, where it is and which faces touch it.
struct Weighted_path
{
  void operator()(const Vertex v)
  {
    points.push_back(mesh.point(v));
    faces.emplace_back();
    if(!mesh.is_isolated(v))
      for(const Face f : mesh.faces_around_target(mesh.halfedge(v)))
        faces.back().insert(f);
  }

  void operator()(const Halfedge h, const double t)
  {
    EXPECT_GE(t, 0);
    EXPECT_LE(t, 1);
    points.push_back(CGAL::barycenter(mesh.point(mesh.target(h)), t, mesh.point(mesh.source(h))));
    faces.push_back({mesh.face(h), mesh.face(mesh.opposite(h))});
  }

  // infinity where the path leaves the surface
  double cost() const
  {
    double result = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      double weight = infinity;
      for(const Face f : faces[i])
        if(f != Mesh::null_face() && faces[i - 1].count(f) > 0)
          weight = (std::min)(weight, weights[f.idx()]);
      if(points[i] != points[i - 1])
        result += weight * std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
    }
    return result;
  }

  const Mesh& mesh;
  const Weights& weights;
  std::vector<Point> points = {};
  std::vector<std::set<Face>> faces = {};
};

TEST(Weighted_paths, cost_what_they_say)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    const std::size_t m = 3;
    using Graph = Steiner_graph<Equally_spaced_points>;
    AG::Surface_mesh_shortest_path<Mesh, Graph> paths(
        mesh, steiner_graph(mesh, weights, Equally_spaced_points(m)));
    const Vertex source = random_vertex(mesh, random);
    paths.add_source_point(source);
    for(const Vertex v : mesh.vertices())
    {
      Weighted_path path{mesh, weights};
      std::vector<Point> points;
      const double cost = paths.shortest_path_sequence_to_source_points(v, path).first;
      paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
      EXPECT_EQ(points.empty(), cost < 0);
      ASSERT_EQ(points.size(), path.points.size());
      if(points.empty())
        continue;
      EXPECT_EQ(points.front(), mesh.point(v));
      EXPECT_EQ(points.back(), mesh.point(source));
      EXPECT_EQ(points, path.points);
      EXPECT_NEAR(path.cost(), cost, cost * 1e-9) << "to " << v;
    }
    const Vertex target = random_vertex(mesh, random);
    std::vector<Point> points, backward;
    const double cost =
        CGAL::approximate_geodesic_path(mesh, source, target, std::back_inserter(points),
                                        with_weights(weights).number_of_points_per_edge(m));
    const double expected =
        paths.shortest_path_points_to_source_points(target, std::back_inserter(backward)).first;
    if(expected < 0)
      EXPECT_EQ(cost, infinity);
    else
      EXPECT_NEAR(cost, expected, expected * rounding);
    EXPECT_EQ(points.empty(), backward.empty());
    if(!points.empty())
    {
      EXPECT_EQ(points.front(), mesh.point(source));
      EXPECT_EQ(points.back(), mesh.point(target));
    }
  });
}

// Every vertex is told the one that its path comes through last.
TEST(Weighted_paths, lead_from_predecessor_to_vertex)
{
  for_weighted_meshes([](const Mesh& const_mesh, const Weights& weights, Random& random) {
    Mesh mesh = const_mesh;
    auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
    auto predecessor = mesh.add_property_map<Vertex, Vertex>("v:predecessor").first;
    const Vertex source = random_vertex(mesh, random);
    CGAL::approximate_geodesic_distances(
        mesh, distance, source,
        with_weights(weights).predecessor_map(predecessor).number_of_points_per_edge(2));
    Basic_mesh_search<Steiner_graph<Equally_spaced_points>> search(
        mesh, steiner_graph(mesh, weights, Equally_spaced_points(2)));
    EXPECT_EQ(predecessor[source], source);
    EXPECT_EQ(distance[source], 0);
    std::size_t number_of_checks = 0;
    for(const Vertex v : mesh.vertices())
    {
      const Vertex p = predecessor[v];
      EXPECT_EQ(p == Mesh::null_vertex(), distance[v] == infinity);
      if(p == Mesh::null_vertex() || v == source)
        continue;
      EXPECT_NE(p, v);
      EXPECT_LE(distance[p], distance[v]);
      if(++number_of_checks % 37 == 1)
      {
        EXPECT_NEAR(distance[p] + search.distances({p})[v], distance[v], distance[v] * 1e-9);
      }
      Vertex root = v;
      for(std::size_t steps = 0; root != source && steps <= mesh.num_vertices(); ++steps)
        root = predecessor[root];
      EXPECT_EQ(root, source);
    }
  });
}

// ----- where points are

// Calls `f(halfedge, parts)` for all edges with points, with the places of these.
template <typename Graph, typename F>
void for_each_row(const Graph& graph, F f)
{
  Node n = graph.triangulation().number_of_vertices();
  while(n < graph.number_of_nodes())
  {
    const Node h = graph.place(n).halfedge;
    std::vector<double> parts;
    for(; n < graph.number_of_nodes() && graph.place(n).halfedge == h; ++n)
      parts.push_back(graph.place(n).t);
    f(h, parts);
  }
}

TEST(Equally_dense_points, are_as_dense_as_asked_for_and_not_denser)
{
  Random random(test_seed());
  for(const Soup& soup : small_soups(random))
    for(const double density : {0.3, 2., 7.})
    {
      const Mesh mesh = to_mesh(soup);
      const Steiner_graph<Equally_dense_points> graph(
          Triangulation(mesh), parameters::number_of_points_per_distance_unit(density));
      std::size_t smallest = 0, largest = 0, found = 0;
      for(const double length : edge_lengths(mesh)) // which can be multiples of the spacing
      {
        const double parts = length * density;
        smallest += static_cast<std::size_t>(std::ceil(parts * (1 - rounding))) - 1;
        largest += static_cast<std::size_t>(std::ceil(parts * (1 + rounding))) - 1;
      }
      for_each_row(graph, [&](const Node h, const std::vector<double>& parts) {
        const double length = graph.triangulation().length(h) * graph.triangulation().unit();
        found += parts.size();
        double last = 0;
        for(const double part : parts)
        {
          EXPECT_GT(part, last);
          EXPECT_LE((part - last) * length, (1 + 1e-6) / density);
          last = part;
        }
        EXPECT_LE((1 - last) * length, (1 + 1e-6) / density);
      });
      EXPECT_GE(found, smallest);
      EXPECT_LE(found, largest);
      EXPECT_EQ(graph.number_of_points(), found);
    }
}

TEST(Equally_spaced_points, divide_edges_into_equal_parts)
{
  const Mesh mesh = to_mesh(sphere(7, 5));
  for(const std::size_t m : {1u, 2u, 7u, 40u})
  {
    const auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 1), Equally_spaced_points(m));
    EXPECT_EQ(graph.number_of_points(), m * mesh.num_edges());
    for_each_row(graph, [&](const Node, const std::vector<double>& parts) {
      ASSERT_EQ(parts.size(), m);
      for(std::size_t i = 0; i < m; ++i)
        EXPECT_NEAR(parts[i], double(i + 1) / double(m + 1), 1e-7);
    });
  }
}

TEST(Geometric_points, ascend_and_are_not_at_the_border)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random&) {
    std::size_t last_number = 0;
    for(const double e : {0.5, 0.1, 0.03})
    {
      const auto graph = steiner_graph(mesh, weights, Geometric_points(e));
      const Triangulation& t = graph.triangulation();
      for_each_row(graph, [&](const Node h, const std::vector<double>& parts) {
        EXPECT_FALSE(t.is_border(h) || t.is_border(t.opposite(h)));
        EXPECT_GE(parts.front(), Geometric_points::SMALLEST_START * (1 - 1e-6));
        EXPECT_LE(parts.back(), 1);
        for(std::size_t i = 1; i < parts.size(); ++i)
          EXPECT_GE(parts[i], parts[i - 1]);
      });
      EXPECT_GE(graph.number_of_points(), last_number);
      last_number = graph.number_of_points();
    }
  });
}

// Such an edge has no points.
TEST(Geometric_points, may_meet_edges_of_length_zero)
{
  Random random(test_seed());
  for(const Named_mesh& named : generated_meshes(test_seed()))
    if(has_edge_of_length_zero(named.mesh))
    {
      const Weights weights = random_weights(named.mesh, random, 0.1, 10, 0.05);
      const std::vector<double> found =
          costs(named.mesh, weights, Geometric_points(0.1), {Vertex(0)});
      const std::vector<double> along_edges =
          costs(named.mesh, weights, Equally_spaced_points(0), {Vertex(0)});
      for(std::size_t i = 0; i < found.size(); ++i)
        EXPECT_LE(found[i], along_edges[i] * (1 + rounding));
    }
}

// ----- bad parameters

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Bad_parameters, are_refused)
{
  const Mesh mesh = to_mesh(flat_grid(4, 4));
  const Triangulation triangulation(mesh);
  const Weights weights(mesh.num_faces(), 1);
  for(const double e : {0., -0.1, nan, infinity, -infinity})
  {
    const auto np = parameters::epsilon(e);
    expect_message<std::invalid_argument>([&] { Geometric_points points(e); }, "epsilon");
    expect_message<std::invalid_argument>([&] { Steiner_graph<> g(triangulation, np); }, "epsilon");
    expect_message<std::invalid_argument>(
        [&] {
          std::vector<Point> points;
          CGAL::approximate_geodesic_path(mesh, Vertex(0), Vertex(1), std::back_inserter(points),
                                          with_weights(weights).epsilon(e));
        },
        "epsilon");
  }
  using Spaced_graph = Steiner_graph<Equally_spaced_points>;
  for(const int m : {-1, std::numeric_limits<int>::min()})
    expect_message<std::invalid_argument>(
        [&] { Spaced_graph g(triangulation, parameters::number_of_points_per_edge(m)); },
        "points per edge", std::to_string(m));
  for(const double m : {-1., 2.5, nan, infinity})
    expect_message<std::invalid_argument>(
        [&] { Spaced_graph g(triangulation, parameters::number_of_points_per_edge(m)); },
        "points per edge");
  using Dense_graph = Steiner_graph<Equally_dense_points>;
  for(const double d : {0., -1., nan})
  {
    expect_message<std::invalid_argument>([&] { Equally_dense_points points(d); }, "spacing");
    expect_message<std::invalid_argument>(
        [&] { Dense_graph g(triangulation, parameters::number_of_points_per_distance_unit(d)); },
        "points per distance unit");
  }
  expect_message<std::invalid_argument>(
      [&] {
        Dense_graph g(triangulation, parameters::number_of_points_per_distance_unit(infinity));
      },
      "points per distance unit");
}

// Counting comes first: there is no memory for so many.
TEST(Bad_parameters, are_refused_if_there_would_be_too_many_points)
{
  const Triangulation triangulation(to_mesh(flat_grid(4, 4)));
  for(const std::size_t m :
      {std::size_t(1) << 31, std::size_t(1) << 32, (std::numeric_limits<std::size_t>::max)()})
    expect_message<std::length_error>(
        [&] { Steiner_graph<Equally_spaced_points> g(triangulation, Equally_spaced_points(m)); },
        "points");
  for(const double spacing : {1e-9, 1e-300})
    expect_message<std::length_error>(
        [&] {
          Steiner_graph<Equally_dense_points> g(triangulation, Equally_dense_points(spacing));
        },
        "points");
  for(const double e : {1e-18, 1e-300})
    expect_message<std::length_error>(
        [&] { Steiner_graph<> g(triangulation, Geometric_points(e)); }, "points");
}

TEST(Bad_meshes, are_refused_only_if_paths_run_across_faces)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  std::vector<double> lengths(mesh.num_edges(), 1);
  lengths[0] = 3;
  const auto np = parameters::edge_length_map(
      boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh)));
  const Triangulation triangulation(mesh, np);
  using Graph = Steiner_graph<Equally_spaced_points>;
  EXPECT_NO_THROW(Graph(triangulation, Equally_spaced_points(0)));
  expect_message<std::invalid_argument>([&] { Graph g(triangulation, Equally_spaced_points(1)); },
                                        "triangle inequality");
}

TEST(Steiner_graph, may_be_empty)
{
  const Steiner_graph<> graph;
  EXPECT_EQ(graph.number_of_nodes(), 0u);
  const Mesh mesh;
  const Weights weights;
  EXPECT_EQ(steiner_graph(mesh, weights, Equally_spaced_points(4)).number_of_nodes(), 0u);
}

} // namespace
