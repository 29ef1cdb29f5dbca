// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>

#include "checks/expect_exact_distances.h"
#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/developed_surfaces.h"
#include "meshes/random_soups.h"
#include "meshes/sample_meshes.h"
#include "oracles/exact_surface_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What exact searches have in common with others, and what only they do.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Intrinsic_point;

// ----- runs of all kinds, on surfaces with known distances and on others

struct Exact_subject
{
  explicit Exact_subject(const Mesh& m) : mesh(m), triangulation(mesh), graph(triangulation)
  {
    translation.list_vertices();
  }

  std::vector<Intrinsic_point> points(const std::size_t number, Random& random) const
  {
    std::vector<Intrinsic_point> result;
    for(const Surface_point& p : random_surface_points(mesh, number, random))
      result.push_back(translation.intrinsic_point(p));
    return result;
  }

  AG::Vertex_positions positions() const
  {
    return {triangulation, translation.position_of_vertex(mesh.points())};
  }

  const Mesh mesh;
  const Triangulation triangulation;
  const Saddle_vertex_graph graph;
  AG::Mesh_translation<Mesh, decltype(get(boost::vertex_index, mesh))> translation{
      mesh, get(boost::vertex_index, mesh), triangulation};
};

std::vector<Mesh> meshes_of_searches(Random& random)
{
  Soup parts = scattered_parts(random);
  return {to_mesh(terrain(13, 11, random)), to_mesh(parts), to_mesh(sphere(12, 9)),
          to_mesh(flat_grid(12, 12))};
}

double rounding_of(const Exact_subject& subject)
{
  return rounding_of_places(subject.triangulation);
}

void expect_same(const double found, const double expected, const double rounding)
{
  if(expected == infinity)
  {
    EXPECT_EQ(found, expected);
  }
  else
    EXPECT_NEAR(found, expected, tolerance_of_exact_distances * expected + rounding);
}

TEST(Exact_search, takes_the_nearest_source)
{
  Random random(test_seed());
  for(const Mesh& mesh : meshes_of_searches(random))
  {
    const Exact_subject subject(mesh);
    Exact_search search(subject.graph), single(subject.graph);
    const auto sources = subject.points(4, random), targets = subject.points(60, random);
    const std::vector<double> offsets = {0.5, 0, 1.25, 0.125};
    std::vector<AG::Source_point> all;
    std::vector<std::vector<double>> distances;
    for(std::size_t i = 0; i < sources.size(); ++i)
    {
      all.push_back({sources[i], offsets[i]});
      single.run({all.back()});
      distances.emplace_back();
      for(const Intrinsic_point& p : targets)
        distances.back().push_back(single.distance(p));
    }
    search.run(all);
    for(std::size_t j = 0; j < targets.size(); ++j)
    {
      double nearest = infinity;
      for(std::size_t i = 0; i < sources.size(); ++i)
        nearest = (std::min)(nearest, distances[i][j]);
      const auto answer = search.nearest(targets[j]);
      expect_same(answer.distance, nearest, rounding_of(subject));
      EXPECT_EQ(answer.is_reached(), nearest < infinity);
      if(answer.is_reached())
        expect_same(distances[answer.source][j], nearest, rounding_of(subject));
    }
  }
}

// The limit is a bit more than the one given.
void expect_limited(const double found, const double d, const double limit, const double rounding)
{
  if(d <= limit)
    expect_same(found, d, rounding);
  else if(d > 1.002 * limit + 2 * rounding)
  {
    EXPECT_EQ(found, infinity);
  }
}

// What a run says that ends early is what a full one says, and it says all that it was asked for.
TEST(Exact_search, ends_early_with_the_same_distances)
{
  Random random(test_seed());
  for(const Mesh& mesh : meshes_of_searches(random))
  {
    const Exact_subject subject(mesh);
    const AG::Vertex_positions positions = subject.positions();
    Exact_search full(subject.graph), other(subject.graph);
    const auto points = subject.points(24, random);
    for(std::size_t i = 0; i < 6; ++i)
    {
      const std::vector<AG::Source_point> sources = {{points[i]}, {points[i + 1], 1.5}};
      full.run(sources);
      for(const Intrinsic_point& p : points)
      {
        const double expected = full.distance(p), rounding = rounding_of(subject);
        other.run_to(p, sources);
        expect_same(other.distance(p), expected, rounding);
        other.run_to(p, sources, positions);
        expect_same(other.distance(p), expected, rounding);
        other.run(sources, {infinity, {p, points[7]}});
        expect_same(other.distance(p), expected, rounding);
        expect_same(other.distance(points[7]), full.distance(points[7]), rounding);
        if(expected == infinity)
          continue;
        other.run(sources, {expected * 1.001 + rounding, {}});
        for(const Intrinsic_point& q : points)
          expect_limited(other.distance(q), full.distance(q), expected, rounding);
        if(expected > 0)
        {
          other.run(sources, {expected * 0.999, {}});
          EXPECT_EQ(other.distance(p), infinity);
        }
      }
    }
  }
}

TEST(Exact_search, runs_further)
{
  Random random(test_seed());
  for(const Mesh& mesh : meshes_of_searches(random))
  {
    Basic_mesh_search<Saddle_vertex_graph> search(mesh), full(mesh);
    std::vector<Vertex> sources = {random_vertex(mesh, random)};
    search.run(sources);
    for(int i = 0; i < 8; ++i)
    {
      sources.push_back(random_vertex(mesh, random));
      search.search().run_further({{search.node(sources.back()), 0, sources.size() - 1}});
      const Field field = search.field();
      const std::vector<double> expected = full.distances(sources);
      for(const Vertex v : mesh.vertices())
        expect_same(field.distance[v.idx()], expected[v.idx()], 0);
    }
  }
}

TEST(Exact_search, does_the_same_again)
{
  Random random(test_seed());
  for(const Mesh& mesh : meshes_of_searches(random))
  {
    const Exact_subject subject(mesh);
    const auto points = subject.points(30, random);
    Exact_search used(subject.graph);
    for(std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      Exact_search fresh(subject.graph);
      for(Exact_search* const search : {&used, &fresh})
        if(i % 3 == 0)
          search->run({{points[i]}}, {1.5, {}});
        else if(i % 3 == 1)
          search->run_to(points[i + 1], {{points[i]}});
        else
          search->run({{points[i]}});
      for(const Intrinsic_point& p :
          i % 3 == 1 ? std::vector<Intrinsic_point>{points[i + 1]} : points)
      {
        EXPECT_EQ(used.distance(p), fresh.distance(p));
        EXPECT_EQ(used.find_path(p).points.size(), fresh.find_path(p).points.size());
      }
    }
  }
}

// ----- sample meshes

const std::vector<std::string>& small_sample_meshes()
{
  static const std::vector<std::string> result = {
      "cube.off",         "cross.off", "eight.off", "oblong.off",      "mesh_with_border.off",
      "pinion_small.off", "spool.off", "joint.off", "rotor_small.off", "icosahedron.off"};
  return result;
}

// ----- paths on meshes in space

double angle_around(const Mesh& mesh, const Vertex v)
{
  double result = 0;
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    const auto a = mesh.point(mesh.source(h)) - mesh.point(v),
               b = mesh.point(mesh.target(mesh.next(h))) - mesh.point(v);
    result += std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
  }
  return result;
}

// Whose angles say nothing, or little.
bool has_degenerate_faces(const Mesh& mesh, const Vertex v)
{
  for(const Face f : faces_of(mesh, v))
  {
    const Halfedge h = mesh.halfedge(f);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                &c = mesh.point(mesh.target(mesh.next(h)));
    if(CGAL::collinear(a, b, c))
      return true;
  }
  return false;
}

void expect_path(const Mesh& mesh,
                 const std::vector<Surface_point>& points,
                 const double length,
                 const double distance)
{
  const double rounding = tolerance_of_exact_distances * (distance + size(mesh));
  const auto is_near = [&](const Vertex v) { // one of the ends, so that rounding hides the angle
    const Point first = position(mesh, points.front()), last = position(mesh, points.back());
    return (std::min)(distance_in_space(mesh.point(v), first),
                      distance_in_space(mesh.point(v), last)) <= 1e-9 * size(mesh);
  };
  for(std::size_t i = 1; i < points.size(); ++i)
    EXPECT_TRUE(share_a_face(mesh, points[i - 1], points[i])) << i;
  EXPECT_NEAR(length_of(mesh, points), distance, rounding);
  EXPECT_NEAR(length, distance, rounding);
  for(std::size_t i = 1; i + 1 < points.size(); ++i)
    if(const auto* v = std::get_if<Vertex>(&points[i]))
      if(!mesh.is_border(*v) && !has_degenerate_faces(mesh, *v) && !is_near(*v))
      {
        EXPECT_GE(angle_around(mesh, *v), 8 * std::atan(1.) - 1e-9);
      }
}

void expect_paths(const Mesh& mesh, const std::size_t number_of_sources, Random& random)
{
  const Exact_subject subject(mesh);
  Exact_search search(subject.graph);
  for(std::size_t i = 0; i < number_of_sources; ++i)
  {
    const Surface_point source = random_surface_point(mesh, random);
    search.run({{subject.translation.intrinsic_point(source)}});
    for(const Surface_point& target : random_surface_points(mesh, 40, random))
    {
      const Intrinsic_point end = subject.translation.intrinsic_point(target);
      const AG::Path path = search.find_path(end);
      EXPECT_EQ(path.points.empty(), search.distance(end) == infinity);
      if(path.points.empty())
        continue;
      std::vector<Surface_point> points;
      for(const Intrinsic_point& p : path.points)
        points.push_back(subject.translation.surface_point(p));
      EXPECT_LE(distance_in_space(position(mesh, points.front()), position(mesh, target)),
                1e-14 * size(mesh));
      EXPECT_LE(distance_in_space(position(mesh, points.back()), position(mesh, source)),
                1e-14 * size(mesh));
      expect_path(mesh, points, path.length, search.distance(end));
    }
  }
}

TEST(Exact_paths, have_the_length_of_the_distance)
{
  Random random(test_seed());
  for(const Mesh& mesh : meshes_of_searches(random))
    expect_paths(mesh, 8, random);
  for(const std::uint64_t seed : seeds_of_small_soups())
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    expect_paths(to_mesh(random_small_soup(seed)), 4, random);
  }
}

TEST(Exact_paths, have_the_length_of_the_distance_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  for(const std::string& name : small_sample_meshes())
  {
    SCOPED_TRACE(name);
    expect_paths(sample_mesh(name), 3, random);
  }
}

// ----- other graphs and bounds

TEST(Exact_distances, are_a_metric_between_those_in_space_and_others)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  for(const std::string& name : small_sample_meshes())
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    ASSERT_FALSE(mesh.is_empty());
    Basic_mesh_search<Saddle_vertex_graph> exact(mesh);
    Basic_mesh_search<Discrete_geodesic_graph> bounded(mesh, CGAL::parameters::epsilon(0.1));
    Mesh_search edges(mesh);
    const Vertex s = random_vertex(mesh, random), t = random_vertex(mesh, random);
    const auto from_s = exact.distances({s}), from_t = exact.distances({t});
    const auto other = bounded.distances({s}), along_edges = edges.distances({s});
    EXPECT_NEAR(from_s[t], from_t[s], 1e-12 * from_s[t]);
    for(const Vertex v : mesh.vertices())
    {
      EXPECT_LE(from_s[v], (from_s[t] + from_t[v]) * (1 + 1e-12));
      EXPECT_LE(from_s[v], other[v] * (1 + single_precision));
      EXPECT_LE(other[v], from_s[v] * 1.1 * (1 + single_precision));
      EXPECT_LE(from_s[v], along_edges[v] * (1 + 1e-12));
      EXPECT_GE(from_s[v], distance_in_space(mesh.point(s), mesh.point(v)) * (1 - 1e-12));
    }
  }
}

// CGAL's class finds a longer way on some of these, and none that is shorter.
TEST(Exact_distances, are_those_of_the_exact_class_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  for(const std::string& name : small_sample_meshes())
  {
    SCOPED_TRACE(name);
    const Mesh mesh = sample_mesh(name);
    Basic_mesh_search<Saddle_vertex_graph> search(mesh);
    const double rounding = rounding_of_places(search.graph().triangulation());
    for(int i = 0; i < 3; ++i)
    {
      const Vertex s = random_vertex(mesh, random);
      const auto found = search.distances({s}), other = exact_distances(mesh, s);
      for(const Vertex v : mesh.vertices())
      {
        const double tolerance = 1e-10 * other[v] + rounding;
        EXPECT_LE(found[v], other[v] + tolerance) << s << " to " << v;
        if(name != "oblong.off")
        {
          EXPECT_GE(found[v], other[v] - tolerance) << s << " to " << v;
        }
      }
    }
  }
}

} // namespace
