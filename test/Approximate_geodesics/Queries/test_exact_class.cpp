// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/sample_meshes.h"
#include "oracles/exact_distances.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

// Beside CGAL's exact class.

namespace {

using namespace geodesics_test;
using Our_shortest_paths = CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh>;

// Remembers what a path goes through.
struct Sequence_recorder
{
  void operator()(const Halfedge, const double) { ++edges; }
  void operator()(const Vertex v) { vertices.push_back(v); }
  template <typename Coordinates>
  void operator()(const Face, const Coordinates&)
  {
    ++faces;
  }

  std::vector<Vertex> vertices = {};
  std::size_t edges = 0;
  std::size_t faces = 0;
};

// What is written for one class means the same for the other. Along the edges of a grid, and to
// places that these lead to straight, both find the same.
template <typename Shortest_paths>
class Either_class : public testing::Test
{
protected:
  Either_class() : m_mesh(make_mesh()), m_paths(m_mesh) {}

  static Mesh make_mesh()
  {
    Soup soup = flat_grid(6, 5);
    soup.append(flat_grid(3, 3));
    return to_mesh(soup);
  }

  double distance(const Vertex v) { return m_paths.shortest_distance_to_source_points(v).first; }

  Mesh m_mesh;
  Shortest_paths m_paths;
};
using Both_classes = testing::Types<Our_shortest_paths, Exact_shortest_paths>;
TYPED_TEST_SUITE(Either_class, Both_classes, );

TYPED_TEST(Either_class, gives_a_distance_and_a_source)
{
  const auto first = this->m_paths.add_source_point(Vertex(0));
  const auto second = this->m_paths.add_source_point(Vertex(5));
  EXPECT_EQ(this->m_paths.number_of_source_points(), 2u);
  const auto [near_first, it] = this->m_paths.shortest_distance_to_source_points(Vertex(2));
  EXPECT_DOUBLE_EQ(near_first, 2);
  EXPECT_TRUE(it == first);
  const auto [near_second, other] = this->m_paths.shortest_distance_to_source_points(Vertex(4));
  EXPECT_DOUBLE_EQ(near_second, 1);
  EXPECT_TRUE(other == second);
  EXPECT_EQ(this->distance(Vertex(0)), 0);
}

TYPED_TEST(Either_class, gives_a_path_from_the_query_to_the_source)
{
  const auto source = this->m_paths.add_source_point(Vertex(1));
  std::vector<Point> points;
  const auto result =
      this->m_paths.shortest_path_points_to_source_points(Vertex(4), std::back_inserter(points));
  EXPECT_DOUBLE_EQ(result.first, 3);
  EXPECT_TRUE(result.second == source);
  ASSERT_GE(points.size(), 2u);
  EXPECT_EQ(points.front(), Point(4, 0, 0));
  EXPECT_EQ(points.back(), Point(1, 0, 0));
}

TYPED_TEST(Either_class, tells_a_visitor_what_a_path_goes_through)
{
  this->m_paths.add_source_point(Vertex(1));
  Sequence_recorder recorder;
  const auto result = this->m_paths.shortest_path_sequence_to_source_points(Vertex(3), recorder);
  EXPECT_DOUBLE_EQ(result.first, 2);
  ASSERT_GE(recorder.vertices.size(), 2u);
  EXPECT_EQ(recorder.vertices.front(), Vertex(3));
  EXPECT_EQ(recorder.vertices.back(), Vertex(1));
}

TYPED_TEST(Either_class, says_when_there_is_no_path)
{
  this->m_paths.add_source_point(Vertex(0));
  std::vector<Point> points;
  Sequence_recorder recorder;
  const Vertex elsewhere(32);
  const auto result =
      this->m_paths.shortest_path_points_to_source_points(elsewhere, std::back_inserter(points));
  EXPECT_LT(result.first, 0);
  EXPECT_TRUE(result.second == this->m_paths.source_points_end());
  EXPECT_TRUE(points.empty());
  this->m_paths.shortest_path_sequence_to_source_points(elsewhere, recorder);
  EXPECT_TRUE(recorder.vertices.empty());
  EXPECT_LT(this->m_paths.shortest_distance_to_source_points(elsewhere).first, 0);
}

TYPED_TEST(Either_class, adds_and_removes_sources)
{
  const std::vector<Vertex> vertices = {Vertex(0), Vertex(5), Vertex(24)};
  const auto first = this->m_paths.add_source_points(vertices.begin(), vertices.end());
  EXPECT_EQ(this->m_paths.number_of_source_points(), 3u);
  EXPECT_TRUE(first == this->m_paths.source_points_begin());
  auto second = first; // the exact class's iterator does not tell its difference type
  ++second;
  auto last = second;
  ++last;
  EXPECT_TRUE(++last == this->m_paths.source_points_end());
  this->m_paths.build_sequence_tree();
  EXPECT_FALSE(this->m_paths.changed_since_last_build());
  EXPECT_DOUBLE_EQ(this->distance(Vertex(4)), 1);

  this->m_paths.remove_source_point(second);
  EXPECT_TRUE(this->m_paths.changed_since_last_build());
  EXPECT_EQ(this->m_paths.number_of_source_points(), 2u);
  EXPECT_DOUBLE_EQ(this->distance(Vertex(4)), 4);
  EXPECT_TRUE(this->m_paths.shortest_distance_to_source_points(Vertex(4)).second == first);

  this->m_paths.remove_all_source_points();
  EXPECT_EQ(this->m_paths.number_of_source_points(), 0u);
  EXPECT_LT(this->distance(Vertex(4)), 0);
  this->m_paths.clear();
  this->m_paths.add_source_point(Vertex(3));
  EXPECT_DOUBLE_EQ(this->distance(Vertex(4)), 1);
}

TYPED_TEST(Either_class, shows_sources_as_places_in_faces)
{
  for(const Vertex v : this->m_mesh.vertices())
  {
    const auto it = this->m_paths.add_source_point(v);
    const auto& [face, weights] = *it;
    ASSERT_NE(face, Mesh::null_face());
    Halfedge h = this->m_mesh.halfedge(face);
    for(const double weight : weights)
    {
      EXPECT_EQ(weight, this->m_mesh.source(h) == v ? 1 : 0);
      h = this->m_mesh.next(h);
    }
    EXPECT_EQ(this->m_paths.point(v), this->m_mesh.point(v));
  }
}

// Never below the distances along the surface, of which the exact class has a rounding error.
void expect_not_below_exact(const Mesh& mesh, const Vertex source)
{
  Mesh_search search(mesh);
  const std::vector<double> found = search.distances({source});
  const std::vector<double> exact = exact_distances(mesh, source);
  for(const Vertex v : mesh.vertices())
  {
    if(mesh.is_isolated(v))
      continue;
    EXPECT_EQ(found[v.idx()] == infinity, exact[v.idx()] == infinity) << v;
    EXPECT_GE(found[v.idx()], exact[v.idx()] * (1 - 1e-12)) << v;
  }
}

TEST(Distances, are_not_below_the_exact_ones_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name :
      {"tetrahedron.off", "icosahedron.off", "cube-meshed.off", "eight.off", "elephant.off",
       "head.off", "sphere.off", "mesh_with_border.off", "mushroom.off", "cactus.off", "plane.off",
       "pinion.off", "rotor.off", "hand.off", "elk.off", "holes.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_GT(mesh.number_of_faces(), 0u);
    ASSERT_LT(mesh.number_of_vertices(), 5000u);
    expect_not_below_exact(mesh, *mesh.vertices_begin());
  }
}

TEST(Distances, are_not_below_the_exact_ones_on_generated_meshes)
{
  Random random(test_seed());
  expect_not_below_exact(to_mesh(terrain(20, 15, random)), Vertex(7));
  expect_not_below_exact(to_mesh(sphere(16, 11)), Vertex(0));
  expect_not_below_exact(to_mesh(fan(30, 2)), Vertex(3));
}

} // namespace
