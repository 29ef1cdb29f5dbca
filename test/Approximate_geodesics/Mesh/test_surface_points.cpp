// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/surface_subjects.h"
#include "meshes/sample_meshes.h"
#include "meshes/surface_points.h"
#include "meshes/test_weights.h"
#include "oracles/exact_surface_distances.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Edge_graph.h>
#include <CGAL/Approximate_geodesics/Graphs/Lazy_discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_costs/Geometric_points.h>
#include <CGAL/Geodesic_costs/Steiner_graph.h>
#include <CGAL/Geodesic_costs/equal_parts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Paths between any points of a surface, on all graphs: that they are paths, as long as they say,
// and not longer than they may be.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// ----- graphs

// Whether arcs are the same both ways.
template <typename Graph>
constexpr bool is_symmetric = !std::is_same_v<Graph, AG::Discrete_geodesic_graph> &&
                              !std::is_same_v<Graph, AG::Lazy_discrete_geodesic_graph>;

// Whether the lengths of arcs are kept as a `float`.
template <typename Graph>
constexpr bool is_rounded = std::is_same_v<Graph, AG::Discrete_geodesic_graph>;

template <typename Graph>
constexpr bool has_points_on_edges = is_symmetric<Graph> && !std::is_same_v<Graph, AG::Edge_graph>;

// Whether the arcs do not depend on what is searched for.
template <typename Graph>
constexpr bool is_fixed = !std::is_same_v<Graph, AG::Lazy_discrete_geodesic_graph>;

// ----- pairs of points

// Sources and targets on a mesh, and the exact distances from each of the sources to all targets.
class Pairs
{
public:
  Pairs(const Subject& subject, Random& random)
    : mesh(subject.mesh),
      sources(random_surface_points(mesh, 5, random)),
      targets(random_surface_points(mesh, 14, random)),
      rounding(1e-13 * size(mesh))
  {
    if(subject.has_exact_distances)
      for(const Surface_point& source : sources)
        exact.push_back(exact_distances(mesh, source, targets));
  }

  const Mesh& mesh;
  std::vector<Surface_point> sources, targets;
  std::vector<std::vector<double>> exact; // empty if they are not known
  double rounding;                        // of coordinates
};

// ----- what is to be expected of paths on one graph

template <typename Graph>
class Expectations
{
  using Shortest_paths = AG::Surface_mesh_shortest_path<Mesh, Graph>;

public:
  template <typename NamedParameters>
  Expectations(const Pairs& pairs, const double epsilon, const NamedParameters& np)
    : m_pairs(pairs), m_mesh(pairs.mesh), m_epsilon(epsilon), m_paths(m_mesh, np)
  {
    if constexpr(has_points_on_edges<Graph>)
      m_epsilon = m_paths.graph().epsilon(); // none for angles of almost zero
  }

  void check_everything(Random& random)
  {
    check_single_sources();
    check_all_sources(random);
    check_points();
    if constexpr(is_symmetric<Graph>)
      check_symmetry();
  }

private:
  // From each source alone.
  void check_single_sources()
  {
    for(std::size_t i = 0; i < m_pairs.sources.size(); ++i)
    {
      m_paths.remove_all_source_points();
      m_paths.add_source_point(m_pairs.sources[i]);
      m_distances.emplace_back();
      for(std::size_t j = 0; j < m_pairs.targets.size(); ++j)
      {
        SCOPED_TRACE("from " + std::to_string(i) + " to " + std::to_string(j));
        const double found = check_path(m_pairs.sources[i], m_pairs.targets[j]);
        m_distances.back().push_back(found);
        if(!m_pairs.exact.empty())
          check_bound(found, m_pairs.exact[i][j], slack(i, j));
      }
    }
  }

  double check_path(const Surface_point& source, const Surface_point& target)
  {
    std::vector<Surface_point> points;
    const double distance = m_paths.shortest_distance_to_source_points(target).first;
    const double length =
        m_paths.shortest_path_surface_points_to_source_points(target, std::back_inserter(points))
            .first;
    EXPECT_EQ(points.empty(), distance < 0);
    if(points.empty())
    {
      EXPECT_EQ(distance, -1);
      EXPECT_EQ(length, -1);
      return infinity;
    }
    check_place(points.front(), target);
    check_place(points.back(), source);
    const double rounding_of_arcs = is_rounded<Graph> ? 0x1p-23 : 1e-12;
    EXPECT_NEAR(length_of(points), length, 1e-9 * length + m_pairs.rounding);
    EXPECT_LE(length, distance * (1 + 1e-12) + m_pairs.rounding);
    EXPECT_GE(length, distance * (1 - rounding_of_arcs) - m_pairs.rounding);
    return distance;
  }

  void check_place(const Surface_point& found, const Surface_point& wanted) const
  {
    EXPECT_LE(distance_in_space(position(m_mesh, found), position(m_mesh, wanted)),
              m_pairs.rounding);
  }

  double length_of(const std::vector<Surface_point>& points) const
  {
    double result = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
    {
      EXPECT_TRUE(share_a_face(m_mesh, points[i - 1], points[i])) << "step " << i;
      result += distance_in_space(position(m_mesh, points[i - 1]), position(m_mesh, points[i]));
    }
    return result;
  }

  void check_bound(const double found, const double exact, const double slack) const
  {
    if(std::isnan(exact)) // as happens to the exact class next to a source
      return;
    ASSERT_EQ(found == infinity, exact == infinity);
    if(found == infinity)
      return;
    const double tolerance = 1e-8 * size(m_mesh); // of the exact class, and for a moved source
    EXPECT_GE(found, exact * (1 - 1e-9) - tolerance);
    if(m_epsilon < infinity)
    {
      EXPECT_LE(found, exact * (1 + m_epsilon) + slack + tolerance);
    }
  }

  // What a path may be longer since points on edges serve paths between vertices: it can always go
  // by way of the vertices next to its ends.
  double slack(const std::size_t i, const std::size_t j) const
  {
    return has_points_on_edges<Graph> ? (2 + m_epsilon) * (distance_to_corner(m_pairs.sources[i]) +
                                                           distance_to_corner(m_pairs.targets[j]))
                                      : 0;
  }

  double distance_to_corner(const Surface_point& p) const
  {
    double result = infinity;
    for(const Vertex v :
        m_mesh.vertices_around_face(m_mesh.halfedge(location_in_face(m_mesh, p).first)))
      result = (std::min)(result, distance_in_space(m_mesh.point(v), position(m_mesh, p)));
    return result;
  }

  // From all sources at once, in another order, and some of them twice.
  void check_all_sources(Random& random)
  {
    std::vector<std::size_t> order;
    std::vector<double> initial;
    for(std::size_t i = 0; i < m_pairs.sources.size(); ++i)
    {
      order.insert(order.end(), 1 + random.below(2), i);
      initial.push_back(random.between(0, 0.3) * size(m_mesh));
    }
    random.shuffle(order);
    m_paths.remove_all_source_points();
    std::vector<typename Shortest_paths::Source_point_iterator> sources;
    for(const std::size_t i : order)
      sources.push_back(m_paths.add_source_point(m_pairs.sources[i], initial[i]));

    for(std::size_t j = 0; j < m_pairs.targets.size(); ++j)
    {
      const auto distance_from = [&](const std::size_t i) {
        return initial[i] + m_distances[i][j];
      };
      double expected = infinity;
      for(const std::size_t i : order)
        expected = (std::min)(expected, distance_from(i));
      const auto [found, it] = m_paths.shortest_distance_to_source_points(m_pairs.targets[j]);
      ASSERT_EQ(found < 0, expected == infinity);
      if(found < 0)
        continue;
      const double tolerance = found * (is_fixed<Graph> ? 1e-14 : m_epsilon);
      EXPECT_NEAR(found, expected, tolerance);
      const auto place = std::find(sources.begin(), sources.end(), it);
      ASSERT_NE(place, sources.end());
      EXPECT_NEAR(distance_from(order[static_cast<std::size_t>(place - sources.begin())]), found,
                  tolerance);
    }
  }

  // To where they start.
  void check_points()
  {
    for(const Surface_point& p : m_pairs.sources)
    {
      m_paths.remove_all_source_points();
      const auto source = m_paths.add_source_point(p);
      std::vector<Surface_point> points;
      const auto [length, it] =
          m_paths.shortest_path_surface_points_to_source_points(p, std::back_inserter(points));
      EXPECT_EQ(length, 0);
      EXPECT_TRUE(it == source);
      EXPECT_EQ(points.size(), 1u);
    }
  }

  // Back from some of the targets.
  void check_symmetry()
  {
    for(std::size_t j = 0; j < m_pairs.targets.size(); j += 4)
    {
      m_paths.remove_all_source_points();
      m_paths.add_source_point(m_pairs.targets[j]);
      for(std::size_t i = 0; i < m_pairs.sources.size(); ++i)
      {
        const double back = m_paths.shortest_distance_to_source_points(m_pairs.sources[i]).first;
        const double forth = m_distances[i][j];
        ASSERT_EQ(back < 0, forth == infinity);
        if(back >= 0)
        {
          EXPECT_NEAR(back, forth, 1e-12 * back + m_pairs.rounding);
        }
      }
    }
  }

  const Pairs& m_pairs;
  const Mesh& m_mesh;
  double m_epsilon;
  Shortest_paths m_paths;
  std::vector<std::vector<double>> m_distances; // from each source alone to the targets
};

// ----- all graphs

template <typename Graph, typename NamedParameters>
void expect_everything(const Pairs& pairs,
                       Random& random,
                       const std::string& graph,
                       const double epsilon,
                       const NamedParameters& np)
{
  SCOPED_TRACE(graph);
  Expectations<Graph>(pairs, epsilon, np).check_everything(random);
}

void expect_everything(const std::vector<Subject>& subjects)
{
  using parameters::epsilon;
  Random random(test_seed());
  for(const Subject& subject : subjects)
  {
    SCOPED_TRACE(subject.name);
    ASSERT_GT(subject.mesh.number_of_faces(), 0u);
    const Pairs pairs(subject, random);
    expect_everything<AG::Edge_graph>(pairs, random, "edges", infinity,
                                      parameters::default_values());
    expect_everything<AG::Discrete_geodesic_graph>(pairs, random, "discrete geodesic graph", 0.1,
                                                   epsilon(0.1));
    expect_everything<AG::Lazy_discrete_geodesic_graph>(pairs, random, "lazy graph", 0.05,
                                                        epsilon(0.05));
    expect_everything<AG::Steiner_graph<AG::Fixed_number_of_points>>(
        pairs, random, "equal parts", infinity, parameters::number_of_points_per_edge(3));
    expect_everything<AG::Steiner_graph<AG::Geometric_points>>(pairs, random, "progressions", 0.5,
                                                               lenient_parameters(0.5));
  }
}

TEST(Surface_points, are_joined_on_generated_meshes) { expect_everything(generated_subjects()); }

TEST(Surface_points, are_joined_on_sample_meshes)
{
  SKIP_WITHOUT_SAMPLE_MESHES();
  expect_everything(sample_subjects());
}

} // namespace
