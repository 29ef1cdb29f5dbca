// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>

#include "checks/expect_message.h"
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
#include <string>
#include <utility>
#include <vector>

// For searches along edges, from and to vertices, only edges are read. For those from the same
// points, of a type that could hold any points, all is.

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Any_point = AG::Surface_point<Mesh>;
using Index = Triangulation::Index;

// ----- reading

template <typename NamedParameters>
Triangulation edges_of(const Mesh& mesh, const NamedParameters& np)
{
  Triangulation result;
  AG::internal::Triangulation_builder<Mesh, NamedParameters> builder(result, mesh, np);
  if(!builder.try_to_build_edges())
    builder.build();
  return result;
}

// Returns the message of a refusal, or nothing if the mesh is accepted.
template <typename Read>
std::string refusal(const Read read)
{
  try
  {
    read();
  }
  catch(const std::invalid_argument& e)
  {
    return e.what();
  }
  return "";
}

std::string refusal_of_edges(const Mesh& mesh)
{
  return refusal([&] { edges_of(mesh, parameters::default_values()); });
}

std::string refusal_of_all(const Mesh& mesh)
{
  return refusal([&] { Triangulation{mesh}; });
}

template <typename NamedParameters>
void expect_arcs_of_triangulation(const Mesh& mesh, const NamedParameters& np)
{
  const Triangulation edges = edges_of(mesh, np), all(mesh, np);
  EXPECT_EQ(edges.unit(), all.unit());
  ASSERT_EQ(edges.number_of_vertices(), all.number_of_vertices());
  for(Index v = 0; v < all.number_of_vertices(); ++v)
  {
    const Index u = edges.vertex(all.index(v));
    ASSERT_EQ(edges.index(u), all.index(v));
    ASSERT_EQ(edges.degree(u), all.degree(v));
    for(Index i = 0; i < all.degree(v); ++i)
    {
      const Index g = edges.first_halfedge(u) + i, h = all.first_halfedge(v) + i;
      ASSERT_EQ(edges.index(edges.target(g)), all.index(all.target(h)));
      ASSERT_EQ(edges.length(g), all.length(h));
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

TEST(Vertex_search, refuses_the_same_meshes)
{
  for(const Hostile_mesh& row : refused_meshes())
  {
    EXPECT_NE(refusal_of_edges(row.mesh), "") << row.name;
    EXPECT_EQ(refusal_of_edges(row.mesh), refusal_of_all(row.mesh)) << row.name;
  }
  for(const Hostile_mesh& row : accepted_meshes())
    EXPECT_EQ(refusal_of_edges(row.mesh), "") << row.name;
}

// Gives every link of a mesh every other value in turn. `set(mesh, i, j)` sets that of the element
// `i` to `j`.
template <typename Element>
void expect_refusal_if_linked_otherwise(const std::size_t size,
                                        const std::function<Element(const Mesh&, std::size_t)>& get,
                                        const std::function<void(Mesh&, std::size_t, Element)>& set,
                                        const std::size_t number_of_values)
{
  const Mesh good = quiet_mesh();
  ASSERT_EQ(refusal_of_all(good), "");
  for(std::size_t i = 0; i < size; ++i)
    for(std::size_t j = 0; j < number_of_values; ++j)
    {
      const Element bad(static_cast<Mesh::size_type>(j));
      if(bad == get(good, i))
        continue;
      SCOPED_TRACE(testing::Message() << i << ' ' << j);
      Mesh mesh = good;
      set(mesh, i, bad);
      const std::string text = refusal_of_all(mesh);
      EXPECT_LE(text.empty(), mesh.is_valid(false));
      EXPECT_EQ(text.find("not in faces()"), std::string::npos); // a diagnosis of last resort
      EXPECT_EQ(text, refusal_of_edges(mesh));
      mesh.remove_vertex(mesh.add_vertex(Point(0, 0, 0))); // leaves a gap in the indices
      EXPECT_EQ(text, refusal_of_all(mesh));
      EXPECT_EQ(text, refusal_of_edges(mesh));
    }
}

Halfedge halfedge_of(const std::size_t i) { return Halfedge(static_cast<Mesh::size_type>(i)); }
Vertex vertex_of(const std::size_t i) { return Vertex(static_cast<Mesh::size_type>(i)); }

TEST(Vertex_search, finds_every_wrong_link)
{
  const std::size_t h = quiet_mesh().num_halfedges(), v = quiet_mesh().num_vertices(),
                    f = quiet_mesh().num_faces();
  expect_refusal_if_linked_otherwise<Halfedge>(
      h, [](const Mesh& m, const std::size_t i) { return m.next(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Halfedge g) { m.set_next_only(halfedge_of(i), g); },
      h);
  expect_refusal_if_linked_otherwise<Halfedge>(
      h, [](const Mesh& m, const std::size_t i) { return m.prev(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Halfedge g) { m.set_prev_only(halfedge_of(i), g); },
      h);
  expect_refusal_if_linked_otherwise<Vertex>(
      h, [](const Mesh& m, const std::size_t i) { return m.target(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Vertex u) { m.set_target(halfedge_of(i), u); }, v);
  expect_refusal_if_linked_otherwise<Face>(
      h, [](const Mesh& m, const std::size_t i) { return m.face(halfedge_of(i)); },
      [](Mesh& m, const std::size_t i, const Face g) { m.set_face(halfedge_of(i), g); }, f);
  expect_refusal_if_linked_otherwise<Halfedge>(
      v, [](const Mesh& m, const std::size_t i) { return m.halfedge(vertex_of(i)); },
      [](Mesh& m, const std::size_t i, const Halfedge g) { m.set_halfedge(vertex_of(i), g); }, h);
}

TEST(Vertex_search, refuses_indices_that_are_given_twice)
{
  const Mesh mesh = quiet_mesh();
  const auto vertices = boost::make_function_property_map<Vertex>(
      [](const Vertex v) { return v.idx() == 11 ? 5 : static_cast<int>(v.idx()); });
  EXPECT_THROW(edges_of(mesh, parameters::vertex_index_map(vertices)), std::invalid_argument);
  const auto halfedges = boost::make_function_property_map<Halfedge>(
      [](const Halfedge h) { return h.idx() == 11 ? 5 : static_cast<int>(h.idx()); });
  EXPECT_THROW(edges_of(mesh, parameters::halfedge_index_map(halfedges)), std::invalid_argument);
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

TEST(Vertex_search, knows_no_removed_elements)
{
  Mesh mesh = to_mesh(flat_grid(6, 6));
  mesh.remove_vertex(mesh.add_vertex(Point(7, 7, 7)));
  std::vector<double> distances(mesh.num_vertices(), -5);
  const auto map =
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  CGAL::approximate_geodesic_distances(mesh, map, Vertex(0));
  EXPECT_EQ(distances[5], 5);
  EXPECT_EQ(distances[36], -5);
  expect_message<std::invalid_argument>(
      [&] { CGAL::approximate_geodesic_distances(mesh, map, Vertex(36)); },
      "vertex 36 is not in the mesh");
}

} // namespace
