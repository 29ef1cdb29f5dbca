// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "meshes/sample_meshes.h"
#include "oracles/exact_distances.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The error bound of the discrete geodesic graph, built and lazy, and relations between distances.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using AG::Lazy_discrete_geodesic_graph;
using CGAL::parameters::epsilon;

constexpr double all_epsilons[] = {0.2, 0.1, 0.05, 0.01};
constexpr double relative_rounding = 1e-10;
constexpr double single_precision = 2e-7; // of stored lengths

template <typename GeodesicGraph>
std::vector<double> distances(const Mesh& mesh, const Vertex source, const double e)
{
  return Basic_mesh_search<GeodesicGraph>(mesh, epsilon(e)).distances({source});
}

// Expects that no distance is below the exact one, nor above it by more than the factor 1 + e.
void expect_within(const std::vector<double>& found,
                   const std::vector<double>& exact,
                   const double e,
                   const double tolerance = relative_rounding)
{
  ASSERT_EQ(found.size(), exact.size());
  for(std::size_t i = 0; i < exact.size(); ++i)
  {
    EXPECT_GE(found[i], exact[i] * (1 - tolerance)) << "at vertex " << i;
    EXPECT_LE(found[i], exact[i] * (1 + e)) << "at vertex " << i;
  }
}

template <typename GeodesicGraph>
class Graph_with_a_bound : public testing::Test
{
};
using Graphs = testing::Types<Discrete_geodesic_graph, Lazy_discrete_geodesic_graph>;
TYPED_TEST_SUITE(Graph_with_a_bound, Graphs, );

TYPED_TEST(Graph_with_a_bound, holds_it_in_the_plane)
{
  Random random(test_seed());
  const auto shake = [&](const Point& p) {
    return Point(p.x() + random.between(-0.3, 0.3), p.y() + random.between(-0.3, 0.3), 0);
  };
  const auto part = [&] { return random.between(0.1, 0.9); };
  for(const Soup& soup :
      {flat_grid(25, 18), flat_grid(25, 18).transformed(shake), with_caps(flat_grid(25, 18), part),
       with_caps(flat_grid(25, 18).transformed(shake), part)})
  {
    const Mesh mesh = to_mesh(soup);
    const Vertex source(7 * 25 + 9); // all others are in sight of it, or next to a straight line
    std::vector<double> straight;
    for(const Vertex v : mesh.vertices())
      straight.push_back(std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(source))));
    for(const double e : all_epsilons)
    {
      const std::vector<double> found = distances<TypeParam>(mesh, source, e);
      for(const Vertex v : mesh.vertices())
      {
        EXPECT_GE(found[v.idx()], straight[v.idx()] * (1 - relative_rounding));
        const Point& p = mesh.point(v);
        const bool is_inside = p.x() > 2 && p.x() < 22 && p.y() > 2 && p.y() < 15;
        if(is_inside) // a shaken border is not convex
        {
          EXPECT_LE(found[v.idx()], straight[v.idx()] * (1 + e));
        }
      }
    }
  }
}

// The surface of a cone, cut open, is flat; a path either stays on it or goes over the tip.
// Stored lengths are rounded by more than the smallest bounds.
TYPED_TEST(Graph_with_a_bound, tells_one_that_it_holds_if_it_is_tiny)
{
  const Mesh mesh = to_mesh(flat_grid(6, 7).transformed(
      [](const Point& p) { return Point(p.x() + 0.371 * p.y(), 0.213 * p.x() + 0.9 * p.y(), 0); }));
  for(const double e : {1e-6, 7e-7, 1e-7, 1e-9, 1e-12})
  {
    Basic_mesh_search<TypeParam> search(mesh, epsilon(e));
    EXPECT_LE(e, search.graph().epsilon());
    EXPECT_LE(search.graph().epsilon(), (std::max)(e, 8e-7));
    const auto found = search.distances({Vertex(0)});
    for(const Vertex v : mesh.vertices())
    {
      const double exact = std::sqrt(CGAL::squared_distance(mesh.point(Vertex(0)), mesh.point(v)));
      EXPECT_LE(found[v], exact * (1 + search.graph().epsilon()) * (1 + 1e-14));
    }
  }
}

TYPED_TEST(Graph_with_a_bound, holds_it_on_a_cone)
{
  const std::size_t valence = 60;
  for(const double height : {0.1, 1., 20.})
  {
    const Mesh mesh = to_mesh(fan(valence, height));
    const double slant = std::sqrt(1 + height * height);
    const double angle = 2 * std::asin(std::sin(4 * std::atan(1.) / valence) / slant);
    for(const double e : all_epsilons)
    {
      const std::vector<double> found = distances<TypeParam>(mesh, Vertex(1), e);
      EXPECT_NEAR(found[0], slant, slant * single_precision);
      for(std::size_t i = 1; i < valence; ++i)
      {
        const double steps = static_cast<double>((std::min)(i, valence - i));
        const double turn = (std::min)(steps * angle, 4 * std::atan(1.));
        const double exact = 2 * slant * std::sin(turn / 2);
        // straight lines between points of a circle leave it, where the frontier is cut off
        EXPECT_GE(found[i + 1], exact * (1 - relative_rounding));
        EXPECT_LE(found[i + 1], exact * (1 + e));
      }
    }
  }
}

TYPED_TEST(Graph_with_a_bound, holds_it_on_generated_meshes)
{
  Random random(test_seed());
  const std::vector<Soup> soups = {terrain(22, 18, random), sphere(24, 15), sphere(7, 40),
                                   fan(150, 3), growing_strip(60, 1e-3, 1e3)};
  for(std::size_t i = 0; i < soups.size(); ++i)
  {
    SCOPED_TRACE(i);
    const Mesh mesh = to_mesh(soups[i]);
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> exact = exact_distances(mesh, source);
    for(const double e : all_epsilons)
      expect_within(distances<TypeParam>(mesh, source, e), exact, e);
  }
}

TYPED_TEST(Graph_with_a_bound, holds_it_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name :
      {"anchor.off", "cow.off", "cube.off", "eight.off", "joint.off", "mesh_with_border.off",
       "oblong.off", "pipe.off", "rotor_small.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_GT(mesh.num_vertices(), 0u);
    const Vertex source(mesh.number_of_vertices() / 3);
    const std::vector<double> exact = exact_distances(mesh, source);
    for(const double e : all_epsilons)
      expect_within(distances<TypeParam>(mesh, source, e), exact, e);
  }
}

// What no exact algorithm is asked about: every distance is finite where there is a path, never
// below the straight line, and about the same with a bound that hardly leaves any room.
TYPED_TEST(Graph_with_a_bound, holds_it_on_degenerate_meshes)
{
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const Mesh& mesh = named.mesh;
    Random random(test_seed());
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> along_edges = Mesh_search(mesh).distances({source});
    const std::vector<double> close = distances<Discrete_geodesic_graph>(mesh, source, 0.002);
    const std::vector<double> found = distances<TypeParam>(mesh, source, 0.1);
    for(const Vertex v : mesh.vertices())
    {
      const std::size_t i = v.idx();
      EXPECT_EQ(std::isinf(found[i]), std::isinf(along_edges[i]));
      EXPECT_FALSE(std::isnan(found[i]));
      if(std::isinf(along_edges[i]))
        continue;
      EXPECT_LE(found[i], along_edges[i] * (1 + single_precision));
      EXPECT_LE(found[i], close[i] * 1.1 * (1 + relative_rounding));
      EXPECT_GE(found[i], close[i] / 1.002 * (1 - 1e-6));
      EXPECT_GE(found[i], std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(source))) *
                              (1 - relative_rounding));
    }
  }
}

// Squashed a million times, a terrain is flat again: its faces are needles and caps.
TYPED_TEST(Graph_with_a_bound, holds_it_with_needles)
{
  Random random(test_seed());
  const auto squash = [](const Point& p) { return Point(p.x(), p.y() * 1e-6, p.z() * 1e-6); };
  const Mesh mesh = to_mesh(terrain(20, 15, random).transformed(squash));
  const Vertex source(107);
  const std::vector<double> exact = exact_distances(mesh, source);
  for(const double e : all_epsilons)
    expect_within(distances<TypeParam>(mesh, source, e), exact, e, 1e-7);
}

TYPED_TEST(Graph_with_a_bound, holds_it_from_the_nearest_of_several_sources)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  const std::vector<Vertex> sources = {Vertex(3), Vertex(4), Vertex(211), Vertex(390)};
  std::vector<double> exact(mesh.num_vertices(), infinity);
  for(const Vertex s : sources)
    exact = minimum(exact, exact_distances(mesh, s));
  for(const double e : all_epsilons)
    expect_within(Basic_mesh_search<TypeParam>(mesh, epsilon(e)).distances(sources), exact, e);
}

TYPED_TEST(Graph_with_a_bound, gives_distances_like_those_of_a_metric)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(15, 15, random));
  const double e = 0.1;
  Basic_mesh_search<TypeParam> search(mesh, epsilon(e));
  std::vector<std::vector<double>> d;
  for(const Vertex v : mesh.vertices())
    d.push_back(search.distances({v}));
  for(std::size_t i = 0; i < d.size(); ++i)
  {
    EXPECT_EQ(d[i][i], 0);
    for(std::size_t j = 0; j < d.size(); j += 3)
    {
      EXPECT_LE(d[i][j], d[j][i] * (1 + e));
      for(std::size_t k = 0; k < d.size(); k += 17)
        EXPECT_LE(d[i][j], (d[i][k] + d[k][j]) * (1 + e));
    }
  }
}

TYPED_TEST(Graph_with_a_bound, does_not_care_for_the_unit)
{
  Random random(test_seed());
  const Soup soup = terrain(18, 14, random);
  const std::vector<double> expected = distances<TypeParam>(to_mesh(soup), Vertex(30), 0.1);
  for(const int exponent : {-900, -1, 3, 900})
  {
    const double factor = std::ldexp(1., exponent);
    const auto scale = [&](const Point& p) {
      return Point(factor * p.x(), factor * p.y(), factor * p.z());
    };
    std::vector<double> found =
        distances<TypeParam>(to_mesh(soup.transformed(scale)), Vertex(30), 0.1);
    for(double& d : found)
      d /= factor;
    EXPECT_TRUE(have_same_bits(found, expected));
  }
}

TYPED_TEST(Graph_with_a_bound, refuses_what_is_no_bound)
{
  const Mesh mesh = to_mesh(flat_grid(3, 3));
  for(const double e : {0., -0.1, infinity, not_a_number})
    expect_message<std::invalid_argument>([&] { TypeParam(Triangulation(mesh), epsilon(e)); },
                                          "epsilon");
  EXPECT_EQ(TypeParam(Triangulation(mesh), epsilon(7)).epsilon(), 7);
  EXPECT_EQ(TypeParam(Triangulation(mesh)).epsilon(), 0.1);
}

TYPED_TEST(Graph_with_a_bound, refuses_lengths_that_no_triangle_has)
{
  const Mesh mesh = to_mesh({{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}});
  const std::vector<double> lengths = {1, 1, 2.1};
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  expect_message<std::invalid_argument>(
      [&] { TypeParam(Triangulation(mesh, CGAL::parameters::edge_length_map(map))); },
      "triangle inequality", "2.1");
}

TYPED_TEST(Graph_with_a_bound, takes_an_empty_mesh_and_one_without_edges)
{
  const TypeParam empty;
  EXPECT_EQ(empty.number_of_nodes(), 0u);
  EXPECT_TRUE(empty.is_valid());
  EXPECT_EQ(TypeParam(Triangulation(Mesh())).number_of_nodes(), 0u);
  const Mesh points = to_mesh({{Point(0, 0, 0), Point(1, 0, 0)}, {}});
  EXPECT_EQ(distances<TypeParam>(points, Vertex(1), 0.1), (std::vector<double>{infinity, 0}));
}

// Renumbering changes the order of faces around a vertex, which must not matter.
TEST(Discrete_geodesic_graph, does_not_depend_on_the_order_of_the_mesh)
{
  Random random(test_seed());
  for(const Soup& soup : {terrain(18, 14, random), sphere(14, 9)})
  {
    const std::vector<std::size_t> position = random.permutation(soup.points.size());
    const auto turn = [](const Point& p) { // about an axis, by the angle of a 3-4-5 triangle
      return Point(0.6 * p.x() - 0.8 * p.y() + 3, 0.8 * p.x() + 0.6 * p.y(), -p.z());
    };
    Soup other = soup.transformed(turn).renumbered(position);
    for(auto& t : other.triangles)
      std::swap(t[0], t[2]);
    random.shuffle(other.triangles);

    const std::vector<double> expected =
        distances<Discrete_geodesic_graph>(to_mesh(soup), Vertex(30), 0.1);
    const Vertex source(static_cast<Mesh::size_type>(position[30]));
    const std::vector<double> found =
        distances<Discrete_geodesic_graph>(to_mesh(other), source, 0.1);
    for(std::size_t i = 0; i < position.size(); ++i)
      EXPECT_NEAR(found[position[i]], expected[i], expected[i] * single_precision);
  }
}

// Counts windows, and loses patience.
struct Window_counter : AG::internal::Leave_out_detours
{
  bool prune(const AG::internal::Window&) const { return ++windows > 100000; }
  std::size_t& windows;
};

// A line that climbs a spike winds round it; a million times here, if it is let.
TEST(Discrete_geodesic_graph, does_not_follow_lines_that_wind_round_a_spike)
{
  Soup soup = fan(3, 0);
  for(std::size_t i = 1; i <= 3; ++i)
    soup.points[i] = Point(1e-6 * soup.points[i].x(), 1e-6 * soup.points[i].y(), 0);
  soup.points[0] = Point(0, 0, 1);
  for(std::size_t i = 0; i < 3; ++i) // a skirt
  {
    const Point& p = soup.points[i + 1];
    soup.points.push_back(Point(1e6 * p.x(), 1e6 * p.y(), 0));
  }
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t a = i + 1, b = (i + 1) % 3 + 1;
    soup.triangles.push_back({a, a + 3, b});
    soup.triangles.push_back({b, a + 3, b + 3});
  }
  const Triangulation t(to_mesh(soup));
  const AG::internal::Unfolding unfolding(t);
  for(const double e : {0.2, 0.01})
  {
    const AG::internal::Cone_expansion<AG::internal::Unfolding> expansion(
        t, unfolding, AG::internal::Cone_rules(e));
    for(Node v = 0; v < t.number_of_vertices(); ++v)
    {
      std::size_t windows = 0;
      expansion.expand(
          v, [](const AG::internal::Straight_arc&) {}, Window_counter{{}, windows});
      EXPECT_LT(windows, 1000u);
    }
  }
}

// Two triangles, in the shape of a kite. The cone from one tip may end at the edge between them if
// the ways over the ends of that edge are good enough for what lies just behind.
TEST(Discrete_geodesic_graph, makes_use_of_what_the_bound_allows)
{
  for(const double e : all_epsilons)
  {
    const auto error = [&](const double half_width) {
      const Mesh kite = to_mesh({{Point(0, 0, 0), Point(1, -half_width, 0), Point(1, half_width, 0),
                                  Point(1 + 1e-9, 0, 0)},
                                 {{0, 1, 2}, {1, 3, 2}}});
      return distances<Discrete_geodesic_graph>(kite, Vertex(0), e)[3] - 1;
    };
    // where length of side + (1 + used) half_width = 1 + used
    const double used = e * 5 / 6; // what is left serves to keep largest errors small
    const double k = (1 + used) * (1 + used), limit = (k - std::sqrt(2 * k - 1)) / (k - 1);
    EXPECT_NEAR(error(0.999 * limit), used * (1 - limit), 0.01 * e);
    EXPECT_LT(error(1.001 * limit), 1e-6);
  }
}

// Nothing grows beyond measure where faces are oblong, or vertices have many neighbors.
TEST(Discrete_geodesic_graph, has_few_arcs_on_oblong_faces)
{
  const auto pull = [](const Point& p) { return Point(p.x(), 1000 * p.y(), p.z()); };
  for(const Soup& soup :
      {fan(1000), fan(2000), sphere(200, 5), flat_grid(40, 40).transformed(pull)})
  {
    const Discrete_geodesic_graph graph(Triangulation(to_mesh(soup)), epsilon(0.1));
    EXPECT_LT(graph.number_of_arcs(), 200 * graph.number_of_nodes());
    EXPECT_TRUE(graph.is_valid());
  }
}

TEST(Discrete_geodesic_graph, is_valid_on_all_generated_meshes)
{
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    EXPECT_TRUE(Discrete_geodesic_graph(Triangulation(named.mesh)).is_valid());
  }
}

TEST(Discrete_geodesic_graph, is_more_accurate_with_a_smaller_epsilon)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(30, 30, random));
  const Vertex source(400);
  const std::vector<double> exact = exact_distances(mesh, source);
  double last = infinity;
  for(const double e : all_epsilons)
  {
    const std::vector<double> found = distances<Discrete_geodesic_graph>(mesh, source, e);
    double sum = 0;
    for(std::size_t i = 0; i < exact.size(); ++i)
      sum += found[i] - exact[i];
    EXPECT_LT(sum, last);
    last = sum;
  }
}

TEST(Lazy_discrete_geodesic_graph, has_the_arcs_of_the_built_graph_if_it_keeps_them)
{
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const Lazy_discrete_geodesic_graph kept(Triangulation(named.mesh), epsilon(0.1),
                                            Lazy_discrete_geodesic_graph::Arcs::KEPT);
    AG::Propagation<Lazy_discrete_geodesic_graph> search(kept);
    const std::size_t before = kept.memory();
    const Vertex source = *named.mesh.vertices().begin();
    const std::vector<double> expected =
        distances<Discrete_geodesic_graph>(named.mesh, source, 0.1);
    for(std::size_t run = 0; run < 2; ++run)
    {
      search.run_from(kept.triangulation().vertex(source.idx()));
      for(const Vertex v : named.mesh.vertices())
        EXPECT_EQ(search.distance(kept.triangulation().vertex(v.idx())), expected[v.idx()]);
    }
    EXPECT_GT(kept.memory(), before);
  }
}

TEST(Lazy_discrete_geodesic_graph, can_be_moved_with_what_it_has_kept)
{
  const Mesh mesh = to_mesh(flat_grid(9, 9));
  Lazy_discrete_geodesic_graph first(Triangulation(mesh), epsilon(0.1),
                                     Lazy_discrete_geodesic_graph::Arcs::KEPT);
  AG::Propagation<Lazy_discrete_geodesic_graph>(first).run_from(0);
  const std::size_t memory = first.memory();
  const Lazy_discrete_geodesic_graph second = std::move(first);
  EXPECT_EQ(second.memory(), memory);
  AG::Propagation<Lazy_discrete_geodesic_graph> search(second);
  search.run_from(second.triangulation().vertex(0));
  EXPECT_NEAR(search.distance(second.triangulation().vertex(80)), std::sqrt(128.), 1e-5);
}

} // namespace
