// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Wrong_input.h"

#include <CGAL/Geodesic_costs.h>
#include <CGAL/approximate_geodesic_path.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

class Wrong_costs : public Wrong_input
{
protected:
  template <typename Weights>
  auto weight_map(const Weights& weights) const
  {
    return boost::make_iterator_property_map(weights.begin(), get(boost::face_index, m_mesh));
  }

  // With `bad` as the weight of the face with the number 7.
  std::function<void()> distances_with_weight(const double bad) const
  {
    return [this, bad] {
      std::vector<double> weights(m_mesh.num_faces(), 1);
      weights[7] = bad;
      distances(m_mesh, Vertex(0), parameters::face_weight_map(weight_map(weights)).epsilon(0.1));
    };
  }
};

TEST_F(Wrong_costs, of_faces)
{
  expect_refusals({
      {"a negative weight", distances_with_weight(-2), {"weight", "-2", "not negative"}},
      {"a weight that is no number", distances_with_weight(m_nan), {"weight", "nan"}},
  });
}

TEST_F(Wrong_costs, of_bounds_and_paths)
{
  const Mesh needle =
      to_mesh({{Point(0, 0, 0), Point(1, 0, 0), Point(0.5, 1e-30, 0)}, {{0, 1, 2}}});
  const std::vector<double> ones(m_mesh.num_faces(), 1);
  expect_refusals({
      {"a face too thin for a bound with weights",
       [&] {
         const auto np = parameters::face_weight_map(
             boost::make_iterator_property_map(ones.begin(), get(boost::face_index, needle)));
         distances(needle, Vertex(0), np.epsilon(0.1));
       },
       {"the face with vertices", "maximum_number_of_points_per_edge"}},
      {"straight paths where faces have weights",
       [&] {
         std::vector<Point> points;
         CGAL::approximate_geodesic_path(
             m_mesh, std::back_inserter(points), Vertex(0), Vertex(9),
             parameters::face_weight_map(weight_map(ones)).epsilon(0.1).straighten(true));
       },
       {"cannot be straightened"}},
  });
}

} // namespace
