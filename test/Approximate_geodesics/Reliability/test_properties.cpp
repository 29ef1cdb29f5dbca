// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_of_all_kinds.h"
#include "meshes/random_soups.h"
#include "meshes/surface_points.h"
#include "meshes/test_weights.h"
#include "oracles/test_oracles.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// What holds between distances on any mesh, on random ones. A case that fails prints its seed.

namespace {

using namespace geodesics_test;
using Values = std::vector<double>;
using Vertices = std::vector<Vertex>;

// From the nearest of some vertices to all, as far as a stop rule allows.
struct Query
{
  Vertices sources;
  double maximum_distance = infinity;
  Vertices targets = {};
};
using Searcher = std::function<Values(const Query&)>;

// A way to find distances: a kind of graph without its type.
struct Method
{
  std::string name;
  std::function<Searcher(const Mesh&, const Triangulation&)> on;
  double epsilon;
  double deviation;
  double asymmetry;
  double rounding_of_arcs;
};

template <typename GeodesicGraph>
Method method(const Kind_of_graph<GeodesicGraph>& kind)
{
  const auto on = [kind](const Mesh& mesh, const Triangulation& triangulation) -> Searcher {
    const auto search =
        std::make_shared<Basic_mesh_search<GeodesicGraph>>(mesh, kind.make(triangulation));
    return [search](const Query& query) {
      typename Basic_mesh_search<GeodesicGraph>::Search::Stop_rule stop{query.maximum_distance};
      for(const Vertex v : query.targets)
        stop.targets.push_back(search->node(v));
      return search->run(query.sources, stop).distance;
    };
  };
  return {kind.name, on, kind.epsilon, kind.deviation, kind.asymmetry, kind.rounding_of_arcs};
}

Method method_with_points(const std::size_t number)
{
  return method(graph_with_spaced_points(number));
}

const std::vector<Method>& methods()
{
  using Arcs = Lazy_discrete_geodesic_graph::Arcs;
  static const std::vector<Method> result = {
      method(edge_graph()),
      method_with_points(1),
      method_with_points(4),
      method(graph_with_points("geometric points", lenient_points(0.5), 0.5)),
      method(discrete_geodesic_graph(0.5)),
      method(discrete_geodesic_graph(0.05)),
      method(lazy_graph(0.2, Arcs::FORGOTTEN)),
      method(lazy_graph(0.2, Arcs::KEPT)),
      method(saddle_vertex_graph()),
  };
  return result;
}

// How far the values of one method may be apart if lengths were rounded otherwise: where there is a
// bound, other arcs may be left out, or there may be one point more.
double tolerance(const Method& method)
{
  return method.epsilon < infinity ? (std::max)(method.epsilon, 1e-12) : 1e-12;
}

// A kind of meshes, and the seed that says which one.
struct Subject
{
  Soup (*make)(std::uint64_t);
  std::uint64_t seed;

  friend std::ostream& operator<<(std::ostream& out, const Subject& subject)
  {
    return out << "seed " << subject.seed;
  }
};

std::vector<Subject> subjects(Soup (*make)(std::uint64_t), const std::vector<std::uint64_t>& seeds)
{
  std::vector<Subject> result;
  for(const std::uint64_t seed : seeds)
    result.push_back({make, seed});
  return result;
}

class Properties : public testing::TestWithParam<Subject>
{
protected:
  Properties()
    : m_random(GetParam().seed), m_soup(GetParam().make(GetParam().seed)), m_mesh(to_mesh(m_soup))
  {
  }

  // Calls `f(method, search)` for all methods on the mesh.
  template <typename F>
  void for_each_method(F f)
  {
    const Triangulation triangulation(m_mesh);
    for(const Method& m : methods())
    {
      SCOPED_TRACE(m.name);
      f(m, m.on(m_mesh, triangulation));
    }
  }

  static Values distances_on(const Method& method, const Soup& soup, const Vertex source)
  {
    const Mesh mesh = to_mesh(soup);
    return method.on(mesh, Triangulation(mesh))({{source}});
  }

  Vertex random_source() { return random_vertex(m_mesh, m_random); }

  Vertices random_sources(const std::size_t number)
  {
    Vertices result;
    for(std::size_t i = 0; i < number; ++i)
      result.push_back(random_source());
    return result;
  }

  Random m_random;
  const Soup m_soup;
  const Mesh m_mesh;
};

void expect_close(const Values& found,
                  const Values& expected,
                  const double relative,
                  const double absolute = 0)
{
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    if(expected[i] == infinity || (relative == 0 && absolute == 0))
    {
      EXPECT_EQ(found[i], expected[i]) << "vertex " << i;
    }
    else
    {
      EXPECT_LE(found[i], (1 + relative) * expected[i] + absolute) << "vertex " << i;
      EXPECT_LE(expected[i], (1 + relative) * found[i] + absolute) << "vertex " << i;
    }
}

void expect_at_most(const Values& found,
                    const Values& limit,
                    const double relative,
                    const double absolute = 0)
{
  ASSERT_EQ(found.size(), limit.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LE(found[i], (1 + relative) * limit[i] + absolute) << "vertex " << i;
}

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

TEST_P(Properties, more_points_are_never_worse_if_the_others_are_among_them)
{
  const Triangulation triangulation(m_mesh, with_weights(random_weights(m_mesh, m_random, 0.2, 5)));
  const Vertex s = random_source();
  Values last = method_with_points(0).on(m_mesh, triangulation)({{s}});
  for(const std::size_t number : {1u, 3u, 7u})
  {
    const Values found = method_with_points(number).on(m_mesh, triangulation)({{s}});
    expect_at_most(found, last, 1e-14);
    last = found;
  }
}

TEST_P(Properties, no_points_make_the_edge_graph)
{
  const Triangulation triangulation(m_mesh);
  const Vertex s = random_source();
  EXPECT_TRUE(have_same_bits(method_with_points(0).on(m_mesh, triangulation)({{s}}),
                             methods()[0].on(m_mesh, triangulation)({{s}})));
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

TEST_P(Properties, without_a_face_nothing_is_nearer)
{
  const Vertex s = random_source();
  Weights weights(m_mesh.number_of_faces(), 1);
  const Triangulation whole(m_mesh, with_weights(weights));
  for(int i = 0; i < 4; ++i)
    weights[m_random.below(weights.size())] = infinity;
  const Triangulation rest(m_mesh, with_weights(weights));
  const Barriers barriers = random_barriers(m_mesh, 0.2, m_random);
  const Triangulation divided(m_mesh, with_barriers(barriers));
  for(const Method& m : {methods()[1], methods()[2], methods()[3]})
  {
    SCOPED_TRACE(m.name);
    const Values distances = m.on(m_mesh, whole)({{s}});
    expect_at_most(distances, m.on(m_mesh, rest)({{s}}), tolerance(m));
    expect_at_most(distances, m.on(m_mesh, divided)({{s}}), tolerance(m));
  }
}

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

// ----- weights

TEST_P(Properties, costs_grow_with_weights)
{
  const Vertex s = random_source();
  const Weights weights = random_weights(m_mesh, m_random, 0.2, 5, 0.05);
  Weights twice = weights, larger = weights;
  for(double& w : twice)
    w *= 2;
  for(double& w : larger)
    w *= m_random.between(1, 2);
  const Triangulation once(m_mesh, with_weights(weights));
  for(const std::size_t number : {0u, 1u, 4u})
  {
    SCOPED_TRACE(testing::Message() << number << " points");
    const Method m = method_with_points(number);
    const Values costs = m.on(m_mesh, once)({{s}});
    Values expected = costs;
    for(double& c : expected)
      c *= 2;
    EXPECT_TRUE(
        have_same_bits(m.on(m_mesh, Triangulation(m_mesh, with_weights(twice)))({{s}}), expected));
    expect_at_most(costs, m.on(m_mesh, Triangulation(m_mesh, with_weights(larger)))({{s}}), 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(On_small_meshes,
                         Properties,
                         testing::ValuesIn(subjects(random_small_soup, seeds_of_small_soups())));
INSTANTIATE_TEST_SUITE_P(On_larger_meshes,
                         Properties,
                         testing::ValuesIn(subjects(random_large_soup, seeds_of_large_soups())));

} // namespace
