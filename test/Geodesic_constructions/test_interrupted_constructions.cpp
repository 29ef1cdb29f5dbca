// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Interrupted_function.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>
#include <CGAL/Geodesic_constructions/voronoi_partition.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST_F(Interrupted_function, voronoi_partition)
{
  expect_survival_of([&](Results_of_functions& r) {
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
  expect_survival_of([&](Results_of_functions& r) {
    AG::farthest_point_sampling(m_mesh, std::back_inserter(r.samples), 8, Vertex(3));
  });
}

TEST_F(Interrupted_function, on_a_field)
{
  Values field(m_mesh.num_vertices());
  CGAL::approximate_geodesic_distances(m_mesh, map(field), Vertex(3));
  expect_survival_of([&](Results_of_functions& r) {
    AG::isolines(m_mesh, map(field), std::vector<double>{1, 2, 4}, std::back_inserter(r.polylines));
  });
  Results_of_functions results(m_mesh);
  const auto gradient =
      boost::make_iterator_property_map(results.gradient.begin(), get(CGAL::face_index, m_mesh));
  EXPECT_TRUE(needs_no_allocation([&] { AG::gradient(m_mesh, map(field), gradient); }));
}

} // namespace
