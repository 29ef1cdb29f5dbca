// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/distance_fields.h"
#include "checks/expect_message.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Geodesic_costs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Points as far as possible from those before.

namespace {

using namespace geodesics_test;

// A search from all points for every point.
template <typename GeodesicGraph>
Sample sample_from_scratch(Basic_mesh_search<GeodesicGraph> search,
                           std::vector<Vertex> sources,
                           const std::size_t number)
{
  Sample result;
  for(;;)
  {
    const std::vector<double> distances = search.distances(sources);
    const auto farthest = std::max_element(distances.begin(), distances.end());
    result.radius = *farthest;
    if(result.points.size() == number || result.radius == 0)
      return result;
    const auto i = static_cast<Mesh::size_type>(farthest - distances.begin());
    result.points.push_back(Vertex(i));
    sources.push_back(Vertex(i));
  }
}

template <typename GeodesicGraph, typename... NamedParameters>
void expect_sample_from_scratch(const Mesh& mesh, const NamedParameters&... np)
{
  for(const std::vector<Vertex>& sources : {std::vector<Vertex>{}, {Vertex(2), Vertex(1)}})
  {
    const Sample found = sample(mesh, sources, 30, np...);
    const Sample expected =
        sample_from_scratch(Basic_mesh_search<GeodesicGraph>(mesh, np...), sources, 30);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.radius, expected.radius); // bit for bit
  }
}

TEST(Farthest_point_sampling, is_the_same_as_from_scratch)
{
  for(const auto& [name, mesh] : generated_meshes(test_seed()))
  {
    SCOPED_TRACE(name);
    expect_sample_from_scratch<AG::Edge_graph>(mesh);
    expect_sample_from_scratch<AG::Discrete_geodesic_graph>(mesh, parameters::epsilon(0.2));
    expect_sample_from_scratch<AG::Steiner_graph<AG::Fixed_number_of_points>>(
        mesh, parameters::number_of_points_per_edge(1));
  }
}

// A hexagon with its center, all of whose edges have length 1.
TEST(Farthest_point_sampling, chooses_the_first_of_those_that_are_equally_far)
{
  const Mesh mesh = to_mesh(fan(6));
  const auto one = boost::make_static_property_map<Edge>(1.);
  const auto np = parameters::edge_length_map(one);
  for(std::size_t number = 0; number < 10; ++number)
  {
    const Sample found = sample(mesh, {}, number, np);
    EXPECT_EQ(found.radius, number == 0 ? infinity : number < 7 ? 1 : 0);
    ASSERT_EQ(found.points.size(), (std::min<std::size_t>)(number, 7));
    for(std::size_t i = 0; i < found.points.size(); ++i)
      EXPECT_EQ(found.points[i], Vertex(Mesh::size_type(i)));
  }
}

// Both sides of it are at the same place, as only lengths along it count.
TEST(Farthest_point_sampling, halves_a_strip)
{
  const Mesh mesh = to_mesh(flat_grid(17, 2));
  const auto x = [&](const Vertex v) { return mesh.point(v).x(); };
  const auto lengths = boost::make_function_property_map<Edge, double>(
      [&](const Edge e) { return std::abs(x(mesh.vertex(e, 0)) - x(mesh.vertex(e, 1))); });
  const Sample found = sample(mesh, {Vertex(0)}, 1000, parameters::edge_length_map(lengths));
  const std::vector<double> expected = {16, 8, 4, 12, 2, 6, 10, 14, 1, 3, 5, 7, 9, 11, 13, 15};
  ASSERT_EQ(found.points.size(), expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(x(found.points[i]), expected[i]);
  EXPECT_EQ(found.radius, 0);
}

TEST(Farthest_point_sampling, gives_every_part_a_point_first)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(scattered_parts(random));
  const Vertex last(mesh.number_of_vertices() - 1);
  const std::vector<Vertex> firsts = {Vertex(0), Vertex(1), Vertex(2), Vertex(2 + 12 * 9), last};
  for(std::size_t number = 0; number < 5; ++number)
  {
    const Sample found = sample(mesh, {}, number);
    EXPECT_EQ(found.points,
              std::vector<Vertex>(firsts.begin(), firsts.begin() + std::ptrdiff_t(number)));
    EXPECT_EQ(found.radius, infinity);
  }
  EXPECT_LT(sample(mesh, {}, 5).radius, infinity);
  EXPECT_EQ(sample(mesh, {last, Vertex(0)}, 2).points, std::vector<Vertex>({Vertex(1), Vertex(2)}));
}

TEST(Farthest_point_sampling, takes_no_source_or_one_or_a_range_and_returns_the_radius)
{
  Random random(test_seed());
  const Mesh mesh = to_mesh(terrain(20, 20, random));
  const auto np = parameters::epsilon(0.3);
  const Sample expected = sample(mesh, {}, 50), across_faces = sample(mesh, {}, 50, np);
  std::vector<Vertex> same, same_across_faces, from_vertex, from_vertex_across_faces;
  EXPECT_EQ(AG::farthest_point_sampling(mesh, std::back_inserter(same), 50), expected.radius);
  EXPECT_EQ(same, expected.points);
  EXPECT_EQ(AG::farthest_point_sampling(mesh, std::back_inserter(same_across_faces), 50, np),
            across_faces.radius);
  EXPECT_EQ(same_across_faces, across_faces.points);
  EXPECT_EQ(AG::farthest_point_sampling(mesh, std::back_inserter(from_vertex), 49, Vertex(0)),
            expected.radius);
  EXPECT_TRUE(std::equal(from_vertex.begin(), from_vertex.end(), expected.points.begin() + 1));
  EXPECT_EQ(AG::farthest_point_sampling(mesh, std::back_inserter(from_vertex_across_faces), 49,
                                        Vertex(0), np),
            across_faces.radius);
  EXPECT_EQ(from_vertex_across_faces.size(), 49u);
  EXPECT_TRUE(std::equal(from_vertex_across_faces.begin(), from_vertex_across_faces.end(),
                         across_faces.points.begin() + 1));
}

TEST(Farthest_point_sampling, takes_numbers_of_any_type_but_no_negative_one)
{
  const Mesh mesh = to_mesh(fan(6));
  std::vector<Vertex> points;
  const auto number_of_points = [&](const auto number) {
    points.clear();
    AG::farthest_point_sampling(mesh, std::back_inserter(points), number);
    return points.size();
  };
  EXPECT_EQ(number_of_points(0), 0u);
  EXPECT_EQ(number_of_points(std::size_t(2)), 2u);
  EXPECT_EQ(number_of_points(short(3)), 3u);
  EXPECT_EQ(number_of_points(1000000), 7u); // of all vertices
  EXPECT_EQ(number_of_points((std::numeric_limits<std::size_t>::max)()), 7u);
  for(const int number : {-1, (std::numeric_limits<int>::min)()})
    expect_message<std::invalid_argument>([&] { number_of_points(number); }, "number of points",
                                          std::to_string(number), "not be negative");
  EXPECT_TRUE(points.empty());
}

} // namespace
