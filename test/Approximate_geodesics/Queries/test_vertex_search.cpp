// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Queries/internal/Vertex_search.h>

#include "checks/test_recorder.h"
#include "meshes/hostile_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

// Searches along edges, from and to vertices, need no triangulation. Those from the same points, of
// a type that could hold any points, have one.

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Any_point = AG::Surface_point<Mesh>;

// Whether a mesh is read, and not left to the builder of triangulations.
template <typename... NamedParameters>
bool is_read(const Mesh& mesh, const NamedParameters&... np)
{
  const auto all = std::make_tuple(np..., parameters::default_values());
  return AG::internal::search_vertices_once(mesh, std::get<0>(all), [](auto&) { return true; });
}

// ----- reading

template <typename NamedParameters>
void expect_arcs_of_triangulation(const Mesh& mesh, const NamedParameters& np)
{
  using Index_map = decltype(AG::internal::vertex_index_map(mesh, np));
  using Vertex_numbers = AG::internal::Vertex_numbers<Mesh, Index_map>;
  Vertex_numbers numbers(mesh, AG::internal::vertex_index_map(mesh, np), mesh.num_vertices());
  ASSERT_TRUE(numbers.list_vertices());
  AG::internal::Adjacency_reader reader(numbers, AG::internal::halfedge_index_map(mesh, np));
  ASSERT_TRUE(reader.read());
  const auto& adjacency = reader.adjacency();
  const AG::internal::Edge_lengths lengths = reader.lengths(np);
  const Triangulation t(mesh, np);
  EXPECT_EQ(lengths.unit, t.unit());
  ASSERT_EQ(adjacency.number_of_vertices(), t.number_of_vertices());
  for(Triangulation::Index v = 0; v < adjacency.number_of_vertices(); ++v)
  {
    const Triangulation::Index u = t.vertex(v);
    ASSERT_EQ(adjacency.degree(v), t.degree(u));
    for(Triangulation::Index i = 0; i < t.degree(u); ++i)
    {
      const Triangulation::Index h = adjacency.first_halfedge(v) + i, g = t.first_halfedge(u) + i;
      ASSERT_EQ(adjacency.source(h), v);
      ASSERT_EQ(adjacency.target(h), t.index(t.target(g)));
      ASSERT_EQ(lengths.of_halfedge[h], t.length(g));
    }
  }
}

TEST(Vertex_search, has_the_arcs_of_a_triangulation_in_the_same_order)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    expect_arcs_of_triangulation(mesh, parameters::default_values());
    const auto lengths = boost::make_function_property_map<Edge>(
        [](const Edge e) { return 1 + 1. / (1 + double(e.idx())); });
    expect_arcs_of_triangulation(mesh, parameters::edge_length_map(lengths));
    const auto backward = boost::make_function_property_map<Vertex>(
        [n = mesh.num_vertices()](const Vertex v) { return n - 1 - v.idx(); });
    expect_arcs_of_triangulation(mesh, parameters::vertex_index_map(backward));
  }
}

TEST(Vertex_search, reads_no_mesh_that_is_refused)
{
  for(const Hostile_mesh& row : refused_meshes())
    try
    {
      EXPECT_FALSE(is_read(row.mesh)) << row.name;
    }
    catch(const std::invalid_argument&) // of a coordinate or a length
    {
    }
  for(const Hostile_mesh& row : accepted_meshes())
    EXPECT_TRUE(is_read(row.mesh) || row.mesh.has_garbage()) << row.name;
}

bool is_accepted(const Mesh& mesh)
{
  try
  {
    Triangulation{mesh};
  }
  catch(const std::invalid_argument&)
  {
    return false;
  }
  return true;
}

// Gives every link of a mesh every other value in turn. `set(mesh, i, j)` sets that of the element
// `i` to `j`.
template <typename Element>
void expect_unread_if_linked_otherwise(const std::size_t size,
                                       const std::function<Element(const Mesh&, std::size_t)>& get,
                                       const std::function<void(Mesh&, std::size_t, Element)>& set,
                                       const std::size_t number_of_values)
{
  const Mesh good = quiet_mesh();
  ASSERT_TRUE(is_read(good));
  for(std::size_t i = 0; i < size; ++i)
    for(std::size_t j = 0; j < number_of_values; ++j)
    {
      const Element bad(static_cast<Mesh::size_type>(j));
      if(bad == get(good, i))
        continue;
      Mesh mesh = good;
      set(mesh, i, bad);
      const bool is_read_at_once = is_read(mesh), is_triangulated = is_accepted(mesh);
      mesh.remove_vertex(mesh.add_vertex(Point(0, 0, 0))); // is read step by step from now on
      EXPECT_EQ(is_triangulated, is_accepted(mesh)) << i << ' ' << j;
      EXPECT_LE(is_read_at_once, is_triangulated) << i << ' ' << j;
    }
}

Halfedge halfedge_of(const std::size_t i) { return Halfedge(static_cast<Mesh::size_type>(i)); }
Vertex vertex_of(const std::size_t i) { return Vertex(static_cast<Mesh::size_type>(i)); }

TEST(Vertex_search, finds_every_wrong_link)
{
  const std::size_t h = quiet_mesh().num_halfedges(), v = quiet_mesh().num_vertices(),
                    f = quiet_mesh().num_faces();
  expect_unread_if_linked_otherwise<Halfedge>(
      h, [](const Mesh& m, const std::size_t i) { return m.next(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Halfedge g) { m.set_next_only(halfedge_of(i), g); },
      h);
  expect_unread_if_linked_otherwise<Halfedge>(
      h, [](const Mesh& m, const std::size_t i) { return m.prev(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Halfedge g) { m.set_prev_only(halfedge_of(i), g); },
      h);
  expect_unread_if_linked_otherwise<Vertex>(
      h, [](const Mesh& m, const std::size_t i) { return m.target(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Vertex u) { m.set_target(halfedge_of(i), u); }, v);
  expect_unread_if_linked_otherwise<Face>(
      h, [](const Mesh& m, const std::size_t i) { return m.face(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Face g) { m.set_face(halfedge_of(i), g); }, f);
  expect_unread_if_linked_otherwise<Halfedge>(
      v, [](const Mesh& m, const std::size_t i) { return m.halfedge(vertex_of(i)); },
      [](Mesh& m, const std::size_t i, const Halfedge g) { m.set_halfedge(vertex_of(i), g); }, h);
}

TEST(Vertex_search, reads_no_indices_that_are_given_twice)
{
  const Mesh mesh = quiet_mesh();
  const auto vertices = boost::make_function_property_map<Vertex>(
      [](const Vertex v) { return v.idx() == 11 ? 5 : static_cast<int>(v.idx()); });
  EXPECT_FALSE(is_read(mesh, parameters::vertex_index_map(vertices)));
  const auto halfedges = boost::make_function_property_map<Halfedge>(
      [](const Halfedge h) { return h.idx() == 11 ? 5 : static_cast<int>(h.idx()); });
  EXPECT_FALSE(is_read(mesh, parameters::halfedge_index_map(halfedges)));
}

// ----- answers

struct Answers
{
  std::vector<double> distances;
  std::vector<int> sources;
  std::vector<Vertex> predecessors;
};

template <typename Points, typename NamedParameters>
Answers answers(const Mesh& mesh, const Points& points, const NamedParameters& np)
{
  const std::size_t n = mesh.num_vertices();
  Answers result{std::vector<double>(n), std::vector<int>(n), std::vector<Vertex>(n)};
  const auto index = get(boost::vertex_index, mesh);
  const auto map = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), index);
  };
  CGAL::approximate_geodesic_distances(
      mesh, map(result.distances), points,
      np.nearest_source_map(map(result.sources)).predecessor_map(map(result.predecessors)));
  return result;
}

template <typename NamedParameters>
void expect_same_answers(const Mesh& mesh,
                         const std::vector<Vertex>& sources,
                         const NamedParameters& np)
{
  const Answers ours = answers(mesh, sources, np);
  const Answers theirs = answers(mesh, std::vector<Any_point>(sources.begin(), sources.end()), np);
  EXPECT_TRUE(have_same_bits(ours.distances, theirs.distances));
  EXPECT_EQ(ours.sources, theirs.sources);
  EXPECT_EQ(ours.predecessors, theirs.predecessors);
}

TEST(Vertex_search, has_the_answers_of_a_search_of_any_points)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    const std::vector<Vertex> sources = {random_vertex(mesh, random), random_vertex(mesh, random)},
                              targets = {random_vertex(mesh, random)};
    const std::vector<double> initial = {1, 0.5};
    using parameters::initial_distances;
    expect_same_answers(mesh, sources, initial_distances(initial));
    expect_same_answers(mesh, sources, initial_distances(initial).maximum_distance(3));
    expect_same_answers(mesh, sources, initial_distances(initial).targets(targets));
  }
}

TEST(Vertex_search, has_the_paths_of_a_search_of_any_points)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    const Vertex source = random_vertex(mesh, random), target = random_vertex(mesh, random);
    std::vector<Point> ours, theirs;
    const double length =
        CGAL::approximate_geodesic_path(mesh, std::back_inserter(ours), source, target);
    EXPECT_EQ(length, CGAL::approximate_geodesic_path(mesh, std::back_inserter(theirs),
                                                      Any_point(source), Any_point(target)));
    EXPECT_EQ(ours, theirs);
  }
}

TEST(Vertex_search, tells_visitors_the_same)
{
  const Mesh mesh = to_mesh(flat_grid(30, 20));
  std::vector<double> distances(mesh.num_vertices());
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  const auto settled = [&](const auto& source, const std::size_t stop_at) {
    Recorder<Vertex> recorder;
    recorder.stop_at = stop_at;
    CGAL::approximate_geodesic_distances(mesh, map, source,
                                         parameters::visitor(std::ref(recorder)));
    std::vector<double> result;
    for(const auto& [v, distance] : recorder.settled)
    {
      EXPECT_EQ(distance, distances[v.idx()]);
      result.push_back(distance);
    }
    return std::make_pair(result, recorder.progress);
  };
  for(const std::size_t stop_at : {Recorder<Vertex>::never, std::size_t(50)})
    EXPECT_EQ(settled(Vertex(33), stop_at), settled(Any_point(Vertex(33)), stop_at));
}

TEST(Vertex_search, leaves_meshes_with_removed_elements_to_others)
{
  Mesh mesh = to_mesh(flat_grid(6, 6));
  mesh.remove_vertex(mesh.add_vertex(Point(7, 7, 7)));
  EXPECT_FALSE(is_read(mesh));
  std::vector<double> distances(mesh.num_vertices(), -5);
  CGAL::approximate_geodesic_distances(
      mesh, boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)),
      Vertex(0));
  EXPECT_EQ(distances[5], 5);
  EXPECT_EQ(distances[36], -5);
}

} // namespace
