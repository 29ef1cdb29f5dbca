// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/hostile_meshes.h"
#include "oracles/distances_to_curves.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Geodesic_constructions/Source_curve.h>
#include <CGAL/Geodesic_constructions/internal/Curves/signed_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Curves on meshes that are as bad as they get.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// A path may not be traced across nearly degenerate faces; the message says so.
template <typename Search>
void expect_path_or_message(const Search& search, const Intrinsic_point& p, const double small)
{
  try
  {
    const auto path = search.find_path(p);
    const auto answer = search.nearest(p);
    EXPECT_EQ(path.points.empty(), !answer.is_reached());
    if(answer.is_reached())
    {
      EXPECT_NEAR(path.length, answer.distance, 1e-5 * answer.distance + small);
      const auto& t = search.graph().triangulation();
      EXPECT_TRUE(path.points.back().is_same(answer.start, t) ||
                  AG::internal::shortest_segment(t, path.points.back(), answer.start).length *
                          t.unit() <=
                      small);
    }
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("cannot be traced"), std::string::npos) << e.what();
  }
}

// No vertex is farther from a curve than from a point of it, and none is nearer than the length of
// the curve allows. `excess` is the part by which distances may be too long; in a graph without a
// bound, the latter need not hold.
template <typename Graph>
void expect_properties(const Graph& graph, const double excess, Random& random)
{
  const AG::Intrinsic_triangulation& t = graph.triangulation();
  Polyline_on_surface polyline;
  try
  {
    polyline = random_polyline(graph, 3, random);
  }
  catch(const std::invalid_argument&) // a path that cannot be traced
  {
    polyline = {random_intrinsic_point(t, random)};
  }
  const double small =
      1e-9 * graph.arc_lengths().longest * t.unit() + 8 * std::numeric_limits<double>::denorm_min();
  const double length = AG::internal::length_of_segments(t, polyline) * t.unit();
  AG::Surface_search<Graph> search(graph), from_point(graph);
  AG::run_from_curves(search, {{{polyline}}});
  const std::size_t step = 1 + polyline.size() / 4;
  for(std::size_t i = 0; i < polyline.size(); i += step)
  {
    from_point.run({{polyline[i]}});
    const unsigned beyond = (std::min)(t.number_of_vertices(), 500u);
    for(unsigned v = 0; v < beyond; ++v)
    {
      const Intrinsic_point p = Intrinsic_point::at_vertex(v);
      const double d = search.distance(p), other = from_point.distance(p);
      ASSERT_FALSE(std::isnan(d));
      EXPECT_EQ(std::isinf(d), std::isinf(other)) << v;
      if(std::isinf(other))
        continue;
      EXPECT_LE(d, other * (1 + (excess < infinity ? excess : 1e-12)) + small) << v;
      if(excess < infinity)
      {
        EXPECT_GE(d * (1 + excess) + length * (1 + excess) + small, other * (1 - 1e-6)) << v;
      }
    }
  }
  for(int i = 0; i < 4; ++i)
    expect_path_or_message(search, random_intrinsic_point(t, random), small);
  for(unsigned v = 0; v < t.number_of_vertices(); v += 1 + t.number_of_vertices() / 20)
    expect_path_or_message(search, Intrinsic_point::at_vertex(v), small);
}

template <typename MakeGraph>
void expect_properties_on_all_meshes(const double excess, const bool needs_faces, MakeGraph make)
{
  const std::uint64_t seed = test_seed();
  for(const Hostile_mesh& hostile : accepted_meshes())
  {
    if(hostile.mesh.number_of_faces() == 0 ||
       (needs_faces && !hostile.refusal_across_faces.empty()))
      continue;
    SCOPED_TRACE(hostile.name);
    Random random(seed);
    const auto graph = make(Triangulation(hostile.mesh));
    for(int i = 0; i < 3; ++i)
      expect_properties(graph, excess, random);
  }
}

TEST(Hostile_meshes, curves_along_edges)
{
  expect_properties_on_all_meshes(infinity, false,
                                  [](Triangulation t) { return AG::Edge_graph(std::move(t)); });
}

TEST(Hostile_meshes, curves_in_the_exact_graph)
{
  expect_properties_on_all_meshes(
      1e-7, true, [](Triangulation t) { return AG::Saddle_vertex_graph(std::move(t)); });
}

TEST(Hostile_meshes, curves_in_lazy_graphs)
{
  expect_properties_on_all_meshes(0.3, true, [](Triangulation t) {
    return AG::Lazy_discrete_geodesic_graph(std::move(t), parameters::epsilon(0.3));
  });
}

TEST(Hostile_meshes, curves_in_graphs_that_are_built)
{
  expect_properties_on_all_meshes(0.3, true, [](Triangulation t) {
    return AG::Discrete_geodesic_graph(std::move(t), parameters::epsilon(0.3));
  });
}

// ----- sides

// With their signs, exact distances of neighbors differ by no more than the length of their edge.
void expect_sides(const AG::Saddle_vertex_graph& graph, const Intrinsic_curve& curve)
{
  const AG::Intrinsic_triangulation& t = graph.triangulation();
  AG::Surface_search<AG::Saddle_vertex_graph> search(graph);
  AG::run_from_curves(search, {curve});
  const std::vector<double> found = AG::internal::signed_distances(search);
  const double small = 1e-7 * graph.arc_lengths().longest * t.unit() +
                       16 * std::numeric_limits<double>::denorm_min();
  for(unsigned v = 0; v < t.number_of_vertices(); ++v)
  {
    EXPECT_EQ(std::abs(found[v]), search.distance(Intrinsic_point::at_vertex(v)));
    for(unsigned h = t.first_halfedge(v); h < t.beyond_halfedge(v); ++h)
      if(std::isfinite(found[v]))
      {
        EXPECT_LE(std::abs(found[v] - found[t.target(h)]), t.length(h) * t.unit() + small);
      }
  }
}

// Expects them, or a message that tells why there are none. Returns whether there are.
bool has_sides(const AG::Saddle_vertex_graph& graph, const Intrinsic_curve& curve)
{
  try
  {
    expect_sides(graph, curve);
    return true;
  }
  catch(const std::invalid_argument& e)
  {
    const std::string text = e.what();
    EXPECT_TRUE(text.find("no two sides") != std::string::npos ||
                text.find("nearly degenerate") != std::string::npos ||
                text.find("as it is a point") != std::string::npos)
        << text;
    return false;
  }
}

// A triangle of three random points and shortest paths.
Polyline_on_surface random_triangle(const AG::Saddle_vertex_graph& graph, Random& random)
{
  Polyline_on_surface result = random_polyline(graph, 3, random);
  AG::Surface_search<AG::Saddle_vertex_graph> search(graph);
  search.run_to(result.back(), {{result.front()}});
  const Polyline_on_surface path = search.find_path(result.back()).points;
  if(!path.empty())
    result.insert(result.end(), path.begin() + 1, path.end());
  return result;
}

TEST(Hostile_meshes, curves_have_two_sides_or_a_message)
{
  const std::uint64_t seed = test_seed();
  std::size_t number_with_sides = 0;
  for(const Hostile_mesh& hostile : accepted_meshes())
  {
    if(hostile.mesh.number_of_faces() == 0 || !hostile.refusal_across_faces.empty())
      continue;
    SCOPED_TRACE(hostile.name);
    Random random(seed);
    const AG::Saddle_vertex_graph graph{Triangulation(hostile.mesh)};
    for(int i = 0; i < 6; ++i)
      try
      {
        if(has_sides(graph, {{random_triangle(graph, random)}}))
          ++number_with_sides;
      }
      catch(const std::invalid_argument&) // a path that cannot be traced
      {
      }
  }
  EXPECT_GT(number_with_sides, 20u);
}

// A connected set of faces, from one to all of them.
std::vector<Face> random_region(const Mesh& mesh, Random& random)
{
  const std::vector<Face> all(mesh.faces().begin(), mesh.faces().end());
  Halfedge h = mesh.halfedge(all[random.below(all.size())]);
  std::set<Face> result;
  const std::size_t wanted = 1 + random.below(all.size());
  for(std::size_t step = 0; step < 20 * wanted && result.size() < wanted; ++step)
  {
    if(!mesh.is_border(h))
      result.insert(mesh.face(h));
    h = random.below(2) == 0 || mesh.is_border(h) ? mesh.opposite(h) : mesh.next(h);
  }
  return {result.begin(), result.end()};
}

// Vertices inside of a region are to the left of its border, and those outside are not.
void expect_sides(const Mesh& mesh, const std::vector<Face>& region)
{
  using Sides = AG::internal::Curve_sides;
  const Triangulation t(mesh);
  const AG::Mesh_translation translation(mesh, get(boost::vertex_index, mesh), t);
  const Sides sides(t, {AG::internal::intrinsic_curve(translation, t, {region})});
  const std::set<Face> faces(region.begin(), region.end());
  for(const Vertex v : mesh.vertices())
  {
    bool is_inside = false, is_outside = mesh.is_isolated(v);
    if(!mesh.is_isolated(v))
      for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
        (faces.count(mesh.face(h)) > 0 ? is_inside : is_outside) = true;
    const Sides::Side found = sides[t.vertex(v.idx())];
    if(is_inside)
      EXPECT_EQ(found, is_outside ? Sides::NONE : Sides::LEFT) << v;
    else
      EXPECT_NE(found, Sides::LEFT) << v;
  }
}

// Their vertices do not tell on which of these edges a border runs.
bool has_parallel_edges(const Mesh& mesh)
{
  std::set<std::pair<Vertex, Vertex>> ends;
  for(const Halfedge h : mesh.halfedges())
    if(!ends.emplace(mesh.source(h), mesh.target(h)).second)
      return true;
  return false;
}

TEST(Hostile_meshes, regions_are_to_the_left_of_their_border)
{
  const std::uint64_t seed = test_seed();
  for(const Hostile_mesh& hostile : accepted_meshes())
  {
    if(hostile.mesh.number_of_faces() == 0 || has_parallel_edges(hostile.mesh))
      continue;
    SCOPED_TRACE(hostile.name);
    Random random(seed);
    for(int i = 0; i < 10; ++i)
      expect_sides(hostile.mesh, random_region(hostile.mesh, random));
  }
}

} // namespace
