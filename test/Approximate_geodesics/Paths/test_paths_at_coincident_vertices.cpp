// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/graphs_of_all_kinds.h"
#include "meshes/random_soups.h"
#include "meshes/sample_meshes.h"
#include "meshes/surface_points.h"
#include "paths/straightened_paths.h"

#include <CGAL/Approximate_geodesics/Mesh/Mesh_translation.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

// Where edges have length zero, paths are as long as their distances, and have no vertex twice.

namespace {

using namespace geodesics_test;

template <typename GeodesicGraph>
class Paths_to_check
{
public:
  // `rounding` is part of the size of the mesh
  Paths_to_check(const Mesh& mesh,
                 const Kind_of_graph<GeodesicGraph>& kind,
                 const double rounding = 4e-12)
    : m_mesh(mesh),
      m_graph(kind.make(Triangulation(mesh))),
      m_precision((std::max)(1e-12, kind.rounding_of_arcs > 0 ? single_precision : 0)),
      m_rounding(rounding * size(mesh))
  {
    m_translation.list_vertices();
  }

  void expect_paths(Random& random, const std::size_t number_of_sources)
  {
    AG::Surface_search<GeodesicGraph> search(m_graph);
    for(std::size_t i = 0; i < number_of_sources; ++i)
    {
      const Intrinsic_point source = random_point(random);
      search.run({{source}});
      for(int j = 0; j < 40; ++j)
      {
        const Intrinsic_point target = random_point(random);
        const double distance = search.distance(target);
        if(distance < infinity)
          expect_path(search.find_path(target), target, source, distance);
      }
    }
  }

private:
  Intrinsic_point random_point(Random& random) const
  {
    return m_translation.intrinsic_point(random.below(2) == 0
                                             ? Surface_point(random_vertex(m_mesh, random))
                                             : random_surface_point(m_mesh, random));
  }

  void expect_path(const Path& path,
                   const Intrinsic_point& target,
                   const Intrinsic_point& source,
                   const double distance) const
  {
    EXPECT_NEAR(path.length, distance, m_precision * distance + m_rounding);
    expect_points(path, target, source);
    const Path straight = Path_straightener(m_graph.triangulation()).shortened(path);
    EXPECT_LE(straight.length, path.length + m_rounding);
    expect_points(straight, target, source);
  }

  // The ends are right, each point shares a face with the next, and no vertex occurs twice.
  void expect_points(const Path& path,
                     const Intrinsic_point& target,
                     const Intrinsic_point& source) const
  {
    const Triangulation& t = m_graph.triangulation();
    const double length = AG::internal::length_of_segments(t, path.points) * t.unit();
    EXPECT_NEAR(length, path.length, 1e-12 * length + m_rounding);
    EXPECT_TRUE(is_at(path.points.front(), target));
    EXPECT_TRUE(is_at(path.points.back(), source));
    std::set<Index> vertices;
    for(std::size_t i = 0; i < path.points.size(); ++i)
    {
      const Intrinsic_point& p = path.points[i];
      EXPECT_TRUE(!p.is_vertex() || vertices.insert(p.vertex).second) << "vertex " << p.vertex;
      EXPECT_TRUE(i == 0 || !p.is_same(path.points[i - 1], t)) << "point " << i;
    }
  }

  bool is_at(const Intrinsic_point& p, const Intrinsic_point& q) const
  {
    const Triangulation& t = m_graph.triangulation();
    return p.is_same(q, t) || q.is_same(p, t) || p.is_same(q.reduced(t), t);
  }

  const Mesh& m_mesh;
  const GeodesicGraph m_graph;
  AG::Mesh_translation<Mesh, decltype(get(boost::vertex_index, m_mesh))> m_translation{
      m_mesh, get(boost::vertex_index, m_mesh), m_graph.triangulation()};
  const double m_precision, m_rounding;
};

void expect_paths(const Mesh& mesh, Random& random, const std::size_t number_of_sources)
{
  for_each_small_graph(0.1, [&](const auto& kind) {
    Paths_to_check(mesh, kind).expect_paths(random, number_of_sources);
  });
}

TEST(Coincident_vertices, leave_paths_as_long_as_distances)
{
  std::vector<std::uint64_t> seeds = seeds_of_small_soups();
  seeds.push_back(1493); // paths led around vertices on the other side of their start
  for(const std::uint64_t seed : seeds)
    for(const std::size_t number : {std::size_t(3), std::size_t(12)})
    {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << number << " places");
      Random random(seed);
      expect_paths(with_coincident_vertices(to_mesh(random_small_soup(seed)), number, random),
                   random, 5);
    }
}

// Edges are nearly as short as can be, and faces nearly without area.
Mesh nearly_degenerate(const std::uint64_t seed)
{
  Random random(seed);
  const double part = std::pow(10., -9 - static_cast<double>(seed % 7));
  Mesh mesh = to_mesh(random_small_soup(seed));
  if(seed % 10 != 7) // a terrain with steps has coincident vertices
    mesh = with_coincident_vertices(mesh, 3 + random.below(10), random);
  return with_moved_vertices(mesh, part, random);
}

TEST(Nearly_coincident_vertices, leave_paths_as_long_as_distances)
{
  std::vector<std::uint64_t> seeds = seeds_of_small_soups();
  // lines had not been found, or had been longer
  for(const std::uint64_t seed : {3u, 120u, 136u, 177u, 234u, 277u, 344u, 380u, 416u, 527u, 646u,
                                  690u, 696u, 3814u, 5884u, 9888u})
    seeds.push_back(seed);
  for(const std::uint64_t seed : seeds)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    Paths_to_check(nearly_degenerate(seed), saddle_vertex_graph(), 1e-8).expect_paths(random, 4);
  }
}

// Lines from points close to a corner had lost their direction, and crossed edges elsewhere.
TEST(Nearly_coincident_vertices, leave_straight_lines_as_long_as_they_say)
{
  std::vector<std::uint64_t> seeds = seeds_of_small_soups();
  for(const std::uint64_t seed : {136u, 1686u, 11147u, 11803u})
    seeds.push_back(seed);
  for(const std::uint64_t seed : seeds)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const auto kind = lazy_graph(0.1, AG::Lazy_discrete_geodesic_graph::Arcs::FORGOTTEN);
    Paths_to_check(nearly_degenerate(seed), kind, 1e-8).expect_paths(random, 4);
  }
}

TEST(Coincident_vertices, leave_paths_as_long_as_distances_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  Random random(test_seed());
  for(const std::string name : {"pinion_small.off", "joint.off", "cross.off", "cow.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = with_coincident_vertices(sample_mesh(name), 30, random);
    ASSERT_FALSE(mesh.is_empty());
    Paths_to_check(mesh, saddle_vertex_graph()).expect_paths(random, 12);
    Paths_to_check(mesh, discrete_geodesic_graph(0.1)).expect_paths(random, 4);
  }
}

// Two sheets at this distance, joined along some of their edges. Other lines are nearly as long as
// the shortest ones.
Soup thin_box(const double h)
{
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 0, h), Point(2, 0, 0), Point(2, 0, h),
           Point(1, 0, 2 * h), Point(0, 0, 2 * h), Point(2, 1, h), Point(2, 1, 0), Point(1, 1, h),
           Point(1, 1, 2 * h), Point(0, 1, 2 * h), Point(0, 1, h), Point(0, 1, 0), Point(2, 0, 0),
           Point(2, 1, h), Point(2, 1, h), Point(1, 1, h)},
          {{0, 1, 2},  {1, 3, 4},   {1, 4, 2},    {2, 5, 6},    {7, 8, 14},
           {15, 3, 1}, {14, 8, 7},  {3, 16, 4},   {2, 4, 16},   {2, 16, 9},
           {2, 10, 5}, {6, 5, 10},  {6, 10, 11},  {2, 6, 11},   {2, 11, 12},
           {0, 2, 12}, {0, 12, 13}, {12, 11, 10}, {12, 10, 17}, {13, 12, 17}}};
}

TEST(Thin_box, has_paths_as_long_as_distances)
{
  Random random(test_seed());
  for(const double h : {1e-3, 1e-6})
  {
    SCOPED_TRACE(h);
    const Mesh mesh = to_mesh(thin_box(h));
    Paths_to_check(mesh, saddle_vertex_graph(), 1e-9).expect_paths(random, 60);
  }
}

} // namespace
