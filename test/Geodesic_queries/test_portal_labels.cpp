// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Geodesic_queries/Portal_labels.h>

#include "checks/distance_matrices.h"
#include "checks/expect_message.h"
#include "checks/graphs_of_all_kinds.h"
#include "meshes/hostile_meshes.h"
#include "meshes/random_soups.h"
#include "meshes/test_costs.h"
#include "meshes/test_weights.h"
#include "paths/dijkstra.h"
#include "threads/Interruption_at.h"
#include "threads/numbers_of_threads.h"

#include <CGAL/Approximate_geodesics/Base/internal/binary_io.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>
#include <CGAL/Geodesic_queries/Guided_search.h>
#include <CGAL/Geodesic_queries/Landmarks.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ios>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Intervals from labels at portals contain the distances in the graph, whatever the pair.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using AG::Portal_labels;
using AG::internal::Part_nodes;
using AG::internal::Two_way_arcs;
using AG::internal::Two_way_search;

// In the unit of the mesh.
std::vector<double> two_way_distances(const Two_way_arcs& arcs, const std::uint32_t source)
{
  std::vector<double> result = textbook_distances<double>(
      arcs.number_of_nodes(), source, [&](const std::size_t node, const auto& f) {
        arcs.for_each_arc(static_cast<std::uint32_t>(node), 0, f);
      });
  for(double& distance : result)
    distance *= arcs.unit();
  return result;
}

Two_way_arcs arcs_of_part(const Two_way_arcs& arcs, const Part_nodes& part)
{
  Part_nodes place(arcs.number_of_nodes(), Two_way_search::null_node);
  for(std::uint32_t i = 0; i < part.size(); ++i)
    place[part[i]] = i;
  return {arcs, part, place};
}

// Some vertices, or all if they are few.
std::vector<std::uint32_t> some_numbers(const std::size_t number, Random& random)
{
  std::vector<std::uint32_t> result;
  for(const std::size_t i : random.permutation(number))
    if(result.size() < 25)
      result.push_back(static_cast<std::uint32_t>(i));
  return result;
}

template <typename SurfaceGraph>
void expect_intervals(const SurfaceGraph& graph, const double epsilon, Random& random)
{
  constexpr double rounding = 1e-5;
  const double smallest = 1e-37 * graph.arc_lengths().longest * graph.unit(); // in single precision
  const Portal_labels<SurfaceGraph> labels(graph, parameters::epsilon(epsilon));
  EXPECT_EQ(labels.epsilon(), epsilon);
  const Two_way_arcs arcs(graph);
  AG::Propagation<SurfaceGraph> search(graph);
  const auto n = static_cast<std::uint32_t>(graph.triangulation().number_of_vertices());
  for(const std::uint32_t v : some_numbers(n, random))
  {
    const std::vector<double> distances = two_way_distances(arcs, v);
    search.run_from(v);
    for(std::uint32_t w = 0; w < n; ++w)
    {
      const auto [lower, upper] = labels.distance_interval(v, w);
      ASSERT_LE(lower, distances[w]) << v << ' ' << w;
      ASSERT_GE(upper, distances[w]) << v << ' ' << w;
      ASSERT_LE(lower, search.distance(w)) << v << ' ' << w;
      ASSERT_GE(upper * (1 + graph.asymmetry()) * (1 + 1e-12) + smallest, search.distance(w));
      if(lower > smallest)
      {
        ASSERT_LE(upper, (1 + epsilon) * (1 + rounding) * lower);
      }
      ASSERT_EQ(labels.distance_interval(w, v), std::make_pair(lower, upper));
      ASSERT_EQ(std::isinf(lower), std::isinf(search.distance(w)));
    }
  }
}

TEST(Portal_labels, contain_distances)
{
  Random random(test_seed());
  for(const Named_mesh& row : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(row.name);
    const Triangulation triangulation(row.mesh);
    for(const double epsilon : {0.005, 0.5})
      expect_intervals(edge_graph().make(triangulation), epsilon, random);
    expect_intervals(discrete_geodesic_graph(0.2).make(triangulation), 0.02, random);
  }
}

TEST(Portal_labels, contain_distances_on_random_soups)
{
  Random random(test_seed());
  for(std::uint64_t i = 0; i < number_of_kinds_of_soups; ++i)
  {
    SCOPED_TRACE(test_seed() + i);
    const Triangulation triangulation(to_mesh(random_small_soup(test_seed() + i)));
    expect_intervals(edge_graph().make(triangulation), 0.05, random);
    expect_intervals(discrete_geodesic_graph(0.3).make(triangulation), 0.05, random);
  }
}

TEST(Portal_labels, contain_distances_on_hostile_meshes)
{
  Random random(test_seed());
  for(const Hostile_mesh& row : accepted_meshes())
  {
    SCOPED_TRACE(row.name);
    const Triangulation triangulation(row.mesh);
    expect_intervals(edge_graph().make(triangulation), 0.02, random);
    if(row.refusal_across_faces.empty() && row.mesh.number_of_vertices() < 500)
      expect_intervals(discrete_geodesic_graph(0.2).make(triangulation), 0.02, random);
  }
}

TEST(Portal_labels, heed_weights)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(14, 12, random));
  const Weights weights = random_weights(mesh, random, 0.5, 4, 0.1);
  expect_intervals(steiner_graph(mesh, weights, Fixed_number_of_points(1)), 0.03, random);
}

// Straight lines in the plane are shortest.
TEST(Portal_labels, contain_distances_in_the_plane)
{
  constexpr double bound = 0.05, epsilon = 0.02, rounding = 1 + 1e-5;
  const Mesh mesh = to_mesh(flat_grid(24, 20));
  const auto graph = discrete_geodesic_graph(bound).make(Triangulation(mesh));
  const Portal_labels<Discrete_geodesic_graph> labels(graph);
  EXPECT_EQ(labels.epsilon(), epsilon);
  for(const Vertex v : mesh.vertices())
    for(const Vertex w : mesh.vertices())
    {
      const double exact = std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
      const Triangulation& t = graph.triangulation();
      const auto [lower, upper] = labels.distance_interval(t.vertex(v.idx()), t.vertex(w.idx()));
      ASSERT_LE(exact, upper * rounding);
      ASSERT_LE(upper, (1 + bound) * (1 + epsilon) * rounding * exact);
      ASSERT_LE(lower, (1 + bound) * rounding * exact);
      ASSERT_LE(exact, (1 + epsilon) * rounding * lower * (1 + bound));
    }
}

TEST(Portal_labels, know_what_is_not_connected)
{
  Soup soup = flat_grid(20, 20);
  soup.append(flat_grid(3, 3));
  soup.points.push_back(Point(7, 7, 7));
  const AG::Edge_graph graph{Triangulation(to_mesh(soup))};
  const Portal_labels<AG::Edge_graph> labels(graph);
  const Triangulation& t = graph.triangulation();
  const auto distance = [&](const std::size_t i, const std::size_t j) {
    return labels.distance_interval(t.vertex(i), t.vertex(j)).second;
  };
  EXPECT_EQ(distance(3, 401), infinity);
  EXPECT_EQ(distance(409, 3), infinity);
  EXPECT_EQ(distance(409, 409), 0);
  EXPECT_NEAR(distance(400, 402), 2, 1e-5);
  AG::Surface_search<AG::Edge_graph> search(graph);
  EXPECT_EQ(labels.distance(t.vertex(3), t.vertex(409), 0, search), infinity);
  const AG::Edge_graph empty;
  EXPECT_EQ(Portal_labels<AG::Edge_graph>(empty).number_of_labels(), 0u);
}

TEST(Portal_labels, have_the_same_bits_by_all_threads)
{
  Random random(test_seed());
  const auto graph =
      discrete_geodesic_graph(0.2).make(Triangulation(to_mesh(terrain(24, 22, random))));
  const auto n = static_cast<std::uint32_t>(graph.triangulation().number_of_vertices());
  const Portal_labels<Discrete_geodesic_graph> expected(graph);
  for_each_number_of_threads([&](const auto& tag) {
    const Portal_labels<Discrete_geodesic_graph> labels(graph, tag);
    EXPECT_EQ(labels.number_of_labels(), expected.number_of_labels());
    EXPECT_EQ(labels.memory(), expected.memory());
    for(std::uint32_t v = 0; v < n; v += 7)
      for(std::uint32_t w = 0; w < n; w += 3)
        ASSERT_EQ(labels.distance_interval(v, w), expected.distance_interval(v, w));
  });
}

TEST(Portal_labels, leave_the_rest_to_a_search)
{
  Random random(test_seed());
  const auto graph =
      discrete_geodesic_graph(0.2).make(Triangulation(to_mesh(terrain(25, 20, random))));
  const Portal_labels<Discrete_geodesic_graph> labels(graph, parameters::epsilon(0.1));
  AG::Guided_search<Discrete_geodesic_graph> search(graph);
  AG::Surface_search<Discrete_geodesic_graph> other(graph);
  const AG::Landmarks<Discrete_geodesic_graph> landmarks(graph, 4);
  for(std::uint32_t v = 0; v < 500; v += 41)
  {
    other.run({{Intrinsic_point::at_vertex(v)}});
    for(std::uint32_t w = 0; w < 500; w += 3)
    {
      const double expected = other.distance(Intrinsic_point::at_vertex(w));
      const auto [lower, upper] = labels.distance_interval(v, w);
      for(const double ratio : {0., 0.01, 0.2})
      {
        const double found = labels.distance(v, w, ratio, search);
        ASSERT_LE(found, (1 + ratio) * expected * (1 + 1e-12));
        ASSERT_GE(found * (1 + graph.asymmetry()), expected);
        ASSERT_GE(found, lower);
        if(ratio > 0.11) // no search
        {
          ASSERT_EQ(found, upper);
        }
      }
    }
    if(v > 200)
      search.use_landmarks(landmarks);
  }
}

TEST(Portal_labels, are_those_of_the_graph_as_it_was)
{
  const Mesh mesh = to_mesh(flat_grid(12, 12));
  auto graph = steiner_graph(mesh, Weights(mesh.num_faces(), 4), Fixed_number_of_points(1));
  using Weighted_graph = Steiner_graph<Fixed_number_of_points>;
  const Portal_labels<Weighted_graph> labels(graph);
  AG::Surface_search<Weighted_graph> search(graph);
  const double before = labels.distance(0, 143, 1, search);
  EXPECT_TRUE(labels.are_valid());
  std::vector<AG::Weight_change> changes;
  for(std::uint32_t h = 0; h < graph.triangulation().number_of_halfedges(); ++h)
    if(!graph.triangulation().is_border(h))
      changes.push_back({h, 1});
  graph.set_weights(changes);
  EXPECT_FALSE(labels.are_valid());
  std::ostringstream out;
  expect_message<std::invalid_argument>([&] { labels.save(out); }, "the graph has changed");
  EXPECT_NEAR(labels.distance(0, 143, 1, search), before / 4, 0.03 * before);
}

TEST(Portal_labels, take_more_memory_for_smaller_bounds)
{
  const AG::Edge_graph graph{Triangulation(to_mesh(flat_grid(40, 40)))};
  std::size_t most = 0;
  for(const double epsilon : {10., 0.1, 0.01, 1e-12})
  {
    const Portal_labels<AG::Edge_graph> labels(graph, parameters::epsilon(epsilon));
    EXPECT_GE(labels.number_of_labels(), most);
    EXPECT_GE(labels.memory(), labels.number_of_labels() * 6);
    most = labels.number_of_labels();
  }
  EXPECT_LT(most, 1600u * 200);
}

// Arcs that are left out in one direction lead back, and none is there twice.
TEST(Two_way_arcs, are_those_of_the_graph)
{
  Random random(test_seed());
  const auto graph =
      discrete_geodesic_graph(0.3).make(Triangulation(to_mesh(terrain(15, 12, random))));
  const Two_way_arcs arcs(graph);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> expected, found;
  for(std::uint32_t v = 0; v < graph.number_of_nodes(); ++v)
    graph.for_each_arc(v, 0, [&](const std::uint32_t w, const double length) {
      for(const auto& ends : {std::make_pair(v, w), std::make_pair(w, v)})
      {
        const auto place = expected.emplace(ends, length).first;
        place->second = (std::min)(place->second, length);
      }
    });
  for(std::uint32_t v = 0; v < arcs.number_of_nodes(); ++v)
    arcs.for_each_arc(v, 0, [&](const std::uint32_t w, const double length) {
      EXPECT_TRUE(found.emplace(std::make_pair(v, w), length).second);
    });
  EXPECT_EQ(found, expected);
}

// A last part may be bent around a hole of others.
TEST(Portal_labels, know_paths_that_leave_a_last_part)
{
  AG::internal::Portal_part whole, last;
  whole.is_last = false;
  whole.vertices = {0, 1, 2};
  whole.labels = {{{0, 1}}, {{0, 1}}, {{0, 0}}};
  whole.size = 1;
  whole.table = {0};
  last.parent = 0;
  last.depth = 1;
  last.vertices = {0, 1};
  last.size = 2;
  for(const float within : {1.f, 2.f, 2.01f, 2.2f, 9.f})
  {
    last.table = {within};
    const AG::internal::Portal_tables tables({whole, last}, 3, AG::internal::Portal_scale(), 0.1);
    const auto [lower, upper] = tables.interval(0, 1);
    EXPECT_NEAR(upper, (std::min)(2.f, within), 1e-5);
    EXPECT_NEAR(lower, (std::min)(2 / 1.1f, within), 1e-5);
    EXPECT_LE(lower, (std::min)(2 / 1.1, double(within)));
    EXPECT_EQ(tables.interval(1, 0), std::make_pair(lower, upper));
  }
}

class Portal_file : public testing::Test
{
protected:
  using Labels = Portal_labels<Discrete_geodesic_graph>;

  Portal_file()
    : m_random(test_seed()),
      m_mesh(to_mesh(terrain(30, 8, m_random))),
      m_graph(Triangulation(m_mesh), parameters::epsilon(0.3)),
      m_labels(m_graph, parameters::epsilon(0.1)),
      m_file(saved(m_labels))
  {
  }

  template <typename AnyLabels>
  static std::string saved(const AnyLabels& labels)
  {
    std::ostringstream out(std::ios::binary);
    labels.save(out);
    return out.str();
  }

  template <typename AnyGraph>
  static Portal_labels<AnyGraph> loaded(const std::string& file, const AnyGraph& graph)
  {
    std::istringstream in(file, std::ios::binary);
    return Portal_labels<AnyGraph>::load(in, graph);
  }

  void expect_refused(const std::string& file, const std::string& reason) const
  {
    expect_message<std::invalid_argument>([&] { loaded(file, m_graph); }, reason);
  }

  Random m_random;
  Mesh m_mesh;
  Discrete_geodesic_graph m_graph;
  Labels m_labels;
  std::string m_file;
};

TEST_F(Portal_file, gives_the_same_intervals)
{
  const Labels read = loaded(m_file, m_graph);
  EXPECT_EQ(read.epsilon(), 0.1);
  EXPECT_EQ(&read.graph(), &m_graph);
  EXPECT_TRUE(read.are_valid());
  EXPECT_EQ(read.number_of_labels(), m_labels.number_of_labels());
  EXPECT_GT(read.number_of_labels(), 240u);
  EXPECT_EQ(saved(read), m_file);
  for(std::uint32_t v = 0; v < 240; v += 7)
    for(std::uint32_t w = 0; w < 240; ++w)
      ASSERT_EQ(read.distance_interval(v, w), m_labels.distance_interval(v, w));
}

TEST_F(Portal_file, holds_labels_of_a_mesh_in_pieces)
{
  for(const Named_mesh& row : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(row.name);
    const AG::Edge_graph graph{Triangulation(row.mesh)}, empty;
    const Portal_labels<AG::Edge_graph> built(graph);
    EXPECT_EQ(saved(loaded(saved(built), graph)), saved(built));
    const Portal_labels<AG::Edge_graph> none(empty);
    EXPECT_EQ(loaded(saved(none), empty).number_of_labels(), 0u);
  }
}

TEST_F(Portal_file, is_refused_if_anything_is_missing_or_changed)
{
  for(std::size_t size = 0; size < m_file.size(); size += 1 + size / 20)
    expect_refused(m_file.substr(0, size), "is truncated");
  for(std::size_t i = 0; i < m_file.size(); i += 1 + i / 20)
  {
    std::string file = m_file;
    file[i] = static_cast<char>(file[i] ^ (1 << (i % 8)));
    EXPECT_THROW(loaded(file, m_graph), std::invalid_argument) << "at byte " << i;
  }
}

// The checksum is right; only distances of different places are in the table.
TEST_F(Portal_file, is_refused_if_two_vertices_are_at_one_place)
{
  const AG::Edge_graph graph{Triangulation(to_mesh(flat_grid(2, 2)))}; // is one last part
  const std::string file = saved(Portal_labels<AG::Edge_graph>(graph));
  constexpr std::size_t size_of_vertex = 8, size_of_checksum = 4;
  const std::size_t last = file.size() - size_of_checksum - size_of_vertex;
  std::string damaged = file.substr(0, last) + file.substr(last - size_of_vertex, size_of_vertex);
  AG::internal::Checksum checksum;
  for(const char byte : damaged)
    checksum.add(static_cast<std::uint8_t>(byte));
  for(const auto byte : AG::internal::to_bytes(checksum.value()))
    damaged.push_back(static_cast<char>(byte));
  ASSERT_EQ(damaged.size(), file.size());
  expect_message<std::invalid_argument>([&] { loaded(damaged, graph); }, "the same place");
}

TEST_F(Portal_file, is_refused_if_it_is_something_else)
{
  expect_refused("OFF\n8 12 0\n0 0 0\n", "not that of labels");
  std::string other = m_file;
  other[8] = 7;
  expect_refused(other, "version 7");
  const Discrete_geodesic_graph finer(Triangulation(m_mesh), parameters::epsilon(0.1));
  expect_message<std::invalid_argument>([&] { loaded(m_file, finer); }, "another graph", "arcs");
  const AG::Edge_graph larger{Triangulation(to_mesh(flat_grid(30, 9)))};
  expect_message<std::invalid_argument>([&] { loaded(m_file, larger); }, "another graph",
                                        "240 vertices, this one has 270");
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  expect_message<std::runtime_error>([&] { m_labels.save(out); }, "could not be written");
}

TEST(Portal_labels, can_be_interrupted)
{
  const AG::Edge_graph graph{Triangulation(to_mesh(flat_grid(30, 20)))};
  for_each_number_of_threads([&](const auto& tag) {
    for(const int number : {0, 1, 5, 40, 300})
    {
      const Interruption_at interruption(number);
      EXPECT_THROW(Portal_labels<AG::Edge_graph>(graph, tag), std::runtime_error);
    }
  });
}

TEST(Portal_labels, refuse_bad_input)
{
  const Mesh mesh = to_mesh(flat_grid(5, 4));
  const AG::Edge_graph graph{Triangulation(mesh)}, other{Triangulation(mesh)};
  using Edge_labels = Portal_labels<AG::Edge_graph>;
  for(const double epsilon : {0., -1., infinity, std::nan("")})
    expect_message<std::invalid_argument>([&] { Edge_labels(graph, parameters::epsilon(epsilon)); },
                                          "epsilon is", "finite number larger than 0");
  const Edge_labels labels(graph);
  expect_message<std::invalid_argument>([&] { labels.distance_interval(20, 0); },
                                        "vertex 20 does not exist", "20 vertices");
  expect_message<std::invalid_argument>([&] { labels.distance_interval(0, 4000000000u); },
                                        "vertex 4000000000 does not exist");
  AG::Surface_search<AG::Edge_graph> search(graph), search_of_other(other);
  for(const double ratio : {-0.1, std::nan("")})
    expect_message<std::invalid_argument>([&] { labels.distance(0, 1, ratio, search); },
                                          "the ratio is");
  expect_message<std::invalid_argument>([&] { labels.distance(0, 1, 1, search_of_other); },
                                        "another graph");
}

TEST(Portal_labels, refuse_directions_and_barriers)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(flat_grid(5, 4));
  const Dense_graph graph = dense_graph(mesh, cost_of_faces(random_slants(mesh, random, 0.5)), 1);
  expect_message<std::invalid_argument>([&] { Portal_labels<Dense_graph>{graph}; }, "direction");
  const Barriers barriers = random_barriers(mesh, 0.3, random);
  const Steiner_graph<Fixed_number_of_points> with_walls(
      Triangulation(mesh, with_barriers(barriers)), Fixed_number_of_points(1));
  expect_message<std::invalid_argument>(
      [&] { Portal_labels<Steiner_graph<Fixed_number_of_points>>{with_walls}; }, "barriers");
}

// What is left has no arcs between its pieces, and none of them is much larger than the others
// together.
TEST(Portal_separators, separate)
{
  Random random(test_seed());
  for(const Named_mesh& row : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(row.name);
    const Two_way_arcs all(discrete_geodesic_graph(0.2).make(Triangulation(row.mesh)));
    for(const Part_nodes& part : AG::internal::connected_parts(all))
    {
      const Two_way_arcs arcs = arcs_of_part(all, part);
      Two_way_search search(arcs);
      const Part_nodes separator = AG::internal::Separator(arcs, search).nodes();
      std::vector<int> piece_of(part.size(), -1);
      std::size_t number = separator.size();
      int piece = 0;
      for(const Part_nodes& nodes : AG::internal::connected_parts(arcs, separator))
      {
        EXPECT_LE(3 * nodes.size(), 2 * part.size() + 3);
        number += nodes.size();
        for(const auto node : nodes)
          piece_of[node] = piece;
        ++piece;
      }
      EXPECT_EQ(number, part.size());
      for(std::uint32_t node = 0; node < part.size(); ++node)
        arcs.for_each_neighbor(node, [&](const auto other) {
          EXPECT_TRUE(piece_of[node] == piece_of[other] || piece_of[node] < 0 ||
                      piece_of[other] < 0);
        });
    }
  }
}

// Also where rows of distances are found in several blocks.
TEST(Portal_cover, covers_all_nodes)
{
  Random random(test_seed());
  const Two_way_arcs arcs(
      discrete_geodesic_graph(0.1).make(Triangulation(to_mesh(terrain(40, 15, random)))));
  AG::internal::Workspaces<Two_way_search> searches(arcs);
  Part_nodes separator;
  for(std::uint32_t node = 0; node < 600; node += 7)
    separator.push_back(node);
  constexpr float stretch = 1.02f;
  const AG::internal::Portal_scale scale(arcs.arc_lengths().longest);
  std::vector<std::vector<double>> rows;
  for(const auto node : separator)
    rows.push_back(two_way_distances(arcs, node));
  for(const std::size_t bytes : {0u, 1u << 26})
  {
    AG::internal::Portal_part part;
    for(std::uint32_t node = 0; node < 600; ++node)
      part.vertices.push_back(node);
    AG::internal::Portal_cover(searches, {}, scale, stretch, separator, part, bytes).run();
    ASSERT_EQ(part.size, separator.size()); // each has a label at itself
    for(std::uint32_t v = 0; v < 600; ++v)
      for(std::size_t q = 0; q < separator.size(); ++q)
      {
        double smallest = infinity;
        for(const auto& label : part.labels[v])
        {
          EXPECT_NEAR(scale.label(label.distance) * arcs.unit(), rows[label.portal][v],
                      1e-6 * rows[label.portal][v]);
          smallest = (std::min)(smallest, rows[label.portal][v] + rows[label.portal][separator[q]]);
        }
        ASSERT_LE(smallest, 1.02 * (1 + 1e-6) * rows[q][v]);
      }
  }
}

} // namespace
