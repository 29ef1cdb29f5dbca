// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles/test_oracles.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

// A mesh of which only edge lengths are known.
struct Mesh_without_points : geodesics_test::Mesh
{
  using geodesics_test::Mesh::Mesh;
};
template <>
struct boost::graph_traits<Mesh_without_points> : boost::graph_traits<geodesics_test::Mesh>
{
};

namespace {

using namespace geodesics_test;
using Index = Triangulation::Index;
namespace parameters = CGAL::parameters;

bool is_power_of_two(const double x) { return std::ldexp(1., std::ilogb(x)) == x; }

// Per halfedge of the triangulation, in the unit of the mesh.
std::vector<double> lengths_of(const Triangulation& t)
{
  std::vector<double> result(t.lengths());
  for(double& length : result)
    length *= t.unit();
  return result;
}

std::vector<double> lengths_of(const Soup& soup)
{
  return lengths_of(Triangulation(to_mesh(soup)));
}

// Numbers do not depend on coordinates, so the lengths of moved meshes can be compared one by one.
std::vector<double> times(std::vector<double> lengths, const double factor)
{
  for(double& length : lengths)
    length *= factor;
  return lengths;
}

void expect_lengths_of_mesh(const Mesh& mesh, const std::vector<double>& lengths)
{
  const Triangulation t(mesh);
  EXPECT_TRUE(is_power_of_two(t.unit()));
  std::multiset<double> expected, found;
  for(const Halfedge h : mesh.halfedges())
    expected.insert(lengths[mesh.edge(h).idx()]);
  for(const double length : lengths_of(t))
    found.insert(length);
  EXPECT_EQ(expected, found);
}

TEST(Lengths, are_those_of_the_mesh)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    expect_lengths_of_mesh(mesh, edge_lengths(mesh));
  }
}

TEST(Lengths, scale_by_powers_of_two)
{
  Random random(test_seed());
  const Soup soup = terrain(10, 10, random);
  const std::vector<double> lengths = lengths_of(soup);
  // from coordinates near the smallest normal number to those near the largest number
  for(const int exponent : {-1000, -600, -333, -1, 1, 7, 500, 1000})
  {
    const double factor = std::ldexp(1., exponent);
    const Soup scaled = soup.transformed(
        [&](const Point& p) { return Point(p.x() * factor, p.y() * factor, p.z() * factor); });
    EXPECT_EQ(lengths_of(scaled), times(lengths, factor)) << "2^" << exponent;
  }
}

// No square of such a coordinate is a number other than zero or infinity.
TEST(Lengths, of_huge_and_tiny_meshes_are_right)
{
  Random random(test_seed());
  const Soup soup = terrain(10, 10, random);
  for(const double factor : {1e160, 1e-160, 1e305, 1e-310})
  {
    SCOPED_TRACE(factor);
    const Mesh mesh = to_mesh(soup.transformed(
        [&](const Point& p) { return Point(p.x() * factor, p.y() * factor, p.z() * factor); }));
    const Triangulation t(mesh);
    for(Index v = 0; v < t.number_of_vertices(); ++v)
      for(Index h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
      {
        const Point& p = mesh.point(Vertex(t.index(v)));
        const Point& q = mesh.point(Vertex(t.index(t.target(h))));
        const double length = std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
        // hypot and the sum of squares are each off by a few roundings, subnormals by half a step
        const double tolerance = 1e-15 * length + 2 * std::numeric_limits<double>::denorm_min();
        EXPECT_NEAR(t.length(h) * t.unit(), length, tolerance);
        EXPECT_GT(t.length(h), 0);
      }
  }
}

TEST(Lengths, of_meshes_far_from_the_origin_are_right)
{
  const Soup far = flat_grid(20, 20).transformed(
      [](const Point& p) { return Point(p.x() + 1e8, p.y() - 1e8, p.z() + 1e8); });
  EXPECT_EQ(lengths_of(far), lengths_of(flat_grid(20, 20))); // integers have no rounding errors
}

// An isolated vertex that marks "no point", as exporters write it, must not cost the others bits.
TEST(Lengths, do_not_suffer_from_a_far_vertex)
{
  for(const double size : {1e-14, 1e-3, 1e3})
  {
    Mesh mesh = to_mesh(flat_grid(6, 5).transformed(
        [size](const Point& p) { return Point(p.x() * size, p.y() * size, 0); }));
    const std::vector<double> expected = edge_lengths(mesh);
    mesh.add_vertex(Point(1.7e308, 0, -1.7e308));
    const Triangulation triangulation(mesh);
    EXPECT_NO_THROW(triangulation.check_triangle_inequality());
    for(const auto e : mesh.edges())
    {
      const auto v = triangulation.vertex(mesh.source(mesh.halfedge(e)).idx());
      const auto w = triangulation.vertex(mesh.target(mesh.halfedge(e)).idx());
      auto h = triangulation.first_halfedge(v);
      while(triangulation.target(h) != w)
        ++h;
      EXPECT_EQ(triangulation.length(h) * triangulation.unit(), expected[e.idx()]);
    }
  }
}

TEST(Lengths, may_be_zero)
{
  const Mesh mesh =
      to_mesh(flat_grid(5, 5).transformed([](const Point&) { return Point(1, 2, 3); }));
  const Triangulation t(mesh);
  EXPECT_TRUE(t.is_valid());
  for(const double length : t.lengths())
    EXPECT_EQ(length, 0);
  EXPECT_NO_THROW(t.check_triangle_inequality());
  Mesh_search search(mesh);
  EXPECT_EQ(search.distances({Vertex(7)}), std::vector<double>(25, 0));
}

TEST(Lengths, of_all_magnitudes_are_accurate)
{
  // edges so short beside the mesh's extent that their squares would lose bits, or vanish
  const Mesh mesh = to_mesh(growing_strip(200, 1e-170, 1));
  const Triangulation t(mesh);
  EXPECT_TRUE(t.is_valid());
  for(Index h = 0; h < t.number_of_halfedges(); ++h)
  {
    const Point& p = mesh.point(Vertex(t.index(t.source(h))));
    const Point& q = mesh.point(Vertex(t.index(t.target(h))));
    const double length = std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
    EXPECT_NEAR(t.length(h) * t.unit(), length, 1e-15 * length); // a few roundings
  }
}

TEST(Lengths, can_be_given)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    std::vector<double> lengths(mesh.num_edges());
    for(double& length : lengths)
      length = random.below(9) == 0 ? 0 : std::pow(10, random.between(-20, 20));
    const auto map =
        boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
    const Triangulation t(mesh, parameters::edge_length_map(map));
    EXPECT_TRUE(t.is_valid());
    EXPECT_TRUE(is_power_of_two(t.unit()));

    std::multiset<double> expected, found;
    for(const Halfedge h : mesh.halfedges())
      expected.insert(lengths[mesh.edge(h).idx()]);
    for(const double length : lengths_of(t))
      found.insert(length);
    EXPECT_EQ(expected, found);

    Mesh_search search(mesh, parameters::edge_length_map(map));
    const Vertex source = random_vertex(mesh, random);
    const Field field = search.run({source});
    EXPECT_TRUE(have_same_bits(field.distance, boost_distances(mesh, lengths, source)));
    EXPECT_TRUE(is_optimal(mesh, lengths, field, {source}));
  }
}

TEST(Lengths, need_no_points_if_they_are_given)
{
  Mesh_without_points mesh;
  for(int i = 0; i < 3; ++i)
    mesh.add_vertex();
  mesh.add_face(Vertex(0), Vertex(1), Vertex(2));
  const Triangulation t(mesh, parameters::edge_length_map(boost::make_static_property_map<Edge>(2.))
                                  .vertex_index_map(boost::make_function_property_map<Vertex>(
                                      [](const Vertex v) { return std::size_t(v.idx()); }))
                                  .halfedge_index_map(boost::make_function_property_map<Halfedge>(
                                      [](const Halfedge h) { return std::size_t(h.idx()); })));
  EXPECT_EQ(lengths_of(t), std::vector<double>(6, 2));
}

TEST(Lengths, of_parallel_edges_may_differ)
{
  const Mesh mesh = necklace(5);
  std::vector<double> lengths(mesh.num_edges(), 100);
  for(std::size_t strand = 0; strand < 5; ++strand)
    lengths[strand] = 10 + static_cast<double>((strand * 3) % 5); // the first edges made
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  Mesh_search search(mesh, parameters::edge_length_map(map));
  EXPECT_EQ(search.distances({Vertex(0)})[1], 10);
  lengths[0] = 99;
  Mesh_search other(mesh, parameters::edge_length_map(map));
  EXPECT_EQ(other.distances({Vertex(0)})[1], 11);
}

TEST(Lengths, can_be_of_an_exact_type)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  const std::vector<Exact> lengths(mesh.num_edges(), Exact(3) / 4);
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  Mesh_search search(mesh, parameters::edge_length_map(map));
  EXPECT_EQ(search.distances({Vertex(0)}), (std::vector<double>{0, .75, 1.5, .75, .75, 1.5}));
}

// In any search on lengths that are far too small or large for squares.
TEST(Distances, scale_by_powers_of_two)
{
  Random random(test_seed());
  const Soup soup = terrain(20, 20, random);
  const Mesh mesh = to_mesh(soup);
  Mesh_search search(mesh);
  const std::vector<double> distances = search.distances({Vertex(3)});
  for(const int exponent : {-1000, -40, 3, 512, 1000})
  {
    const double factor = std::ldexp(1., exponent);
    const Mesh scaled = to_mesh(soup.transformed(
        [&](const Point& p) { return Point(p.x() * factor, p.y() * factor, p.z() * factor); }));
    Mesh_search scaled_search(scaled);
    EXPECT_TRUE(have_same_bits(scaled_search.distances({Vertex(3)}), times(distances, factor)));
    Search::Stop_rule stop;
    stop.maximum_distance = distances[200] * factor;
    const Field field = scaled_search.run({Vertex(3)}, stop);
    for(const Vertex v : mesh.vertices())
      EXPECT_EQ(field.distance[v.idx()],
                distances[v.idx()] <= distances[200] ? distances[v.idx()] * factor : infinity);
  }
}

} // namespace
