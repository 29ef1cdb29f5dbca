// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "threads/same_from_all_threads.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

TEST_F(Threads_with_a_mesh, may_find_samples)
{
  expect_same_from_all_threads([&](const std::size_t i) {
    std::vector<Vertex> samples;
    Values result = {
        AG::farthest_point_sampling(m_mesh, std::back_inserter(samples), 5, vertex(i))};
    for(const Vertex v : samples)
      result.push_back(v.idx());
    return result;
  });
}

TEST_F(Threads_with_a_mesh, may_evaluate_a_field)
{
  Values field;
  const auto field_map = map(field);
  CGAL::approximate_geodesic_distances(m_mesh, field_map, vertex(3));
  expect_same_from_all_threads([&](const std::size_t i) {
    std::vector<std::vector<Point>> polylines;
    AG::isolines(m_mesh, field_map, std::vector<double>{3, 5 + double(i)},
                 std::back_inserter(polylines));
    Values result(m_mesh.number_of_faces());
    AG::voronoi_partition(
        m_mesh, boost::make_iterator_property_map(result.begin(), get(CGAL::face_index, m_mesh)),
        std::vector<Vertex>{vertex(0), vertex(30 * i + 60)});
    for(const auto& polyline : polylines)
      for(const Point& p : polyline)
        result.insert(result.end(), {p.x(), p.y(), p.z()});
    return result;
  });
}

} // namespace
