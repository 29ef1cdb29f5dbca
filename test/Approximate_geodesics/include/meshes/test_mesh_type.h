// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_MESH_TYPE_H
#define APPROXIMATE_GEODESICS_TEST_MESH_TYPE_H

#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

namespace geodesics_test {

template <typename M>
using Paths_along_edges = CGAL::Approximate_geodesics::
    Surface_mesh_shortest_path<M, CGAL::Approximate_geodesics::Edge_graph>;

// The meshes that types of meshes are compared on: coordinates that a `float` holds too, and
// neither parallel edges nor isolated vertices, which not all of them can represent.
inline std::vector<Mesh> simple_meshes()
{
  const auto round = [](const Point& p) {
    const auto single = [](const double x) { return static_cast<double>(static_cast<float>(x)); };
    return Point(single(p.x()), single(p.y()), single(p.z()));
  };
  Random random(test_seed());
  Soup parts = terrain(9, 8, random);
  parts.append(fan(7, 1));
  std::vector<Mesh> result;
  for(const Soup& soup : {flat_grid(8, 5), sphere(9, 6), parts})
    result.push_back(to_mesh(soup.transformed(round)));
  return result;
}

// A mesh of another type, and its vertices by the index of the one that was copied.
template <typename Other>
struct Copied_mesh
{
  using vertex_descriptor = typename boost::graph_traits<Other>::vertex_descriptor;

  explicit Copied_mesh(const Mesh& original)
  {
    std::vector<std::pair<Vertex, vertex_descriptor>> pairs;
    CGAL::copy_face_graph(
        original, mesh,
        CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(pairs)));
    vertices.resize(original.num_vertices());
    for(const auto& [v, copy] : pairs)
      vertices[v.idx()] = copy;
  }

  Other mesh;
  std::vector<vertex_descriptor> vertices;
};

// The distances to `vertices` that the free function finds, whose results go into a map that needs
// no index.
template <typename OtherMesh, typename Vertices, typename... NamedParameters>
std::vector<double> distances_on(const OtherMesh& mesh,
                                 const Vertices& vertices,
                                 const std::size_t source,
                                 const NamedParameters&... np)
{
  using vertex_descriptor = typename boost::graph_traits<OtherMesh>::vertex_descriptor;
  std::map<vertex_descriptor, double> found;
  CGAL::approximate_geodesic_distances(mesh, boost::make_assoc_property_map(found),
                                       vertices[source], np...);
  std::vector<double> result;
  for(const vertex_descriptor v : vertices)
    result.push_back(found.at(v));
  return result;
}

// Everything that takes a mesh gives what it gives for the mesh that was copied.
template <typename OtherMesh, typename Vertices>
void expect_same_results(const Mesh& original, const OtherMesh& mesh, const Vertices& vertices)
{
  ASSERT_EQ(vertices.size(), original.number_of_vertices());
  const Triangulation t(mesh);
  EXPECT_TRUE(t.is_valid());
  EXPECT_EQ(t.number_of_vertices(), original.number_of_vertices());
  EXPECT_EQ(t.number_of_edges(), original.number_of_edges());
  EXPECT_EQ(t.number_of_faces(), original.number_of_faces());

  const std::size_t source = 5;
  Mesh_search search(original);
  const std::vector<double> expected = search.distances({Vertex(source)});
  EXPECT_TRUE(have_same_bits(distances_on(mesh, vertices, source), expected));

  Paths_along_edges<OtherMesh> paths(mesh);
  paths.add_source_point(vertices[source]);
  using Other_point = typename decltype(paths)::Point_3;
  for(std::size_t i = 0; i < vertices.size(); ++i)
  {
    std::vector<Other_point> points, same_points;
    const double d =
        paths.shortest_path_points_to_source_points(vertices[i], std::back_inserter(points)).first;
    EXPECT_EQ(d, expected[i] == infinity ? -1 : expected[i]);
    EXPECT_EQ(CGAL::approximate_geodesic_path(mesh, std::back_inserter(same_points),
                                              vertices[source], vertices[i]),
              expected[i]);
    ASSERT_EQ(points.empty(), expected[i] == infinity);
    ASSERT_EQ(same_points.empty(), points.empty());
    if(!points.empty())
    {
      EXPECT_EQ(points.front(), get(CGAL::vertex_point, mesh, vertices[i]));
      EXPECT_EQ(same_points.front(), get(CGAL::vertex_point, mesh, vertices[source]));
    }
  }
}

template <typename OtherMesh>
void expect_same_results_on_copies()
{
  for(const Mesh& original : simple_meshes())
  {
    const Copied_mesh<OtherMesh> copy(original);
    expect_same_results(original, copy.mesh, copy.vertices);
  }
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_MESH_TYPE_H
