// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes/surface_points.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Graphs/Discrete_geodesic_graph.h>
#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <vector>

// Property maps that throw when they are read or written.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Polylines = std::vector<std::vector<Point>>;
using Values = std::vector<double>;
using Vectors = std::vector<Kernel::Vector_3>;

// How often maps may be used before one throws.
class Patience
{
public:
  void set(const std::size_t number) { m_number = number; }
  void use()
  {
    if(m_number == 0)
      throw std::runtime_error("from the map");
    --m_number;
  }

private:
  std::size_t m_number = 0;
};

template <typename Descriptor, typename Value>
struct Impatient_map
{
  using key_type = Descriptor;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;

  friend Value get(const Impatient_map& map, const Descriptor d)
  {
    map.patience->use();
    return (*map.values)[d];
  }

  friend void put(const Impatient_map& map, const Descriptor d, const Value& value)
  {
    map.patience->use();
    (*map.values)[d] = value;
  }

  std::vector<Value>* values;
  Patience* patience;
};

// A mesh, its properties, and maps to them.
class Impatient_maps : public testing::Test
{
protected:
  Impatient_maps()
    : m_mesh(to_mesh(terrain(9, 7, m_random))),
      m_lengths(edge_lengths(m_mesh)),
      m_weights(random_weights(m_mesh, m_random, 0.5, 2))
  {
    for(const Vertex v : m_mesh.vertices())
      m_points.push_back(m_mesh.point(v));
  }

  template <typename Descriptor, typename Value>
  Impatient_map<Descriptor, Value> map(std::vector<Value>& values)
  {
    return {&values, &m_patience};
  }

  // Calls `operation` with patience for no use of a map, for one, and so on until there is no
  // exception, and `check` after each one. Returns how much patience it took.
  template <typename Operation, typename Check>
  std::size_t interrupt(Operation operation, Check check)
  {
    for(std::size_t number = 0;; ++number)
      try
      {
        m_patience.set(number);
        operation();
        return number;
      }
      catch(const std::runtime_error&)
      {
        m_patience.set(number);
        check(number);
      }
  }

  auto point_map() { return map<Vertex>(m_points); }

  Random m_random = Random(test_seed());
  const Mesh m_mesh;
  std::vector<Point> m_points;
  Values m_lengths, m_weights;
  Patience m_patience;
};

TEST_F(Impatient_maps, end_the_construction_of_a_triangulation)
{
  const auto expect_uses = [&](const std::size_t number, const auto& np) {
    const auto construct = [&] { EXPECT_TRUE(Triangulation(m_mesh, np).is_valid()); };
    EXPECT_GE(interrupt(construct, [](std::size_t) {}), number);
  };
  expect_uses(m_mesh.number_of_vertices(), parameters::vertex_point_map(point_map()));
  expect_uses(m_mesh.number_of_edges(), parameters::edge_length_map(map<Edge>(m_lengths)));
  expect_uses(m_mesh.number_of_faces(), parameters::face_weight_map(map<Face>(m_weights)));
}

TEST_F(Impatient_maps, leave_distances_alone_if_they_are_read)
{
  const auto expect_untouched = [&](const auto& np) {
    Values distances(m_points.size(), -1);
    const auto distance_map =
        boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh));
    interrupt([&] { CGAL::approximate_geodesic_distances(m_mesh, distance_map, Vertex(3), np); },
              [&](std::size_t) { EXPECT_EQ(distances, Values(m_points.size(), -1)); });
    EXPECT_EQ(distances[3], 0);
  };
  expect_untouched(parameters::vertex_point_map(point_map()));
  expect_untouched(parameters::epsilon(0.5).vertex_point_map(point_map()));
  expect_untouched(parameters::edge_length_map(map<Edge>(m_lengths)));
  expect_untouched(parameters::face_weight_map(map<Face>(m_weights)));
}

// First all distances, then all sources, and then all predecessors, each in the order of the
// vertices.
TEST_F(Impatient_maps, have_what_was_written_before)
{
  const std::size_t n = m_points.size();
  const Values expected = Mesh_search(m_mesh).distances({Vertex(3)});
  Values distances;
  std::vector<std::size_t> sources;
  std::vector<Vertex> predecessors;
  const auto forget = [&] {
    distances.assign(n, -1);
    sources.assign(n, 99);
    predecessors.assign(n, Vertex(99));
  };
  const auto check = [&](const std::size_t number_written) {
    for(std::size_t i = 0; i < n; ++i)
    {
      EXPECT_EQ(distances[i], i < number_written ? expected[i] : -1);
      EXPECT_EQ(sources[i], n + i < number_written ? 0u : 99u);
      EXPECT_EQ(predecessors[i] != Vertex(99), 2 * n + i < number_written);
    }
  };
  const std::size_t uses = interrupt(
      [&] {
        forget();
        CGAL::approximate_geodesic_distances(m_mesh, map<Vertex>(distances), Vertex(3),
                                             parameters::nearest_source_map(map<Vertex>(sources))
                                                 .predecessor_map(map<Vertex>(predecessors)));
      },
      check);
  EXPECT_EQ(uses, 3 * n);
  check(uses);
}

TEST_F(Impatient_maps, leave_weights_alone)
{
  using Weighted_graph = Steiner_graph<Fixed_number_of_points>;
  using Paths = AG::Surface_mesh_shortest_path<Mesh, Weighted_graph>;
  Paths paths(m_mesh,
              steiner_graph(m_mesh, Weights(m_mesh.num_faces(), 1), Fixed_number_of_points(1)));
  paths.add_source_point(Vertex(3));
  const auto cost = [&] { return paths.shortest_distance_to_source_points(Vertex(60)).first; };
  const double before = cost();
  interrupt([&] { paths.set_face_weights(map<Face>(m_weights)); },
            [&](std::size_t) { EXPECT_EQ(cost(), before); });
  EXPECT_EQ(cost(), costs(m_mesh, m_weights, Fixed_number_of_points(1), {Vertex(3)})[60]);
}

TEST_F(Impatient_maps, interrupt_queries_of_the_class)
{
  using Paths = AG::Surface_mesh_shortest_path<Mesh, AG::Discrete_geodesic_graph>;
  m_patience.set(1000000);
  Paths paths(m_mesh, parameters::vertex_point_map(point_map()));
  const Face_location source = random_face_location(m_mesh, m_random);
  paths.add_source_point(source);
  const double expected = paths.shortest_distance_to_source_points(Vertex(60)).first;

  std::vector<Point> points, all_points;
  paths.shortest_path_points_to_source_points(Vertex(60), std::back_inserter(all_points));
  interrupt(
      [&] {
        points.clear();
        EXPECT_EQ(
            paths.shortest_path_points_to_source_points(Vertex(60), std::back_inserter(points))
                .first,
            paths.shortest_path_points(Vertex(60), source, std::back_inserter(points)));
      },
      [&](std::size_t) {
        EXPECT_TRUE(std::equal(points.begin(),
                               points.begin() +
                                   std::ptrdiff_t((std::min)(points.size(), all_points.size())),
                               all_points.begin()));
        EXPECT_EQ(paths.shortest_distance_to_source_points(Vertex(60)).first, expected);
      });
}

// The points of a path that were written when the next one's could not be read.
TEST_F(Impatient_maps, interrupt_paths_that_are_written)
{
  const auto expect_first_points = [&](const auto& np) {
    std::vector<Point> points, all_points;
    CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(all_points), Vertex(3), Vertex(60),
                                    np);
    interrupt(
        [&] {
          points.clear();
          CGAL::approximate_geodesic_path(
              m_mesh, std::back_inserter(points), Vertex(3), Vertex(60),
              parameters::combine(np, parameters::vertex_point_map(point_map())));
        },
        [&](std::size_t) {
          ASSERT_LE(points.size(), all_points.size());
          EXPECT_TRUE(std::equal(points.begin(), points.end(), all_points.begin()));
        });
    EXPECT_EQ(points, all_points);
  };
  expect_first_points(parameters::maximum_distance(1e9));
  expect_first_points(parameters::epsilon(0.1));
}

class Impatient_maps_of_a_field : public Impatient_maps
{
protected:
  Impatient_maps_of_a_field() : m_field(Mesh_search(m_mesh).distances({Vertex(3)})) {}

  Values m_field;
};

// It reads and writes one face after the other.
TEST_F(Impatient_maps_of_a_field, leave_the_first_gradients)
{
  const Vectors nothing(m_mesh.num_faces(), Kernel::Vector_3(9, 9, 9));
  Vectors gradients, all_gradients = nothing;
  const auto gradient = [&](Vectors& vectors) {
    AG::gradient(m_mesh, map<Vertex>(m_field),
                 boost::make_iterator_property_map(vectors.begin(), get(CGAL::face_index, m_mesh)),
                 parameters::vertex_point_map(point_map()));
  };
  m_patience.set(1000000);
  gradient(all_gradients);
  interrupt(
      [&] {
        gradients = nothing;
        gradient(gradients);
      },
      [&](const std::size_t number) {
        const std::size_t number_written = number / 6; // of a point and a value for each corner
        for(std::size_t i = 0; i < nothing.size(); ++i)
          EXPECT_EQ(gradients[i], i < number_written ? all_gradients[i] : nothing[i]);
      });
  EXPECT_EQ(gradients, all_gradients);
}

TEST_F(Impatient_maps_of_a_field, leave_whole_isolines)
{
  const Values isovalues = {1, 2, 5};
  Polylines polylines, all_polylines;
  const auto isolines = [&](Polylines& result) {
    result.clear();
    AG::isolines(m_mesh, map<Vertex>(m_field), isovalues, std::back_inserter(result),
                 parameters::vertex_point_map(point_map()));
  };
  m_patience.set(1000000);
  isolines(all_polylines);
  interrupt([&] { isolines(polylines); },
            [&](std::size_t) {
              ASSERT_LE(polylines.size(), all_polylines.size());
              EXPECT_TRUE(std::equal(polylines.begin(), polylines.end(), all_polylines.begin()));
            });
  EXPECT_EQ(polylines, all_polylines);
}

} // namespace
