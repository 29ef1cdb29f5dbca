// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles/test_oracles.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace {

using namespace geodesics_test;
using Index = Triangulation::Index;

TEST(Fixtures, are_what_their_names_say)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    EXPECT_GT(mesh.number_of_faces(), 0u);
    EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
    const auto is_isolated = [&m = mesh](const Vertex v) { return m.is_isolated(v); };
    if(std::none_of(mesh.vertices_begin(), mesh.vertices_end(), is_isolated)) // CGAL wants none
    {
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    }
  }
  EXPECT_TRUE(CGAL::is_closed(to_mesh(sphere(8, 5))));
  EXPECT_TRUE(CGAL::is_closed(necklace(3)));
  EXPECT_EQ(necklace(1).number_of_faces(), 2u);
  const std::vector<double> lengths = edge_lengths(to_mesh(growing_strip(300, 1, 1e12)));
  EXPECT_EQ(*std::min_element(lengths.begin(), lengths.end()), 1);
  EXPECT_GT(*std::max_element(lengths.begin(), lengths.end()), 9e11);
}

// The halfedge of the triangulation for each of the mesh, found by walking around both at once from
// halfedges that correspond; parallel edges leave no other way.
std::vector<Index> corresponding_halfedges(const Mesh& mesh, const Triangulation& t)
{
  std::vector<Index> result(mesh.num_halfedges(), Triangulation::null_index);
  for(const Vertex v : mesh.vertices())
  {
    if(mesh.is_isolated(v))
      continue;
    const Index first = t.first_halfedge(t.vertex(v.idx()));
    Halfedge h = mesh.opposite(mesh.halfedge(v)); // where the groups start
    const Index degree = mesh.degree(v);
    for(Index i = 0; i < degree; ++i)
    {
      result[h.idx()] = first + i;
      h = mesh.opposite(mesh.prev(h));
    }
  }
  return result;
}

void expect_same_connectivity(const Mesh& mesh, const Triangulation& t)
{
  ASSERT_TRUE(t.is_valid());
  ASSERT_EQ(t.number_of_vertices(), mesh.number_of_vertices());
  ASSERT_EQ(t.number_of_halfedges(), mesh.number_of_halfedges());
  EXPECT_EQ(t.number_of_edges(), mesh.number_of_edges());
  EXPECT_EQ(t.number_of_faces(), mesh.number_of_faces());

  const std::vector<Index> number = corresponding_halfedges(mesh, t);
  for(const Halfedge h : mesh.halfedges())
  {
    const Index n = number[h.idx()];
    ASSERT_NE(n, Triangulation::null_index);
    EXPECT_EQ(t.target(n), t.vertex(mesh.target(h).idx()));
    EXPECT_EQ(t.source(n), t.vertex(mesh.source(h).idx()));
    EXPECT_EQ(t.opposite(n), number[mesh.opposite(h).idx()]);
    EXPECT_EQ(t.is_border(n), mesh.is_border(h));
    if(!mesh.is_border(h))
    {
      EXPECT_EQ(t.next(n), number[mesh.next(h).idx()]);
    }
  }
}

void expect_permutation(const Mesh& mesh, const Triangulation& t)
{
  std::vector<bool> is_taken(t.number_of_vertices(), false);
  for(const Vertex v : mesh.vertices())
  {
    const Index n = t.vertex(v.idx());
    ASSERT_LT(n, t.number_of_vertices());
    EXPECT_FALSE(is_taken[n]);
    is_taken[n] = true;
    EXPECT_EQ(t.index(n), v.idx());
    EXPECT_EQ(t.degree(n), mesh.is_isolated(v) ? 0 : mesh.degree(v));
    EXPECT_EQ(t.beyond_halfedge(n) - t.first_halfedge(n), t.degree(n));
  }
  EXPECT_EQ(t.vertex(mesh.num_vertices()), Triangulation::null_index);
}

TEST(Triangulation, has_the_connectivity_of_the_mesh)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    const Triangulation t(mesh);
    expect_permutation(mesh, t);
    expect_same_connectivity(mesh, t);
  }
}

TEST(Triangulation, copes_with_a_hub_and_strands)
{
  for(const Mesh& mesh : {to_mesh(fan(100000)), necklace(1000)})
  {
    const Triangulation t(mesh);
    ASSERT_GE(*std::max_element(t.lengths().begin(), t.lengths().end()), 0);
    expect_permutation(mesh, t);
    expect_same_connectivity(mesh, t);
  }
}

TEST(Triangulation, skips_removed_elements)
{
  Random random(test_seed());
  Mesh mesh = to_mesh(terrain(20, 20, random));
  for(std::size_t i = 0; i < 2000; ++i)
  {
    const Halfedge h(static_cast<Mesh::size_type>(random.below(mesh.num_halfedges())));
    if(!mesh.is_removed(h) && !mesh.is_border(h) && mesh.is_border(mesh.opposite(h)))
      CGAL::Euler::remove_face(h, mesh);
  }
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_LT(mesh.number_of_faces(), mesh.num_faces());
  const Triangulation t(mesh);
  expect_permutation(mesh, t);
  expect_same_connectivity(mesh, t);
}

// Neighbors are numbered in the order in which their own neighbors meet them.
TEST(Triangulation, numbers_breadth_first_by_components)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  const Triangulation t(mesh);
  Index beyond = 0; // all numbers below have been met
  for(Index v = 0; v < t.number_of_vertices(); ++v)
  {
    if(v == beyond)
      ++beyond; // the first vertex of a component
    for(Index h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
    {
      EXPECT_LE(t.target(h), beyond);
      beyond = (std::max)(beyond, t.target(h) + 1);
    }
  }
  EXPECT_EQ(beyond, t.number_of_vertices());
}

// Large components are numbered patch by patch, from where earlier patches end.
TEST(Triangulation, numbers_neighbors_of_what_is_numbered)
{
  const Mesh mesh = to_mesh(flat_grid(400, 300));
  const Triangulation t(mesh);
  expect_permutation(mesh, t);
  expect_same_connectivity(mesh, t);
  for(Index v = 1; v < t.number_of_vertices(); ++v)
  {
    Index nearest = v;
    for(Index h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
      nearest = (std::min)(nearest, t.target(h));
    ASSERT_LT(nearest, v);
  }

  std::vector<Index> breadth_first(t.number_of_vertices(), Triangulation::null_index);
  std::vector<Index> met{0};
  breadth_first[0] = 0;
  for(std::size_t i = 0; i < met.size(); ++i)
    for(Index h = t.first_halfedge(met[i]); h < t.beyond_halfedge(met[i]); ++h)
      if(Index& number = breadth_first[t.target(h)]; number == Triangulation::null_index)
      {
        number = static_cast<Index>(met.size());
        met.push_back(t.target(h));
      }
  const std::size_t size_of_patch = 32768;
  for(Index v = 0; v < size_of_patch; ++v)
    ASSERT_EQ(breadth_first[v], v);
  std::size_t number_that_differ = 0;
  for(Index v = size_of_patch; v < t.number_of_vertices(); ++v)
    number_that_differ += breadth_first[v] != v ? 1 : 0;
  EXPECT_GT(number_that_differ, t.number_of_vertices() / 2);
}

TEST(Triangulation, takes_the_memory_it_says)
{
  const Mesh mesh = to_mesh(sphere(200, 100));
  const Triangulation t(mesh);
  const std::size_t memory = t.memory();
  // 6 halfedges of 4 + 8 + 1 + 1/8 bytes, and 12 bytes for the vertex itself; that is less than 92
  EXPECT_LE(memory, 92u * t.number_of_vertices());
  EXPECT_GE(memory, 78u * t.number_of_vertices());
  EXPECT_EQ(Graph(t).memory(), memory);
}

TEST(Triangulation, of_nothing_is_empty)
{
  for(const Triangulation& t : {Triangulation(), Triangulation(Mesh())})
  {
    EXPECT_TRUE(t.is_valid());
    EXPECT_EQ(t.number_of_vertices(), 0u);
    EXPECT_EQ(t.number_of_halfedges(), 0u);
    EXPECT_EQ(t.number_of_faces(), 0u);
    EXPECT_EQ(t.vertex(0), Triangulation::null_index);
    EXPECT_NO_THROW(t.check_triangle_inequality());
  }
}

TEST(Edge_graph, has_the_arcs_of_the_edges)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    const std::vector<double> lengths = edge_lengths(mesh);
    std::vector<std::pair<std::pair<Index, Index>, double>> expected, found;
    const Graph graph{Triangulation(mesh)};
    const Triangulation& t = graph.triangulation();
    for(const Halfedge h : mesh.halfedges())
      expected.push_back({{t.vertex(mesh.source(h).idx()), t.vertex(mesh.target(h).idx())},
                          lengths[mesh.edge(h).idx()]});
    for(Index v = 0; v < graph.number_of_nodes(); ++v)
      graph.for_each_arc(v, nullptr, [&](const Index target, const double length) {
        found.push_back({{v, target}, length * t.unit()});
      });
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(expected, found);
    EXPECT_TRUE(graph.is_valid());
  }
}

TEST(Edge_graph, sums_its_arcs_up)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(30, 30, random));
  const std::vector<double> lengths = edge_lengths(mesh);
  const Graph graph{Triangulation(mesh)};
  const double unit = graph.triangulation().unit();
  EXPECT_EQ(graph.arc_lengths().shortest * unit, *std::min_element(lengths.begin(), lengths.end()));
  EXPECT_EQ(graph.arc_lengths().longest * unit, *std::max_element(lengths.begin(), lengths.end()));
  const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.);
  const double mean = sum / static_cast<double>(lengths.size());
  EXPECT_NEAR(graph.arc_lengths().mean * unit, mean, 1e-12 * mean); // n roundings
}

} // namespace
