// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/sample_meshes.h"
#include "oracles/exact_distances.h"
#include "paths/straightened_paths.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// Paths that are made locally shortest, on all kinds of meshes and from all kinds of places.

namespace {

using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using CGAL::parameters::epsilon;

// ----- all meshes

template <typename GeodesicGraph>
void expect_sound_paths(const Surface& surface, const GeodesicGraph& graph, const bool is_regular)
{
  const Triangulation& t = surface.triangulation();
  const Index step = 1 + t.number_of_vertices() / 50;
  for(const Index source : {Index(0), t.number_of_vertices() / 2})
    for(const Path& path : paths_from(graph, source, step))
    {
      const Path shorter = Path_straightener(t).shortened(path);
      expect_sound(t, path, shorter);
      if(is_regular)
      {
        expect_idempotent(t, shorter);
        EXPECT_LE(Local_check(surface).largest_defect(shorter.points), 1e-9);
      }
    }
}

TEST(Path_straightener, never_makes_a_path_longer)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    const Surface surface(mesh);
    const bool is_regular = name == "terrain" || name == "sphere" || name == "cone" ||
                            name == "random soup" || name == "another random soup";
    expect_sound_paths(surface, Graph(surface.triangulation()), is_regular);
    expect_sound_paths(surface, Discrete_geodesic_graph(surface.triangulation(), epsilon(0.1)),
                       is_regular);
  }
}

TEST(Path_straightener, copes_with_faces_without_area)
{
  Random random(test_seed());
  for(std::size_t i = 0; i < 20; ++i)
  {
    const auto part = [&] { return 0.25 * static_cast<double>(1 + random.below(3)); };
    const Surface surface(to_mesh(with_caps(with_caps(flat_grid(6, 5), part), part)));
    expect_sound_paths(surface, Graph(surface.triangulation()), false);
    expect_sound_paths(surface, Discrete_geodesic_graph(surface.triangulation(), epsilon(0.1)),
                       false);
  }
}

TEST(Path_straightener, copes_with_lengths_that_fit_no_surface)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(12, 12, random));
  std::vector<double> lengths(mesh.num_edges());
  for(double& length : lengths)
    length = random.below(4) == 0 ? 0 : std::pow(10, random.between(-12, 2));
  const auto map = boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, mesh));
  const Graph graph(Triangulation(mesh, CGAL::parameters::edge_length_map(map)));
  for(Index source = 0; source < 140; source += 20)
    for(const Path& path : paths_from(graph, source, 1))
      expect_sound(graph.triangulation(), path,
                   Path_straightener(graph.triangulation()).shortened(path));
}

TEST(Path_straightener, leaves_points_alone)
{
  const Surface surface(to_mesh(cube()));
  EXPECT_TRUE(surface.shortened(std::vector<Intrinsic_point>()).points.empty());
  for(const Intrinsic_point& p :
      {surface.place(3), Intrinsic_point::on_edge(surface.halfedge(0, 1), 0.25),
       Intrinsic_point::in_face(surface.halfedge(0, 1), 0.25, 0.25)})
  {
    const Path path = surface.shortened({p});
    ASSERT_EQ(path.points.size(), 1u);
    EXPECT_EQ(path.length, 0);
    EXPECT_EQ(path.points.front().halfedge, p.halfedge);
  }
}

// ----- ends of every kind

// A point of a face at a vertex, or of an edge there.
Intrinsic_point near_vertex(const Triangulation& t, const Index v, Random& random)
{
  Index h = t.first_halfedge(v) + static_cast<Index>(random.below(t.degree(v)));
  const bool is_on_edge = random.below(2) == 0 || t.is_border(h);
  const double part = random.between(0.1, 0.4), other = random.between(0.1, 0.4);
  if(is_on_edge)
    return random.below(2) == 0 ? Intrinsic_point::on_edge(h, part)
                                : Intrinsic_point::on_edge(t.opposite(h), other);
  const std::size_t turns = random.below(3); // the vertex can be any of the three
  for(std::size_t i = 0; i < turns; ++i)
    h = t.next(h);
  return Intrinsic_point::in_face(h, part, other);
}

TEST(Path_straightener, starts_and_ends_anywhere)
{
  Random random(test_seed());
  const Surface surface(to_mesh(terrain(30, 20, random)));
  const Triangulation& t = surface.triangulation();
  const Graph graph{t};
  for(const Index source : {0u, 77u, 301u, 599u})
    for(Path path : paths_from(graph, source, 7))
    {
      path.points.insert(path.points.begin(), near_vertex(t, path.points.front().vertex, random));
      path.points.push_back(near_vertex(t, path.points.back().vertex, random));
      const Path shorter = Path_straightener(t).shortened(path);
      expect_sound(t, path, shorter);
      expect_idempotent(t, shorter);
      EXPECT_LE(Local_check(surface).largest_defect(shorter.points), 1e-9);
      EXPECT_NEAR(surface.length(shorter.points), shorter.length, 1e-9);
    }
}

TEST(Path_straightener, starts_and_ends_anywhere_in_the_plane)
{
  Random random(test_seed());
  const Surface surface(to_mesh(flat_grid(12, 9)));
  const Triangulation& t = surface.triangulation();
  const Graph graph{t};
  for(const Index source : {0u, 50u, 107u})
    for(Path path : paths_from(graph, source, 1))
    {
      path.points.insert(path.points.begin(), near_vertex(t, path.points.front().vertex, random));
      path.points.push_back(near_vertex(t, path.points.back().vertex, random));
      const Path straight = surface.shortened(path.points);
      const double expected =
          norm(surface.point(path.points.back()) - surface.point(path.points.front()));
      EXPECT_NEAR(straight.length, expected, 1e-12 * (1 + expected));
    }
}

// Next to a vertex, the part of an edge before a point can vanish when it is taken from 1.
TEST(Path_straightener, starts_next_to_a_vertex)
{
  const Surface surface(to_mesh(flat_grid(4, 4)));
  for(const double t : {1e-18, 1e-17, 1e-16, 1e-15})
    for(const Intrinsic_point start : {Intrinsic_point::on_edge(surface.halfedge(5, 6), t),
                                       Intrinsic_point::on_edge(surface.halfedge(6, 5), 1 - t)})
      for(const unsigned target : {1u, 4u, 9u, 10u})
      {
        const Path path = surface.shortened({start, surface.place(5), surface.place(target)});
        EXPECT_NEAR(path.length, target == 10 ? std::sqrt(2.) : 1., 1e-12);
      }
}

// Points inside faces in the middle of a path are not kept.
TEST(Path_straightener, takes_points_in_faces_on_the_way)
{
  const Surface surface(to_mesh(flat_grid(4, 4)));
  const Intrinsic_point on_way = Intrinsic_point::in_face(surface.halfedge(0, 1), 0.5, 0.25);
  const Intrinsic_point crossing = Intrinsic_point::on_edge(surface.halfedge(0, 5), 0.75);
  const Path path = surface.shortened({surface.place(1), on_way, crossing, surface.place(4)});
  EXPECT_NEAR(path.length, std::sqrt(2.), 1e-12);
  EXPECT_EQ(path.points.size(), 3u);
}

// ----- exact distances

template <typename GeodesicGraph>
std::size_t number_of_exact_paths(const GeodesicGraph& graph,
                                  const std::vector<double>& exact,
                                  const Vertex source)
{
  const Triangulation& t = graph.triangulation();
  std::size_t result = 0;
  for(const Path& path : paths_from(graph, t.vertex(source.idx()), 1))
  {
    const double expected = exact[t.index(path.points.front().vertex)];
    const double length = Path_straightener(t).shortened(path).length;
    EXPECT_GE(length, expected * (1 - 1e-9));
    result += length <= expected * (1 + 1e-9) ? 1 : 0;
  }
  return result;
}

TEST(Path_straightener, finds_most_of_the_shortest_paths)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  for(const std::string name : {"elephant.off", "cow.off", "blobby.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_FALSE(mesh.is_empty());
    Random random(test_seed());
    const Vertex source = random_vertex(mesh, random);
    const std::vector<double> exact = exact_distances(mesh, source);
    const auto all = static_cast<double>(mesh.num_vertices());
    const Discrete_geodesic_graph graph(Triangulation(mesh), epsilon(0.1));
    EXPECT_GT(static_cast<double>(number_of_exact_paths(graph, exact, source)), 0.85 * all);
    const Graph edges{Triangulation(mesh)};
    EXPECT_GT(static_cast<double>(number_of_exact_paths(edges, exact, source)), 0.5 * all);
  }
}

} // namespace
