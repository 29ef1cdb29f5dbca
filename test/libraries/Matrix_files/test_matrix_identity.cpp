// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Approximate_geodesics/Matrix_files/internal/Matrix_identity.h>

#include "meshes/test_meshes.h"
#include "meshes/test_soup.h"

#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Geodesic_queries/internal/distance_matrix.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

// A file of distances goes on only with what it was begun with.

namespace {

namespace AG = CGAL::Approximate_geodesics;
using namespace geodesics_test;
using AG::internal::checksum;

class Matrix_identity : public testing::Test
{
protected:
  AG::Intrinsic_triangulation with_costs() const
  {
    return AG::Intrinsic_triangulation(
        m_mesh, CGAL::parameters::face_weight_map(CGAL::make_property_map(m_weights))
                    .edge_is_constrained_map(CGAL::make_property_map(m_barriers)));
  }

  const Mesh m_mesh = to_mesh(flat_grid(4, 3));
  std::vector<double> m_weights = std::vector<double>(m_mesh.number_of_faces(), 1.5);
  std::vector<char> m_barriers = std::vector<char>(m_mesh.number_of_edges(), false);
};

TEST_F(Matrix_identity, tells_each_weight_and_barrier)
{
  std::set<std::uint64_t> found{checksum(AG::Intrinsic_triangulation(m_mesh)),
                                checksum(with_costs())};
  EXPECT_EQ(checksum(with_costs()), checksum(with_costs()));
  for(double& weight : m_weights)
  {
    const double before = std::exchange(weight, 1.25);
    found.insert(checksum(with_costs()));
    weight = before;
  }
  std::size_t number_inside = 0;
  for(const auto e : m_mesh.edges())
    if(!m_mesh.is_border(e)) // where a barrier makes no difference
    {
      m_barriers[e.idx()] = true;
      found.insert(checksum(with_costs()));
      m_barriers[e.idx()] = false;
      ++number_inside;
    }
  EXPECT_EQ(found.size(), 2 + m_weights.size() + number_inside);
}

TEST_F(Matrix_identity, tells_costs_that_depend_on_the_direction)
{
  std::set<std::uint64_t> found;
  for(const double factor : {1., 0.5})
  {
    const AG::Intrinsic_triangulation t(
        m_mesh, CGAL::parameters::face_weight_map(AG::directional_cost(AG::Hiking_time(factor))));
    found.insert(checksum(t));
    const AG::Directional_graph<AG::Fixed_number_of_points> graph(t, AG::Fixed_number_of_points(1));
    EXPECT_NE(AG::internal::facts_of_graph(graph), AG::internal::facts_of_graph(graph.reversed()));
  }
  EXPECT_EQ(found.size(), 2u);
}

} // namespace
