// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Queries/internal/Mesh_search.h>

#include "checks/expect_message.h"
#include "checks/parts_of_meshes.h"
#include "checks/test_recorder.h"
#include "meshes/hostile_meshes.h"
#include "meshes/surface_points.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/approximate_geodesic_path.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// The functions read only a part of a mesh where that is enough. A visitor makes them read it all.

namespace {

using namespace geodesics_test;
namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using Part = AG::internal::Mesh_part<Mesh>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// ----- the part

// Links that fit each other, and borders where neither the mesh nor the part has a face.
void expect_mesh_in_mesh(const Part& part)
{
  const Mesh& mesh = whole(part);
  for(const Halfedge h : halfedges(part))
  {
    ASSERT_EQ(prev(next(h, part), part), h);
    ASSERT_EQ(next(prev(h, part), part), h);
    ASSERT_EQ(source(next(h, part), part), target(h, part));
    ASSERT_TRUE(part.contains(opposite(h, part)));
    const bool is_at_border = face(h, part) == Mesh::null_face();
    ASSERT_TRUE(is_at_border || face(h, part) == mesh.face(h));
  }
  const Triangulation t(part);
  EXPECT_TRUE(t.is_valid());
  EXPECT_EQ(t.number_of_vertices(), num_vertices(part));
  EXPECT_EQ(t.number_of_faces(), num_faces(part));
}

TEST(Part_of_mesh, is_a_mesh)
{
  Random random(test_seed());
  for(const auto& [name, mesh] : large_meshes())
  {
    SCOPED_TRACE(name);
    std::size_t number_of_parts = 0;
    for(int i = 0; i < 100; ++i)
    {
      const Surface_point source = random_surface_point(mesh, random);
      const Surface_point target = random_target(mesh, source, random);
      if(const auto part = part_between(mesh, source, target, parameters::epsilon(0)))
      {
        ++number_of_parts;
        EXPECT_LT(num_faces(*part), mesh.number_of_faces() / 4 + 1);
        expect_mesh_in_mesh(*part);
      }
    }
    EXPECT_GT(number_of_parts, 20u);
  }
}

// Messages name vertices by their indices in the mesh.
TEST(Part_of_mesh, is_refused_where_a_line_cannot_be_traced)
{
  const Mesh mesh = to_mesh(flat_grid(3, 2));
  Part part(mesh);
  ASSERT_TRUE(part.add_face(mesh.halfedge(*mesh.faces().begin())));
  ASSERT_TRUE(part.close());
  const auto fail = [](auto&) { throw AG::internal::Untraceable_line("vertex 0"); };
  const auto np = parameters::epsilon(0);
  EXPECT_FALSE(AG::internal::search_once<Vertex>(part, np, true, fail));
  EXPECT_THROW(AG::internal::search_once<Vertex>(mesh, np, true, fail), std::invalid_argument);
}

// ----- distances

// `bound` is where distances may be within or not, by rounding.
void expect_same_distances(const Mesh& mesh,
                           const std::vector<double>& distances,
                           const std::vector<double>& expected,
                           const double bound)
{
  for(std::size_t i = 0; i < expected.size(); ++i)
    if(std::isinf(distances[i]) != std::isinf(expected[i]))
    {
      EXPECT_NEAR((std::min)(distances[i], expected[i]), bound,
                  rounding_of_lengths * (bound + size(mesh)));
    }
    else
      expect_same_length(distances[i], expected[i], mesh);
}

TEST(Part_of_mesh, has_the_distances_within_a_radius)
{
  Random random(test_seed());
  const AG::Geodesic_visitor_base visitor;
  for(const auto& [name, mesh] : large_meshes())
  {
    SCOPED_TRACE(name);
    std::size_t number_of_parts = 0;
    for(int i = 0; i < 20; ++i)
    {
      const auto sources = random_surface_points(mesh, 1 + random.below(3), random);
      std::vector<double> initial;
      for(std::size_t k = 0; k < sources.size(); ++k)
        initial.push_back(random.between(0, 0.03) * size(mesh));
      const double radius = random.between(0, 0.07) * size(mesh);
      const auto exact = parameters::epsilon(0).initial_distances(initial).maximum_distance(radius);
      number_of_parts += AG::internal::Part_to_read(mesh, exact).around(sources) ? 1 : 0;
      expect_same_distances(mesh, distances_from(mesh, sources, exact),
                            distances_from(mesh, sources, exact.visitor(visitor)), radius);
      const auto edges = parameters::initial_distances(initial).maximum_distance(radius);
      expect_same_distances(mesh, distances_from(mesh, sources, edges),
                            distances_from(mesh, sources, edges.visitor(visitor)), radius);
    }
    EXPECT_GT(number_of_parts, 5u);
  }
}

TEST(Part_of_mesh, has_all_other_results)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(100, 200, random));
  const std::vector<Vertex> sources = {Vertex(10050), Vertex(10053), Vertex(10152)};
  std::vector<int> source(mesh.num_vertices(), -7);
  std::vector<Vertex> before(mesh.num_vertices());
  const auto index_map = get(boost::vertex_index, mesh);
  const auto np =
      parameters::epsilon(0)
          .maximum_distance(5)
          .nearest_source_map(boost::make_iterator_property_map(source.begin(), index_map))
          .predecessor_map(boost::make_iterator_property_map(before.begin(), index_map));
  ASSERT_TRUE(AG::internal::Part_to_read(mesh, np).around(sources));
  const std::vector<double> distances = distances_from(mesh, sources, np);
  std::size_t number_of_reached = 0;
  for(const Vertex v : mesh.vertices())
    if(std::isinf(distances[v.idx()]))
    {
      EXPECT_EQ(source[v.idx()], -1);
      EXPECT_EQ(before[v.idx()], Mesh::null_vertex());
    }
    else
    {
      ASSERT_TRUE(source[v.idx()] >= 0 && source[v.idx()] < 3);
      const Vertex from = sources[std::size_t(source[v.idx()])];
      if(number_of_reached++ % 4 == 0) // as each path reads the whole mesh
        expect_same_length(length_of_path(mesh, from, v, without_part(0)), distances[v.idx()],
                           mesh);
      EXPECT_LE(distances[before[v.idx()].idx()], distances[v.idx()]);
    }
  EXPECT_GT(number_of_reached, 50u);
}

// Distances near the last target depend on what was read.
TEST(Part_of_mesh, is_not_enough_for_targets)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(60, 50, random));
  const Vertex source(1530);
  const std::vector<Vertex> targets = {Vertex(1532), Vertex(1652)};
  const auto np = parameters::epsilon(0.1).maximum_distance(5).targets(targets);
  EXPECT_EQ(distances_from(mesh, source, np),
            distances_from(mesh, source, np.visitor(AG::Geodesic_visitor_base())));
}

// ----- threads

TEST(Part_of_mesh, is_searched_by_several_threads)
{
  const CGAL::Parallel_if_available_tag several;
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(130, 120, random));
  const Vertex s(7865), t(8395);
  for(const double epsilon : {0., 0.1})
  {
    const auto np = parameters::epsilon(epsilon);
    ASSERT_TRUE(part_between(mesh, s, t, np.concurrency_tag(several)));
    EXPECT_EQ(length_of_path(mesh, s, t, np.concurrency_tag(several)),
              length_of_path(mesh, s, t, np));
    const auto near = np.maximum_distance(5);
    ASSERT_TRUE(AG::internal::Part_to_read(mesh, near.concurrency_tag(several)).around(s));
    EXPECT_EQ(distances_from(mesh, s, near.concurrency_tag(several)),
              distances_from(mesh, s, near));
  }
}

// ----- other meshes and numbers

TEST(Part_of_mesh, is_one_of_a_polyhedron)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(60, 50, random));
  Polyhedron polyhedron;
  std::vector<std::pair<Vertex, Polyhedron::Vertex_handle>> pairs;
  CGAL::copy_face_graph(
      mesh, polyhedron,
      CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(pairs)));
  const auto np = parameters::epsilon(0.1);
  for(std::size_t i = 0; i + 7 < pairs.size(); i += 100)
  {
    const auto& [s, source] = pairs[i];
    const auto& [t, target] = pairs[i + 7];
    std::vector<Point> points;
    const double length =
        CGAL::approximate_geodesic_path(polyhedron, std::back_inserter(points), source, target, np);
    ASSERT_FALSE(points.empty());
    EXPECT_EQ(points.front(), mesh.point(s));
    EXPECT_EQ(points.back(), mesh.point(t));
    const double exact = length_of_path(mesh, s, t, without_part(0));
    EXPECT_GE(length, exact * (1 - rounding_of_lengths));
    EXPECT_LE(length, 1.1 * exact);
    EXPECT_EQ(part_between(polyhedron, source, target, np).has_value(),
              part_between(mesh, s, t, np).has_value());
  }
}

TEST(Part_of_mesh, is_right_for_coordinates_of_any_size)
{
  Random random(test_seed());
  const Soup soup = terrain(50, 50, random);
  const Vertex a(1200), b(1305);
  const double expected = bare_length(to_mesh(soup), a, b, without_part(0));
  for(const double factor : {1e-310, 1e-300, 1e-160, 1e100, 1e160, 1e300})
  {
    SCOPED_TRACE(factor);
    const Mesh mesh = to_mesh(scaled(soup, factor));
    const double whole = bare_length(mesh, a, b, without_part(0));
    EXPECT_NEAR(bare_length(mesh, a, b, parameters::epsilon(0)) / whole, 1, rounding_of_lengths);
    EXPECT_NEAR(whole / factor / expected, 1, factor < 1e-305 ? 1e-9 : rounding_of_lengths);
  }
  const Mesh far_away = to_mesh(moved(soup, 1e8));
  EXPECT_NEAR(bare_length(far_away, a, b, parameters::epsilon(0)),
              bare_length(far_away, a, b, without_part(0)), rounding_of_lengths * expected);
}

// ----- bad input

TEST_F(Bad_part, is_refused_where_it_is_read)
{
  const auto with_point_at = [&](const Vertex v, const double x) {
    return with_point(m_mesh, v.idx(), Point(x, 0, 0));
  };
  expect_rejection(with_point_at(at(11, 10), not_a_number),
                   "vertex " + std::to_string(11 + n * 10));
  expect_rejection(with_point_at(at(11, 10), infinity), "vertex " + std::to_string(11 + n * 10));
  for(const double bad : {not_a_number, infinity})
    EXPECT_EQ(bare_length(with_point_at(at(40, 40), bad), near, near_too, parameters::epsilon(0)),
              2);
}

TEST_F(Bad_part, is_refused_if_links_are_broken_where_it_is_read)
{
  const Halfedge h = m_mesh.halfedge(at(11, 10), at(12, 10));
  Mesh one_way = m_mesh;
  one_way.set_next(m_mesh.opposite(h), m_mesh.next(h));
  expect_rejection(one_way);
  Mesh no_halfedge = m_mesh;
  no_halfedge.set_halfedge(m_mesh.face(h), Mesh::null_halfedge());
  expect_rejection(no_halfedge, "has no halfedge");
  Mesh no_target = m_mesh;
  no_target.set_target(h, Mesh::null_vertex());
  expect_rejection(no_target);
  Mesh other_face = m_mesh;
  other_face.set_face(h, Face(0));
  expect_rejection(other_face);
}

// The message has the numbers of the whole mesh.
TEST_F(Bad_part, is_refused_if_a_face_of_it_is_too_small)
{
  for(const Vertex v : m_mesh.vertices())
    m_mesh.point(v) = Point(m_mesh.point(v).x() - 10, m_mesh.point(v).y() - 10, 0);
  m_mesh.point(at(11, 10)) = Point(1e-140, 0, 0);
  m_mesh.point(at(11, 11)) = Point(0, 1e-140, 0);
  const auto number = [](const Vertex v) { return std::to_string(v.idx()); };
  for(const double epsilon : {0., 0.1})
    expect_message<std::invalid_argument>(
        [&] { bare_length(m_mesh, near, near_too, parameters::epsilon(epsilon)); }, "too small",
        number(near), number(at(11, 10)), number(at(11, 11)));
}

// The walk around a vertex from one border of the part to the next enters a cycle outside of it.
TEST_F(Bad_part, is_refused_if_its_border_leads_into_a_cycle)
{
  const auto halfedges = CGAL::halfedges_around_target(near, m_mesh);
  const std::vector<Halfedge> incoming(halfedges.begin(), halfedges.end());
  ASSERT_EQ(incoming.size(), 6u);
  const auto is_part_of_one_face = [&](const Mesh& mesh) {
    Part part(mesh);
    return part.add_face(incoming[0]) && part.close();
  };
  EXPECT_TRUE(is_part_of_one_face(m_mesh));
  m_mesh.set_next(incoming[4], m_mesh.next(incoming[2]));
  EXPECT_FALSE(is_part_of_one_face(m_mesh));
}

// Every link around the path to every other value nearby: refused, or as if all were read.
TEST_F(Bad_part, never_makes_it_hang)
{
  const auto halfedges = CGAL::halfedges_around_source(near, m_mesh);
  for(const Halfedge h : halfedges)
    for(const Halfedge g : halfedges)
      for(const bool is_opposite : {false, true})
      {
        Mesh mesh = m_mesh;
        mesh.set_next(h, is_opposite ? mesh.opposite(g) : g);
        std::string whole = "accepted", part = "accepted";
        try
        {
          length_of_path(mesh, near, near_too, without_part(0));
        }
        catch(const std::invalid_argument& e)
        {
          whole = e.what();
        }
        try
        {
          length_of_path(mesh, near, near_too, parameters::epsilon(0));
        }
        catch(const std::invalid_argument& e)
        {
          part = e.what();
        }
        EXPECT_EQ(part, whole);
      }
}

TEST_F(Bad_part, has_places_or_numbers_that_are_none)
{
  const auto expect_rejected = [&](const auto& source, const auto& np) {
    EXPECT_THROW(length_of_path(m_mesh, source, near, np), std::invalid_argument);
    EXPECT_THROW(length_of_path(m_mesh, near, source, np), std::invalid_argument);
    EXPECT_THROW(distances_from(m_mesh, source, np), std::invalid_argument);
  };
  const auto np = parameters::epsilon(0.1).maximum_distance(2);
  expect_rejected(Mesh::null_vertex(), np);
  expect_rejected(Vertex(n * n), np);
  expect_rejected(Face_location(Mesh::null_face(), {0.2, 0.3, 0.5}), np);
  expect_rejected(Face_location(Face(100000), {0.2, 0.3, 0.5}), np);
  expect_rejected(Face_location(Face(7), {0.2, 0.3, 0.6}), np);
  expect_rejected(Face_location(Face(7), {not_a_number, 0.5, 0.5}), np);
  expect_rejected(Edge_location(Halfedge(7), 1.5), np);
  expect_rejected(Edge_location(Mesh::null_halfedge(), 0.5), np);
  expect_rejected(near_too, parameters::epsilon(0.1).maximum_distance(-1));
  expect_rejected(near_too, parameters::epsilon(0.1).maximum_distance(not_a_number));
  expect_rejected(near_too, parameters::epsilon(-0.1).maximum_distance(2));
  expect_rejected(near_too, parameters::epsilon(not_a_number).maximum_distance(2));
  const std::vector<double> bad = {-1.};
  EXPECT_THROW(distances_from(m_mesh, near, np.initial_distances(bad)), std::invalid_argument);
}

TEST_F(Bad_part, was_removed)
{
  const Vertex a = m_mesh.add_vertex(Point(9, 9, 0)), b = m_mesh.add_vertex(Point(10, 9, 0)),
               c = m_mesh.add_vertex(Point(10, 10, 0));
  const Face f = m_mesh.add_face(a, b, c);
  const Halfedge h = m_mesh.halfedge(f);
  CGAL::Euler::remove_face(h, m_mesh);
  ASSERT_TRUE(m_mesh.is_removed(a) && m_mesh.is_removed(f));
  const auto np = parameters::epsilon(0.1);
  EXPECT_THROW(length_of_path(m_mesh, a, b, np), std::invalid_argument);
  EXPECT_THROW(length_of_path(m_mesh, Face_location(f, {0.2, 0.3, 0.5}), near, np),
               std::invalid_argument);
  EXPECT_EQ(length_of_path(m_mesh, near, near_too, np), 2);
}

} // namespace
