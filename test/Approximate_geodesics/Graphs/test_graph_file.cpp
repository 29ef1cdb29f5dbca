// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Graphs that are written and read, or built by several threads.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using CGAL::parameters::epsilon;
using Graph_search = Basic_mesh_search<Discrete_geodesic_graph>;

std::string saved(const Discrete_geodesic_graph& graph)
{
  std::ostringstream out(std::ios::binary);
  graph.save(out);
  return out.str();
}

Discrete_geodesic_graph loaded(const std::string& file, const Mesh& mesh)
{
  std::istringstream in(file, std::ios::binary);
  return Discrete_geodesic_graph::load(in, Triangulation(mesh));
}

void expect_refused(const std::string& file, const Mesh& mesh, const std::string& reason)
{
  expect_message<std::invalid_argument>([&] { loaded(file, mesh); }, reason);
}

class Graph_file : public testing::Test
{
protected:
  Graph_file()
    : m_random(test_seed()),
      m_mesh(to_mesh(terrain(20, 15, m_random))),
      m_graph(Triangulation(m_mesh), epsilon(0.1)),
      m_file(saved(m_graph))
  {
  }

  Random m_random;
  Mesh m_mesh;
  Discrete_geodesic_graph m_graph;
  std::string m_file;
};

TEST_F(Graph_file, gives_the_same_graph)
{
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(named.name);
    const Discrete_geodesic_graph built(Triangulation(named.mesh), epsilon(0.05));
    const std::string file = saved(built);
    Discrete_geodesic_graph read = loaded(file, named.mesh);
    EXPECT_TRUE(read.is_valid());
    EXPECT_EQ(read.epsilon(), 0.05);
    EXPECT_EQ(read.number_of_arcs(), built.number_of_arcs());
    EXPECT_EQ(read.maximum_degree(), built.maximum_degree());
    EXPECT_EQ(saved(read), file);
    const Vertex source = *named.mesh.vertices().begin();
    const std::vector<double> expected = Graph_search(named.mesh, built).distances({source});
    const std::vector<double> found = Graph_search(named.mesh, std::move(read)).distances({source});
    EXPECT_TRUE(have_same_bits(found, expected));
  }
}

// ... also where blocks of arcs are full, or have one row.
TEST_F(Graph_file, gives_the_same_graph_at_the_ends_of_blocks)
{
  for(const auto& [columns, rows] :
      {std::pair(31u, 33u), {32u, 32u}, {41u, 25u}, {64u, 32u}, {683u, 3u}})
  {
    const Mesh mesh = to_mesh(flat_grid(columns, rows));
    const Discrete_geodesic_graph built(Triangulation(mesh), epsilon(0.5));
    ASSERT_EQ(built.number_of_nodes(), std::size_t(columns) * rows);
    const Discrete_geodesic_graph read = loaded(saved(built), mesh), copy = read;
    EXPECT_TRUE(built.is_valid() && read.is_valid() && copy.is_valid());
    EXPECT_EQ(saved(copy), saved(built));
    EXPECT_EQ(copy.maximum_degree(), built.maximum_degree());
    const Discrete_geodesic_graph parallel(
        Triangulation(mesh), epsilon(0.5).concurrency_tag(CGAL::Parallel_if_available_tag()));
    EXPECT_EQ(saved(parallel), saved(built));
  }
}

TEST_F(Graph_file, has_the_size_that_is_documented)
{
  constexpr std::size_t header_and_checksum = 72;
  EXPECT_EQ(m_file.size(),
            8 * m_graph.number_of_arcs() + 4 * m_graph.number_of_nodes() + header_and_checksum);
}

TEST_F(Graph_file, serves_the_class)
{
  using Shortest_paths = AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>;
  Shortest_paths built(m_mesh, epsilon(0.1)), read(m_mesh, loaded(m_file, m_mesh));
  built.add_source_point(Vertex(7));
  read.add_source_point(Vertex(7));
  for(const Vertex v : m_mesh.vertices())
    EXPECT_EQ(read.shortest_distance_to_source_points(v).first,
              built.shortest_distance_to_source_points(v).first);

  const Mesh other = to_mesh(flat_grid(3, 3));
  expect_message<std::invalid_argument>([&] { Shortest_paths(other, loaded(m_file, m_mesh)); },
                                        "another mesh", "300 vertices", "9");
}

TEST_F(Graph_file, is_refused_if_anything_is_missing)
{
  for(std::size_t size = 0; size < m_file.size(); size += 1 + size / 50)
    expect_refused(m_file.substr(0, size), m_mesh, "is truncated");
}

TEST_F(Graph_file, is_refused_if_anything_is_changed)
{
  for(std::size_t i = 0; i < m_file.size(); i += 1 + i / 20)
  {
    std::string file = m_file;
    file[i] = static_cast<char>(file[i] ^ (1 << (i % 8)));
    EXPECT_THROW(loaded(file, m_mesh), std::invalid_argument) << "at byte " << i;
  }
}

TEST_F(Graph_file, is_refused_if_it_is_something_else)
{
  expect_refused("", m_mesh, "truncated");
  std::ifstream missing("no folder/no file");
  expect_message<std::invalid_argument>(
      [&] { Discrete_geodesic_graph::load(missing, Triangulation(m_mesh)); },
      "the stream of the graph cannot be read");
  expect_refused("OFF\n8 12 0\n0 0 0\n", m_mesh, "not that of a discrete geodesic graph");
  for(const int version : {1, 7}) // an older one, and a newer one
  {
    std::string other = m_file;
    other[8] = static_cast<char>(version);
    expect_refused(other, m_mesh, "version " + std::to_string(version));
  }
}

TEST_F(Graph_file, is_refused_for_another_mesh)
{
  expect_refused(m_file, to_mesh(terrain(20, 16, m_random)), "300 vertices, this one has 320");
  Mesh moved = m_mesh;
  moved.point(Vertex(5)) = Point(0, 0, 17);
  expect_refused(m_file, moved, "another mesh of the same size");
}

// Thin faces have other shapes if coordinates tell them.
TEST(Graph_of_lengths, is_refused_for_coordinates)
{
  const Mesh mesh = to_mesh({{Point(0, 0, 0), Point(1, 0, 0), Point(0.5, 1e-6, 0)}, {{0, 1, 2}}});
  const std::vector<double> lengths = edge_lengths(mesh);
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  const Discrete_geodesic_graph graph(Triangulation(mesh, CGAL::parameters::edge_length_map(map)),
                                      epsilon(0.1));
  expect_refused(saved(graph), mesh, "with lengths in place of coordinates");
}

TEST_F(Graph_file, says_when_it_cannot_be_written)
{
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  expect_message<std::runtime_error>([&] { m_graph.save(out); }, "could not be written");
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Parallel_build, gives_the_same_graph)
{
  for(const Named_mesh& named : generated_meshes(test_seed()))
  {
    const Triangulation t(named.mesh);
    const Discrete_geodesic_graph sequential(t, epsilon(0.1));
    const Discrete_geodesic_graph parallel(t, epsilon(0.1).concurrency_tag(CGAL::Parallel_tag()));
    EXPECT_EQ(saved(parallel), saved(sequential)) << named.name;
  }
}
#endif

// Two arcs to the same target, in a file whose checksum fits.
TEST_F(Graph_file, is_refused_with_two_arcs_to_one_target)
{
  const Triangulation t(m_mesh);
  for(const AG::Intrinsic_triangulation::Index second : {5u, 6u})
  {
    AG::internal::Compressed_arcs arcs(AG::internal::unit_of_arcs(t));
    for(AG::Intrinsic_triangulation::Index v = 0; v < t.number_of_vertices(); ++v)
      arcs.append_row({{v == 5 ? 4u : 5u, 1}, {v == 5 ? 7u : v == 6 ? 8u : second, 2}});
    std::ostringstream out(std::ios::binary);
    AG::internal::Arc_file::save(AG::internal::bytes_to(out), t, t, 0.1, arcs);
    if(second == 5)
      expect_refused(out.str(), m_mesh, "damaged");
    else
      EXPECT_EQ(loaded(out.str(), m_mesh).number_of_arcs(), 2 * t.number_of_vertices());
  }
}

TEST(Stored_arcs, are_rounded_up_and_no_farther_than_needed)
{
  constexpr float largest = (std::numeric_limits<float>::max)();
  constexpr float below = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(AG::internal::round_up(0), 0);
  for(const double x : {1., 1 + 1e-12, 1 - 1e-12, 1. / 3, 2. / 3, 1e-30, 1e-42, 1e-300, 3e38,
                        static_cast<double>(largest), std::nextafter(double(largest), 1e300)})
  {
    const float rounded = AG::internal::round_up(x);
    EXPECT_GE(static_cast<double>(rounded), x);
    EXPECT_LT(static_cast<double>(std::nextafter(rounded, below)), x);
  }
}

TEST(Stored_arcs, are_sorted_alike_whether_few_or_many)
{
  for(std::size_t size = 0; size <= AG::internal::FEW_ARCS; ++size)
  {
    std::vector<AG::internal::Stored_arc> few;
    for(std::size_t i = 0; i < size; ++i) // some targets several times
      few.push_back({static_cast<std::uint32_t>(i * 7919 % 97), static_cast<float>(i * 31 % 17)});
    std::vector<AG::internal::Stored_arc> many = few;
    AG::internal::sort_few_arcs(few);
    AG::internal::sort_many_arcs(many);
    ASSERT_EQ(few.size(), many.size());
    for(std::size_t i = 0; i < few.size(); ++i)
    {
      EXPECT_EQ(few[i].target, many[i].target);
      EXPECT_EQ(few[i].length, many[i].length);
    }
  }
}

// Differences of targets fit 16 bits, or not, and only just.
TEST(Compressed_arcs, keep_targets_that_are_far_apart)
{
  for(const std::uint32_t difference : {65534u, 65535u, 65536u, 65537u, 1000000u})
  {
    AG::internal::Compressed_arcs arcs;
    arcs.append_row({{3, 1.5f}, {4, 2.5f}, {3 + difference, 3.5f}});
    std::vector<std::pair<std::uint32_t, double>> found;
    arcs.for_each_arc(0, [&](const std::uint32_t target, const double length) {
      found.emplace_back(target, length);
    });
    const std::vector<std::pair<std::uint32_t, double>> expected = {
        {3, 1.5}, {4, 2.5}, {3 + difference, 3.5}};
    EXPECT_EQ(found, expected);
    EXPECT_EQ(arcs.degree(0), 3u);
  }
}

} // namespace
