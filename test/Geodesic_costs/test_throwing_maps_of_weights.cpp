// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures/Impatient_maps.h"
#include "meshes/test_weights.h"

#include <CGAL/Approximate_geodesics/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

namespace AG = CGAL::Approximate_geodesics;
namespace parameters = CGAL::parameters;
using namespace geodesics_test;

TEST_F(Impatient_maps, end_the_construction_of_a_triangulation_with_weights)
{
  std::vector<double> weights = random_weights(m_mesh, m_random, 0.5, 2);
  expect_uses(m_mesh.number_of_faces(), parameters::face_weight_map(map<Face>(weights)));
}

TEST_F(Impatient_maps, leave_distances_alone_if_weights_are_read)
{
  std::vector<double> weights = random_weights(m_mesh, m_random, 0.5, 2);
  expect_untouched_distances(parameters::face_weight_map(map<Face>(weights)));
}

TEST_F(Impatient_maps, leave_weights_alone)
{
  std::vector<double> weights = random_weights(m_mesh, m_random, 0.5, 2);
  using Weighted_graph = Steiner_graph<Fixed_number_of_points>;
  using Weighted_class = AG::Surface_mesh_shortest_path<Mesh, Weighted_graph>;
  Weighted_class paths(
      m_mesh, steiner_graph(m_mesh, Weights(m_mesh.num_faces(), 1), Fixed_number_of_points(1)));
  paths.add_source_point(Vertex(3));
  const auto cost = [&] { return paths.shortest_distance_to_source_points(Vertex(60)).first; };
  const double before = cost();
  interrupt([&] { paths.set_face_weights(map<Face>(weights)); },
            [&](std::size_t) { EXPECT_EQ(cost(), before); });
  EXPECT_EQ(cost(), costs(m_mesh, weights, Fixed_number_of_points(1), {Vertex(3)})[60]);
}

} // namespace
