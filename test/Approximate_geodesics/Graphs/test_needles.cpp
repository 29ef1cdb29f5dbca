// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/expect_message.h"
#include "checks/test_random.h"
#include "meshes/test_meshes.h"
#include "oracles/test_oracles.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Saddle_vertex_graph.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Approximate_geodesics/Paths/Vertex_positions.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Retriangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Strips of faces that are far longer than wide: cones must not run across hundreds of them, and
// the bound has to hold with the vertices that are added there.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::Discrete_geodesic_graph;
using AG::Lazy_discrete_geodesic_graph;
using AG::internal::Refined_needles;
using AG::internal::Retriangulation;
using CGAL::parameters::epsilon;

// ----- the meshes

struct Needle_mesh
{
  std::string name;
  Soup soup;
};

// A grid whose columns go around; faces are `aspect` times as high as wide.
Soup tube(const std::size_t columns,
          const std::size_t rows,
          const double aspect,
          const double jitter = 0)
{
  const double width = 2 * CGAL_PI / static_cast<double>(columns);
  const double step = jitter * width * (std::min)(1., aspect);
  Random random(3);
  const auto moved = [&](const double x) { return x + step * random.between(-1, 1); };
  Soup result = grid(columns, rows, [&](const double i, const double j) {
    return Point(moved(std::cos(i * width)), moved(std::sin(i * width)), moved(j * width * aspect));
  });
  for(std::size_t j = 0; j + 1 < rows; ++j)
  {
    const std::size_t a = j * columns, b = a + columns, last = columns - 1;
    result.triangles.push_back({a + last, a, b});
    result.triangles.push_back({a + last, b, b + last});
  }
  return result;
}

// The outline is extruded, and closed by fans.
Soup extruded(const std::size_t size, const double height, double (*radius)(std::size_t))
{
  Soup result = tube(size, 2, 1);
  for(std::size_t i = 0; i < 2 * size; ++i)
  {
    const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(size);
    const double r = radius(i % size);
    result.points[i] = Point(r * std::cos(angle), r * std::sin(angle), i < size ? 0 : height);
  }
  result.points.push_back(Point(0, 0, 0));
  result.points.push_back(Point(0, 0, height));
  for(std::size_t i = 0; i < size; ++i)
  {
    const std::size_t j = (i + 1) % size;
    result.triangles.push_back({j, i, 2 * size});
    result.triangles.push_back({i + size, j + size, 2 * size + 1});
  }
  return result;
}

Soup helix(const std::size_t size)
{
  return grid(size, 2, [](const double i, const double j) {
    const double angle = i / 200, radius = 1 + j / 3;
    return Point(radius * std::cos(angle), radius * std::sin(angle), angle / 9);
  });
}

// Moves a vertex to a neighbor, or nearly: all faces around it are nearly degenerate then.
Soup with_sliver(Soup soup, const std::size_t from, const std::size_t to, const double part)
{
  soup.points[from] = soup.points[to] + part * (soup.points[from] - soup.points[to]);
  return soup;
}

std::vector<Needle_mesh> needle_meshes()
{
  const auto round = [](std::size_t) { return 1.; };
  const auto teeth = [](const std::size_t i) { return i / 5 % 2 == 0 ? 1. : 1.2; };
  return {
      {"wide tube", tube(200, 5, 40)},
      {"wide tube, uneven", tube(200, 5, 40, 0.3)},
      {"tall tube", tube(6, 200, 1. / 60)},
      {"tall tube, uneven", tube(6, 200, 1. / 60, 0.3)},
      {"wide tube, thin sliver", with_sliver(tube(200, 5, 40, 0.3), 500, 501, 1e-9)},
      {"wide tube, two vertices at the same place", with_sliver(tube(200, 5, 40), 500, 501, 0)},
      {"tall tube, thin sliver", with_sliver(tube(6, 200, 1. / 60, 0.3), 600, 606, 1e-7)},
      {"short strip",
       grid(220, 2, [](const double i, const double j) { return Point(i, 60 * j, 0); })},
      {"strip", grid(700, 2, [](const double i, const double j) { return Point(i, 99 * j, 0); })},
      {"slanted strip",
       grid(700, 2, [](const double i, const double j) { return Point(i + 99 * j, 50 * j, 0); })},
      {"helix", helix(800)},
      {"prism", extruded(300, 3, round)},
      {"gear", extruded(300, 3, teeth)}};
}

AG::Vertex_positions positions_of(const Mesh& mesh, const Triangulation& t)
{
  return AG::Vertex_positions(t, [&](const Node v) {
    const Point& p = mesh.point(Vertex(static_cast<Mesh::size_type>(t.index(v))));
    return AG::Vertex_positions::Position{p.x(), p.y(), p.z()};
  });
}

// ----- the triangulation

TEST(Needles, are_refined_to_another_triangulation_of_the_same_surface)
{
  for(const Needle_mesh& m : needle_meshes())
  {
    SCOPED_TRACE(m.name);
    const Triangulation mesh(to_mesh(m.soup));
    ASSERT_TRUE(Refined_needles::are_useful(mesh));
    const Retriangulation needles = *Retriangulation::make(mesh);
    const Triangulation& t = needles.triangulation();
    EXPECT_TRUE(t.is_valid());
    EXPECT_NO_THROW(t.check_triangle_inequality());
    EXPECT_GT(t.number_of_vertices(), mesh.number_of_vertices());
    EXPECT_LE(t.number_of_vertices(), 2 * mesh.number_of_vertices());
    for(Node v = mesh.number_of_vertices(); v < t.number_of_vertices(); ++v)
      EXPECT_TRUE(needles.position(v).is_valid(mesh));
    EXPECT_FALSE(needles.has_balanced_fans());
  }
}

// An edge cannot be shorter than the straight line between its ends.
TEST(Needles, have_added_vertices_where_they_say)
{
  for(const Needle_mesh& m : needle_meshes())
  {
    SCOPED_TRACE(m.name);
    const Mesh surface = to_mesh(m.soup);
    const Triangulation mesh(surface);
    const Retriangulation needles = *Retriangulation::make(mesh);
    const Triangulation& t = needles.triangulation();
    const AG::Vertex_positions positions = positions_of(surface, mesh);
    const auto place = [&](const Node v) {
      return positions.relative_to({}, mesh, needles.position(v));
    };
    for(Node h = 0; h < t.number_of_halfedges(); ++h)
      EXPECT_LE(AG::internal::distance(place(t.source(h)), place(t.target(h))),
                t.length(h) * (1 + 1e-9));
  }
}

// Where flips end early, the triangulation is another one, and no worse a surface.
TEST(Needles, are_refined_with_few_flips)
{
  for(const Needle_mesh& m : needle_meshes())
    for(const std::size_t most_flips : {std::size_t(0), std::size_t(100)})
    {
      SCOPED_TRACE(m.name);
      const Triangulation mesh(to_mesh(m.soup));
      const Retriangulation needles(mesh, true, most_flips);
      EXPECT_TRUE(needles.triangulation().is_valid());
      EXPECT_NO_THROW(needles.triangulation().check_triangle_inequality());
      std::size_t number = 0;
      for(Node h = 0; h < mesh.number_of_halfedges(); ++h)
        number += needles.is_lost(h) ? 1 : 0;
      EXPECT_TRUE(needles.has_balanced_fans() || number <= 2 * most_flips);
    }
}

// A pole, a lid of which is drawn out so far that its faces are nearly degenerate.
TEST(Needles, are_refined_beside_balanced_fans)
{
  const auto round = [](std::size_t) { return 1.; };
  Soup soup = extruded(400, 3, round);
  soup.points[800] = Point(0, 0, -300);
  const Triangulation mesh(to_mesh(soup));
  const Retriangulation other = *Retriangulation::make(mesh);
  EXPECT_TRUE(other.has_balanced_fans());
  EXPECT_TRUE(other.has_refined_needles());
  EXPECT_TRUE(other.triangulation().is_valid());
  for(Node v = 0; v < other.triangulation().number_of_vertices(); ++v)
    EXPECT_LE(other.triangulation().degree(v), AG::internal::Balanced_fans::LARGEST_DEGREE);
}

TEST(Needles, are_left_alone_where_they_are_few)
{
  const Triangulation mesh(to_mesh(tube(40, 40, 1)));
  const AG::internal::Cone_triangulation cones(mesh);
  EXPECT_EQ(&cones.get(), &cones.mesh());
}

// ----- what they cost

struct Windows : AG::internal::Leave_out_detours
{
  bool prune(const AG::internal::Window&) const
  {
    ++number;
    return false;
  }
  std::size_t& number;
};

double windows_per_vertex(const Soup& soup)
{
  const Triangulation mesh(to_mesh(soup));
  const AG::internal::Cone_triangulation cones(mesh);
  const Triangulation& t = cones.get();
  const AG::internal::Unfolding unfolding(t);
  const AG::internal::Cone_expansion<AG::internal::Unfolding> expansion(
      t, unfolding, AG::internal::Cone_rules(0.1));
  std::size_t result = 0;
  for(Node v = 0; v < t.number_of_vertices(); ++v)
    expansion.expand(
        v, [](const AG::internal::Straight_arc&) {}, Windows{{}, result});
  return static_cast<double>(result) / mesh.number_of_vertices();
}

TEST(Needles, cost_a_vertex_nearly_the_same_however_long_they_are)
{
  constexpr double most = 800; // about 180 on an ordinary mesh
  for(const double aspect : {50., 200., 1000.})
    for(const double jitter : {0., 0.3})
      EXPECT_LT(windows_per_vertex(tube(1500, 4, aspect, jitter)), most) << aspect;
  EXPECT_LT(windows_per_vertex(tube(6, 1000, 1. / 60)), most);
  EXPECT_LT(windows_per_vertex(tube(6, 1000, 1. / 600)), most);
}

// ----- the bound

template <typename Graph>
void expect_bound(const Graph& graph,
                  const Node source,
                  const std::vector<double>& exact,
                  const double e)
{
  AG::Propagation<Graph> search(graph);
  search.run_from(source);
  for(Node v = 0; v < exact.size(); ++v)
  {
    EXPECT_GE(search.distance(v), exact[v] * (1 - 1e-11)) << "at vertex " << v;
    EXPECT_LE(search.distance(v), exact[v] * (1 + e)) << "at vertex " << v;
  }
}

TEST(Needles, have_the_bound)
{
  for(const Needle_mesh& m : needle_meshes())
  {
    SCOPED_TRACE(m.name);
    const Triangulation t(to_mesh(m.soup));
    const AG::Saddle_vertex_graph exact_graph(t);
    AG::Propagation<AG::Saddle_vertex_graph> search(exact_graph);
    const std::array<Node, 2> sources{t.vertex(0), t.vertex(m.soup.points.size() / 3)};
    std::array<std::vector<double>, 2> exact;
    for(std::size_t i = 0; i < 2; ++i)
    {
      search.run_from(sources[i]);
      for(Node v = 0; v < t.number_of_vertices(); ++v)
        exact[i].push_back(search.distance(v));
    }
    for(const double e : {1., 0.3, 0.1, 0.01})
    {
      const Discrete_geodesic_graph built(t, epsilon(e));
      const Lazy_discrete_geodesic_graph lazy(t, epsilon(e));
      EXPECT_TRUE(built.is_valid());
      for(std::size_t i = 0; i < 2; ++i)
      {
        expect_bound(built, sources[i], exact[i], e);
        expect_bound(lazy, sources[i], exact[i], e);
      }
    }
  }
}

// Edges that are in the mesh only are arcs, too. Those of a built graph are rounded up.
TEST(Needles, have_distances_not_above_those_along_edges)
{
  constexpr double rounding_up = 1 + 1. / (1 << 23);
  for(const Needle_mesh& m : needle_meshes())
    for(const double e : {1., 0.1})
    {
      SCOPED_TRACE(m.name);
      const Triangulation t(to_mesh(m.soup));
      const AG::Edge_graph edges(t);
      const Discrete_geodesic_graph built(t, epsilon(e));
      const Lazy_discrete_geodesic_graph lazy(t, epsilon(e));
      AG::Propagation<AG::Edge_graph> along_edges(edges);
      AG::Propagation<Discrete_geodesic_graph> stored(built);
      AG::Propagation<Lazy_discrete_geodesic_graph> searched(lazy);
      const Node source = t.vertex(m.soup.points.size() / 3);
      along_edges.run_from(source);
      stored.run_from(source);
      searched.run_from(source);
      for(Node v = 0; v < t.number_of_vertices(); ++v)
      {
        EXPECT_LE(searched.distance(v), along_edges.distance(v)) << "at vertex " << v;
        EXPECT_LE(stored.distance(v), along_edges.distance(v) * rounding_up) << "at vertex " << v;
      }
    }
}

TEST(Needles, have_the_same_graph_lazily_and_from_a_file)
{
  const Triangulation t(to_mesh(tube(200, 5, 40, 0.3)));
  const Discrete_geodesic_graph built(t, epsilon(0.1));
  std::stringstream file;
  built.save(file);
  const Discrete_geodesic_graph read = Discrete_geodesic_graph::load(file, t);
  EXPECT_TRUE(read.is_valid());
  const Lazy_discrete_geodesic_graph kept(t, epsilon(0.1),
                                          Lazy_discrete_geodesic_graph::Arcs::KEPT);
  AG::Propagation<Discrete_geodesic_graph> search(built), search_of_file(read);
  AG::Propagation<Lazy_discrete_geodesic_graph> search_of_kept(kept);
  search.run_from(9);
  search_of_file.run_from(9);
  search_of_kept.run_from(9);
  for(Node v = 0; v < built.number_of_nodes(); ++v)
  {
    EXPECT_EQ(search_of_file.distance(v), search.distance(v));
    EXPECT_EQ(search_of_kept.distance(v), search.distance(v));
  }
}

// The file tells where its nodes are. A mesh without needles has the same number of vertices.
TEST(Needles, have_a_file_that_is_refused_for_other_nodes)
{
  const Triangulation mesh(to_mesh(tube(200, 5, 40, 0.3)));
  const Retriangulation needles = *Retriangulation::make(mesh), others(mesh, true, 100),
                        none(mesh, false, 0);
  const AG::internal::Compressed_arcs no_arcs(AG::internal::unit_of_arcs(mesh));
  std::stringstream file;
  AG::internal::Arc_file::save(AG::internal::bytes_to(file), mesh, needles.triangulation(), 0.1,
                               no_arcs);
  const auto load = [&](const Triangulation& nodes) {
    std::stringstream copy(file.str());
    double e;
    AG::internal::Compressed_arcs arcs;
    AG::internal::Arc_file::load(AG::internal::bytes_from(copy), mesh, nodes, e, arcs);
  };
  expect_message<std::invalid_argument>([&] { load(none.triangulation()); }, "this version makes");
  expect_message<std::invalid_argument>([&] { load(others.triangulation()); },
                                        "this version makes");
}

// ----- paths

TEST(Needles, have_no_lines_of_other_lengths)
{
  const Triangulation mesh(to_mesh(tube(200, 5, 40)));
  const auto expect_none = [&](const AG::Intrinsic_point& a, const AG::Intrinsic_point& b) {
    const AG::internal::Cones_of_point lines(mesh, AG::internal::Cone_rules(1e-300), a);
    AG::internal::Line_search line(0.9 * mesh.length(0));
    lines.consider_lines_in_faces(b, line);
    using Any = AG::internal::Within_reach<AG::internal::Leave_out_nothing_in_doubt>;
    lines.find_line(b, Any{{}, line.reach()}, line);
    EXPECT_FALSE(line.is_found());
  };
  const auto start = AG::Intrinsic_point::at_vertex(mesh.source(0)),
             end = AG::Intrinsic_point::at_vertex(mesh.target(0)),
             beside = AG::Intrinsic_point::on_edge(mesh.next(mesh.next(0)), 0.001);
  expect_none(start, end);
  expect_none(start, beside);
  expect_none(beside, end);
  const auto trace = [&] {
    AG::internal::Cone_triangulation(mesh).trace<AG::internal::Leave_out_detours>(
        AG::internal::Cone_rules(0.1), start.vertex, end.vertex, 0.9 * mesh.length(0), 0,
        [](Node, double) {});
  };
  expect_message<std::invalid_argument>(trace, "an arc of length");
}

// A search of all that is within reach would find them as well, but crosses a strip of needles.
TEST(Needles, have_arcs_that_are_found_by_their_direction)
{
  for(const Needle_mesh& m : needle_meshes())
  {
    SCOPED_TRACE(m.name);
    const Triangulation mesh(to_mesh(m.soup));
    const Retriangulation needles = *Retriangulation::make(mesh);
    const Triangulation& t = needles.triangulation();
    const AG::internal::Unfolding unfolding(t);
    const AG::internal::Cone_expansion<AG::internal::Unfolding> expansion(
        t, unfolding, AG::internal::Cone_rules(0.1));
    std::size_t number = 0, number_found = 0;
    for(Node v = 0; v < t.number_of_vertices(); v += 7)
      expansion.expand(v, [&](const AG::internal::Straight_arc& arc) {
        const AG::Intrinsic_point end = needles.position(arc.target);
        const AG::internal::Lines_by_direction lines(mesh, AG::internal::Cone_rules(1e-300),
                                                     needles.position(v));
        AG::internal::Line_search line(arc.length);
        lines.consider_lines_in_faces(end, line);
        if(!line.is_found())
          lines.find_arc(needles, v, arc, end, line);
        ++number;
        number_found += line.is_found() ? 1 : 0;
      });
    EXPECT_GE(static_cast<double>(number_found), 0.999 * static_cast<double>(number));
  }
}

// Lines around either side of a thin slab, from a corner to the opposite one, differ in length by
// less than lengths in single precision do. The path of an arc is the shorter one.
TEST(Needles, have_paths_in_a_built_graph_that_are_not_longer_than_the_distance)
{
  Random random(test_seed());
  for(int i = 0; i < 200; ++i)
  {
    const double thickness = std::pow(10., -random.between(6, 8)), width = random.between(1, 2);
    const auto corner = [&](const std::size_t j) {
      return Point(j & 1, j & 2 ? width : 0, j & 4 ? thickness : 0);
    };
    Soup slab;
    for(std::size_t j = 0; j < 8; ++j)
      slab.points.push_back(corner(j));
    slab.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    const Triangulation t(to_mesh(slab));
    const Discrete_geodesic_graph graph(t, epsilon(0.1));
    AG::Surface_search<Discrete_geodesic_graph> search(graph);
    search.run({{AG::Intrinsic_point::at_vertex(t.vertex(0))}});
    for(Node v = 0; v < t.number_of_vertices(); ++v)
    {
      const auto end = AG::Intrinsic_point::at_vertex(v);
      EXPECT_LE(search.find_path(end).length, search.distance(end) * (1 + 1e-14));
    }
  }
}

// The points of a path, in space, are as far apart as its length says.
template <typename Graph>
void expect_paths(const Mesh& mesh, const double tolerance)
{
  const Triangulation t(mesh);
  const Graph graph(t, epsilon(0.1));
  const AG::Vertex_positions positions = positions_of(mesh, t);
  AG::Surface_search<Graph> search(graph);
  const Node source = t.vertex(1);
  search.run({{AG::Intrinsic_point::at_vertex(source)}});
  for(Node v = 0; v < t.number_of_vertices(); v += 1 + t.number_of_vertices() / 29)
  {
    const AG::Path path = search.find_path(AG::Intrinsic_point::at_vertex(v));
    double length = 0;
    for(std::size_t i = 1; i < path.points.size(); ++i)
      length += t.unit() * AG::internal::distance(positions.relative_to({}, t, path.points[i - 1]),
                                                  positions.relative_to({}, t, path.points[i]));
    const double expected = search.search().distance(v);
    EXPECT_NEAR(path.length, expected, tolerance * expected) << "to vertex " << v;
    EXPECT_NEAR(length, expected, tolerance * expected) << "to vertex " << v;
  }
}

TEST(Needles, have_paths_on_the_mesh)
{
  constexpr double rounding = 1e-9, rounding_of_arcs = 1e-6;
  for(const Needle_mesh& m : needle_meshes())
  {
    SCOPED_TRACE(m.name);
    expect_paths<Lazy_discrete_geodesic_graph>(to_mesh(m.soup), rounding);
    expect_paths<Discrete_geodesic_graph>(to_mesh(m.soup), rounding_of_arcs);
  }
}

// A length of an arc is a difference of labels, which are rounded.
template <typename Graph>
void expect_paths_from_afar(const double distance_of_source)
{
  const Triangulation t(to_mesh(tube(200, 5, 40)));
  const Graph graph(t, epsilon(0.1));
  AG::Surface_search<Graph> search(graph);
  const double rounding = 1e-12 * distance_of_source;
  for(const AG::Intrinsic_point& source :
      {AG::Intrinsic_point::at_vertex(t.vertex(1)),
       AG::Intrinsic_point::in_face(t.first_halfedge(t.vertex(300)), 0.3, 0.3)})
  {
    search.run({{source, distance_of_source}});
    for(Node v = 0; v < t.number_of_vertices(); v += 29)
    {
      const AG::Intrinsic_point end = AG::Intrinsic_point::at_vertex(v);
      const double distance = search.distance(end) - distance_of_source;
      EXPECT_NEAR(search.find_path(end).length, distance, 1e-6 * distance + rounding);
    }
  }
}

TEST(Needles, have_paths_from_sources_with_large_distances)
{
  for(const double distance : {1e8, 1e10, 1e12})
  {
    expect_paths_from_afar<Lazy_discrete_geodesic_graph>(distance);
    expect_paths_from_afar<Discrete_geodesic_graph>(distance);
  }
}

} // namespace
