// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_fields.h"
#include "checks/expect_message.h"
#include "oracles/known_distances.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/aabb_traits.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

// The functions on meshes that are as bad as they get: results are right, or there is an exception
// that says what is wrong, and nothing is written.

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;
using Paths_along_edges = AG::Surface_mesh_shortest_path<Mesh, AG::Edge_graph>;

// ----- everything that reads a mesh

// Receives anything, and counts it.
template <typename Key, typename Value>
struct Counting_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;

  friend void put(const Counting_map& map, const Key&, const Value&) { ++*map.number; }

  std::size_t* number;
};

struct Entry_point
{
  std::string name;
  std::function<void(const Mesh&, std::size_t&)> call; // which counts what is written
  bool is_across_faces = true;
};

struct Counter
{
  template <typename T>
  void operator()(const T&) const
  {
    ++*number;
  }

  std::size_t* number;
};

auto counting_iterator(std::size_t& number)
{
  return boost::make_function_output_iterator(Counter{&number});
}

template <typename... NamedParameters>
Entry_point distances_with(const std::string& name, const NamedParameters&... np)
{
  return {name,
          [=](const Mesh& mesh, std::size_t& number) {
            const Vertex source = *mesh.vertices().begin();
            CGAL::approximate_geodesic_distances(mesh, Counting_map<Vertex, double>{&number},
                                                 source, np...);
          },
          sizeof...(np) > 0};
}

template <typename... NamedParameters>
Entry_point path_with(const std::string& name, const NamedParameters&... np)
{
  return {name,
          [=](const Mesh& mesh, std::size_t& number) {
            const Vertex source = *mesh.vertices().begin();
            CGAL::approximate_geodesic_path(mesh, counting_iterator(number), source, source, np...);
          },
          sizeof...(np) > 0};
}

std::vector<Entry_point> entry_points()
{
  using parameters::epsilon;
  using parameters::number_of_points_per_edge;
  return {{"triangulation", [](const Mesh& mesh, std::size_t&) { Triangulation{mesh}; }, false},
          {"class along edges",
           [](const Mesh& mesh, std::size_t&) { Paths_along_edges paths(mesh); }, false},
          {"class", [](const Mesh& mesh,
                       std::size_t&) { AG::Surface_mesh_shortest_path<Mesh> paths(mesh); }},
          distances_with("distances along edges"),
          distances_with("distances", epsilon(0.1)),
          distances_with("distances with points", number_of_points_per_edge(2)),
          path_with("path along edges"),
          path_with("path", epsilon(0.1)),
          {"refined path",
           [](const Mesh& mesh, std::size_t& number) {
             const Vertex source = *mesh.vertices().begin();
             AG::refined_path(mesh, counting_iterator(number), source, source);
           }},
          {"partition",
           [](const Mesh& mesh, std::size_t& number) {
             AG::voronoi_partition(mesh, Counting_map<Face, int>{&number},
                                   std::vector<Vertex>{*mesh.vertices().begin()});
           },
           false},
          {"sampling along edges",
           [](const Mesh& mesh, std::size_t& number) {
             AG::farthest_point_sampling(mesh, counting_iterator(number), 3);
           },
           false},
          {"sampling", [](const Mesh& mesh, std::size_t& number) {
             AG::farthest_point_sampling(mesh, counting_iterator(number), 3, epsilon(0.1));
           }}};
}

TEST(Hostile_meshes, are_refused_by_everything)
{
  for(const Hostile_mesh& row : refused_meshes())
    for(const Entry_point& entry : entry_points())
    {
      SCOPED_TRACE(row.name + ", " + entry.name);
      std::size_t number = 0;
      for(const std::string& text : row.refusal)
        expect_message<std::invalid_argument>([&] { entry.call(row.mesh, number); }, text);
      EXPECT_EQ(number, 0u);
    }
}

TEST(Hostile_meshes, are_refused_by_everything_across_faces)
{
  for(const Hostile_mesh& row : accepted_meshes())
    for(const Entry_point& entry : entry_points())
    {
      SCOPED_TRACE(row.name + ", " + entry.name);
      std::size_t number = 0;
      if(entry.is_across_faces)
      {
        for(const std::string& text : row.refusal_across_faces)
          expect_message<std::invalid_argument>([&] { entry.call(row.mesh, number); }, text);
        EXPECT_EQ(number, 0u);
      }
      else if(row.mesh.number_of_vertices() > 0)
      {
        EXPECT_NO_THROW(entry.call(row.mesh, number));
      }
    }
}

// What is given to these are values, and coordinates are only copied.
TEST(Hostile_meshes, are_refused_by_functions_of_values_if_they_have_other_faces)
{
  for(const Hostile_mesh& row : refused_meshes())
  {
    const auto& texts = row.refusal;
    if(std::find(texts.begin(), texts.end(), "not a triangle") == texts.end())
      continue;
    std::size_t number = 0;
    const auto values = at_vertices([](const Vertex v) { return double(v.idx()); });
    expect_message<std::invalid_argument>(
        [&] {
          AG::isolines(row.mesh, values, std::vector<double>{0.5}, counting_iterator(number));
        },
        "not a triangle");
    expect_message<std::invalid_argument>(
        [&] { AG::gradient(row.mesh, values, Counting_map<Face, Vector>{&number}); },
        "not a triangle");
    EXPECT_EQ(number, 0u);
  }
}

// ----- distances and paths

template <typename... NamedParameters>
std::vector<double>
distances(const Mesh& mesh, const std::vector<Vertex>& sources, const NamedParameters&... np)
{
  std::vector<double> result(mesh.num_vertices(), -5);
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)),
      sources, np...);
  return result;
}

double or_minus_one(const double distance) { return distance < infinity ? distance : -1; }

template <typename... NamedParameters>
void expect_distances(const Bound& bound, const NamedParameters&... np)
{
  for_accepted_meshes(refused_across_faces(), [&](Known_distances& known) {
    for(const Surface_point& p : some_vertices(known.mesh))
    {
      const std::vector<double> found = distances(known.mesh, {std::get<Vertex>(p)}, np...);
      for(const Vertex v : known.mesh.vertices())
        expect_distance(or_minus_one(found[v.idx()]), known, bound, p, v);
    }
  });
}

template <typename... NamedParameters>
void expect_paths(const Bound& bound, const NamedParameters&... np)
{
  for_accepted_meshes(refused_across_faces(), [&](Known_distances& known) {
    for(const Surface_point& p : some_vertices(known.mesh))
      for(const Surface_point& q : some_vertices(known.mesh))
      {
        std::vector<Point> points;
        const auto source = std::get<Vertex>(p), target = std::get<Vertex>(q);
        const double length = CGAL::approximate_geodesic_path(
            known.mesh, std::back_inserter(points), source, target, np...);
        expect_length(or_minus_one(length), known, bound, p, q);
        ASSERT_EQ(points.empty(), length == infinity);
        if(points.empty())
          continue;
        EXPECT_EQ(points.front(), known.mesh.point(source));
        EXPECT_EQ(points.back(), known.mesh.point(target));
      }
  });
}

TEST(Hostile_meshes, have_distances)
{
  expect_distances({true});
  expect_distances({false, 0.05, 0.05}, parameters::epsilon(0.05));
  expect_distances({}, parameters::number_of_points_per_edge(2));
}

TEST(Hostile_meshes, have_paths)
{
  expect_paths({true});
  expect_paths({false, 0.05, 0.05}, parameters::epsilon(0.05));
  expect_paths({false, 0.05, 0.05}, parameters::epsilon(0.05).straighten(true));
}

TEST(Hostile_meshes, have_refined_paths)
{
  for_accepted_meshes(refused_across_faces(), [](Known_distances& known) {
    for(const Surface_point& p : some_vertices(known.mesh))
      for(const Surface_point& q : some_vertices(known.mesh))
      {
        std::vector<Point> points;
        const double length = AG::refined_path(known.mesh, std::back_inserter(points),
                                               std::get<Vertex>(p), std::get<Vertex>(q));
        expect_length(or_minus_one(length), known, {}, p, q);
        EXPECT_EQ(points.empty(), length == infinity);
      }
  });
}

TEST(Hostile_meshes, have_certain_distances_along_edges)
{
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    const std::vector<double> lengths = edge_lengths(row.mesh);
    const std::vector<Long> exact = Known_distances(row).lengths_of_edges();
    const bool has_squares = std::all_of(exact.begin(), exact.end(), [](const Long l) {
      return l == 0 || (l > 1e-130L && l < 1e150L);
    });
    if(!has_squares || row.mesh.has_garbage())
      continue;
    Mesh_search search(row.mesh);
    for(const Surface_point& p : some_vertices(row.mesh))
      EXPECT_TRUE(
          is_optimal(row.mesh, lengths, search.run({std::get<Vertex>(p)}), {std::get<Vertex>(p)}));
  }
}

// ----- what follows from distances

std::vector<Vertex> first_vertex(const Mesh& mesh)
{
  return mesh.number_of_vertices() == 0 ? std::vector<Vertex>()
                                        : std::vector<Vertex>{*mesh.vertices().begin()};
}

TEST(Hostile_meshes, have_isolines)
{
  for_accepted_meshes(refused_across_faces(), [](Known_distances& known) {
    const std::vector<double> values = distances(known.mesh, first_vertex(known.mesh));
    const double largest = largest_finite(values);
    for(const double isovalue : {0., largest / 3, largest / 2, largest})
      for(const Polyline& polyline : isolines(known.mesh, from_vector(values), {isovalue}))
      {
        EXPECT_GT(polyline.size(), 1u);
        for(const Point& p : polyline)
          for(int i = 0; i < 3; ++i)
            EXPECT_TRUE(std::isfinite(p[i]));
      }
  });
}

TEST(Hostile_meshes, have_gradients)
{
  for_accepted_meshes(refused_across_faces(), [](Known_distances& known) {
    const std::vector<double> values = distances(known.mesh, first_vertex(known.mesh));
    for(const Vector& v : gradients(known.mesh, from_vector(values)))
      for(int i = 0; i < 3; ++i)
        EXPECT_TRUE(std::isfinite(v[i]));
  });
}

TEST(Hostile_meshes, are_divided_among_sources)
{
  for_accepted_meshes(refused_across_faces(), [](Known_distances& known) {
    std::vector<Vertex> sources;
    for(const Surface_point& p : some_vertices(known.mesh))
      sources.push_back(std::get<Vertex>(p));
    const std::vector<int> cells = partition(known.mesh, sources);
    std::size_t i = 0;
    for(const Face f : known.mesh.faces())
    {
      const int cell = cells[i++];
      bool is_reached = false;
      for(const Vertex v : corners(known.mesh, f))
        for(const Vertex s : sources)
          is_reached = is_reached || known.longest(s, v) < infinity;
      ASSERT_EQ(cell >= 0, is_reached);
      if(cell < 0)
        continue;
      // it is the nearest one of some corner
      ASSERT_LT(static_cast<std::size_t>(cell), sources.size());
      bool is_nearest = false;
      for(const Vertex v : corners(known.mesh, f))
      {
        const Long distance = known.longest(sources[static_cast<std::size_t>(cell)], v);
        is_nearest = is_nearest || std::all_of(sources.begin(), sources.end(), [&](const Vertex s) {
                       return distance <= known.longest(s, v) * (1 + Long(1e-12));
                     });
      }
      EXPECT_TRUE(is_nearest);
    }
  });
}

TEST(Hostile_meshes, are_sampled)
{
  for_accepted_meshes(refused_across_faces(), [](Known_distances& known) {
    const Sample found = sample(known.mesh, {}, 5);
    EXPECT_LE(found.points.size(), 5u);
    Long radius = 0;
    for(const Vertex v : known.mesh.vertices())
    {
      Long distance = infinity;
      for(const Vertex p : found.points)
        distance = (std::min)(distance, known.longest(p, v));
      radius = (std::max)(radius, distance);
    }
    if(radius == infinity)
    {
      EXPECT_EQ(found.radius, infinity);
    }
    else
    {
      EXPECT_NEAR(found.radius, double(radius), 1e-12 * found.radius);
    }
  });
}

// ----- locations

// Whether CGAL's tree can compute with squares.
bool has_squares(const Mesh& mesh)
{
  return std::all_of(mesh.points().begin(), mesh.points().end(), [](const Point& p) {
    return std::all_of(p.cartesian_begin(), p.cartesian_end(), [](const double x) {
      return x == 0 || (std::abs(x) > 1e-70 && std::abs(x) < 1e70);
    });
  });
}

TEST(Hostile_meshes, know_where_their_vertices_are)
{
  using Traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
  for(const Hostile_mesh& row : accepted_meshes())
  {
    if(row.mesh.number_of_faces() == 0 || !has_squares(row.mesh))
      continue;
    SCOPED_TRACE(row.name);
    const Paths_along_edges paths(row.mesh);
    CGAL::AABB_tree<Traits> tree;
    paths.build_aabb_tree(tree);
    for(const Surface_point& v : some_vertices(row.mesh))
    {
      if(row.mesh.is_isolated(std::get<Vertex>(v)))
        continue;
      const Face_location found = paths.locate(row.mesh.point(std::get<Vertex>(v)), tree);
      ASSERT_NE(found.first, Mesh::null_face());
      EXPECT_LE(straight_line(row.mesh, found, v), 1e-9 * size(row.mesh));
    }
  }
}

} // namespace
