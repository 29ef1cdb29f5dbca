// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks/failing_allocation.h"
#include "meshes/test_weights.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/Geodesic_queries/refined_path.h>
#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

// Functions that end for want of memory.

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;
using Polylines = std::vector<std::vector<Point>>;

// What functions write to, and has room.
struct Results
{
  explicit Results(const Mesh& mesh)
    : distance(mesh.num_vertices(), -1),
      source(mesh.num_vertices(), 99),
      predecessor(mesh.num_vertices()),
      source_of_face(mesh.num_faces(), 99),
      gradient(mesh.num_faces(), Kernel::Vector_3(-1, -1, -1))
  {
    samples.reserve(10);
    points.reserve(100);
    polylines.reserve(100);
  }

  bool no_map_is_written() const
  {
    const auto are = [](const auto& values, const auto& value) {
      return std::count(values.begin(), values.end(), value) == std::ptrdiff_t(values.size());
    };
    return are(distance, -1) && are(source, 99u) && are(predecessor, Vertex()) &&
           are(source_of_face, 99u) && are(gradient, Kernel::Vector_3(-1, -1, -1));
  }

  Values distance;
  std::vector<std::size_t> source;
  std::vector<Vertex> predecessor;
  std::vector<std::size_t> source_of_face;
  std::vector<Kernel::Vector_3> gradient;
  std::vector<Vertex> samples = {};
  std::vector<Point> points = {};
  Polylines polylines = {};
};

class Interrupted_function : public testing::Test
{
protected:
  Interrupted_function() : m_mesh(to_mesh(terrain(9, 7, m_random))) {}

  // Maps are written to after all that could fail; and so are iterators, but for those that receive
  // several things which are found one after the other.
  void expect_survival_of(const std::function<void(Results&)>& function) const
  {
    expect_survival<Results>({[&] { return Results(m_mesh); },
                              [&](Results& results) {
                                results.samples.clear();
                                results.polylines.clear();
                                function(results);
                              },
                              [](Results& results) { return values(results); },
                              [](Results& results) {
                                EXPECT_TRUE(results.no_map_is_written());
                                EXPECT_TRUE(results.points.empty());
                              }});
  }

  static Values values(const Results& results)
  {
    Values result = results.distance;
    for(std::size_t i = 0; i < results.source.size(); ++i)
    {
      result.push_back(static_cast<double>(results.source[i]));
      result.push_back(results.predecessor[i].idx());
    }
    for(std::size_t i = 0; i < results.gradient.size(); ++i)
    {
      result.push_back(static_cast<double>(results.source_of_face[i]));
      append(results.gradient[i], result);
    }
    for(const Vertex v : results.samples)
      result.push_back(v.idx());
    for(const Point& p : results.points)
      append(p, result);
    for(const auto& polyline : results.polylines)
      for(const Point& p : polyline)
        append(p, result);
    return result;
  }

  template <typename T>
  static void append(const T& t, Values& result)
  {
    result.insert(result.end(), {t.x(), t.y(), t.z()});
  }

  auto map(Values& distance) const
  {
    return boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, m_mesh));
  }

  Random m_random = Random(test_seed());
  const Mesh m_mesh;
  const std::array<Vertex, 2> m_sources = {Vertex(3), Vertex(40)};
};

TEST_F(Interrupted_function, approximate_geodesic_distances)
{
  const auto index_map = get(boost::vertex_index, m_mesh);
  const Weights weights(m_mesh.num_faces(), 2);
  expect_survival_of([&](Results& r) {
    CGAL::approximate_geodesic_distances(
        m_mesh, map(r.distance), m_sources,
        parameters::nearest_source_map(
            boost::make_iterator_property_map(r.source.begin(), index_map))
            .predecessor_map(boost::make_iterator_property_map(r.predecessor.begin(), index_map)));
  });
  expect_survival_of([&](Results& r) {
    CGAL::approximate_geodesic_distances(
        m_mesh, map(r.distance), m_sources,
        parameters::epsilon(0.3).predecessor_map(
            boost::make_iterator_property_map(r.predecessor.begin(), index_map)));
  });
  expect_survival_of([&](Results& r) {
    CGAL::approximate_geodesic_distances(
        m_mesh, map(r.distance), m_sources,
        parameters::epsilon(1.).face_weight_map(weight_map(weights)));
  });
}

TEST_F(Interrupted_function, approximate_geodesic_path)
{
  expect_survival_of([&](Results& r) {
    CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(r.points), Vertex(3), Vertex(60));
  });
  expect_survival_of([&](Results& r) {
    CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(r.points), Vertex(3), Vertex(60),
                                    parameters::epsilon(0.1).straighten(true));
  });
}

TEST_F(Interrupted_function, refined_path)
{
  expect_survival_of([&](Results& r) {
    AG::refined_path(m_mesh, std::back_inserter(r.points), Vertex(3), Vertex(60));
  });
}

TEST_F(Interrupted_function, voronoi_partition)
{
  expect_survival_of([&](Results& r) {
    const auto face_index_map = get(CGAL::face_index, m_mesh);
    const auto vertex_index_map = get(boost::vertex_index, m_mesh);
    AG::voronoi_partition(
        m_mesh, boost::make_iterator_property_map(r.source_of_face.begin(), face_index_map),
        m_sources,
        parameters::nearest_source_map(
            boost::make_iterator_property_map(r.source.begin(), vertex_index_map)));
  });
}

TEST_F(Interrupted_function, farthest_point_sampling)
{
  expect_survival_of([&](Results& r) {
    AG::farthest_point_sampling(m_mesh, std::back_inserter(r.samples), 8, Vertex(3));
  });
}

TEST_F(Interrupted_function, on_a_field)
{
  Values field(m_mesh.num_vertices());
  CGAL::approximate_geodesic_distances(m_mesh, map(field), Vertex(3));
  expect_survival_of([&](Results& r) {
    AG::isolines(m_mesh, map(field), std::vector<double>{1, 2, 4}, std::back_inserter(r.polylines));
  });
  Results results(m_mesh);
  const auto gradient =
      boost::make_iterator_property_map(results.gradient.begin(), get(CGAL::face_index, m_mesh));
  EXPECT_TRUE(needs_no_allocation([&] { AG::gradient(m_mesh, map(field), gradient); }));
}

} // namespace
