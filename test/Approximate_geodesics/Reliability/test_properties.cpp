// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Properties.h"
#include "meshes/random_soups.h"
#include "oracles/test_oracles.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace geodesics_test;

// ----- what one graph says

TEST_P(Properties, symmetry)
{
  for_each_method([&](const Method& m, const Searcher& distances) {
    const Vertex s = random_source();
    const Values from = distances({{s}});
    for(const Vertex t : random_sources(8))
      expect_close({distances({{t}})[s]}, {from[t]}, m.asymmetry);
  });
}

TEST_P(Properties, triangle_inequality)
{
  for_each_method([&](const Method& m, const Searcher& distances) {
    const Vertex s = random_source();
    const Values from = distances({{s}});
    for(const Vertex middle : random_sources(4))
    {
      Values limit = distances({{middle}});
      for(double& d : limit)
        d += from[middle];
      expect_at_most(from, limit, m.asymmetry);
    }
  });
}

TEST_P(Properties, distances_grow_by_no_more_than_an_edge)
{
  const Values lengths = edge_lengths(m_mesh);
  for_each_method([&](const Method& m, const Searcher& distances) {
    const Values from = distances({{random_source()}});
    for(const Halfedge h : m_mesh.halfedges())
      EXPECT_LE(from[m_mesh.target(h)],
                (from[m_mesh.source(h)] + lengths[m_mesh.edge(h)]) * (1 + m.rounding_of_arcs));
  });
}

TEST_P(Properties, several_sources_give_the_minimum)
{
  for_each_method([&](const Method& m, const Searcher& distances) {
    Vertices sources = random_sources(4);
    Values expected(m_mesh.number_of_vertices(), infinity);
    for(const Vertex s : sources)
      expected = minimum(expected, distances({{s}}));
    expect_close(distances({sources}), expected, m.deviation);
    sources.insert(sources.end(), {sources[2], sources[0]});
    m_random.shuffle(sources);
    expect_close(distances({sources}), expected, m.deviation);
  });
}

// What was reached is certain, also if the object was used before.
TEST_P(Properties, early_stops_change_nothing)
{
  for_each_method([&](const Method& m, const Searcher& distances) {
    const Vertex s = random_source(), t = random_source();
    const Values all = distances({{s}});
    const double limit = all[random_source()];
    const Values within = distances({{s}, limit});
    const Values to_target = distances({{s}, infinity, {t}});
    expect_close({to_target[t]}, {all[t]}, m.deviation);
    for(std::size_t i = 0; i < all.size(); ++i)
    {
      if(m.deviation == 0)
      {
        EXPECT_EQ(within[i], all[i] <= limit ? all[i] : infinity);
      }
      if(within[i] < infinity)
        expect_close({within[i]}, {all[i]}, m.deviation);
      if(to_target[i] < infinity)
        expect_close({to_target[i]}, {all[i]}, m.deviation);
    }
    expect_close(distances({{s}}), all, m.deviation);
  });
}

// But for the rounding of a sum of roots.
TEST_P(Properties, no_path_along_edges_is_shorter_than_a_straight_line)
{
  const Vertex s = random_source();
  const Values from = Mesh_search(m_mesh).distances({s});
  const double roundings = static_cast<double>(m_mesh.number_of_vertices() + 4);
  for(const Vertex v : m_mesh.vertices())
  {
    const double line = std::sqrt(CGAL::squared_distance(m_mesh.point(v), m_mesh.point(s)));
    EXPECT_GE(from[v], line * (1 - roundings * 0x1p-53)) << v;
  }
}

// ----- one graph and another

TEST_P(Properties, distances_of_all_graphs_are_within_their_bounds)
{
  const Vertex s = random_source();
  std::vector<Values> all;
  for_each_method(
      [&](const Method&, const Searcher& distances) { all.push_back(distances({{s}})); });
  for(std::size_t i = 0; i < all.size(); ++i)
    if(methods()[i].epsilon < infinity)
      for(std::size_t j = 0; j < all.size(); ++j)
      {
        SCOPED_TRACE(methods()[i].name + " and " + methods()[j].name);
        expect_at_most(all[i], all[j], tolerance(methods()[i]));
      }
}

// ----- the same surface

TEST_P(Properties, a_power_of_two_scales_exactly)
{
  const Vertex s = random_source();
  for_each_method([&](const Method& m, const Searcher& distances) {
    Values expected = distances({{s}});
    for(double& d : expected)
      d = std::ldexp(d, -300);
    const auto scale = [](const Point& p) {
      return Point(std::ldexp(p.x(), -300), std::ldexp(p.y(), -300), std::ldexp(p.z(), -300));
    };
    EXPECT_TRUE(have_same_bits(distances_on(m, m_soup.transformed(scale), s), expected));
  });
}

TEST_P(Properties, a_mirror_changes_nothing)
{
  const Vertex s = random_source();
  const auto mirror = [](const Point& p) { return Point(p.x(), -p.y(), p.z()); };
  for_each_method([&](const Method& m, const Searcher& distances) {
    EXPECT_TRUE(have_same_bits(distances_on(m, m_soup.transformed(mirror), s), distances({{s}})));
  });
}

// Coordinates are rounded, relative to the largest ones. A face without area gets a height by that
// whose square is what was rounded.
TEST_P(Properties, a_turn_changes_roundings)
{
  const Vertex s = random_source();
  const auto turn = [](const Point& p) {
    return Point(0.6 * p.y() - 0.8 * p.z(), 0.8 * p.y() + 0.6 * p.z(), p.x());
  };
  const double of_a_path = 1e-14 * size(m_mesh) * static_cast<double>(m_mesh.number_of_vertices());
  const double across_faces = has_flat_faces(m_mesh) ? 1e-7 * size(m_mesh) : of_a_path;
  for_each_method([&](const Method& m, const Searcher& distances) {
    expect_close(distances_on(m, m_soup.transformed(turn), s), distances({{s}}), tolerance(m),
                 m.name == "edge graph" ? of_a_path : across_faces);
  });
}

TEST_P(Properties, another_order_changes_roundings)
{
  const std::vector<std::size_t> position = m_random.permutation(m_soup.points.size());
  Soup other = m_soup.renumbered(position);
  for(auto& t : other.triangles)
  {
    std::swap(t[1], t[2]); // other orientation
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(m_random.below(3)), t.end());
  }
  m_random.shuffle(other.triangles);
  const Vertex s = random_source();
  for_each_method([&](const Method& m, const Searcher& distances) {
    const Values there = distances_on(m, other, Vertex(static_cast<Mesh::size_type>(position[s])));
    Values found;
    for(const std::size_t i : position)
      found.push_back(there[i]);
    expect_close(found, distances({{s}}), m.name == "edge graph" ? 0 : tolerance(m));
  });
}

// ----- less surface, or more edges

// The mesh is left with indices of faces, edges and vertices that stand for nothing.
TEST_P(Properties, without_a_face_no_path_along_edges_is_shorter)
{
  Mesh mesh = m_mesh;
  const Vertex s = random_source();
  Values last = Mesh_search(mesh).distances({s});
  for(int i = 0; i < 20; ++i)
  {
    const std::vector<Face> faces(mesh.faces_begin(), mesh.faces_end());
    CGAL::Euler::remove_face(mesh.halfedge(faces[m_random.below(faces.size())]), mesh);
    if(mesh.is_removed(s) || mesh.number_of_faces() == 0)
      break;
    Mesh_search search(mesh);
    const Field field = search.run({s});
    EXPECT_TRUE(is_optimal(mesh, edge_lengths(mesh), field, {s}));
    for(const Vertex v : mesh.vertices())
      EXPECT_GE(field.distance[v], last[v]);
    last = field.distance;
  }
}

// Every edge in two, every face in four.
Soup subdivided(const Soup& soup)
{
  Soup result{soup.points, {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middle = [&](const std::size_t a, const std::size_t b) {
    const auto known = middles.insert({std::minmax(a, b), result.points.size()});
    if(known.second)
      result.points.push_back(CGAL::midpoint(soup.points[a], soup.points[b]));
    return known.first->second;
  };
  for(const auto& [a, b, c] : soup.triangles)
  {
    const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    result.triangles.insert(result.triangles.end(),
                            {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return result;
}

TEST_P(Properties, smaller_faces_make_no_path_along_edges_longer)
{
  const Vertex s = random_source();
  const Values before = methods()[0].on(m_mesh, Triangulation(m_mesh))({{s}});
  Values after = distances_on(methods()[0], subdivided(m_soup), s);
  after.resize(before.size());
  expect_at_most(after, before, 1e-14, 1e-15 * size(m_mesh)); // midpoints are rounded
}

INSTANTIATE_TEST_SUITE_P(On_small_meshes,
                         Properties,
                         testing::ValuesIn(random_meshes(random_small_soup,
                                                         seeds_of_small_soups())));
INSTANTIATE_TEST_SUITE_P(On_larger_meshes,
                         Properties,
                         testing::ValuesIn(random_meshes(random_large_soup,
                                                         seeds_of_large_soups())));

} // namespace
