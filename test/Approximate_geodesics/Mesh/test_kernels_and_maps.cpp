// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/test_mesh_type.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace {

using namespace geodesics_test;
namespace parameters = CGAL::parameters;

template <typename K>
class Kernels : public testing::Test
{
};
using All_kernels = testing::Types<CGAL::Simple_cartesian<float>,
                                   CGAL::Simple_cartesian<double>,
                                   CGAL::Exact_predicates_inexact_constructions_kernel,
                                   CGAL::Exact_predicates_exact_constructions_kernel>;
TYPED_TEST_SUITE(Kernels, All_kernels, );

TYPED_TEST(Kernels, give_the_same_distances)
{
  expect_same_results_on_copies<CGAL::Surface_mesh<typename TypeParam::Point_3>>();
}

TYPED_TEST(Kernels, have_points_where_paths_cross_edges)
{
  using Kernel_mesh = CGAL::Surface_mesh<typename TypeParam::Point_3>;
  const Copied_mesh<Kernel_mesh> copy(to_mesh(flat_grid(8, 5)));
  std::vector<typename TypeParam::Point_3> points;
  const double distance =
      CGAL::approximate_geodesic_path(copy.mesh, std::back_inserter(points), copy.vertices[0],
                                      copy.vertices[4 * 8 + 3], parameters::epsilon(1e-5));
  EXPECT_NEAR(distance, 5, 1e-9);
  ASSERT_GT(points.size(), 4u);
  for(const auto& p : points)
    EXPECT_NEAR(CGAL::to_double(p.x()) * 4, CGAL::to_double(p.y()) * 3, 1e-5);
}

class Maps : public testing::Test
{
protected:
  template <typename... NamedParameters>
  std::vector<double> distances(const NamedParameters&... np)
  {
    const std::vector<Vertex> vertices(m_mesh.vertices_begin(), m_mesh.vertices_end());
    return distances_on(m_mesh, vertices, 5, np...);
  }

  const Mesh m_mesh = simple_meshes().back();
  const std::vector<double> m_expected = Mesh_search(m_mesh).distances({Vertex(5)});
};

TEST_F(Maps, vertex_point_map)
{
  const auto shifted = boost::make_function_property_map<Vertex>([&](const Vertex v) {
    const Point& p = m_mesh.point(v);
    return CGAL::Simple_cartesian<float>::Point_3(float(2 * p.x()), float(2 * p.y()),
                                                  float(2 * p.z()));
  });
  std::vector<double> doubled = m_expected;
  for(double& d : doubled)
    d *= 2;
  EXPECT_EQ(distances(parameters::vertex_point_map(shifted)), doubled);
  EXPECT_EQ(
      distances(parameters::vertex_point_map(shifted).geom_traits(CGAL::Simple_cartesian<float>())),
      doubled);
}

TEST_F(Maps, edge_length_map)
{
  const std::vector<double> lengths = edge_lengths(m_mesh);
  const auto map =
      boost::make_function_property_map<Edge>([&](const Edge e) { return lengths[e.idx()]; });
  EXPECT_EQ(distances(parameters::edge_length_map(map)), m_expected);
  const auto unit = boost::make_function_property_map<Edge>([](const Edge) { return 1; });
  for(const double d : distances(parameters::edge_length_map(unit)))
    EXPECT_EQ(d, std::floor(d)); // infinity is its own
}

TEST_F(Maps, index_maps)
{
  const int vertices = static_cast<int>(m_mesh.num_vertices());
  const int halfedges = static_cast<int>(m_mesh.num_halfedges());
  const auto backward = boost::make_function_property_map<Vertex>(
      [=](const Vertex v) { return vertices - 1 - static_cast<int>(v.idx()); });
  const auto halfedges_backward = boost::make_function_property_map<Halfedge>(
      [=](const Halfedge h) { return halfedges - 1 - static_cast<int>(h.idx()); });
  EXPECT_EQ(distances(parameters::vertex_index_map(backward)), m_expected);
  EXPECT_EQ(distances(parameters::halfedge_index_map(halfedges_backward)), m_expected);
  const auto np = parameters::vertex_index_map(backward).halfedge_index_map(halfedges_backward);
  EXPECT_EQ(distances(np), m_expected);
  const Triangulation t(m_mesh, np);
  EXPECT_EQ(t.index(t.vertex(3)), 3u);
  EXPECT_EQ(t.degree(t.vertex(3)), m_mesh.degree(Vertex(Mesh::size_type(vertices - 4))));
}

TEST_F(Maps, geom_traits) { EXPECT_EQ(distances(parameters::geom_traits(Kernel())), m_expected); }

TEST_F(Maps, given_to_the_class)
{
  const int vertices = static_cast<int>(m_mesh.num_vertices());
  const auto backward = boost::make_function_property_map<Vertex>(
      [=](const Vertex v) { return vertices - 1 - static_cast<int>(v.idx()); });
  const auto mirrored = boost::make_function_property_map<Vertex>([&](const Vertex v) {
    return Point(-m_mesh.point(v).x(), m_mesh.point(v).y(), m_mesh.point(v).z());
  });
  Paths_along_edges<Mesh> paths(m_mesh,
                                parameters::vertex_index_map(backward).vertex_point_map(mirrored));
  paths.add_source_point(Vertex(5));
  for(const Vertex v : m_mesh.vertices())
  {
    std::vector<Point> points;
    const double d =
        paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first;
    EXPECT_EQ(d, m_expected[v.idx()] == infinity ? -1 : m_expected[v.idx()]);
    if(d >= 0)
    {
      EXPECT_EQ(points.front(), get(mirrored, v));
    }
  }
}

// A mesh whose vertices and faces were removed and not collected.
TEST(Surface_mesh, with_garbage)
{
  Random random(test_seed());
  Mesh mesh = to_mesh(terrain(12, 12, random));
  for(std::size_t i = 0; i < 200; ++i)
  {
    const Halfedge h(static_cast<Mesh::size_type>(random.below(mesh.num_halfedges())));
    if(!mesh.is_removed(h) && !mesh.is_border(h) && mesh.is_border(mesh.opposite(h)))
      CGAL::Euler::remove_face(h, mesh);
  }
  while(!mesh.is_removed(Vertex(5))) // at the border
  {
    Halfedge h = mesh.halfedge(Vertex(5));
    while(mesh.is_border(h))
      h = mesh.opposite(mesh.next(h));
    CGAL::Euler::remove_face(h, mesh);
  }
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_TRUE(CGAL::is_triangle_mesh(mesh));
  const std::vector<double> lengths = edge_lengths(mesh);
  Mesh_search search(mesh);
  const Field field = search.run({*mesh.vertices_begin()});
  EXPECT_TRUE(is_optimal(mesh, lengths, field, {*mesh.vertices_begin()}));
  const std::vector<Vertex> vertices(mesh.vertices_begin(), mesh.vertices_end());
  const std::vector<double> found = distances_on(mesh, vertices, 0);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_EQ(found[i], field.distance[vertices[i].idx()]);

  Paths_along_edges<Mesh> paths(mesh);
  paths.add_source_point(vertices[0]);
  for(const Vertex v : vertices)
  {
    const double distance = field.distance[v.idx()];
    EXPECT_EQ(paths.shortest_distance_to_source_points(v).first,
              distance == infinity ? -1 : distance);
  }
}

// Points that no kernel knows of will do along edges, if lengths are given.
TEST(Points, may_be_of_any_type)
{
  struct Name
  {
    char letter;
  };
  CGAL::Surface_mesh<Name> mesh;
  const auto a = mesh.add_vertex({'a'}), b = mesh.add_vertex({'b'}), c = mesh.add_vertex({'c'});
  mesh.add_face(a, b, c);
  const std::vector<double> lengths = {1, 1, 5}; // of ab, bc and ca
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  std::vector<Name> points;
  EXPECT_EQ(CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), a, c,
                                            parameters::edge_length_map(map)),
            2);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[1].letter, 'b');

  Paths_along_edges<CGAL::Surface_mesh<Name>> paths(mesh, parameters::edge_length_map(map));
  paths.add_source_point(c);
  points.clear();
  paths.shortest_path_points_to_source_points(a, std::back_inserter(points));
  EXPECT_EQ(points.size(), 3u);
}

} // namespace
