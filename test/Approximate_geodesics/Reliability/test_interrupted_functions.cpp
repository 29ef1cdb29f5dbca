// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Interrupted_function.h"

#include <CGAL/approximate_geodesic_distances.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <iterator>

namespace {

namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST_F(Interrupted_function, approximate_geodesic_distances)
{
  const auto index_map = get(boost::vertex_index, m_mesh);
  expect_survival_of([&](Results_of_functions& r) {
    CGAL::approximate_geodesic_distances(
        m_mesh, map(r.distance), m_sources,
        parameters::nearest_source_map(
            boost::make_iterator_property_map(r.source.begin(), index_map))
            .predecessor_map(boost::make_iterator_property_map(r.predecessor.begin(), index_map)));
  });
  expect_survival_of([&](Results_of_functions& r) {
    CGAL::approximate_geodesic_distances(
        m_mesh, map(r.distance), m_sources,
        parameters::epsilon(0.3).predecessor_map(
            boost::make_iterator_property_map(r.predecessor.begin(), index_map)));
  });
}

TEST_F(Interrupted_function, approximate_geodesic_path)
{
  expect_survival_of([&](Results_of_functions& r) {
    CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(r.points), Vertex(3), Vertex(60));
  });
  expect_survival_of([&](Results_of_functions& r) {
    CGAL::approximate_geodesic_path(m_mesh, std::back_inserter(r.points), Vertex(3), Vertex(60),
                                    parameters::epsilon(0.1).straighten(true));
  });
}

} // namespace
