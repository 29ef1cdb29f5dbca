// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef APPROXIMATE_GEODESICS_TEST_EXPECT_EVERYTHING_H
#define APPROXIMATE_GEODESICS_TEST_EXPECT_EVERYTHING_H

#include "checks/expect_message.h"
#include "oracles/known_distances.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// What is to be expected of the class on meshes that are as bad as they get.

namespace geodesics_test {

// ----- the class, whatever its graph

struct Found_path
{
  double length;
  std::vector<Surface_point> points;
};

class Any_shortest_paths
{
public:
  virtual ~Any_shortest_paths() = default;

  virtual void set_sources(const std::vector<Surface_point>& sources) = 0;
  virtual double distance(const Surface_point& target) = 0;
  virtual Found_path path(const Surface_point& start, bool is_straight) = 0;
  virtual double pair_distance(const Surface_point& source, const Surface_point& target) = 0;
  virtual std::pair<double, std::vector<Point>>
  pair_points(const Surface_point& source, const Surface_point& target, bool is_straight) = 0;
};

template <typename Graph>
class Shortest_paths : public Any_shortest_paths
{
public:
  template <typename NamedParameters>
  Shortest_paths(const Mesh& mesh, const NamedParameters& np) : m_paths(mesh, np)
  {
  }

  const Graph& graph() const { return m_paths.graph(); }

  void set_sources(const std::vector<Surface_point>& sources) override
  {
    m_paths.remove_all_source_points();
    m_paths.add_source_points(sources.begin(), sources.end());
    EXPECT_EQ(m_paths.number_of_source_points(), sources.size());
  }

  double distance(const Surface_point& target) override
  {
    return m_paths.shortest_distance_to_source_points(target).first;
  }

  Found_path path(const Surface_point& start, const bool is_straight) override
  {
    Found_path result;
    result.length =
        m_paths
            .shortest_path_surface_points_to_source_points(
                start, std::back_inserter(result.points), CGAL::parameters::straighten(is_straight))
            .first;
    return result;
  }

  double pair_distance(const Surface_point& source, const Surface_point& target) override
  {
    return m_paths.shortest_distance(source, target);
  }

  std::pair<double, std::vector<Point>> pair_points(const Surface_point& source,
                                                    const Surface_point& target,
                                                    const bool is_straight) override
  {
    std::vector<Point> points;
    const double length = m_paths.shortest_path_points(source, target, std::back_inserter(points),
                                                       CGAL::parameters::straighten(is_straight));
    return {length, points};
  }

private:
  CGAL::Approximate_geodesics::Surface_mesh_shortest_path<Mesh, Graph> m_paths;
};

// ----- what is expected of it

class Expectations
{
public:
  Expectations(Known_distances& known, Any_shortest_paths& paths, const Bound& bound)
    : m_known(known), m_mesh(known.mesh), m_paths(paths), m_bound(bound)
  {
  }

  void check_vertices() { check_single_sources(some_vertices(m_mesh), all_vertices(m_mesh)); }

  void check_everything()
  {
    const std::vector<Surface_point> sources = some_vertices(m_mesh), points = some_points(m_mesh);
    check_single_sources(sources, all_vertices(m_mesh));
    check_single_sources(points, points);
    check_single_sources(sources, points);
    check_paths(sources, sources);
    check_paths(points, sources);
    check_paths(points, points);
    check_many_sources(sources);
    check_many_sources(points);
    check_no_source();
    check_all_sources();
  }

private:
  // ----- distances

  void check_single_sources(const std::vector<Surface_point>& sources,
                            const std::vector<Surface_point>& targets)
  {
    for(std::size_t i = 0; i < sources.size(); ++i)
    {
      m_paths.set_sources({sources[i]});
      EXPECT_EQ(m_paths.distance(sources[i]), 0);
      for(std::size_t j = 0; j < targets.size(); ++j)
      {
        SCOPED_TRACE("from " + std::to_string(i) + " to " + std::to_string(j));
        check_distance(m_paths.distance(targets[j]), sources[i], targets[j]);
        if(j % 7 == 0)
          check_distance(m_paths.pair_distance(sources[i], targets[j]), sources[i], targets[j]);
      }
    }
  }

  void check_distance(const double found, const Surface_point& p, const Surface_point& q)
  {
    expect_distance(found, m_known, m_bound, p, q);
  }

  void check_many_sources(const std::vector<Surface_point>& sources)
  {
    m_paths.set_sources(sources);
    for(const Surface_point& target : all_vertices(m_mesh))
    {
      Long shortest = infinity, along_edges = infinity;
      for(const Surface_point& source : sources)
      {
        if(m_known.longest(source, target) < infinity)
          shortest = (std::min)(shortest, m_known.shortest(source, target));
        along_edges = (std::min)(along_edges, m_known.longest(source, target));
      }
      const double found = m_paths.distance(target);
      ASSERT_EQ(found == -1, along_edges == infinity);
      if(found == -1)
        continue;
      const Long rounding = m_known.rounding(target, along_edges);
      EXPECT_GE(found, shortest - rounding);
      EXPECT_LE(found, along_edges * (1 + m_bound.of_edges) + rounding);
    }
  }

  void check_no_source()
  {
    m_paths.set_sources({});
    for(const Surface_point& target : some_vertices(m_mesh))
    {
      EXPECT_EQ(m_paths.distance(target), -1);
      EXPECT_TRUE(m_paths.path(target, false).points.empty());
    }
  }

  void check_all_sources()
  {
    m_paths.set_sources(all_vertices(m_mesh));
    for(const Surface_point& target : all_vertices(m_mesh))
      EXPECT_EQ(m_paths.distance(target), 0);
  }

  // ----- paths

  void check_paths(const std::vector<Surface_point>& sources,
                   const std::vector<Surface_point>& targets)
  {
    for(std::size_t i = 0; i < sources.size(); ++i)
    {
      m_paths.set_sources({sources[i]});
      for(std::size_t j = 0; j < targets.size(); ++j)
      {
        SCOPED_TRACE("path from " + std::to_string(i) + " to " + std::to_string(j));
        const double distance = m_paths.distance(targets[j]);
        const double straight = check_path(m_paths.path(targets[j], true), sources[i], targets[j]);
        const double length = check_path(m_paths.path(targets[j], false), sources[i], targets[j]);
        EXPECT_EQ(distance < 0, length < 0);
        if(distance < 0)
          continue;
        const double rounding = static_cast<double>(m_known.rounding(sources[i], distance));
        EXPECT_LE(straight, length * (1 + 1e-14)); // where the length is a distance, not a sum
        EXPECT_LE(length, distance * (1 + 1e-12) + rounding);
        EXPECT_GE(length, distance * (1 - 0x1p-22) - rounding);
        check_points(sources[i], targets[j]);
      }
    }
  }

  // that a path is one, and as long as it says
  double
  check_path(const Found_path& path, const Surface_point& source, const Surface_point& target)
  {
    if(path.points.empty())
    {
      EXPECT_EQ(path.length, -1);
      return path.length;
    }
    const Long rounding = m_known.rounding(source, path.length);
    EXPECT_LE(straight_line(m_mesh, path.points.front(), target), rounding);
    EXPECT_LE(straight_line(m_mesh, path.points.back(), source), rounding);
    Long sum = 0;
    for(std::size_t i = 1; i < path.points.size(); ++i)
    {
      EXPECT_TRUE(can_go_straight(path.points[i - 1], path.points[i])) << "step " << i;
      sum += straight_line(m_mesh, path.points[i - 1], path.points[i]);
    }
    // across needles, where the path crosses edges is known to fewer digits than its length
    EXPECT_LE(std::abs(sum - Long(path.length)), 10 * rounding);
    expect_length(path.length, m_known, m_bound, source, target);
    return path.length;
  }

  bool can_go_straight(const Surface_point& p, const Surface_point& q) const
  {
    const auto *v = std::get_if<Vertex>(&p), *w = std::get_if<Vertex>(&q);
    return share_a_face(m_mesh, p, q) ||
           (v != nullptr && w != nullptr && m_mesh.halfedge(*v, *w) != Mesh::null_halfedge());
  }

  void check_points(const Surface_point& source, const Surface_point& target)
  {
    for(const bool is_straight : {false, true})
    {
      const auto [length, points] = m_paths.pair_points(source, target, is_straight);
      expect_length(length, m_known, m_bound, source, target);
      ASSERT_FALSE(points.empty());
      for(const Point& p : points)
        for(int i = 0; i < 3; ++i)
          ASSERT_TRUE(std::isfinite(p[i]));
    }
  }

  Known_distances& m_known;
  const Mesh& m_mesh;
  Any_shortest_paths& m_paths;
  const Bound m_bound;
};

// ----- all meshes

template <typename Graph>
Bound bound_of(const Graph& graph)
{
  namespace AG = CGAL::Approximate_geodesics;
  if constexpr(std::is_same_v<Graph, AG::Edge_graph>)
    return {true};
  else if constexpr(std::is_same_v<Graph, AG::Discrete_geodesic_graph> ||
                    std::is_same_v<Graph, AG::Lazy_discrete_geodesic_graph>)
    return {false, graph.epsilon(), graph.epsilon()};
  else // edges are arcs
    return {false, graph.epsilon()};
}

template <typename Graph, typename NamedParameters>
void expect_everything(const NamedParameters& np, const std::set<std::string>& left_out)
{
  for_accepted_meshes(left_out, [&](Known_distances& known) {
    const std::vector<std::string>& refusal = known.row.refusal_across_faces;
    const bool is_along_edges = std::is_same_v<Graph, CGAL::Approximate_geodesics::Edge_graph>;
    if(!refusal.empty() && !is_along_edges)
    {
      for(const std::string& text : refusal)
        expect_message<std::invalid_argument>([&] { Shortest_paths<Graph>(known.mesh, np); }, text);
      return;
    }
    Shortest_paths<Graph> paths(known.mesh, np);
    Expectations expectations(known, paths, bound_of(paths.graph()));
    refusal.empty() ? expectations.check_everything() : expectations.check_vertices();
  });
}

} // namespace geodesics_test

#endif // APPROXIMATE_GEODESICS_TEST_EXPECT_EVERYTHING_H
