// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Wrong_input.h"

#include <CGAL/Geodesic_constructions/farthest_point_sampling.h>
#include <CGAL/Geodesic_constructions/isolines.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;

TEST_F(Wrong_input, of_samples_and_isolines)
{
  expect_refusals({
      {"-1 samples",
       [&] {
         std::vector<Vertex> samples;
         AG::farthest_point_sampling(m_mesh, std::back_inserter(samples), -1);
       },
       {"number of points is -1"}},
      {"an isovalue that is no number",
       [&] {
         std::vector<std::vector<Point>> lines;
         const std::vector<double> x(m_mesh.num_vertices());
         AG::isolines(
             m_mesh, boost::make_iterator_property_map(x.begin(), get(boost::vertex_index, m_mesh)),
             std::vector<double>{1, m_nan}, std::back_inserter(lines));
       },
       {"isovalue 1, counted from 0, is not a number"}},
  });
}

// What looks wrong, and has an answer that is documented.
TEST_F(Wrong_input, of_samples_that_is_none)
{
  std::vector<Vertex> samples;
  EXPECT_EQ(AG::farthest_point_sampling(m_mesh, std::back_inserter(samples), 1000), 0);
  EXPECT_EQ(samples.size(), m_mesh.num_vertices());
}

} // namespace
