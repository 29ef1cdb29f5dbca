// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_costs.h"
#include "meshes/steiner_meshes.h"
#include "oracles/straight_lines.h"
#include "paths/Path_recorder.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

// Paths through points on edges: that they cost what they say.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

// Knows what a path costs.
struct Weighted_path : Path_recorder
{
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
        result += weight * distance_in_space(points[i - 1], points[i]);
    }
    return result;
  }

  const Weights& weights;
};

TEST(Weighted_paths, cost_what_they_say)
{
  for_weighted_meshes([](const Mesh& mesh, const Weights& weights, Random& random) {
    const std::size_t m = 3;
    using Graph = Steiner_graph<Fixed_number_of_points>;
    AG::Surface_mesh_shortest_path<Mesh, Graph> paths(
        mesh, steiner_graph(mesh, weights, Fixed_number_of_points(m)));
    const Vertex source = random_vertex(mesh, random);
    paths.add_source_point(source);
    for(const Vertex v : mesh.vertices())
    {
      Weighted_path path{{mesh}, weights};
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
        CGAL::approximate_geodesic_path(mesh, std::back_inserter(points), source, target,
                                        with_weights(weights).number_of_points_per_edge(m));
    const double expected =
        paths.shortest_path_points_to_source_points(target, std::back_inserter(backward)).first;
    if(expected < 0)
      EXPECT_EQ(cost, infinity);
    else
      EXPECT_NEAR(cost, expected, expected * rounding_of_costs);
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
    Basic_mesh_search<Steiner_graph<Fixed_number_of_points>> search(
        mesh, steiner_graph(mesh, weights, Fixed_number_of_points(2)));
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

} // namespace
