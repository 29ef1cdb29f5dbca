// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "oracles/test_oracles.h"

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

// Index maps that give no indices.

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

template <typename Index>
std::vector<Index> numbers_up_to(const std::size_t n)
{
  std::vector<Index> result(n);
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

class Bad_index_map : public testing::Test
{
protected:
  template <typename NamedParameters, typename... Texts>
  static void expect_rejection(const Mesh& mesh, const NamedParameters& np, const Texts&... texts)
  {
    expect_message<std::invalid_argument>([&] { Triangulation(mesh, np); }, texts...);
  }

  template <typename Descriptor, typename Index>
  static auto map_of(const std::vector<Index>& indices)
  {
    return boost::make_function_property_map<Descriptor>(
        [&indices](const Descriptor d) { return indices[d.idx()]; });
  }

  // Gives vertex 11 an index that it must not have.
  template <typename Index, typename... Texts>
  static void expect_vertex_index_rejected(const Index bad, const Texts&... texts)
  {
    const Mesh mesh = quiet_mesh();
    std::vector<Index> indices = numbers_up_to<Index>(mesh.num_vertices());
    const auto np = parameters::vertex_index_map(map_of<Vertex>(indices));
    EXPECT_NO_THROW(Triangulation(mesh, np));
    indices[11] = bad;
    expect_rejection(mesh, np, "vertex index " + std::to_string(bad), texts...);
  }

  template <typename Index>
  static void expect_halfedge_index_rejected(const Index bad)
  {
    const Mesh mesh = quiet_mesh();
    std::vector<Index> indices = numbers_up_to<Index>(mesh.num_halfedges());
    const auto np = parameters::halfedge_index_map(map_of<Halfedge>(indices));
    EXPECT_NO_THROW(Triangulation(mesh, np));
    indices[11] = bad;
    expect_rejection(mesh, np, "halfedge index " + std::to_string(bad), "out of range");
  }

  // Gives every pair of halfedges the same index in turn, those with a common target or the others.
  static void expect_equal_indices_rejected(const Mesh& mesh, const bool have_common_target)
  {
    std::size_t number_of_pairs = 0;
    std::vector<std::size_t> indices = numbers_up_to<std::size_t>(mesh.num_halfedges());
    const auto np = parameters::halfedge_index_map(map_of<Halfedge>(indices));
    for(const Halfedge h : mesh.halfedges())
      for(const Halfedge g : mesh.halfedges())
        if(h != g && (mesh.target(h) == mesh.target(g)) == have_common_target)
        {
          SCOPED_TRACE(testing::Message() << h << " has the index of " << g);
          ++number_of_pairs;
          indices[h.idx()] = g.idx();
          expect_rejection(mesh, np);
          indices[h.idx()] = h.idx();
        }
    EXPECT_GT(number_of_pairs, 0u);
  }
};

TEST_F(Bad_index_map, vertex_index_out_of_range)
{
  expect_vertex_index_rejected<int>(20, "out of range", "20");
  expect_vertex_index_rejected<int>(-1, "out of range");
  expect_vertex_index_rejected<std::size_t>(std::size_t(1) << 32, "out of range");
}

TEST_F(Bad_index_map, vertex_index_used_twice)
{
  expect_vertex_index_rejected<int>(5, "more than one vertex");
  expect_vertex_index_rejected<int>(12, "more than one vertex"); // of a neighbor
}

TEST_F(Bad_index_map, halfedge_index_out_of_range)
{
  expect_halfedge_index_rejected<int>(static_cast<int>(quiet_mesh().num_halfedges()));
  expect_halfedge_index_rejected<int>(-1);
  expect_halfedge_index_rejected<std::size_t>(std::size_t(1) << 40);
}

TEST_F(Bad_index_map, halfedge_index_used_twice)
{
  expect_equal_indices_rejected(quiet_mesh(), false);
}

TEST_F(Bad_index_map, halfedge_index_used_twice_around_a_vertex)
{
  expect_equal_indices_rejected(quiet_mesh(), true);
  expect_equal_indices_rejected(necklace(3), true);
}

// A halfedge that its vertex does not know of, with the index of one that has the same target.
TEST_F(Bad_index_map, halfedge_index_used_twice_beyond_what_a_vertex_knows)
{
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0),
                 Point(3, 0, 0), Point(4, 0, 0), Point(3, 1, 0)};
  soup.triangles = {{0, 1, 2}, {3, 4, 5}};
  Mesh mesh = to_mesh(soup);
  const auto h = [&mesh](const Mesh::size_type from, const Mesh::size_type to) {
    return mesh.halfedge(Vertex(from), Vertex(to));
  };
  const Halfedge out = h(3, 4), in = h(5, 3), beside_out = h(5, 4), beside_in = h(4, 5);
  std::vector<std::size_t> indices = numbers_up_to<std::size_t>(mesh.num_halfedges());
  const auto np = parameters::halfedge_index_map(map_of<Halfedge>(indices));
  EXPECT_NO_THROW(Triangulation(mesh, np));
  mesh.set_target(in, Vertex(0));
  mesh.set_target(mesh.opposite(out), Vertex(0));
  mesh.set_halfedge(Vertex(3), Mesh::null_halfedge());
  indices[out.idx()] = indices[beside_out.idx()];
  indices[mesh.opposite(in).idx()] = indices[beside_in.idx()];
  expect_rejection(mesh, np, "do not form one cycle");
  mesh.set_face(beside_out, mesh.face(out)); // makes up for the side that is not known of
  expect_rejection(mesh, np, "do not form one cycle");
}

} // namespace
