// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// Vertices with very many neighbors: cones must not cross all faces around them, and the bound has
// to hold on the triangulation that they cross instead.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using AG::Lazy_discrete_geodesic_graph;
using AG::internal::Balanced_fans;
using AG::internal::Cone_rules;
using AG::internal::Cone_triangulation;
using AG::internal::Retriangulation;
using AG::internal::Unfolding;
using CGAL::parameters::epsilon;

// ----- the meshes: the vertices of the rim, and behind them one or two hubs

struct Hub_mesh
{
  std::string name;
  Point (*rim)(double angle, std::size_t i);
  std::vector<Point> hubs;
};

Point on_circle(const double angle, const double radius, const double z)
{
  return Point(radius * std::cos(angle), radius * std::sin(angle), z);
}

Point flat_rim(const double angle, std::size_t) { return on_circle(angle, 1, 0); }

std::vector<Hub_mesh> hub_meshes()
{
  return {{"flat", flat_rim, {Point(0, 0, 0)}},
          {"off the middle", flat_rim, {Point(0.7, 0, 0)}},
          {"cone", flat_rim, {Point(0, 0, 1)}},
          {"saddle",
           [](const double angle, std::size_t) {
             return on_circle(angle, 1, 0.7 * std::sin(2 * angle));
           },
           {Point(0, 0, 0)}},
          {"with straight sides",
           [](const double angle, std::size_t) {
             const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
             return on_circle(angle, 1 / (std::max)(c, s), 0);
           },
           {Point(0, 0, 0)}},
          {"star",
           [](const double angle, const std::size_t i) {
             return on_circle(angle, i % 2 == 0 ? 1 : 2, 0);
           },
           {Point(0, 0, 0)}},
          {"two hubs", flat_rim, {Point(0, 0, 1), Point(0, 0, -0.5)}},
          {"folded", // where straight lines in new faces can be longer than ways around
           [](const double angle, const std::size_t i) {
             return on_circle(angle, 1, i % 2 == 0 ? 0.03 : -0.03);
           },
           {Point(0, 0, 1), Point(0, 0, -0.1)}}};
}

Mesh make_mesh(const Hub_mesh& fan, const std::size_t size)
{
  Soup soup;
  for(std::size_t i = 0; i < size; ++i)
    soup.points.push_back(
        fan.rim(2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(size), i));
  for(const Point& hub : fan.hubs)
  {
    const std::size_t apex = soup.points.size();
    soup.points.push_back(hub);
    for(std::size_t i = 0; i < size; ++i)
    {
      const std::size_t j = (i + 1) % size;
      if(apex == size)
        soup.triangles.push_back({i, j, apex});
      else
        soup.triangles.push_back({j, i, apex});
    }
  }
  return to_mesh(soup);
}

Triangulation triangulate(const Hub_mesh& fan, const std::size_t size)
{
  return Triangulation(make_mesh(fan, size));
}

// ----- what they cost

struct Hub_windows : AG::internal::Leave_out_detours
{
  bool prune(const AG::internal::Window&) const
  {
    ++windows;
    return false;
  }
  std::size_t& windows;
};

double windows_per_vertex(const Triangulation& mesh)
{
  const Cone_triangulation cones(mesh);
  const Triangulation& t = cones.get();
  const Unfolding unfolding(t);
  const AG::internal::Cone_expansion<Unfolding> expansion(t, unfolding, Cone_rules(0.1));
  std::size_t result = 0;
  for(Node v = 0; v < t.number_of_vertices(); ++v)
    expansion.expand(
        v, [](const AG::internal::Straight_arc&) {}, Hub_windows{{}, result});
  return static_cast<double>(result) / t.number_of_vertices();
}

TEST(Hubs, cost_a_vertex_nearly_the_same_whatever_their_size)
{
  constexpr double most_growth_at_hubs = 1.5;
  for(const Hub_mesh& fan : hub_meshes())
  {
    SCOPED_TRACE(fan.name);
    EXPECT_LE(windows_per_vertex(triangulate(fan, 4000)),
              most_growth_at_hubs * windows_per_vertex(triangulate(fan, 500)));
  }
}

TEST(Hubs, have_few_neighbors_in_balanced_fans_of_the_same_surface)
{
  for(const Hub_mesh& fan : hub_meshes())
  {
    SCOPED_TRACE(fan.name);
    const Triangulation mesh = triangulate(fan, 1001);
    const Retriangulation fans = *Retriangulation::make(mesh);
    const Triangulation& t = fans.triangulation();
    EXPECT_TRUE(t.is_valid());
    EXPECT_EQ(t.number_of_halfedges(), mesh.number_of_halfedges());
    EXPECT_EQ(t.number_of_faces(), mesh.number_of_faces());
    for(Node v = 0; v < t.number_of_vertices(); ++v)
      EXPECT_LE(t.degree(v), Balanced_fans::LARGEST_DEGREE);
    for(Node h = 0; h < mesh.number_of_halfedges(); ++h)
      if(!fans.is_lost(h))
      {
        EXPECT_EQ(fans.number_in_mesh(fans.number(h)), h);
        EXPECT_EQ(t.length(fans.number(h)), mesh.length(h));
      }
  }
}

TEST(Hubs, are_left_alone_if_they_are_small)
{
  const Triangulation mesh = triangulate(hub_meshes().front(), Balanced_fans::LARGEST_DEGREE);
  const Cone_triangulation cones(mesh);
  EXPECT_EQ(&cones.get(), &cones.mesh());
}

// A chain that is bent toward the hub: its vertices can be connected to nothing else.
TEST(Hubs, keep_edges_to_vertices_that_turn_inwards)
{
  constexpr std::size_t size = 200;
  Soup soup{{Point(0, 2, 0)}, {}};
  for(std::size_t i = 0; i <= size; ++i)
    soup.points.push_back(on_circle(CGAL_PI * (0.25 + 0.5 * static_cast<double>(i) / size), 1, 0));
  for(std::size_t i = 1; i <= size; ++i)
    soup.triangles.push_back({0, i + 1, i});
  const Triangulation mesh(to_mesh(soup));
  const Triangulation t = Retriangulation::make(mesh)->triangulation();
  EXPECT_EQ(t.degree(t.vertex(0)), size + 1);
  EXPECT_EQ(t.lengths(), mesh.lengths());
}

// ----- the bound

template <typename Graph>
void expect_bound_at_hub(const Triangulation& t,
                         const Node source,
                         const std::vector<double>& exact,
                         const double e)
{
  const Graph graph(t, epsilon(e));
  EXPECT_TRUE(graph.is_valid());
  AG::Propagation<Graph> search(graph);
  search.run_from(source);
  for(Node v = 0; v < t.number_of_vertices(); ++v)
  {
    EXPECT_GE(search.distance(v), exact[v] * (1 - 1e-12)) << "at vertex " << v;
    EXPECT_LE(search.distance(v), exact[v] * (1 + e)) << "at vertex " << v;
  }
}

TEST(Hubs, have_the_bound)
{
  constexpr std::size_t size = 200;
  for(const Hub_mesh& fan : hub_meshes())
  {
    SCOPED_TRACE(fan.name);
    const Triangulation t = triangulate(fan, size);
    const AG::Saddle_vertex_graph exact_graph(t);
    AG::Propagation<AG::Saddle_vertex_graph> search(exact_graph);
    for(const std::size_t source : {std::size_t(0), std::size_t(7), size})
    {
      search.run_from(t.vertex(source));
      std::vector<double> exact;
      for(Node v = 0; v < t.number_of_vertices(); ++v)
        exact.push_back(search.distance(v));
      for(const double e : {0.5, 0.1, 0.01})
      {
        expect_bound_at_hub<Discrete_geodesic_graph>(t, t.vertex(source), exact, e);
        expect_bound_at_hub<Lazy_discrete_geodesic_graph>(t, t.vertex(source), exact, e);
      }
    }
  }
}

TEST(Hubs, have_the_distances_of_the_plane_where_they_are_flat_and_convex)
{
  constexpr std::size_t size = 3000;
  const Hub_mesh fan = hub_meshes()[1];
  const Triangulation t = triangulate(fan, size);
  std::vector<double> exact(size + 1);
  const auto point = [&](const std::size_t i) {
    return i == size ? fan.hubs[0] : flat_rim(2 * CGAL_PI * static_cast<double>(i) / size, i);
  };
  for(std::size_t i = 0; i <= size; ++i)
    exact[t.vertex(i)] = std::sqrt(CGAL::squared_distance(point(5), point(i)));
  expect_bound_at_hub<Discrete_geodesic_graph>(t, t.vertex(5), exact, 0.1);
  expect_bound_at_hub<Lazy_discrete_geodesic_graph>(t, t.vertex(5), exact, 0.1);
}

// Two hubs that share an edge, in a disk that is divided between them.
TEST(Hubs, have_the_bound_where_they_are_neighbors)
{
  constexpr std::size_t size = 1000;
  Soup soup;
  for(std::size_t i = 0; i < size; ++i)
    soup.points.push_back(flat_rim(2 * CGAL_PI * static_cast<double>(i) / size, i));
  soup.points.push_back(Point(0, 0.4, 0));
  soup.points.push_back(Point(0.1, -0.3, 0));
  for(std::size_t i = 0; i < size; ++i)
    soup.triangles.push_back({i, (i + 1) % size, i < size / 2 ? size : size + 1});
  soup.triangles.push_back({0, size, size + 1});
  soup.triangles.push_back({size / 2, size + 1, size});
  const Triangulation t(to_mesh(soup));
  EXPECT_TRUE(Retriangulation::make(t)->triangulation().is_valid());
  for(const std::size_t source : {std::size_t(3), size / 2, size, size + 1})
  {
    std::vector<double> exact(size + 2);
    for(std::size_t i = 0; i < size + 2; ++i)
      exact[t.vertex(i)] = std::sqrt(CGAL::squared_distance(soup.points[source], soup.points[i]));
    expect_bound_at_hub<Discrete_geodesic_graph>(t, t.vertex(source), exact, 0.1);
    expect_bound_at_hub<Lazy_discrete_geodesic_graph>(t, t.vertex(source), exact, 0.1);
  }
}

// A cone with an angle of about 100 degrees in all, whose rim has three parts of different width.
// New edges span more than half of it, so that shortest paths between vertices beyond their ends
// cross them twice, or come back to a new face.
TEST(Hubs, have_the_distances_of_cones_where_lines_return_to_new_edges_and_faces)
{
  constexpr std::size_t size = 192;
  constexpr double e = 1e-4, radius = 100. / 360; // the rim is at the distance 1 from the hub
  Random random(test_seed());
  for(int trial = 0; trial < 20; ++trial)
  {
    const double first = random.between(0.2, 0.6), second = random.between(0.05, 0.3);
    const double widths[3] = {first, second, 1 - first - second};
    std::vector<double> angle(1, 0); // at the hub, from the first vertex of the rim on
    Soup soup;
    double azimuth = 0;
    for(std::size_t i = 0; i < size; ++i)
    {
      soup.points.push_back(on_circle(azimuth, radius, 0));
      soup.triangles.push_back({i, (i + 1) % size, size});
      const double step = 2 * CGAL_PI * widths[i / 64] / 64;
      azimuth += step;
      angle.push_back(angle.back() + 2 * std::asin(radius * std::sin(step / 2)));
    }
    soup.points.push_back(Point(0, 0, std::sqrt(1 - radius * radius)));
    const Triangulation t(to_mesh(soup));
    for(std::size_t source = 0; source < size; source += 5)
    {
      std::vector<double> exact(size + 1, 1);
      for(std::size_t i = 0; i < size; ++i)
      {
        const double turn = std::abs(angle[i] - angle[source]);
        exact[t.vertex(i)] =
            2 * std::sin((std::min)(turn, angle[size] - turn) / 2) * (1 - 1e-10); // for rounding
      }
      expect_bound_at_hub<Lazy_discrete_geodesic_graph>(t, t.vertex(source), exact, e);
      if(source % 50 == 0)
        expect_bound_at_hub<Discrete_geodesic_graph>(t, t.vertex(source), exact, e);
    }
  }
}

// Rounded shapes of thin faces are those that the mesh has; lengths alone say less of them.
TEST(Hubs, have_the_bound_where_only_lengths_are_known)
{
  constexpr std::size_t size = 300;
  for(const Hub_mesh& fan : hub_meshes())
  {
    SCOPED_TRACE(fan.name);
    const Mesh mesh = make_mesh(fan, size);
    const std::vector<double> lengths = edge_lengths(mesh);
    const auto map =
        boost::make_function_property_map<Edge>([&](const Edge e) { return lengths[e.idx()]; });
    const Triangulation t(mesh, CGAL::parameters::edge_length_map(map));
    const AG::Saddle_vertex_graph exact_graph(t);
    AG::Propagation<AG::Saddle_vertex_graph> search(exact_graph);
    search.run_from(t.vertex(2));
    std::vector<double> exact;
    for(Node v = 0; v < t.number_of_vertices(); ++v)
      exact.push_back(search.distance(v) * (1 - 1e-9));
    expect_bound_at_hub<Discrete_geodesic_graph>(t, t.vertex(2), exact, 0.1);
  }
}

// ----- paths

// The length of an arc, by the points of the mesh's edges that it crosses.
template <typename Graph>
double length_by_crossings(
    const Graph& graph, const Mesh& mesh, const Node from, const Node to, const double l)
{
  const Triangulation& t = graph.triangulation();
  const auto point = [&](const Node v) { return mesh.point(Vertex(t.index(v))); };
  Point last = point(from);
  double result = 0;
  const auto go_to = [&](const Point& next) {
    result += std::sqrt(CGAL::squared_distance(last, next));
    last = next;
  };
  graph.for_each_crossing(from, to, l, [&](const Node h, const double part) {
    go_to(point(t.source(h)) + part * (point(t.target(h)) - point(t.source(h))));
  });
  go_to(point(to));
  return result;
}

template <typename Graph>
void expect_arcs_of_the_mesh(const Graph& graph, const Mesh& mesh)
{
  AG::Propagation<Graph> search(graph);
  search.run_from(0);
  std::size_t number_of_arcs = 0;
  for(Node v = 1; v < graph.number_of_nodes(); v += 7)
  {
    const Node from = search.predecessor(v);
    const double length = search.distance(v) - search.distance(from);
    if(!(length > 1e-3 * search.distance(v))) // lost to rounding
      continue;
    ++number_of_arcs;
    EXPECT_NEAR(length_by_crossings(graph, mesh, from, v, length / graph.unit()), length,
                1e-6 * length);
  }
  EXPECT_GT(number_of_arcs, graph.number_of_nodes() / 20);
}

TEST(Hubs, have_paths_across_faces_of_the_mesh)
{
  for(const Hub_mesh& fan : hub_meshes())
  {
    SCOPED_TRACE(fan.name);
    const Mesh mesh = make_mesh(fan, 600);
    const Triangulation t(mesh);
    const Discrete_geodesic_graph built(t, epsilon(0.1));
    expect_arcs_of_the_mesh(built, mesh);
    expect_arcs_of_the_mesh(Lazy_discrete_geodesic_graph(t, epsilon(0.1)), mesh);
    std::stringstream file;
    built.save(file);
    expect_arcs_of_the_mesh(Discrete_geodesic_graph::load(file, t), mesh);
  }
}

} // namespace
