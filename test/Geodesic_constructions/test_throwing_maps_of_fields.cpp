// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Impatient_maps.h"

#include <CGAL/Geodesic_constructions/gradient.h>
#include <CGAL/Geodesic_constructions/isolines.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

// It reads and writes one face after the other.
TEST_F(Impatient_maps_of_a_field, leave_the_first_gradients)
{
  const std::vector<Kernel::Vector_3> nothing(m_mesh.num_faces(), Kernel::Vector_3(9, 9, 9));
  std::vector<Kernel::Vector_3> gradients, all_gradients = nothing;
  const auto gradient = [&](std::vector<Kernel::Vector_3>& vectors) {
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
  const std::vector<double> isovalues = {1, 2, 5};
  std::vector<std::vector<Point>> polylines, all_polylines;
  const auto isolines = [&](std::vector<std::vector<Point>>& result) {
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
