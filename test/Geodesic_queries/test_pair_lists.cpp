// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/approximate_geodesic_pair_distances.h>

#include "checks/distance_matrices.h"
#include "checks/expect_message.h"
#include "meshes/random_soups.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_queries/Pair_queries.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <list>
#include <stdexcept>
#include <utility>
#include <vector>

// Lists of pairs of points of a mesh, by the function and the class.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Pair = std::pair<Surface_point, Surface_point>;
using Distances = std::vector<double>;
using Interval = std::pair<double, double>;

template <typename Domain, typename Pairs, typename... NamedParameters>
Distances distances_of(const Domain& domain, const Pairs& pairs, const NamedParameters&... np)
{
  Distances result;
  EXPECT_TRUE(
      CGAL::approximate_geodesic_pair_distances(domain, pairs, std::back_inserter(result), np...));
  return result;
}

class Pair_lists : public testing::Test
{
protected:
  // By a search for each pair.
  template <typename GeodesicGraph>
  Distances expected(const GeodesicGraph& graph) const
  {
    Distances result;
    for(const auto& [source, target] : m_pairs)
    {
      const auto ends = intrinsic_points(m_mesh, graph.triangulation(), {source, target});
      const bool is_reversed = AG::internal::leads_to_sources(graph);
      AG::Surface_search<GeodesicGraph> search(graph);
      search.run({{ends[is_reversed ? 1 : 0]}}, {infinity, {ends[is_reversed ? 0 : 1]}});
      result.push_back(search.distance(ends[is_reversed ? 0 : 1]));
    }
    return result;
  }

  // By the function, on the mesh and in the graph, and by the class.
  template <typename GeodesicGraph, typename Named_parameters>
  void expect_same(const Named_parameters& np) const
  {
    const AG::Surface_mesh_shortest_path<Mesh, GeodesicGraph> paths(m_mesh, np);
    const Distances expected = this->expected(paths.graph());
    EXPECT_TRUE(have_same_bits(distances_of(m_mesh, m_pairs, np), expected));
    EXPECT_TRUE(have_same_bits(AG::Pair_queries(paths).distances(m_pairs), expected));
    std::vector<AG::Point_pair> pairs;
    for(const auto& [source, target] : m_pairs)
    {
      const auto ends = intrinsic_points(m_mesh, paths.graph().triangulation(), {source, target});
      pairs.emplace_back(ends[0], ends[1]);
    }
    EXPECT_TRUE(have_same_bits(distances_of(paths.graph(), pairs), expected));
  }

  std::vector<Pair> pairs()
  {
    const auto points = random_surface_points(m_mesh, 25, m_random);
    std::vector<Pair> result;
    for(std::size_t i = 0; i < 60; ++i)
      result.emplace_back(points[m_random.below(25)], points[m_random.below(25)]);
    return result;
  }

  Random m_random{test_seed()};
  const Mesh m_mesh = to_mesh(with_holes(terrain(11, 9, m_random), 0.25, m_random));
  const std::vector<Pair> m_pairs = pairs();
};

TEST_F(Pair_lists, are_those_of_single_searches)
{
  const Weights weights = random_weights(m_mesh, m_random, 0.2, 5);
  const Barriers barriers = random_barriers(m_mesh, 0.2, m_random);
  expect_same<AG::Edge_graph>(parameters::default_values());
  expect_same<Discrete_geodesic_graph>(parameters::epsilon(0.1));
  expect_same<Saddle_vertex_graph>(parameters::epsilon(0));
  expect_same<Steiner_graph<Fixed_number_of_points>>(parameters::number_of_points_per_edge(2));
  expect_same<Steiner_graph<>>(with_weights(weights).epsilon(0.5));
  expect_same<Steiner_graph<Fixed_number_of_points>>(
      with_barriers(barriers).number_of_points_per_edge(1));
}

TEST_F(Pair_lists, are_those_of_single_searches_if_costs_depend_on_the_direction)
{
  const auto np = with_cost(cost_everywhere(Slant{2, Vector(0.6, -0.2, 0)})).epsilon(0.5);
  const AG::Surface_mesh_shortest_path<Mesh, Directional_graph<>> from(m_mesh, np);
  const AG::Surface_mesh_shortest_path<Mesh, Directional_graph<>> to(m_mesh,
                                                                     from.graph().reversed());
  EXPECT_TRUE(have_same_bits(distances_of(m_mesh, m_pairs, np), expected(from.graph())));
  EXPECT_TRUE(have_same_bits(AG::Pair_queries(from).distances(m_pairs), expected(from.graph())));
  EXPECT_TRUE(have_same_bits(AG::Pair_queries(to).distances(m_pairs), expected(to.graph())));
}

// Workspaces that a list has left are used by the next one.
TEST_F(Pair_lists, can_be_found_one_after_the_other)
{
  const Weights weights = random_weights(m_mesh, m_random, 0.2, 5);
  AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<Fixed_number_of_points>> paths(
      m_mesh, parameters::number_of_points_per_edge(2));
  const AG::Pair_queries queries(paths);
  for(int i = 0; i < 3; ++i)
  {
    if(i == 2)
      paths.set_face_weights(weight_map(weights));
    const Distances expected = this->expected(paths.graph());
    EXPECT_TRUE(have_same_bits(queries.distances(m_pairs), expected));
    EXPECT_TRUE(queries.distances(m_pairs, parameters::maximum_distance(1)) != expected);
    EXPECT_TRUE(have_same_bits(queries.distances(m_pairs), expected));
  }
}

TEST_F(Pair_lists, are_the_same_in_a_graph_that_keeps_its_arcs)
{
  const auto np = parameters::epsilon(0.1);
  const Lazy_discrete_geodesic_graph graph(Triangulation(m_mesh), np,
                                           Lazy_discrete_geodesic_graph::Arcs::KEPT);
  std::vector<AG::Point_pair> pairs;
  for(const auto& [source, target] : m_pairs)
  {
    const auto ends = intrinsic_points(m_mesh, graph.triangulation(), {source, target});
    pairs.emplace_back(ends[0], ends[1]);
  }
  EXPECT_TRUE(have_same_bits(distances_of(graph, pairs), distances_of(m_mesh, m_pairs, np)));
}

TEST_F(Pair_lists, keep_the_direction_of_costs)
{
  const Mesh mesh = to_mesh(flat_grid(6, 5));
  const Slant slant{2, Vector(0.6, -0.2, 0)};
  const auto np = with_cost(cost_everywhere(slant)).epsilon(0.1);
  const std::vector<std::pair<Vertex, Vertex>> pairs{{Vertex(0), Vertex(29)},
                                                     {Vertex(29), Vertex(0)}};
  const AG::Surface_mesh_shortest_path<Mesh, Directional_graph<>> from(mesh, np);
  const AG::Surface_mesh_shortest_path<Mesh, Directional_graph<>> to(mesh, from.graph().reversed());
  const AG::Pair_queries queries(from), queries_to(to);
  for(const Distances& found :
      {distances_of(mesh, pairs, np), queries.distances(pairs), queries_to.distances(pairs)})
    for(std::size_t i = 0; i < 2; ++i)
    {
      const double cost = slant.cost(mesh.point(pairs[i].second) - mesh.point(pairs[i].first));
      EXPECT_GE(found[i], (1 - 1e-9) * cost);
      EXPECT_LE(found[i], 1.1 * cost);
    }
  for(const auto& paths : {queries.paths(pairs), queries_to.paths(pairs)})
    for(std::size_t i = 0; i < 2; ++i)
    {
      EXPECT_EQ(paths[i].front(), mesh.point(pairs[i].first));
      EXPECT_EQ(paths[i].back(), mesh.point(pairs[i].second));
    }
}

TEST_F(Pair_lists, may_be_of_other_ranges_and_points)
{
  const std::list<std::pair<Vertex, Vertex>> pairs{{Vertex(3), Vertex(8)}, {Vertex(0), Vertex(0)}};
  const Face_location place(*m_mesh.faces().begin(), {0.5, 0.25, 0.25});
  const std::vector<std::pair<Vertex, Face_location>> mixed{{Vertex(3), place}};
  const std::vector<Pair> same{{Vertex(3), Vertex(8)}, {Vertex(0), Vertex(0)}, {Vertex(3), place}};
  Distances found = distances_of(m_mesh, pairs);
  const Distances last = distances_of(m_mesh, mixed);
  found.insert(found.end(), last.begin(), last.end());
  EXPECT_EQ(found, distances_of(m_mesh, same));
  EXPECT_TRUE(distances_of(m_mesh, std::vector<Pair>()).empty());
}

TEST_F(Pair_lists, end_at_a_distance)
{
  const auto np = parameters::epsilon(0.1);
  const Distances all = distances_of(m_mesh, m_pairs, np);
  const Distances found = distances_of(m_mesh, m_pairs, np.maximum_distance(3));
  for(std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(found[i], all[i] <= 3 ? all[i] : infinity);
}

TEST_F(Pair_lists, have_intervals_that_contain_exact_distances)
{
  const Distances exact = distances_of(m_mesh, m_pairs, parameters::epsilon(0));
  const auto expect = [&](const std::vector<Interval>& found) {
    ASSERT_EQ(found.size(), exact.size());
    for(std::size_t i = 0; i < exact.size(); ++i)
    {
      EXPECT_LE(found[i].first, exact[i]);
      EXPECT_GE(found[i].second, exact[i]);
    }
  };
  using Exact_paths = AG::Surface_mesh_shortest_path<Mesh, Saddle_vertex_graph>;
  using Paths_across_faces = AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph>;
  using Weighted_paths = AG::Surface_mesh_shortest_path<Mesh, Steiner_graph<>>;
  const auto np = parameters::epsilon(0.3);
  const Exact_paths exact_paths(m_mesh);
  const Paths_across_faces across_faces(m_mesh, np);
  const Weighted_paths weighted(m_mesh, np);
  expect(AG::Pair_queries(exact_paths).distance_intervals(m_pairs));
  expect(AG::Pair_queries(across_faces).distance_intervals(m_pairs));
  expect(
      AG::Pair_queries(across_faces).distance_intervals(m_pairs, parameters::maximum_distance(2)));
  expect(AG::Pair_queries(weighted).distance_intervals(m_pairs));
}

TEST_F(Pair_lists, have_paths)
{
  const auto length = [](const std::vector<Point>& path) {
    return path.empty() ? infinity : length_of(path);
  };
  const AG::Surface_mesh_shortest_path<Mesh, Discrete_geodesic_graph> paths(
      m_mesh, parameters::epsilon(0.2));
  const AG::Pair_queries queries(paths);
  const Distances distances = queries.distances(m_pairs);
  const auto found = queries.paths(m_pairs);
  const auto straight = queries.paths(m_pairs, parameters::straighten(true));
  ASSERT_EQ(found.size(), m_pairs.size());
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    if(distances[i] == infinity)
    {
      EXPECT_TRUE(found[i].empty() && straight[i].empty());
      continue;
    }
    EXPECT_NEAR(length(found[i]), distances[i], 1e-6);
    EXPECT_LE(length(straight[i]), length(found[i]) * (1 + 1e-12));
    for(const auto& path : {found[i], straight[i]})
    {
      EXPECT_LT(CGAL::squared_distance(path.front(), position(m_mesh, m_pairs[i].first)), 1e-20);
      EXPECT_LT(CGAL::squared_distance(path.back(), position(m_mesh, m_pairs[i].second)), 1e-20);
    }
  }
}

TEST_F(Pair_lists, name_a_wrong_pair_and_write_nothing)
{
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const Vertex wrong(9999);
  const Face_location nowhere(*m_mesh.faces().begin(), {0.5, not_a_number, 0.25});
  Distances found;
  const auto compute = [&](const auto& domain, const auto& pairs) {
    CGAL::approximate_geodesic_pair_distances(domain, pairs, std::back_inserter(found));
  };
  const std::vector<std::pair<Vertex, Vertex>> wrong_source{{Vertex(0), Vertex(1)},
                                                            {wrong, Vertex(1)}};
  const std::vector<std::pair<Vertex, Face_location>> wrong_target{{Vertex(0), nowhere}};
  const std::vector<AG::Point_pair> wrong_point(3, {Intrinsic_point::at_vertex(9999), {}});
  expect_message<std::invalid_argument>([&] { compute(m_mesh, wrong_source); }, "pair 1", "source",
                                        "vertex 9999");
  expect_message<std::invalid_argument>([&] { compute(m_mesh, wrong_target); }, "pair 0", "target",
                                        "barycentric");
  const Graph graph{Triangulation(m_mesh)};
  expect_message<std::invalid_argument>([&] { compute(graph, wrong_point); }, "pair 0", "source");
  const AG::Surface_mesh_shortest_path<Mesh> paths(m_mesh);
  const AG::Pair_queries queries(paths);
  expect_message<std::invalid_argument>([&] { queries.paths(wrong_source); }, "pair 1", "source");
  expect_message<std::invalid_argument>(
      [&] { queries.distances(m_pairs, parameters::maximum_distance(-1)); }, "maximum_distance");
  EXPECT_TRUE(found.empty());
}

} // namespace
